//! What is no mistake: other roundings, other notations, less than everything, other random numbers.

use conform::{Profile, Status, ours};
use serde_json::{Value, json};

use super::altered::{
    Altered, all_numbers, card, card_with, data, each, instead, length, swap, vector,
};

/// The next number away from zero.
fn next(x: f64) -> f64 {
    if x == 0.0 { x } else { f64::from_bits(x.to_bits() + 1) }
}

/// The families in which much can differ without being wrong.
const SOME: [&str; 12] = [
    "shapes/sphere",
    "shapes/box",
    "shapes/torus",
    "shapes/instance",
    "fresnel",
    "lobe",
    "camera_ray",
    "project",
    "map",
    "light",
    "transform",
    "mapping",
];

/// A harmless variant of our answers: what it is, by which profile, to which families, and how it is made.
type Variant = (&'static str, Profile, &'static [&'static str], fn(&Value, Value) -> Value);

const VARIANTS: &[Variant] = &[
    ("single precision", Profile::Book, &SOME, |_, a| {
        all_numbers(a, &|x| json!(f64::from(x as f32)))
    }),
    ("ε = 10⁻⁴", Profile::Book, &["intersect"], |question, a| {
        let is_plain =
            question["intersect"]["all"].is_null() && question["intersect"]["span"].is_null();
        match is_plain {
            true => instead(question, |data| {
                let size = length(&data["ray"]["direction"]);
                data["span"] = json!([1e-4 / size, "inf"]);
            }),
            false => a,
        }
    }),
    ("the next number", Profile::Careful, &SOME, |_, a| all_numbers(a, &|x| json!(next(x)))),
    ("−0", Profile::Careful, &SOME, |_, a| {
        all_numbers(a, &|x| if x == 0.0 { json!(-0.0) } else { json!(x) })
    }),
    ("8 for 8.0", Profile::Careful, &SOME, |_, a| {
        let is_small = |x: f64| x.fract() == 0.0 && x.abs() < 1e9;
        all_numbers(a, &|x| if is_small(x) { json!(x as i64) } else { json!(x) })
    }),
    ("equal hits", Profile::Careful, &["shapes/torus", "shapes/box"], |_, mut a| {
        if let Some(hits) = a.as_array_mut() {
            hits.reverse();
            hits.sort_by(|a, b| a["t"].as_f64().partial_cmp(&b["t"].as_f64()).expect("numbers"));
        }
        a
    }),
    ("double roots", Profile::Careful, &["intersect.sphere.tangent"], |question, mut a| {
        let direction = &question["intersect"]["ray"]["direction"];
        let [n, d] = [vector(&a["normal"]), vector(direction)];
        let cosine = (0..3).map(|i| n[i] * d[i]).sum::<f64>() / length(direction);
        if !a.is_null() && cosine.abs() < 1e-13 {
            each(&mut a["normal"], |x| -x);
        }
        a
    }),
    ("t and normal only", Profile::Careful, &["shapes/sphere", "shapes/torus"], |_, a| {
        let less = |hit: &Value| json!({"t": hit["t"], "normal": hit["normal"], "note": "a hit"});
        match &a {
            Value::Array(hits) => hits.iter().map(less).collect(),
            Value::Object(_) => less(&a),
            _ => a,
        }
    }),
    (
        "reflected only",
        Profile::Careful,
        &["fresnel.cosine"],
        |_, a| json!({"reflected": a["reflected"], "took": "3 ms"}),
    ),
    (
        "another seed",
        Profile::Careful,
        &["samples.jittered", "samples.multi_jittered", "samples.n_rooks", "samples.random"],
        |question, _| {
            instead(question, |data| data["seed"] = json!(data["seed"].as_u64().unwrap_or(0) + 1))
        },
    ),
    (
        "u and v swapped",
        Profile::Careful,
        &["lobe.lambertian", "lobe.glossy_specular"],
        |question, a| match question["lobe"]["u"].is_null() {
            true => a,
            false => instead(question, |data| swap(&mut data["u"], 0, 1)),
        },
    ),
    ("another lattice", Profile::Careful, &["noise"], |question, a| {
        let mut other = question.clone();
        let seed = &mut other["noise"]["noise"]["seed"];
        *seed = json!(99 + seed.as_u64().unwrap_or(0));
        ours(&other).unwrap_or(a)
    }),
    // The book's pixels draw one of 83 sets, each with one order of its points (Suffern, ch. 5).
    (
        "83 sets",
        Profile::Book,
        &["samples.jittered.stream", "samples.multi_jittered.stream", "samples.random.stream"],
        |question, _| {
            instead(question, |data| {
                let [x, y] = [0, 1].map(|i| data["draw"]["pixel"][i].as_u64().unwrap_or(0));
                let set = (x + 1000 * y).wrapping_mul(0x9e37_79b9_7f4a_7c15) % 83;
                data["draw"]["pixel"] = json!([set, 0]);
            })
        },
    ),
    // `⌊multiplier · w / s⌋ + 1` cells for all sets of boxes, where s³ is their volume over their number (Suffern, ch. 22).
    ("the book's formula", Profile::Careful, &["grid.boxes"], |question, mut a| {
        let data = data(question);
        let boxes = data["boxes"].as_array().expect("boxes");
        let ends = |corner: &str, of: fn(f64, f64) -> f64| {
            let corners: Vec<[f64; 3]> = boxes.iter().map(|it| vector(&it[corner])).collect();
            corners.into_iter().reduce(|a, b| [0, 1, 2].map(|i| of(a[i], b[i]))).expect("a box")
        };
        let (low, high) = (ends("min", f64::min), ends("max", f64::max));
        let w = [0, 1, 2].map(|i| high[i] - low[i]);
        let s = groundtruth::math::cbrt(w.iter().product::<f64>() / boxes.len() as f64);
        let multiplier = data["multiplier"].as_f64().unwrap_or(2.0);
        a["resolution"] = json!(w.map(|w| (multiplier * w / s).floor() + 1.0));
        a
    }),
];

fn passes(what: &str, profile: Profile, words: &[&str], alter: fn(&Value, Value) -> Value) {
    let card = card(&mut Altered(alter), words, profile, 12);
    assert!(!card.is_failed(), "{what}: {card}");
}

/// Law: harmless variants of our answers pass. Oracle: the variants, made on purpose.
#[test]
fn harmless_variants_pass() {
    for (what, profile, words, alter) in VARIANTS {
        passes(what, *profile, words, *alter);
    }
}

/// Law: of a program in single precision, every wrong answer to an ordinary question counts as fair, those that break
/// laws and those at edges too. Oracle: the profile *book*, by which none of them fails.
#[test]
fn single_precision_is_counted_as_fair() {
    let mut single = Altered(|_, a| all_numbers(a, &|x| json!(f64::from(x as f32))));
    let ordinary = card(&mut single, &SOME, Profile::Book, 12);
    let is_ordinary = |name: &str| ordinary.rows.iter().any(|row| row.name == name);
    let card = card_with(&mut single, &SOME, Profile::Careful, 12, false);
    let rows = card.rows.iter().filter(|row| is_ordinary(&row.name));
    let wrong: Vec<_> = rows.filter(|row| row.count(Status::Wrong) > 0).collect();
    assert!(wrong.iter().any(|row| row.name.ends_with(".there_and_back")), "no law is broken");
    for row in wrong {
        assert_eq!(row.fair, row.count(Status::Wrong), "{}: {card}", row.name);
    }
}

/// A lattice that does not repeat after 256 cells, and splines that are not limited where they overshoot 1.
#[test]
fn noise_without_tables_or_limits_is_no_mistake() {
    /// Any numbers from −1 to 1, another at each point of the lattice.
    fn at(knot: [i64; 3]) -> f64 {
        let odd = [0x9e37_79b9_7f4a_7c15_u64, 0xc2b2_ae3d_27d4_eb4f, 0x1656_67b1_9e37_79f9];
        let mut x =
            (0..3).fold(1, |x: u64, i| (x ^ (x >> 31) ^ knot[i] as u64).wrapping_mul(odd[i]));
        x ^= x >> 29;
        2.0 * (x as f64 / u64::MAX as f64) - 1.0
    }
    /// The weight of a point of the lattice `x` away: lines, or the splines of Catmull and Rom.
    fn weight(x: f64, is_linear: bool) -> f64 {
        match (x.abs(), is_linear) {
            (x, true) => (1.0 - x).max(0.0),
            (x, _) if x < 1.0 => 1.0 + x * x * (1.5 * x - 2.5),
            (x, _) if x < 2.0 => 2.0 + x * (x * (2.5 - 0.5 * x) - 4.0),
            _ => 0.0,
        }
    }
    let families = ["linear", "cubic", "knots"].map(|name| format!("noise.lattice.{name}"));
    let families = families.each_ref().map(String::as_str);
    passes("noise of a hash", Profile::Careful, &families, |question, _| {
        let is_linear = question["noise"]["noise"]["interpolation"] == "linear";
        let point = vector(&question["noise"]["point"]);
        let cell = point.map(|x| x.floor() as i64);
        let mut value = 0.0;
        for step in 0..64 {
            let knot = [0, 1, 2].map(|i| cell[i] - 1 + (step >> (2 * i)) % 4);
            let weights = [0, 1, 2].map(|i| weight(point[i] - knot[i] as f64, is_linear));
            value += weights.iter().product::<f64>() * at(knot);
        }
        json!({"value": value})
    });
}
