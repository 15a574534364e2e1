//! Mistakes of the kinds that people make: each is judged wrong, in the right family, with a small question; and what
//! can be named is named.

mod lights_and_cameras;
mod made;
mod optics;
pub mod planted;
mod shapes;
mod surfaces;

use ask::Asking;
use conform::family::Judge;
use conform::mistakes::{self as m, Mistake, Name};
use conform::{Judgement, Ours, Profile, Status, Wrong, ours};
use groundtruth::math::Vector;
use judge::mistakes::known::{self, KnownMistake};
use serde_json::{Value, json};

use planted::Planted;

use super::altered::{Altered, at, card, data, families, swap, vector, with};

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
/// numbers other than 0 and ±1 (of a whole scene: 60) that still fails and asks for all that was asked for, the right answer to that question
/// passes its rule; the mistake is named, or nothing is, and that for at most a fifth. Oracle: the mistake, made on purpose in our own answers.
fn found(planted: Vec<Planted>) {
    let (mut problems, mut nameless, count) = (Vec::new(), Vec::new(), planted.len());
    for Planted { what, wrong, name, mut way } in planted {
        let card = card(&mut way, wrong, Profile::Careful, 24);
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
            // making a whole scene smaller may end by its time, before its numbers are few
            let most = if row.name.starts_with("radiance.") { 60 } else { 12 };
            if size > most {
                problem(format!("{size} numbers in {}", failure.question));
            }
            if !passes_when_right(&row.name, &failure.question) {
                problem(format!("the right answer does not pass {}", failure.question));
            }
            names.extend(row.names.iter().map(|name| (row.name.clone(), name.clone())));
        }
        let shown: Vec<String> = names.iter().map(|(_, it)| it.to_string()).collect();
        if let Some(name) = name {
            let is_it = |(_, it): &(String, Name)| matches!(it, Name::Known { mistake, .. } if *mistake == name);
            match names.iter().any(is_it) {
                true => {}
                false if names.is_empty() => nameless.push(what),
                false => {
                    problems.push(format!("{what}: not named {:?}; found {shown:?}", name.words()));
                }
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    assert!(5 * nameless.len() <= count, "of {count}, these have no name: {nameless:?}");
}

/// Whether our answer to a question is right by the judge of its family.
fn passes_when_right(family: &str, question: &Value) -> bool {
    let family = families(&[family]).into_iter().find(|it| it.name == family).expect("it is one");
    let found = match family.judge {
        Judge::Answer(judge, rules) => {
            ours(question).map(|answer| judge(question, &answer, Profile::Careful, rules)).ok()
        }
        Judge::Law(law) => law(&mut Asking::new(&mut Ours), question, Profile::Careful).ok(),
    };
    found.is_some_and(|judgement| judgement.is_right())
}

/// Law: a question made smaller still asks for what its rule needs. Oracle: an adapter that answers the albedo of a
/// lobe alone, met in the field, whose question lost its `u`.
#[test]
fn what_is_asked_for_is_asked_for_still() {
    let mut subject = Altered(|_, a| json!({"albedo": a["albedo"]}));
    let card = card(&mut subject, &["lobe.lambertian.sample"], Profile::Careful, 24);
    let failure = card.rows[0].failure.as_ref().expect("it fails");
    assert!(failure.question["lobe"]["u"].is_array(), "{}", failure.question);
    assert!(passes_when_right("lobe.lambertian.sample", &failure.question));
}

#[test]
fn mistakes_in_shapes_are_found() {
    found(shapes::planted_here());
}

#[test]
fn mistakes_in_optics_are_found() {
    found(optics::planted_here());
}

#[test]
fn mistakes_in_lights_and_cameras_are_found() {
    found(lights_and_cameras::planted_here());
}

#[test]
fn mistakes_in_surfaces_and_spaces_are_found() {
    found(surfaces::planted_here());
}

/// Law: the mistakes that give 0/0 are named, each. Oracle: the mistake, made on purpose.
#[test]
fn what_is_no_number_is_named() {
    let all = surfaces::planted_here().into_iter().chain(lights_and_cameras::planted_here());
    let of_nan = [Some(&m::DIVIDED_BY_ZERO_AXIS), Some(&m::DIVIDED_BY_ZERO_ANGLE)];
    found(all.filter(|it| of_nan.contains(&it.name)).collect());
}

/// Law: rays that have the right directions of a lens, and start in its middle, are not said to be those of a lens that is a
/// point. Oracle: our rays, moved to the eye.
#[test]
fn a_right_field_refutes_a_name() {
    let mut subject = Altered(|question, mut answer| {
        answer["origin"] = data(question)["camera"]["eye"].clone();
        answer
    });
    let card = card(&mut subject, &["camera_ray.thin_lens.values"], Profile::Careful, 24);
    assert!(card.rows[0].count(Status::Wrong) > 10, "{card}");
    assert!(card.rows[0].names.is_empty(), "{:?}", card.rows[0].names);
}

/// Law: numbers are those of a mistake that changes little if they are much nearer to it than to the right ones. Oracle: numbers
/// with a difference of 2·10⁻⁷.
#[test]
fn a_small_difference_tells_a_mistake() {
    let (right, near) = ([1.0, 0.5], [1.0, 0.5 + 2e-7]);
    assert!(m::tells(&near, &near, &right));
    assert!(!m::tells(&right, &near, &right));
    assert!(!m::tells(&near, &right, &right));
    assert!(!m::tells(&[1.0, 0.5 + 4e-7], &near, &right), "halfway");
    assert!(m::tells(&[2.0, 0.5], &[2.0, 0.5 + 2e-7], &right), "large");
}

/// Law: a constant factor that is none of the known ones is named by its number. Oracle: the factor planted.
#[test]
fn an_unknown_constant_factor_is_named_by_its_number() {
    let mut subject = planted::Numbers("/t", |t| 0.8 * t);
    let card = card(&mut subject, &["intersect.plane.ordinary"], Profile::Careful, 24);
    let [Name::Factor(factor)] = card.rows[0].names[..] else { panic!("{:?}", card.rows[0].names) };
    assert!((factor - 0.8).abs() < 1e-9, "{factor}");
}

/// Law: of two mistakes in one family, which explain less than nearly all of its wrong answers each, none is named. Oracle: the
/// two mistakes, planted for answers whose first hit is above or below y = 0.
#[test]
fn half_of_the_wrong_answers_name_nothing() {
    let mut subject = Altered(|_, mut a| {
        match a["point"][1].as_f64() {
            Some(y) if y > 0.0 => at(&mut a, "/t", |t| 2.0 * t),
            Some(_) => a.pointer_mut("/normal").into_iter().for_each(|n| swap(n, 1, 2)),
            None => {}
        }
        a
    });
    let card = card(&mut subject, &["intersect.sphere.ordinary"], Profile::Careful, 40);
    assert!(card.rows[0].count(Status::Wrong) > 20, "{card}");
    assert!(card.rows[0].names.is_empty(), "{:?}", card.rows[0].names);
}

/// Law: a mistake is named if it explains nine of ten answers, or all of fewer. Oracle: answers with clues of known numbers.
#[test]
fn what_explains_nearly_all_answers_is_named() {
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
    assert!(named([7, 1, 0]).is_empty(), "one of eight is left");
    assert_eq!(named([9, 1, 0]), [9]);
    assert_eq!(named([1, 18, 1]), [18]);
    assert!(named([2, 17, 0]).is_empty());
}

/// Law: what explains all answers is named alone, without a count and without the sign or factor that it implies.
/// Oracle: a normal turned to the viewer, whose sign is wrong, too.
#[test]
fn a_specific_name_replaces_the_sign() {
    let mut subject =
        Altered(|_, a| if a["front"] == json!(false) { with(a, "/normal", |x| -x) } else { a });
    let card = card(&mut subject, &["intersect.plane.ordinary"], Profile::Careful, 24);
    let names: Vec<String> = card.rows[0].names.iter().map(ToString::to_string).collect();
    let [name] = &names[..] else { panic!("{names:?}") };
    assert!(name.starts_with("the normal is turned to the viewer (docs/probe.md"), "{name}");
    assert!(!name.contains("explains"), "{name}");
}

/// Law: the textbook's `(−b ∓ √(b² − 4ac)) / 2a` is known by its own errors. Oracle: the formula, for far and tiny spheres, which is wrong and nothing else.
#[test]
fn cancellation_is_named() {
    let mut textbook = Altered(|q, a| {
        let sphere = &data(q)["shape"]["sphere"];
        let [o, d] = ["origin", "direction"].map(|it| Vector::from(vector(&data(q)["ray"][it])));
        let (center, radius) = (vector(&sphere["center"]), sphere["radius"].as_f64());
        let l = o - Vector::from(center);
        // a t² + 2 b t + c = 0
        let (a2, b, c) = (d.dot(d), l.dot(d), l.dot(l) - radius.map_or(1.0, |r| r * r));
        let root = (4.0 * b * b - 4.0 * a2 * c).sqrt();
        let ts = [(-2.0 * b - root) / (2.0 * a2), (-2.0 * b + root) / (2.0 * a2)];
        let least = data(q)["span"][0].as_f64().unwrap_or(0.0);
        let t = ts.into_iter().find(|t| *t > least);
        with(a, "/t", |right| t.unwrap_or(right))
    });
    let words = ["intersect.sphere.far_origin", "intersect.sphere.tiny_shape"];
    let card = card(&mut textbook, &words, Profile::Careful, 40);
    for row in &card.rows {
        assert!(row.count(Status::Wrong) > 10, "the textbook's formula loses digits: {card}");
        let [Name::Known { mistake, .. }] = &row.names[..] else {
            panic!("{}: {:?}", row.name, row.names)
        };
        assert_eq!(*mistake, &m::CANCELLATION, "{}", row.name);
    }
}

/// Law: where the farther of two roots is taken, or one is left out, nothing is said of lost digits. Oracle: the roots by the
/// formula of a unit sphere, which has no such error near it.
#[test]
fn the_other_root_is_no_lost_digit() {
    let mut second = Altered(|_, mut answer| match answer.as_array_mut() {
        Some(hits) if hits.len() > 1 => json!([hits.pop()]),
        _ => answer,
    });
    let card = card(&mut second, &["intersect.sphere.all_roots"], Profile::Careful, 40);
    let row = &card.rows[0];
    assert!(row.count(Status::Wrong) > 10, "{card}");
    let is_cancellation =
        |name: &Name| matches!(name, Name::Known { mistake, .. } if *mistake == &m::CANCELLATION);
    assert!(!row.names.iter().any(is_cancellation), "{:?}", row.names);
}

/// Law: the same wrong answer to every question of a kind is named as such, and only then. Oracle: shadow rays that
/// never hit, as where a kind has no `shadow_hit`, and those that miss a half.
#[test]
fn shadow_rays_that_never_hit_are_named() {
    let name = |alter: fn(&Value, Value) -> Value| {
        let words = ["occluded.torus.segment"];
        let card = card(&mut Altered(alter), &words, Profile::Book, 32);
        card.rows[0].names.iter().map(ToString::to_string).collect::<String>()
    };
    let never = name(|_, _| json!(false));
    assert!(never.contains("shadow_hit for this kind"), "{never}");
    let half = name(|q, a| {
        let x = data(q)["segment"]["from"][0].as_f64();
        if x > Some(0.0) { json!(false) } else { a }
    });
    assert!(half.starts_with("hits are missed"), "{half}");
}

/// Law: the normal of an open or part cylinder or of a thick ring may be turned to the viewer by the book, which the card
/// says; with care it is wrong, and the card says that the book does it, too. Of other shapes it is wrong by both.
/// Oracle: our normals, turned.
#[test]
fn conventions_of_the_book_pass_by_the_book() {
    let mut turned = Altered(|_, mut a| {
        if a["front"] == json!(false) {
            at(&mut a, "/normal", |x| -x);
            a["front"] = json!(true);
        }
        a
    });
    let mut of = |kind: &str, profile: Profile| {
        card(&mut turned, &[&format!("intersect.{kind}.around")], profile, 48)
    };
    for kind in ["open_cylinder", "part_cylinder", "thick_ring"] {
        let by_the_book = of(kind, Profile::Book);
        assert!(!by_the_book.is_failed(), "{by_the_book}");
        let row = &by_the_book.rows[0];
        let [(_, count)] = row.conventions[..] else { panic!("not one convention: {by_the_book}") };
        let said = format!("{count} of {} by a convention of the book", row.total());
        assert!(by_the_book.to_string().contains(&said), "no `{said}`: {by_the_book}");
        let with_care = of(kind, Profile::Careful);
        assert_eq!(with_care.rows[0].count(Status::Wrong), count, "{with_care}");
        let with_care = with_care.to_string();
        assert!(with_care.contains("the book does this, too (docs/book-card.md"), "{with_care}");
        assert!(with_care.contains("the book turns it to the viewer, too"), "{with_care}");
    }
    for kind in ["cone", "solid_cylinder"] {
        assert!(of(kind, Profile::Book).is_failed(), "{kind}");
    }
}

/// Law: a mistake that only answers tell is named by code or changes a question; each way to make one in a question about a
/// function changes that or our answer; and its scene is in the gallery. Oracle: the questions of all families; the list of names; the
/// gallery.
#[test]
fn mistakes_of_answers_are_told() {
    let mut left: Vec<&KnownMistake> = known::answers().iter().collect();
    assert!(left.iter().filter_map(|it| it.scene).all(|scene| gallery::find(scene).is_some()));
    let is_code = |it: &&KnownMistake| m::NAMED.iter().any(|m| m.known().name == it.name);
    left.retain(|it| !it.change.is_empty() || !is_code(it) && it.asked.is_empty());
    let all = known::pictures().iter().chain(known::answers());
    let mut ways: Vec<(&str, usize)> =
        all.flat_map(|it| (1..=it.asked.len()).map(move |way| (it.name, way))).collect();
    for question in families(&[]).iter().flat_map(|family| (family.cases)(3, 4)) {
        let mut told = data(&question).clone();
        left.retain(|it| it.change(&mut told.clone()).is_none());
        if told.get("scene").is_none() {
            told["answer"] = ours(&question).unwrap_or_default();
            let changes = |name: &str, way: usize| {
                known::find(name).expect("it is one").ways(&told)[way].is_some()
            };
            ways.retain(|(name, way)| !changes(name, *way));
        }
    }
    assert!(left.is_empty() && ways.is_empty(), "{left:?}, {ways:?} change nothing");
}
