//! What `intersect` says about the parts of a shape, and where a ray that leaves the surface starts.

use ask::Draw;
use groundtruth::math::Vector;
use serde_json::{Value, json};

use super::{ask, numbers};

/// A few dozen roundings of numbers below 100.
const ROUNDING: f64 = 1e-12;

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

/// Law: a ray that leaves a sphere starts on the side to which it goes, within a few error bounds of the
/// surface. Outwards it meets nothing, inwards only the far side. Oracle: the distance from the centre, and
/// the chord `−2 (n·d) r / d·d`.
#[test]
fn a_ray_leaves_a_sphere_on_the_side_it_goes_to() {
    let mut draw = Draw::new(2166);
    for _ in 0..1_000 {
        let (center, radius) = (draw.point(50.0), draw.decades(-2.0, 2.0));
        let n = draw.direction();
        let leave = draw.decades(-2.0, 2.0) * Vector::from(draw.direction());
        let shape = json!({"sphere": {"center": center.to_array(), "radius": radius}});
        let from = center + (5.0 * radius) * n;
        let ray = json!({"origin": from.to_array(), "direction": (-Vector::from(n)).to_array()});
        let hit =
            ask(&json!({"intersect": {"shape": shape, "ray": ray, "leave": leave.to_array()}}));
        let start = numbers(&hit["leave"]);
        let error = hit["error"].as_f64().expect("a bound");
        let off = Vector::new(start[0], start[1], start[2]) - center.to_vector();
        let above = off.length() - radius;
        let outward = n.dot(leave);
        if outward.abs() < 1e-3 * leave.length() {
            continue;
        }
        assert_eq!(above > 0.0, outward > 0.0, "{above:e} {outward}");
        assert!(above.abs() <= 5.0 * error, "{above:e} {error:e}");
        let ray = json!({"origin": start, "direction": leave.to_array()});
        let next = ask(&json!({"intersect": {"shape": shape, "ray": ray, "all": true}}));
        let ts: Vec<f64> = next
            .as_array()
            .expect("a list")
            .iter()
            .map(|hit| hit["t"].as_f64().expect("t"))
            .collect();
        if outward > 0.0 {
            assert!(ts.is_empty(), "{ts:?}");
        } else {
            let chord = -2.0 * outward * radius / leave.length_squared();
            assert_eq!(ts.len(), 1);
            // the start is known to a few error bounds, which a slanted ray multiplies
            let slant = leave.length() / outward.abs();
            let tolerance = (10.0 * error * slant + ROUNDING * radius) / leave.length();
            assert!((ts[0] - chord).abs() <= tolerance, "{} {chord}", ts[0]);
        }
    }
}

/// Law: a mesh of lists is hit in the triangle at which the ray is aimed, with the texture coordinates of
/// the lists. Oracle: the ray is built backwards from barycentric coordinates.
#[test]
fn a_mesh_of_lists_is_hit_where_it_was_aimed_at() {
    let mut draw = Draw::new(2167);
    for _ in 0..300 {
        let corners = [draw.point(5.0), draw.point(5.0), draw.point(5.0)];
        let [a, b, c] = corners;
        let across = (b - a).cross(c - a);
        if across.length() < 1.0 {
            continue;
        }
        let uvs = [[0.0, 0.0], [1.0, 0.25], [0.5, 2.0]];
        let (beta, gamma) = (draw.between(0.05, 0.45), draw.between(0.05, 0.45));
        let target = a + beta * (b - a) + gamma * (c - a);
        let from = target + (3.0 / across.length()) * across;
        let shape = json!({"mesh": {
            "vertices": corners.map(|p| p.to_array()), "triangles": [[0, 1, 2]], "uvs": uvs,
        }});
        let ray = json!({"origin": from.to_array(), "direction": (target - from).to_array()});
        let hit = ask(&json!({"intersect": {"shape": shape, "ray": ray}}));
        let t = hit["t"].as_f64().expect("t");
        assert!((t - 1.0).abs() < 1e-11, "t is {t}, not 1");
        assert_eq!(hit["path"], json!([{"triangle": 0}]));
        assert_eq!(hit["front"], json!(true));
        let expected = [0, 1].map(|i| beta * uvs[1][i] + gamma * uvs[2][i]);
        for (found, expected) in numbers(&hit["uv"]).into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-11, "{found} {expected}");
        }
    }
}
