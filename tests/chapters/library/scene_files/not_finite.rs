//! NaN and infinity, which TOML can express, are refused in every field.

use groundtruth::kinds::Entry;
use groundtruth::{cameras, samplers, textures};
use rayon::prelude::*;
use toml::Value;

use super::places::{at, places};
use crate::prelude::*;

fn specimens<Kind>(entries: &[Entry<Kind>]) -> Vec<Kind> {
    entries.iter().flat_map(|entry| (entry.specimens)()).collect()
}

/// A scene with an example of every kind, every step and every field that has a default.
pub fn everything(lens: cameras::Kind) -> Scene {
    let camera = Viewpoint {
        roll: 10.0,
        medium: Medium { eta: 1.5, absorption: Rgb::new(0.5, 0.25, 0.125) },
        ..Viewpoint::new(Point::new(1.0, 2.0, 9.0), Point::new(0.5, 0.25, 0.0), lens)
    };
    let sampler = specimens(samplers::Kind::ENTRIES).into_iter().next();
    let mut scene = Scene::new("everything", Image { sampler, ..Image::new(4, 4) }, camera);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 3 });
    let recipes = specimens(materials::Kind::ENTRIES).into_iter();
    let painted = specimens(textures::Kind::ENTRIES).into_iter().map(|texture| {
        materials::Kind::from(Matte { ka: 0.5.into(), kd: 0.5.into(), cd: Paint::from(texture) })
    });
    for (i, recipe) in recipes.chain(painted).enumerate() {
        scene.materials.push(Material::new(&format!("material {i}"), recipe));
    }
    scene.materials.push(Material::new("glow", Emissive::new(1.0, Rgb::WHITE)));
    for (i, mut source) in specimens(lights::Kind::ENTRIES).into_iter().enumerate() {
        if let lights::Kind::Area(area) = &mut source {
            area.object = format!("lamp {i}");
            let lamp = Sphere { center: Point::new(0.5, 7.0, 1.5), radius: 0.75, inward: false };
            scene.objects.push(Object::new(&area.object, "glow", lamp));
        }
        scene.lights.push(Light::new(&format!("light {i}"), source));
    }
    let sphere = Sphere { center: Point::new(0.5, 0.25, 1.5), radius: 0.75, inward: false };
    let instance = Instance::new(
        sphere,
        vec![
            Step::Translate(Vector::new(1.0, 2.0, 3.0)),
            Step::Scale(Vector::new(1.0, 2.0, 3.0)),
            Step::RotateX(10.0),
            Step::RotateY(20.0),
            Step::RotateZ(30.0),
            Step::RotateAbout { point: Point::ORIGIN, direction: Vector::Y, degrees: 40.0 },
            Step::Reflect(Axis::Z),
            Step::Shear([0.5, 0.25, 0.0, 0.0, 0.125, 0.0]),
            Step::Matrix([
                [1.0, 0.5, 0.25, 3.0],
                [0.0, 1.0, 0.5, 2.0],
                [0.0, 0.0, 1.0, 1.0],
                [0.0, 0.0, 0.0, 1.0],
            ]),
        ],
    );
    let all = specimens(shapes::Kind::ENTRIES).into_iter().chain([instance.into()]);
    for (i, shape) in all.enumerate() {
        scene.objects.push(Object::new(&format!("object {i}"), "material 0", shape));
    }
    scene
}

/// Law: if any number of any kind is NaN or infinite, the error names its field and the
/// line on which it stands. Oracle: the text has the word on one line only.
#[test]
fn nan_and_infinity_are_refused_in_every_field_of_every_kind() {
    let mut checked = 0;
    for (i, lens) in specimens(cameras::Kind::ENTRIES).into_iter().enumerate() {
        let whole = Value::try_from(everything(lens)).expect("it can be written");
        let text = toml::to_string(&whole).expect("it can be written");
        scenefile::from_toml(&text, Path::new("scene.toml")).expect("it is right");
        let mut places = places(&whole, &[], &Value::is_float);
        // everything but the camera is the same for every lens
        places.retain(|place| i == 0 || place[0] == "camera");
        places.par_iter().enumerate().for_each(|(j, place)| {
            // infinity with alternating sign
            for value in [f64::NAN, [f64::INFINITY, f64::NEG_INFINITY][j % 2]] {
                check_refused(&whole, place, value);
            }
        });
        checked += 2 * places.len();
    }
    assert!(checked > 600, "{checked} places");
}

/// The scene with that item of its lists in which the place is, and those that it names; and the place in it.
/// A place in no item is one of the scene with empty lists.
pub fn only(whole: &Value, place: &[String]) -> (Value, Vec<String>) {
    let (mut scene, mut place) = (whole.clone(), place.to_vec());
    let part = if place.len() > 1 { place[0].clone() } else { String::new() };
    for list in ["materials", "lights", "objects"] {
        let mut index = 0;
        let is_kept = |item: &Value| {
            let name = item["name"].as_str().expect("every item has a name");
            index += 1;
            match (part.as_str(), list) {
                (part, list) if part == list => place[1] == (index - 1).to_string(),
                ("objects", "materials") => name == "material 0" || name == "glow",
                ("lights", "materials") => name == "glow",
                ("lights", "objects") => name.starts_with("lamp "),
                _ => false,
            }
        };
        scene[list].as_array_mut().expect("a list").retain(is_kept);
    }
    if ["materials", "lights", "objects"].contains(&part.as_str()) {
        "0".clone_into(&mut place[1]);
    }
    (scene, place)
}

/// Fails if the scene is valid with this value at this place, or if the error names another field or line.
fn check_refused(whole: &Value, place: &[String], value: f64) {
    let word = match value {
        f64::INFINITY => "inf",
        f64::NEG_INFINITY => "-inf",
        _ => "nan",
    };
    let (mut wrong, place) = only(whole, place);
    *at(&mut wrong, &place) = Value::Float(value);
    let text = toml::to_string(&wrong).expect("it can be written");
    let error = scenefile::from_toml(&text, Path::new("scene.toml"))
        .err()
        .unwrap_or_else(|| panic!("{place:?} may be {word}"))
        .to_string();
    let has_word = |line: &str| line.split([' ', ',', '[', ']', '{', '}']).any(|it| it == word);
    let line = 1 + text.lines().position(has_word).expect("a line");
    let start = format!("scene.toml:{line}: ");
    assert!(error.starts_with(&start), "{place:?}: not on {start}{error}");
    let field = place.iter().rfind(|key| key.parse::<usize>().is_err());
    let path = error.split(": ").nth(1).expect("a path");
    assert!(path.contains(field.expect("a field").as_str()), "{place:?}: {error}");
}
