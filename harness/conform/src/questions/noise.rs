//! Noise, its sums, and what textures and bumps make of it (Suffern, ch. 31). Random numbers are everybody's own: laws
//! hold a program's answers against each other; values are asked for tables that the question gives.

use ask::Draw;
use serde_json::{Value, json};

use super::super::family::{Family, Judge};
use super::super::judgement::{Judgement, Profile};
use super::super::laws;
use super::super::mistakes as m;
use super::super::values::{self, Rules};
use super::{any, family, kinds, swap, vector};
use groundtruth::textures;

/// Textures that are made of noise or random numbers depend on our own tables: laws judge them.
pub const OF_NOISE: [&str; 10] = [
    "fbm",
    "turbulence",
    "wrapped_fbm",
    "two_colors",
    "three_colors",
    "ramp_fbm",
    "wrapped_ramp",
    "wood",
    "random_colors",
    "stripes",
];

/// Textures of noise as functions of the point.
pub fn families() -> Vec<Family> {
    let mut all = Vec::new();
    for (tag, chapter, specimens) in kinds(textures::Kind::ENTRIES) {
        // random colours are those of objects, not of points
        if !OF_NOISE.contains(&&*tag) || tag == "random_colors" {
            continue;
        }
        let about = format!("textures/{tag}");
        let case = move |draw: &mut Draw| {
            let texture = any(draw, &specimens).clone();
            json!({"texture": {"texture": texture, "point": vector(draw, 4.0)}})
        };
        let repeats = Judge::Law(laws::repeats);
        let name = format!("texture.{tag}.repeats");
        all.push(Family { share: 0.25, ..family(&name, &about, chapter, repeats, case) });
    }
    all
}

/// Judges by our own answer.
pub fn still(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    const RULES: Rules = Rules { needed: &[], free: &[], questions: &[], answers: &[] };
    values::judge(question, answer, profile, &RULES)
}

/// Judges by our own answer.
pub fn given(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    // a lattice of permuted coordinates, interpolated, is the noise of permuted coordinates
    const RULES: Rules = Rules {
        needed: &["value"],
        free: &[],
        questions: &[
            (&m::OTHER_PERMUTATION, |question| {
                swap(&mut question["noise"], "/point/0", "/point/1")
            }),
            (&m::OTHER_PERMUTATION, |question| {
                swap(&mut question["noise"], "/point/0", "/point/2")
            }),
            (&m::OTHER_PERMUTATION, |question| {
                swap(&mut question["noise"], "/point/1", "/point/2")
            }),
        ],
        answers: &[],
    };
    values::judge(question, answer, profile, &RULES)
}
