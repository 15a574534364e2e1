//! Programs that answer the same to every question.

use std::collections::BTreeMap;

use harness::conform::{Profile, Reply, Status, Subject};
use serde_json::{Value, json};

use super::altered::{card, card_with};

struct Constant(Value);

/// Every question but those of whole scenes, and of shapes a few: exact answers take long, too.
const FAST: [&str; 15] = [
    "shapes/sphere",
    "shapes/instance",
    "shapes/disk",
    "camera_ray",
    "project",
    "samples",
    "map",
    "lobe",
    "fresnel",
    "light",
    "texture",
    "mapping",
    "noise",
    "transform",
    "grid",
];

impl Subject for Constant {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        questions.iter().map(|_| Reply::Answer(self.0.clone())).collect()
    }
}

/// Law: no question is passed by one answer to everything, and no answer stops the judge. Oracle: constants of every
/// kind of JSON.
#[test]
fn no_constant_passes() {
    let constants =
        [json!(null), json!(false), json!(42), json!([]), json!({}), json!([1, 2, 3]), json!("pi")];
    for constant in constants {
        let mut subject = Constant(constant.clone());
        // whole scenes take long to judge, and are judged as the other values are
        let card = card_with(&mut subject, &FAST, Profile::Careful, 3, false);
        let mut wrong: BTreeMap<&str, u64> = BTreeMap::new();
        for row in &card.rows {
            let question = row.name.split('.').next().unwrap_or_default();
            *wrong.entry(question).or_default() += row.count(Status::Wrong);
            let mostly = 2 * row.count(Status::Pass) > row.total();
            // half of all segments are free, rays go by, and some points are out of view
            let is_guess = ["occluded", "intersect", "project"].contains(&question);
            assert!(!mostly || is_guess, "{constant} passes {}: {:?}", row.name, row.counts);
        }
        assert!(wrong.values().all(|wrong| *wrong > 0), "{constant}: {wrong:?}");
    }
}

/// Law: a question about an algebraic surface shrinks without end of the judge, though it may have no normal where it
/// is hit any more. Oracle: a program that says of every surface that it is missed.
#[test]
fn surfaces_without_a_normal_do_not_stop_the_judge() {
    let card =
        card(&mut Constant(json!(null)), &["intersect.algebraic.ordinary"], Profile::Careful, 4);
    assert!(card.is_failed());
}
