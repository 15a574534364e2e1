//! Ends of the ranges of questions: a value at an end is answered, one beyond it is refused.

use serde_json::{Value, json};

/// A question with one part replaced, by a JSON pointer.
fn with(mut question: Value, pointer: &str, value: Value) -> Value {
    *question.pointer_mut(pointer).unwrap_or_else(|| panic!("no {pointer}")) = value;
    question
}

fn reply(question: &Value) -> Value {
    let line = conform::probe::answer(&question.to_string());
    serde_json::from_str(&line).expect("replies are JSON")
}

/// A question, the part of it that changes, values that fit and values that do not.
type Range = (Value, &'static str, Vec<Value>, Vec<Value>);

fn ranges() -> Vec<Range> {
    let below = 1.0 - f64::EPSILON / 2.0;
    let above = 1.0 + f64::EPSILON;
    let fresnel = json!({"fresnel": {"eta": 1.5, "cos_i": 0.5}});
    let lobe = json!({"lobe": {"lobe": {"lambertian": {"reflectance": [0.5, 0.5, 0.5]}}, "wo": [0, 0, 1], "u": [0.5, 0.5]}});
    let camera = json!({"camera_ray": {
        "camera": {"eye": [0, 0, 5], "lens": {"thin_lens": {"lens_radius": 0.5, "distance": 2, "focal_distance": 4}}},
        "image": {"width": 4, "height": 3}, "pixel": [0, 0], "place": [0.5, 0.5], "lens": [0, 0]}});
    let samples = json!({"samples": {"sampler": {"random": {}}, "n": 16, "sets": 1}});
    let map = json!({"map": {"to": {"hemisphere": {"exponent": 1}}, "u": [0.5, 0.5]}});
    let intersect = json!({"intersect": {
        "shape": {"sphere": {"center": [0, 0, 0], "radius": 1}},
        "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}, "span": [0, "inf"]}});
    let radiance = json!({"radiance": {"scene": "ch03/single-sphere", "pixel": [0, 0], "size": [4, 3], "samples": 1, "replicas": 1}});
    let grid = json!({"grid": {
        "boxes": [{"min": [0, 0, 0], "max": [1, 1, 1]}, {"min": [3, 3, 3], "max": [4, 4, 4]}],
        "multiplier": 2.0, "cell": [0, 0, 0]}});
    let seen = reply(&grid)["answer"]["resolution"].clone();
    let last: Vec<u64> = (0..3).map(|i| seen[i].as_u64().expect("a number") - 1).collect();
    vec![
        (
            fresnel.clone(),
            "/fresnel/cos_i",
            vec![json!(0), json!(1)],
            vec![json!(-1e-300), json!(above)],
        ),
        (fresnel, "/fresnel/eta", vec![json!(0.1), json!(1)], vec![json!(0), json!(-1.5)]),
        (
            lobe.clone(),
            "/lobe/u",
            vec![json!([0, 0]), json!([below, below])],
            vec![
                json!([1, 0]),
                json!([0, 1]),
                json!([-1e-300, 0]),
                json!([0.5]),
                json!([0.5, 0.5, 0.5]),
            ],
        ),
        (lobe, "/lobe/wo", vec![json!([0, 0, 2])], vec![json!([0, 0, 0])]),
        (
            camera.clone(),
            "/camera_ray/pixel",
            vec![json!([3, 2])],
            vec![json!([4, 2]), json!([3, 3]), json!([-1, 0])],
        ),
        (
            camera.clone(),
            "/camera_ray/place",
            vec![json!([0, 0]), json!([1, 1])],
            vec![json!([above, 0]), json!([0, above]), json!([0, -1e-300])],
        ),
        (
            camera,
            "/camera_ray/lens",
            vec![json!([1, 0]), json!([0, -1]), json!([0.6, 0.8])],
            vec![json!([above, 0]), json!([0.8, 0.7])],
        ),
        (samples.clone(), "/samples/n", vec![json!(1), json!(16384)], vec![json!(0), json!(16385)]),
        // 16384 points in all, and 83 sets
        (samples.clone(), "/samples/sets", vec![json!(1), json!(83)], vec![json!(0), json!(84)]),
        (
            with(samples, "/samples/n", json!(8192)),
            "/samples/sets",
            vec![json!(1), json!(2)],
            vec![json!(0), json!(3)],
        ),
        (
            map.clone(),
            "/map/to/hemisphere/exponent",
            vec![json!(0), json!(0.5)],
            vec![json!(-1e-9)],
        ),
        (map, "/map/u", vec![json!([0, below])], vec![json!([0, 1]), json!([1, 0])]),
        (
            intersect.clone(),
            "/intersect/span",
            vec![json!([0, 1e-300]), json!(["-inf", "inf"])],
            vec![json!([0, 0]), json!([1, 0]), json!(["inf", "inf"]), json!([0, "nan"])],
        ),
        (
            intersect.clone(),
            "/intersect/ray/direction",
            vec![json!([0, 0, -1e100]), json!([1e-100, 0, 0])],
            vec![json!([0, 0, -1.1e100]), json!([0.9e-100, 0, 0]), json!([0, 0, 0])],
        ),
        (intersect, "/intersect/shape/sphere/radius", vec![json!(1e-3)], vec![json!(0), json!(-1)]),
        (
            radiance.clone(),
            "/radiance/replicas",
            vec![json!(1), json!(1024)],
            vec![json!(0), json!(1025)],
        ),
        (
            radiance.clone(),
            "/radiance/pixel",
            vec![json!([3, 2])],
            vec![json!([4, 2]), json!([3, 3])],
        ),
        (radiance, "/radiance/samples", vec![json!(1)], vec![json!(0)]),
        (
            grid.clone(),
            "/grid/cell",
            vec![json!(last)],
            (0..3)
                .map(|i| {
                    let mut beyond = last.clone();
                    beyond[i] += 1;
                    json!(beyond)
                })
                .collect(),
        ),
        (grid.clone(), "/grid/multiplier", vec![json!(1e-3)], vec![json!(0), json!(-1)]),
        (
            grid,
            "/grid/boxes/1/max",
            vec![json!([3, 3, 3])],
            vec![json!([2.9, 4, 4]), json!([4, 4, 2.9])],
        ),
    ]
}

/// Law: a question is answered at both ends of each range (docs/probe.md), and refused just beyond them. Oracle: the ends.
#[test]
fn ends_of_ranges_are_answered_and_no_more() {
    for (question, pointer, fit, unfit) in ranges() {
        for value in fit {
            let asked = with(question.clone(), pointer, value.clone());
            let found = reply(&asked);
            assert!(found.get("answer").is_some(), "{pointer} = {value} is refused: {found}");
        }
        for value in unfit {
            let asked = with(question.clone(), pointer, value.clone());
            let found = reply(&asked);
            assert!(found["error"].is_string(), "{pointer} = {value} is answered: {found}");
        }
    }
}

/// Law: `serve` says that all lines were answered only if none got an error, wherever it stands. Oracle: one bad line
/// among four.
#[test]
fn one_bad_line_of_several_is_told() {
    let good = r#"{"fresnel": {"eta": 1.5, "cos_i": 0.5}}"#;
    for bad in 0..5 {
        let lines = (0..4).map(|i| if i == bad { "{}\n".to_owned() } else { format!("{good}\n") });
        let mut output = Vec::new();
        let is_all = conform::probe::serve(lines.collect::<String>().as_bytes(), &mut output);
        assert_eq!(is_all.expect("memory"), bad == 4, "all answered, line {bad} is bad");
        let replies = output.split(|byte| *byte == b'\n').filter(|line| !line.is_empty()).count();
        assert_eq!(replies, 4, "replies to four lines");
    }
}
