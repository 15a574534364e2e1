//! Parts of shapes within one turn, as the book has them, apart from ranges that go farther round (Suffern, ch. 19).

use serde_json::Value;

use super::super::family::Family;
use super::super::intersections;

/// Of the part shapes, cases whose angles are within 0 … 360 degrees.
pub fn within_a_turn() -> Vec<Family> {
    let mut all = Vec::new();
    for part in intersections::families() {
        if !part.name.ends_with(".ordinary") || !part.name.starts_with("intersect.part_") {
            continue;
        }
        let cases = part.cases;
        let cases = move |seed: u64, n: usize| {
            let mut plain = cases(seed ^ 0x360, 8 * n);
            plain.retain(is_within_a_turn);
            plain.truncate(n);
            plain
        };
        let name = part.name.replace(".ordinary", ".within_a_turn");
        all.push(Family { name, share: 0.5, cases: Box::new(cases), ..part });
    }
    all
}

fn is_within_a_turn(question: &Value) -> bool {
    let shape = question["intersect"]["shape"].as_object();
    let data = shape.and_then(|shape| shape.values().next());
    let end = |i: usize| data.and_then(|data| data["phi"][i].as_f64());
    end(0).is_none_or(|low| low >= 0.0) && end(1).is_none_or(|high| high <= 360.0)
}
