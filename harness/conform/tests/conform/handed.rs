//! Programs whose axes are left-handed, and answers that are not whole.

use conform::card::verdict;
use conform::{Profile, Status, ours};
use serde_json::{Value, json};

use super::altered::{Altered, card_with, data};

/// The other sign of z, of a vector.
fn turned(v: &Value) -> Value {
    json!([v[0], v[1], -v[2].as_f64().unwrap_or(0.0)])
}

/// What a program answers that reads z into the screen, and writes it so: ours for the mirrored camera, mirrored.
fn left_handed(question: &Value, _: Value) -> Value {
    let mut asked = question.clone();
    let (name, data) =
        asked.as_object_mut().and_then(|it| it.iter_mut().next()).expect("a question");
    let name = name.clone();
    for field in ["eye", "look_at", "up"] {
        if let Some(v) = data["camera"].get_mut(field) {
            *v = turned(v);
        }
    }
    if let Some(point) = data.get_mut("point") {
        *point = turned(point);
    }
    let mut answer = ours(&asked).unwrap_or_default();
    if name == "camera_ray" && !answer.is_null() {
        for field in ["origin", "direction"] {
            answer[field] = turned(&answer[field]);
        }
    }
    answer
}

/// Law: a card whose every wrong answer is that of left-handed axes says so in place of a mistake; another wrong answer takes
/// it back. Oracle: the mirrored camera, written out for eye, target, up, and the points and rays.
#[test]
fn left_handed_axes_are_no_mistake() {
    let words = ["camera_ray.pinhole", "fresnel.cosine"];
    let of = |alter: fn(&Value, Value) -> Value| {
        card_with(&mut Altered(alter), &words, Profile::Careful, 24, false)
    };
    let card = of(left_handed);
    assert!(card.rows.iter().filter(|row| row.count(Status::Wrong) > 0).count() >= 2, "{card}");
    assert!(verdict(&card, false).contains("left-handed axes"), "{}", verdict(&card, false));
    let card = of(|question, answer| match question.get("fresnel") {
        Some(_) => json!({"reflected": answer["transmitted"]}),
        None => left_handed(question, answer),
    });
    assert!(!card.to_string().contains("left-handed"), "{card}");
    // a sphere's normal that is turned over is another mistake
    let card = card_with(
        &mut Altered(|_, a| super::altered::with(a, "/normal", |x| -x)),
        &["intersect.sphere.ordinary"],
        Profile::Careful,
        24,
        false,
    );
    assert!(!card.to_string().contains("left-handed"), "{card}");
}

/// Law: eyes that are exchanged are no left-handed axes, though each ray is mirrored: the rays of one eye are right there. Oracle:
/// our answer for the other eye.
#[test]
fn exchanged_eyes_are_not_left_handed() {
    fn of_other_eye(question: &Value, _: Value) -> Value {
        let mut asked = question.clone();
        let eye = &mut asked["camera_ray"]["eye"];
        *eye = if *eye == "left" { "right" } else { "left" }.into();
        ours(&asked).unwrap_or_default()
    }
    let words = ["camera_ray.stereo"];
    let card = card_with(&mut Altered(of_other_eye), &words, Profile::Careful, 24, false);
    let verdict = verdict(&card, false);
    assert!(verdict.contains("the left eye for the right one"), "{verdict}");
}

/// Law: a mistake that would have changed right answers is not named, though it gives all the wrong ones. Oracle: the concentric
/// map with 1 − u for u in its second sector alone.
#[test]
fn right_answers_refute_a_name() {
    fn mirrored(question: &Value, answer: Value) -> Value {
        let u = ask::numbers(&question["map"]["u"]).unwrap_or_default();
        let [x, y] = [2.0 * u[0] - 1.0, 2.0 * u[1] - 1.0];
        let mut asked = question.clone();
        asked["map"]["u"][0] = json!(1.0 - u[0]);
        if y > x.abs() { ours(&asked).unwrap_or_default() } else { answer }
    }
    let words = ["map.disk.values"];
    let card = card_with(&mut Altered(mirrored), &words, Profile::Careful, 48, false);
    assert!(card.rows[0].count(Status::Wrong) > 3, "{card}");
    assert!(!card.to_string().contains("1 − u for u"), "{card}");
}

/// Law: an answer that has only some of its parts is judged by those, and the card names what is missing; without any part
/// that is needed it is wrong. Oracle: our answers without a field.
#[test]
fn parts_that_are_there_are_judged() {
    let of = |alter: fn(&Value, Value) -> Value| {
        card_with(&mut Altered(alter), &["fresnel.directions"], Profile::Careful, 24, false)
    };
    let card = of(|_, a| json!({"refracted": a["refracted"]}));
    let row = &card.rows[0];
    assert_eq!((row.count(Status::Wrong), row.lacks.get("reflected")), (0, Some(&24)), "{card}");
    assert!(card.to_string().contains("`reflected` is missing in 24 of 24"), "{card}");
    assert!(verdict(&card, true).contains("parts of answers are missing"));
    let card = of(|q, a| match a["refracted"].is_null() {
        true => json!({"refracted": null}),
        false => {
            let wo = super::altered::vector(&data(q)["wo"]);
            json!({"refracted": wo.map(|x| -x)})
        }
    });
    assert!(card.rows[0].count(Status::Wrong) > 10, "{card}");
    let card = of(|_, _| json!({"other": 1.0}));
    assert_eq!(card.rows[0].count(Status::Wrong), 24, "{card}");
}

/// Law: a colour of a texture that is wrong has no name of light or axes: black, exchanged channels, signs. Oracle: our
/// colours, black or with channels exchanged.
#[test]
fn a_texture_is_not_lit() {
    let changes: [fn(&Value, Value) -> Value; 2] =
        [|_, _| json!([0.0, 0.0, 0.0]), |_, a| json!([a[2], a[1], a[0]])];
    for change in changes {
        let words = ["texture.checker3d"];
        let card = card_with(&mut Altered(change), &words, Profile::Careful, 24, false);
        let row = &card.rows[0];
        assert!(row.count(Status::Wrong) > 1, "{card}");
        assert!(row.names.is_empty(), "{card}");
    }
}
