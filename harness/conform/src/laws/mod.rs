//! Laws that need no oracle: functions over a subject that answers questions.
//!
//! The library's own kinds are held to the same laws by `cargo test`, with the subject [`Ours`](super::subject::Ours).

mod lamps;
mod lattice;
mod lights;
mod lobes;
mod noise;
mod octaves;
mod sampling;
mod shapes;
mod spaces;

use ask::{Stop, number, numbers, triple};
use serde_json::Value;

use super::judgement::{Judgement, Profile};
use groundtruth::math::UNIT_ROUNDOFF;

pub use lattice::{interpolates, knots_differ};
pub use lights::{cosine_drawn, irradiance, jittered_moments, lamp_sample, sky_sample};
pub use lobes::{density, energy, reciprocity, sample_agrees, shares_add_up};
pub use noise::{noise_is_smooth, repeats, seeds_differ, vectors_are_even};
pub use octaves::{bump_adds_noise, octaves_add_up, texture_of_noise};
pub use sampling::{Strata, map_and_back, strata_of, stratified, stream};
pub use shapes::{direction_length, sides_alternate, unaccelerated};
pub use spaces::{inverse_is_inverse, there_and_back};

/// What a law finds.
pub type LawOutcome = Result<Judgement, Stop>;

/// The probability that any statistical law of a run fails for a right program.
const LEVEL: f64 = 1e-3;
/// At least as many statistical tests as a run of 100 cases a family has.
const TESTS: usize = 1000;

/// Right, or wrong with this symptom if the relative error is more than the profile allows.
fn within(
    profile: Profile,
    symptom: &str,
    error: f64,
    expected: impl FnOnce() -> String,
) -> Judgement {
    let error = error / UNIT_ROUNDOFF;
    match error <= profile.allowed() {
        true => Judgement::Right(error),
        false => Judgement::wrong(symptom, error, expected()),
    }
}

/// The largest difference of two lists, relative to the largest number; infinite if one is no list of numbers.
fn relative(a: &Value, b: &Value) -> f64 {
    let list = |value: &Value| number(value).map(|x| vec![x]).or_else(|| numbers(value));
    let (Some(a), Some(b)) = (list(a), list(b)) else { return f64::INFINITY };
    if a.len() != b.len() {
        return f64::INFINITY;
    }
    let largest = b.iter().fold(f64::MIN_POSITIVE, |most, x| most.max(x.abs()));
    let off = a.iter().zip(&b).map(|(a, b)| if a == b { 0.0 } else { (a - b).abs() / largest });
    off.fold(0.0, |most: f64, x| if x.is_nan() { f64::INFINITY } else { most.max(x) })
}

/// Wrong because something is not there.
fn missing(what: &str) -> LawOutcome {
    Ok(Judgement::wrong(&format!("{what} is missing"), f64::INFINITY, format!("`{what}`")))
}

/// The three channels of a colour.
fn color(value: &Value) -> Option<[f64; 3]> {
    triple(value).filter(|color| color.iter().all(|channel| channel.is_finite()))
}
