//! What programs with one known mistake answer to `radiance`.

use std::path::Path;

use serde::Deserialize;
use serde_json::Value;

use super::radiance::{Looks, Radiance, standard_error};
use super::source::Built;
use groundtruth::rgb::Rgb;
use groundtruth::trace::RayBudget;
use groundtruth::world::World;
use groundtruth::{render, trace};
use judge::mistakes::{Mistake, Mistaken, Reweighing, pixel};

/// The answer of a program with a known mistake.
#[derive(Clone, Copy, Debug)]
pub struct WithMistake {
    /// The mistake.
    pub mistake: &'static Mistake,
    /// Its `mean`.
    pub mean: [f64; 3],
    /// Its `standard_error`; 0 for one replica.
    pub standard_error: [f64; 3],
}

/// The answers of programs with each of these mistakes that applies to the scene; none for what is no valid
/// `radiance`.
pub fn mistaken(question: &Value, mistakes: &[&'static Mistake]) -> Vec<WithMistake> {
    let asked = Radiance::deserialize(&question["radiance"]).ok();
    asked.and_then(|asked| of(&asked, mistakes)).unwrap_or_default()
}

/// Rays of all samples of one mistake; a question that our own answer fits into has far fewer.
const MOST_RAYS: u64 = 1 << 24;

fn of(asked: &Radiance, mistakes: &[&'static Mistake]) -> Option<Vec<WithMistake>> {
    let looks = asked.looks().ok()?;
    let Built { scene, world, .. } = asked.built(asked.seed()).ok()?;
    let (reweighed, changed): (Vec<&Mistake>, Vec<&Mistake>) =
        mistakes.iter().copied().partition(|mistake| mistake.is_reweighed());
    let mut all = heard(asked, world, &looks, &reweighed);
    for mistake in changed {
        let other = Mistaken::new(mistake, &scene, Path::new(""), asked.seed());
        let Ok(Some(Mistaken { mut world, .. })) = other else { continue };
        let mut budget = RayBudget::up_to(MOST_RAYS);
        let values = asked.seeds().map(|seed| {
            world.reseed(seed);
            looks.value(&world, &mut budget)
        });
        let values: Vec<Rgb> = values.collect();
        all.push(answered(mistake, &values));
    }
    Some(all)
}

/// The answers with those mistakes that change terms, in one pass.
fn heard(
    asked: &Radiance,
    mut world: World,
    looks: &Looks,
    mistakes: &[&'static Mistake],
) -> Vec<WithMistake> {
    if mistakes.is_empty() {
        return Vec::new();
    }
    let mut values = vec![Vec::new(); mistakes.len()];
    for seed in asked.seeds() {
        world.reseed(seed);
        let mut recorder = Reweighing::new(&world, mistakes);
        let means = match looks {
            Looks::AtPixel(at) => pixel(&world, &mut recorder, *at),
            Looks::Along(ray) => {
                let count = world.samples_per_pixel();
                let samples: Vec<Vec<Rgb>> = (0..count)
                    .map(|index| {
                        recorder.begin(count > 1 && index + 1 == count);
                        trace::radiance(&world, ray, world.draws([0, 0], index), &mut recorder);
                        recorder.radiance().to_vec()
                    })
                    .collect();
                let of = |i: usize| render::mean(samples.iter().map(|sample| sample[i]));
                (0..=mistakes.len()).map(of).collect()
            }
        };
        values.iter_mut().zip(&means[1..]).for_each(|(values, mean)| values.push(*mean));
    }
    mistakes.iter().zip(&values).map(|(mistake, values)| answered(mistake, values)).collect()
}

fn answered(mistake: &'static Mistake, values: &[Rgb]) -> WithMistake {
    let mean = render::mean(values.iter().copied());
    let error = if values.len() > 1 { standard_error(mean, values) } else { Rgb::BLACK };
    WithMistake { mistake, mean: mean.to_array(), standard_error: error.to_array() }
}
