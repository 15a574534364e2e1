//! Rays and shapes, judged by exact answers (`oracle`).

mod cases;
mod formulas;
mod judge;
mod local;
mod names;
mod other_shapes;
mod question;

use serde_json::Value;

use super::family::{Family, Judge};
use super::laws;
use super::values::WHOLE;
use cases::{all_roots, around, changed, nearest, occlusion, within_a_turn};
pub use judge::{judge, judge_occluded};
use oracle::hard::{self, Family as Hard};

/// The families of every kind of shape.
pub fn families() -> Vec<Family> {
    let mut families = Vec::new();
    for kind in hard::Kind::ALL {
        let Some(tag) = tag_of(kind) else { continue };
        let chapter = super::chapters::shape(&tag);
        let mut add = |question: &str, name: &str, share: f64, judge: Judge, cases: Cases| {
            families.push(Family {
                name: format!("{question}.{tag}.{name}"),
                about: format!("shapes/{tag}"),
                chapter,
                // the hard ones are named after what makes them hard
                ordinary: Hard::ALL.iter().all(|it| *it == Hard::Ordinary || name_of(*it) != name),
                share,
                cases,
                judge,
                namer: None,
                is_shrunk: true,
            });
        };
        let judge = Judge::Answer(judge, &WHOLE);
        for family in Hard::ALL {
            let cases = move |seed, n| nearest(kind, family, seed, n);
            add("intersect", &name_of(family), 1.0, judge, Box::new(cases));
        }
        let around = move |seed, n| around(kind, seed + 3, n);
        add("intersect", "around", 1.0, judge, Box::new(around));
        let all = move |seed, n| changed(kind, seed + 1, n, all_roots);
        add("intersect", "all_roots", 1.0, judge, Box::new(all));
        let other = move |seed, n| nearest(kind, Hard::Ordinary, seed ^ 0x5eed, n);
        let judge_length = Judge::Law(laws::direction_length);
        add("intersect", "direction_length", 0.25, judge_length, Box::new(other));
        if kind.is_solid() || ["sphere", "box", "torus"].contains(&&*tag) {
            let others = move |seed: u64, n| changed(kind, (seed ^ 0x5eed) + 1, n, all_roots);
            add("intersect", "sides", 0.25, Judge::Law(laws::sides_alternate), Box::new(others));
        }
        if tag.starts_with("part_") {
            let cases = move |seed, n| within_a_turn(kind, seed, n);
            add("intersect", "within_a_turn", 0.5, judge, Box::new(cases));
        }
        let occluded = move |seed, n| changed(kind, seed + 2, n, occlusion);
        add("occluded", "segment", 1.0, Judge::Answer(judge_occluded, &WHOLE), Box::new(occluded));
    }
    families
}

type Cases = Box<dyn Fn(u64, usize) -> Vec<Value> + Send + Sync>;

/// `FarOrigin` as `far_origin`.
fn name_of(family: Hard) -> String {
    groundtruth::kinds::tag(&format!("{family:?}"))
}

/// The tag of a kind in scene files.
fn tag_of(kind: hard::Kind) -> Option<String> {
    let shape = hard::cases(kind, Hard::Ordinary, 1, 1).pop()?.0;
    let data = serde_json::to_value(exact::our_shape(&shape)?).ok()?;
    data.as_object()?.keys().next().cloned()
}
