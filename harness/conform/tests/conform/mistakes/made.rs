//! Mistakes that the file says as data, made in questions about functions.

use conform::{Profile, ours};
use judge::mistakes::known::{self, KnownMistake};
use serde_json::{Value, json};

use super::super::altered::{Says, card_with, data};

/// The answer of a program that makes a mistake of the file in the first way that there is.
fn made(known: &KnownMistake, question: &Value) -> Option<Value> {
    let right = ours(question).ok()?;
    let (name, told) = question.as_object()?.iter().next()?;
    let mut told = told.clone();
    told["answer"] = right.clone();
    let Some(mut made) = known.ways(&told).into_iter().flatten().next() else {
        return Some(right);
    };
    let answer = made.as_object_mut()?.remove("answer")?;
    let is_answer = made == *data(question);
    Some(if is_answer { answer } else { ours(&json!({name: made})).unwrap_or_default() })
}

/// Families of functions, each with a mistake that the file says as data.
const MADE: [(&str, &str); 28] = [
    ("camera_ray.pinhole.zoom", "zoom-twice"),
    ("transform.reflect.values", "reflects-about-axis"),
    ("intersect.torus.inward", "inward-ignored"),
    ("intersect.lattice.ordinary", "one-spacing"),
    ("grid.boxes.resolution", "one-resolution"),
    ("map.sphere.values", "half-sphere"),
    ("camera_ray.pinhole.values", "look-at-ignored"),
    ("camera_ray.thin_lens.up", "up-ignored"),
    ("camera_ray.orthographic.values", "rays-from-origin"),
    ("camera_ray.pinhole.values", "no-distance"),
    ("camera_ray.fisheye.values", "fisheye-without-circle"),
    ("camera_ray.stereo.values", "eyes-converge"),
    ("camera_ray.stereo.values", "eyes-without-offset"),
    ("transform.composed.values", "translations-reversed"),
    ("transform.composed.values", "scales-inverted"),
    ("transform.shear.values", "shear-transposed"),
    ("intersect.transformed.scale_rotate.sphere", "steps-reversed"),
    ("intersect.triangle.around", "no-third-edge"),
    ("intersect.mesh.scaled", "mesh-scale"),
    ("mapping.hemispherical.values", "hemisphere-as-sphere"),
    ("mapping.square.values", "mapping-not-scaled"),
    ("texture.texture_instance.values", "texture-steps-inverted"),
    ("texture.plane_checker.values", "times-size"),
    ("transform.rotate.values", "steps-in-radians"),
    ("transform.composed.values", "rotation-y-reversed"),
    ("texture.sphere_checker.values", "lines-exchanged"),
    ("texture.texture_instance.values", "texture-steps-reversed"),
    ("transform.rotate.values", "rotation-x-reversed"),
];

/// Law: a mistake in a function that the file says as data is judged wrong and named. Oracle: our answers to what it makes of
/// the questions.
#[test]
fn mistakes_of_the_file_are_named() {
    let mut nameless = Vec::new();
    for (family, name) in MADE {
        let known = known::find(name).expect("it is in the file");
        let mut making = Says(|question: &Value| made(known, question).unwrap_or_default());
        let card = card_with(&mut making, &[family], Profile::Careful, 32, false);
        let names: Vec<String> = card.rows[0].names.iter().map(ToString::to_string).collect();
        let words = known.clue.unwrap_or(known.words);
        if !names.iter().any(|it| it.starts_with(words)) {
            nameless.push((family, name, names));
        }
    }
    assert!(nameless.is_empty(), "{nameless:?}");
}
