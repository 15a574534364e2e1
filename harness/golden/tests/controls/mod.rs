//! Which fields of scenes goldens see.

mod changes;
mod fields;
mod program;
mod reasons;

use std::collections::BTreeSet;
use std::path::Path;

use golden::{GoldenSettings, Goldens};
use groundtruth::lights;
use groundtruth::materials;
use groundtruth::scene::Scene;

use fields::vocabulary;
use program::{Controls, Program, is_field_of};
use reasons::{REASONS, reason};

/// A sphere ahead and one behind the eye, by a lamp without shadows.
const SCENE: &str = r#"
    image = { width = 12, height = 12, gamma = 1.0 }
    camera = { eye = [0, 0, 10], lens.pinhole = { distance = 12 } }
    [[lights]]
    name = "lamp"
    shadows = false
    source.point = { location = [3, 4, 12], ls = 2 }
    [[materials]]
    name = "shiny"
    recipe.phong = { kd = 0.5, cd = [1, 0.5, 0.25], ks = 0.5, cs = [1, 1, 1], exponent = 8 }
    [[objects]]
    name = "ahead"
    material = "shiny"
    shape.AHEAD
    [[objects]]
    name = "behind"
    material = "shiny"
    shape.BEHIND
"#;

/// A sphere around a point near the axis.
const SPHERE: &str = "sphere = { center = [0.5, 0, Z], radius = 3 }";
/// A disk around the same point.
const DISK: &str = "disk = { center = [0.5, 0, Z], normal = [0.1, 0, 1], radius = 3 }";

/// A folder with a golden of each of these texts.
fn folder(texts: &[String]) -> (tempfile::TempDir, Goldens) {
    let folder = tempfile::tempdir().expect("a folder");
    let mut goldens = Goldens::none(folder.path());
    for (index, text) in texts.iter().enumerate() {
        let file = folder.path().join(format!("s{index}.toml"));
        std::fs::write(&file, text).expect("it can be written");
        let settings = GoldenSettings { size: Some([12, 12]), ..GoldenSettings::default() };
        let name = file.to_str().expect("a name of letters");
        let proposal = goldens.propose(name, "a law", &settings).expect("a scene");
        goldens.accept(vec![proposal]).expect("it can be written");
    }
    (folder, goldens)
}

fn of(ahead: &str, behind: &str) -> String {
    SCENE.replace("AHEAD", &ahead.replace('Z', "0")).replace("BEHIND", &behind.replace('Z', "20"))
}

fn controls(program: &Program<'_>, goldens: &Goldens) -> Controls {
    program.controls(goldens.all(), goldens.folder()).expect("the scenes are valid")
}

fn names<'a>(names: impl IntoIterator<Item = &'a String>) -> BTreeSet<&'a str> {
    names.into_iter().map(String::as_str).collect()
}

/// Law: a field is seen if some golden's pixels depend on it, and only then. Oracle: a shape behind the eye, which no ray of
/// the picture meets, as the lamp casts no shadows; a second golden, or a second object, has it ahead.
#[test]
fn fields_of_what_no_ray_meets_are_unseen() {
    let behind = [of(SPHERE, DISK)];
    let (_folder, goldens) = folder(&behind);
    let found = controls(&Program::OURS, &goldens);
    let unseen = names(found.unseen.keys());
    let invisible =
        ["shape disk.center", "shape disk.radius", "light.name", "material.name", "object.name"];
    for field in invisible {
        assert!(unseen.contains(field), "{field} is not among {unseen:?}");
    }
    assert_eq!(
        found.unseen["shape disk.radius"],
        ["s0.toml"],
        "goldens that say the disk's radius"
    );
    for field in [
        "shape sphere.center",
        "shape sphere.radius",
        "camera.eye",
        "camera pinhole.distance",
        "light point.ls",
        "light point.location",
        "material phong.exponent",
        "material phong.cd",
        "image.width",
    ] {
        assert!(found.seen.contains(field), "{field} is not among {:?}", found.seen);
    }

    let (_folder, goldens) = folder(&[behind[0].clone(), of(DISK, SPHERE)]);
    let found = controls(&Program::OURS, &goldens);
    for field in ["shape disk.radius", "shape sphere.radius"] {
        assert!(found.seen.contains(field), "{field} is not among {:?}", found.seen);
    }
    let shapes: Vec<_> = found.unseen.keys().filter(|field| field.starts_with("shape")).collect();
    assert!(shapes.is_empty(), "unseen fields of shapes: {shapes:?}");

    // the first of two spheres is behind the eye
    let turned = SCENE.replace("AHEAD", &SPHERE.replace('Z', "20"));
    let (_folder, goldens) = folder(&[turned.replace("BEHIND", &SPHERE.replace('Z', "0"))]);
    let found = controls(&Program::OURS, &goldens);
    assert!(found.seen.contains("shape sphere.radius"), "a radius of the second of two spheres");
}

/// Law: a value that is the default is not counted, as a program that ignores it draws the same picture; one that is not, is.
/// Oracle: the text, with gamma 1 and 1.5; a golden holds radiance, which gamma does not change.
#[test]
fn defaults_are_not_counted() {
    for (text, is_counted) in [
        (of(SPHERE, SPHERE), false),
        (of(SPHERE, SPHERE).replace("gamma = 1.0", "gamma = 1.5"), true),
    ] {
        let (_folder, goldens) = folder(&[text]);
        let found = controls(&Program::OURS, &goldens);
        assert!(!found.seen.contains("image.gamma"), "gamma is seen");
        let is_unseen = found.unseen.contains_key("image.gamma");
        assert_eq!(is_unseen, is_counted, "whether gamma is counted as unseen");
    }
}

/// Law: a program that ignores a field has it listed as unseen, and no other field more than ours. Oracle: programs that
/// set the field to one value whatever the scene says.
#[test]
fn a_field_that_a_program_ignores_is_unseen() {
    type Reads = fn(Scene) -> Scene;
    let planted: [(&str, Reads); 4] = [
        ("material phong.exponent", |mut scene| {
            for material in &mut scene.materials {
                if let materials::Kind::Phong(phong) = &mut material.recipe {
                    phong.exponent = 20.0.into();
                }
            }
            scene
        }),
        ("light point.ls", |mut scene| {
            for light in &mut scene.lights {
                if let lights::Kind::PointLight(point) = &mut light.source {
                    point.ls = 1.0;
                }
            }
            scene
        }),
        ("camera.eye", |mut scene| {
            scene.camera.eye = groundtruth::math::Point::new(0.5, 0.0, 10.0);
            scene
        }),
        ("image.pixel_size", |mut scene| {
            scene.image.pixel_size = 1.5;
            scene
        }),
    ];
    let (_folder, goldens) =
        folder(&[of(SPHERE, SPHERE).replace("gamma = 1.0", "pixel_size = 1.25")]);
    let ours = controls(&Program::OURS, &goldens);
    let known = vocabulary();
    for field in ours.seen.iter().chain(ours.unseen.keys()) {
        assert!(known.contains(field), "scene files have no {field}");
    }
    for (field, reads) in planted {
        assert!(ours.seen.contains(field), "{field} is not among {:?}", ours.seen);
        let found = controls(&Program { reads: &reads }, &goldens);
        let lost = names(ours.seen.difference(&found.seen));
        assert_eq!(lost, BTreeSet::from([field]), "fields that only ours sees");
        assert!(found.unseen.contains_key(field), "{field} is not among {:?}", found.unseen);
    }
}

/// Law: a kind has its own fields, not those of a kind whose name begins with its name. Oracle: names of scene files.
#[test]
fn fields_belong_to_the_kind_of_their_whole_name() {
    for (field, expected) in [
        ("light ambient.ls", true),
        ("light ambient_occluder.ls", false),
        ("light ambient_occluder", false),
        ("light ambient", false),
    ] {
        let found = is_field_of(field, "light ambient");
        assert_eq!(found, expected, "whether `{field}` is a field of `light ambient`");
    }
}

/// Law: each reason is of a field that scene files have, says something, and stands once. Oracle: the vocabulary of
/// scene files.
#[test]
fn each_reason_is_of_a_field_that_there_is() {
    let known = vocabulary();
    let mut before = "";
    for (field, why) in REASONS {
        assert!(known.contains(*field), "scene files have no {field}");
        assert!(why.len() > 10, "{field}: {why}");
        assert!(*field > before, "{field} stands after {before}; the order is alphabetical");
        assert_eq!(reason(field), Some(*why), "the reason of {field}");
        before = field;
    }
}

/// Law: each field that scene files have is seen by a golden or has a reason, and none has both. Oracle: the pictures.
#[test]
#[ignore = "minutes"]
fn the_goldens_see_every_field_or_there_is_a_reason() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../goldens");
    let goldens = Goldens::open(Path::new(folder)).expect("the goldens are there");
    let found = controls(&Program::OURS, &goldens);
    for field in vocabulary() {
        let is_seen = found.seen.contains(&field);
        let said_by = found.unseen.get(&field);
        assert_ne!(
            is_seen,
            reason(&field).is_some(),
            "{field}: seen by a golden? {is_seen}; unseen, but said by {said_by:?}"
        );
    }
}
