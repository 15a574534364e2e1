//! Mistakes of the kinds that people make: each is judged wrong, in the right family, with a small question; and what
//! can be named is named.

#[path = "mistakes/lights_and_cameras.rs"]
mod lights_and_cameras;
#[path = "mistakes/optics.rs"]
mod optics;
#[path = "mistakes/sampling_and_spaces.rs"]
mod sampling_and_spaces;
#[path = "mistakes/shapes.rs"]
mod shapes;
#[path = "mistakes/surfaces.rs"]
mod surfaces;

use harness::conform::mistakes::{self as m, Mistake, Name};
use harness::conform::{Judgement, Profile, Status, Wrong};
use serde_json::{Value, json};

use super::altered::{Altered, at, card, data, length, swap, vector};

/// A mistake of a program.
struct Planted {
    what: &'static str,
    /// What is asked: exactly these families fail.
    wrong: &'static [&'static str],
    alter: fn(&Value, Value) -> Value,
    /// What the card has to say for each of them.
    name: Option<&'static Mistake>,
}

const fn planted(
    what: &'static str,
    wrong: &'static [&'static str],
    name: Option<&'static Mistake>,
    alter: fn(&Value, Value) -> Value,
) -> Planted {
    Planted { what, wrong, alter, name }
}

/// How many numbers other than 0, 1 and −1 a question has.
fn numbers(question: &Value) -> usize {
    match question {
        Value::Number(number) => {
            usize::from(![0.0, 1.0, -1.0].contains(&number.as_f64().unwrap_or(2.0)))
        }
        Value::Array(items) => items.iter().map(numbers).sum(),
        Value::Object(fields) => fields.values().map(numbers).sum(),
        _ => 0,
    }
}

/// Law: each planted mistake is judged wrong in its families, its first failure shrinks to a question of at most 12
/// numbers other than 0 and ±1 that still fails, and the mistake is named in each of them. Oracle: the mistake, made on
/// purpose in our own answers.
fn found(planted: &[Planted]) {
    let mut problems = Vec::new();
    for &Planted { what, wrong, alter, name } in planted {
        let card = card(&mut Altered(alter), wrong, Profile::Careful, 24);
        let mut names = Vec::new();
        for row in &card.rows {
            let mut problem = |text: String| problems.push(format!("{what}: {}: {text}", row.name));
            if row.count(Status::Wrong) == 0 {
                problem(format!("not found; {:?}", row.counts));
                continue;
            }
            let Some(failure) = &row.failure else {
                problem("without an example".to_owned());
                continue;
            };
            let size = numbers(&failure.question);
            if size > 12 {
                problem(format!("{size} numbers in {}", failure.question));
            }
            names.extend(row.names.iter().map(|name| (row.name.clone(), name.clone())));
        }
        let shown: Vec<String> = names.iter().map(|(_, it)| it.to_string()).collect();
        for (name, word) in name.iter().flat_map(|name| wrong.iter().map(move |word| (*name, word)))
        {
            let is_it = |(family, it): &(String, Name)| {
                let is_same = matches!(it, Name::Known { mistake, .. } if *mistake == name);
                family.starts_with(word) && is_same
            };
            if !names.iter().any(is_it) {
                problems
                    .push(format!("{what}: {word}: not named {:?}; found {shown:?}", name.name));
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

/// `a`, `b` and `c` of a sphere's equation `a t² + 2 b t + c = 0`.
fn quadratic(question: &Value) -> [f64; 3] {
    let sphere = &data(question)["shape"]["sphere"];
    let [o, d] = ["origin", "direction"].map(|it| vector(&data(question)["ray"][it]));
    let (center, radius) = (vector(&sphere["center"]), sphere["radius"].as_f64().unwrap_or(1.0));
    let l: [f64; 3] = std::array::from_fn(|i| o[i] - center[i]);
    let dot = |x: [f64; 3], y: [f64; 3]| (0..3).map(|i| x[i] * y[i]).sum::<f64>();
    [dot(d, d), dot(l, d), dot(l, l) - radius * radius]
}

#[test]
fn mistakes_in_shapes_are_found() {
    found(&shapes::planted_here());
}

#[test]
fn mistakes_in_optics_are_found() {
    found(&optics::planted_here());
}

#[test]
fn mistakes_in_lights_and_cameras_are_found() {
    found(&lights_and_cameras::planted_here());
}

#[test]
fn mistakes_in_sampling_and_spaces_are_found() {
    found(&sampling_and_spaces::planted_here());
}

#[test]
fn mistakes_in_surfaces_are_found() {
    found(&surfaces::planted_here());
}

/// Law: a constant factor that is none of the known ones is named by its number. Oracle: the factor planted.
#[test]
fn an_unknown_constant_factor_is_named_by_its_number() {
    let mut subject = Altered(|_, mut a| {
        at(&mut a, "/t", |t| 0.8 * t);
        a
    });
    let card = card(&mut subject, &["intersect.plane.ordinary"], Profile::Careful, 24);
    let [Name::Factor(factor)] = card.rows[0].names[..] else { panic!("{:?}", card.rows[0].names) };
    assert!((factor - 0.8).abs() < 1e-9, "{factor}");
}

/// Law: two mistakes in one family are both named, each with the number of answers that it explains, and the two add
/// up to all. Oracle: the two mistakes, planted for answers whose first hit is above or below y = 0.
#[test]
fn two_mistakes_in_one_family_are_both_named() {
    let mut subject = Altered(|_, mut a| {
        match a["point"][1].as_f64() {
            Some(y) if y > 0.0 => at(&mut a, "/t", |t| 2.0 * t),
            Some(_) => a.pointer_mut("/normal").into_iter().for_each(|n| swap(n, 1, 2)),
            None => {}
        }
        a
    });
    let card = card(&mut subject, &["intersect.sphere.ordinary"], Profile::Careful, 40);
    let names = &card.rows[0].names;
    let explained = |wanted: &Mistake| {
        let count = |name: &Name| match name {
            Name::Known { mistake, explains, of } if *mistake == wanted => Some((*explains, *of)),
            _ => None,
        };
        names.iter().find_map(count).unwrap_or_else(|| panic!("{} not in {names:?}", wanted.name))
    };
    let ((first, of), (second, _)) = (explained(&m::TIMES_TWO), explained(&m::SWAP_YZ));
    assert!(first >= of / 4 && second >= of / 4, "{first} and {second} of {of}");
    assert_eq!(first + second, of);
    assert_eq!(names.len(), 2, "{names:?}");
    assert!(names[0].to_string().contains(&format!("explains {} of {of}", first.max(second))));
}

/// Law: a mistake is named if it is the only one, or explains at least a quarter of the answers and two. Oracle: answers
/// with clues of known numbers.
#[test]
fn few_answers_name_nothing() {
    let named = |counts: [usize; 3]| {
        let clues: [&'static Mistake; 3] = [&m::FAR_ROOT, &m::BEHIND, &m::TO_VIEWER];
        let one = |clue: &'static Mistake| match Judgement::wrong("t", 1.0, "") {
            Judgement::Wrong(wrong) => Wrong { clues: vec![clue], ..*wrong },
            other => panic!("{other:?}"),
        };
        let of = |(clue, count): (&'static Mistake, usize)| (0..count).map(move |_| one(clue));
        let wrong: Vec<Wrong> = clues.into_iter().zip(counts).flat_map(of).collect();
        let explained = |name: &Name| match name {
            Name::Known { explains, .. } => *explains,
            Name::Factor(_) => 0,
        };
        m::names(&wrong).iter().map(explained).collect::<Vec<_>>()
    };
    assert_eq!(named([1, 0, 0]), [1], "the only one");
    assert!(named([1, 1, 0]).is_empty(), "one each");
    assert_eq!(named([7, 1, 0]), [7]);
    assert_eq!(named([2, 4, 2]), [4, 2, 2]);
    assert_eq!(named([6, 20, 6]), [20], "6 of 32 are less than a quarter");
}

/// Law: what explains all answers is named alone, without a count and without the sign or factor that it implies.
/// Oracle: a normal turned to the viewer, whose sign is wrong, too.
#[test]
fn a_specific_name_replaces_the_sign() {
    let mut subject = Altered(|_, mut a| {
        if a["front"] == json!(false) {
            at(&mut a, "/normal", |x| -x)
        }
        a
    });
    let card = card(&mut subject, &["intersect.plane.ordinary"], Profile::Careful, 24);
    let names: Vec<String> = card.rows[0].names.iter().map(ToString::to_string).collect();
    let [name] = &names[..] else { panic!("{names:?}") };
    assert!(name.starts_with("the normal is turned to the viewer (docs/probe.md"), "{name}");
    assert!(!name.contains("explains"), "{name}");
}

/// Law: rounding has no name. Oracle: the textbook's `(−b ∓ √(b² − 4ac)) / 2a` for far and tiny spheres, which is
/// wrong and nothing else.
#[test]
fn rounding_is_not_named() {
    let mut subject = Altered(|q, mut a| {
        let [a2, b, c] = quadratic(q);
        let root = (4.0 * b * b - 4.0 * a2 * c).sqrt();
        let ts = [(-2.0 * b - root) / (2.0 * a2), (-2.0 * b + root) / (2.0 * a2)];
        let least = data(q)["span"][0].as_f64().unwrap_or(0.0);
        if let Some(t) = ts.into_iter().find(|t| *t > least) {
            at(&mut a, "/t", |_| t);
        }
        a
    });
    let card = card(&mut subject, &["intersect.sphere"], Profile::Careful, 40);
    let wrong = card.count(Status::Wrong);
    assert!(wrong > 0, "the textbook's formula loses digits");
    for row in &card.rows {
        assert!(row.names.is_empty(), "{}: {:?}", row.name, row.names);
    }
}

/// Law: the plain cross product of a triangle's edges is its normal, however thin the triangle. Oracle: the cross
/// product in double precision, in all families of triangles and rectangles.
#[test]
fn a_plain_cross_product_is_no_mistake() {
    let mut subject = Altered(|q, mut a| {
        let shape = &data(q)["shape"];
        let [v0, v1, v2] = [0, 1, 2].map(|i| vector(&shape["triangle"]["vertices"][i]));
        let edges: [[f64; 3]; 2] = match shape.get("rectangle") {
            Some(it) => ["a", "b"].map(|side| vector(&it[side])),
            None => [v1, v2].map(|v| std::array::from_fn(|i| v[i] - v0[i])),
        };
        let [e, f] = edges;
        let cross: [f64; 3] = std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            e[j] * f[k] - e[k] * f[j]
        });
        let length = length(&json!(cross));
        let hits = if a.is_array() { a.as_array_mut() } else { None };
        for hit in hits.into_iter().flatten() {
            hit["normal"] = json!(cross.map(|x| x / length));
        }
        if a.is_object() {
            a["normal"] = json!(cross.map(|x| x / length));
        }
        a
    });
    let words = ["intersect.triangle", "intersect.rectangle"];
    let card = card(&mut subject, &words, Profile::Careful, 100);
    assert!(!card.is_failed(), "{card}");
}

/// Law: every scene that a mistake names is in the gallery. Oracle: the gallery.
#[test]
fn scenes_of_mistakes_exist() {
    for mistake in m::ALL {
        if let Some(scene) = mistake.scene {
            assert!(groundtruth::gallery::find(scene).is_some(), "{scene}");
        }
    }
}
