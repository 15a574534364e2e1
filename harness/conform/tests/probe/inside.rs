//! What `intersect` says about the parts of a shape.

use ask::Draw;
use serde_json::{Value, json};

use super::ask;

/// Law: the path of a hit names the target, from the outermost shape inwards. Oracle: a lattice of
/// compounds of meshes with integer vertices, and rays aimed inside one triangle of one copy.
#[test]
fn the_path_names_what_was_aimed_at() {
    // a sheet of 3 × 2 squares, two triangles each, the first below the diagonal from the origin
    let vertices: Vec<Value> = (0..12).map(|i| json!([i % 4, i / 4, 0])).collect();
    let mut triangles = Vec::new();
    for corner in [0, 1, 2, 4, 5, 6] {
        triangles.push(json!([corner, corner + 1, corner + 5]));
        triangles.push(json!([corner, corner + 5, corner + 4]));
    }
    let sheet = json!({"mesh": {"vertices": vertices, "triangles": triangles}});
    let ball = json!({"sphere": {"center": [0, 0, 50], "radius": 0.1}});
    let pair = json!({"compound": {"parts": [
        {"shape": ball},
        {"name": "sheet", "shape": {"instance": {"of": sheet, "transform": [{"translate": [0, 0, -1]}]}}},
    ]}});
    let rows = json!({"lattice": {"of": pair, "counts": [3, 2, 1], "spacing": [10, 20, 0]}});
    let mut draw = Draw::new(2165);
    for _ in 0..200 {
        let (square, below) = (draw.below(6), draw.coin());
        let copy = [draw.below(3), draw.below(2)];
        let (low, high) = (draw.between(0.01, 0.49), draw.between(0.51, 0.99));
        let (x, y) = if below { (high, low) } else { (low, high) };
        let x = x + (square % 3) as f64 + 10.0 * copy[0] as f64;
        let y = y + (square / 3) as f64 + 20.0 * copy[1] as f64;
        let ray = json!({"origin": [x, y, 9], "direction": [0, 0, -1]});
        let answer = ask(&json!({"intersect": {"shape": rows, "ray": ray}}));
        let expected = json!([
            {"copy": [copy[0], copy[1], 0]},
            {"part": {"index": 1, "name": "sheet"}},
            {"instance": {}},
            {"triangle": 2 * square + usize::from(!below)},
        ]);
        assert_eq!(answer["path"], expected, "{x} {y}");
    }
}

/// Law: a shape of one part has no path; the instance that the question's `transform` makes is a level of
/// the path. Oracle: the document.
#[test]
fn a_shape_of_one_part_has_no_path() {
    let shape = json!({"sphere": {"center": [0, 0, 0], "radius": 1}});
    let ray = json!({"origin": [0, 0, 9], "direction": [0, 0, -1]});
    let plain = ask(&json!({"intersect": {"shape": shape, "ray": ray}}));
    assert!(plain.get("path").is_none() && plain.get("leave").is_none(), "{plain}");
    let steps = json!([{"scale": [2, 2, 2]}]);
    let moved = ask(&json!({"intersect": {"shape": shape, "transform": steps, "ray": ray}}));
    assert_eq!(moved["path"], json!([{"instance": {}}]));
}
