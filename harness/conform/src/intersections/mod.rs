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
use cases::{all_roots, around, changed, nearest, occlusion};
pub use judge::{judge, judge_occluded};
use oracle::hard::{self, Family as Hard};

/// The families of every kind of shape.
pub fn families() -> Vec<Family> {
    let mut families = Vec::new();
    for kind in hard::Kind::ALL {
        let Some(tag) = tag_of(kind) else { continue };
        let chapter = super::chapters::shape(&tag);
        let mut add = |question: &str, name: &str, ordinary: bool, cases: Cases, judge: Judge| {
            families.push(Family {
                name: format!("{question}.{tag}.{name}"),
                about: format!("shapes/{tag}"),
                chapter,
                ordinary,
                share: 1.0,
                cases,
                judge,
                namer: None,
                is_shrunk: true,
            });
        };
        for family in Hard::ALL {
            let cases = move |seed, n| nearest(kind, family, seed, n);
            let ordinary = family == Hard::Ordinary;
            add("intersect", &name_of(family), ordinary, Box::new(cases), Judge::Answer(judge));
        }
        let around = move |seed, n| around(kind, seed + 3, n);
        add("intersect", "around", true, Box::new(around), Judge::Answer(judge));
        let all = move |seed, n| changed(kind, seed + 1, n, all_roots);
        add("intersect", "all_roots", true, Box::new(all), Judge::Answer(judge));
        let occluded = move |seed, n| changed(kind, seed + 2, n, occlusion);
        add("occluded", "segment", true, Box::new(occluded), Judge::Answer(judge_occluded));
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
