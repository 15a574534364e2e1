//! The table of kinds: whole, as the page says it, and true.

use std::fs;
use std::path::Path;

use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::lights::Area;
use groundtruth::materials::{Emissive, Matte};
use groundtruth::math::Point;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Image, Light, Material, Object, Scene};
use groundtruth::{cameras, lights, materials, shapes, textures};
use harness::export::{How, Row, kinds, pbrt, pov};

/// Law: docs/renderers.md has a line for each kind of shape, material, light and camera, and no other.
#[test]
fn the_page_has_the_table_of_kinds() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/renderers.md");
    let page = fs::read_to_string(file).expect("the page is there");
    let line = |Row { list, kind, pov, note, pbrt: (pbrt, pbrt_note) }: &Row| {
        format!("| {list} | `{kind}` | {} | {note} | {} | {pbrt_note} |", pov.word(), pbrt.word())
    };
    let expected: Vec<String> = kinds().iter().map(line).collect();
    let is_row = |line: &&str| {
        ["shape", "material", "texture", "light", "camera"]
            .iter()
            .any(|list| line.starts_with(&format!("| {list} |")))
    };
    let found: Vec<&str> = page.lines().filter(is_row).collect();
    assert_eq!(found, expected, "write the table as it is:\n{}", expected.join("\n"));
}

fn empty() -> Scene {
    let lens = Pinhole { distance: 10.0, zoom: 1.0 };
    let eye = Viewpoint::new(Point::new(0.0, 0.0, 5.0), Point::ORIGIN, lens);
    let mut scene = Scene::new("one kind", Image::new(4, 4), eye);
    let matte = Matte { ka: 0.1.into(), kd: 0.5.into(), cd: Rgb::WHITE.into() };
    // parts of specimens may name any
    scene.materials.push(Material::new("grey", matte));
    scene
}

fn check(what: &str, how: How, scene: &Scene) {
    let said = pov::write("scene", scene);
    assert_eq!(said.is_ok(), how != How::None, "{what}: {:?}", said.err());
}

/// Law: a kind that the table calls sayable is written, and any other is refused.
#[test]
fn the_table_is_true() {
    for entry in shapes::Kind::ENTRIES {
        let Some(shape) = (entry.specimens)().into_iter().next() else { continue };
        let (how, _) = kinds::pov_shape(&shape);
        let mut scene = empty();
        scene.objects.push(Object::new("it", "grey", shape));
        check(entry.module, how, &scene);
    }
    for entry in lights::Kind::ENTRIES {
        let Some(light) = (entry.specimens)().into_iter().next() else { continue };
        let (how, _) = kinds::pov_light(&light);
        let mut scene = empty();
        scene.lights.push(Light::new("it", light));
        check(entry.module, how, &scene);
    }
    for entry in textures::Kind::ENTRIES {
        // the last has plain colours
        let Some(texture) = (entry.specimens)().pop() else { continue };
        let (how, _) = kinds::pov_texture(&texture);
        let mut scene = empty();
        let cd = textures::Paint::Textured(Box::new(texture));
        scene.materials.push(Material::new("it", Matte { ka: 0.1.into(), kd: 0.5.into(), cd }));
        let sphere = shapes::Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
        scene.objects.push(Object::new("ball", "it", sphere));
        check(entry.module, how, &scene);
    }
    for entry in cameras::Kind::ENTRIES {
        let Some(lens) = (entry.specimens)().into_iter().next() else { continue };
        let (how, _) = kinds::pov_camera(&lens);
        let mut scene = empty();
        scene.camera.lens = lens;
        check(entry.module, how, &scene);
    }
}

/// Law: so for materials, whose specimens have highlights, which are refused: without those.
#[test]
fn the_table_of_materials_is_true() {
    for entry in materials::Kind::ENTRIES {
        let Some(mut recipe) = (entry.specimens)().into_iter().next() else { continue };
        match &mut recipe {
            materials::Kind::Phong(it) => it.ks = 0.0.into(),
            materials::Kind::Reflective(it) => it.phong.ks = 0.0.into(),
            materials::Kind::Emissive(it) => it.matte = None,
            _ => {}
        }
        let (how, _) = kinds::pov_material(&recipe);
        let mut scene = empty();
        scene.materials.push(Material::new("it", recipe));
        let sphere = shapes::Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
        scene.objects.push(Object::new("ball", "it", sphere));
        check(entry.module, how, &scene);
    }
}

/// A scene for pbrt: both sides of surfaces reflect, and the camera is in none of the planes of specimens.
fn seen_from_above() -> Scene {
    let mut scene = empty();
    scene.camera.eye = Point::new(0.25, 3.0, 5.0);
    scene.materials[0].two_sided = true;
    scene.materials.push(Material::new("lamp", Emissive::new(2.0, Rgb::WHITE)));
    let ball = shapes::Sphere { center: Point::new(0.0, 90.0, 0.0), radius: 1.0, inward: false };
    scene.objects.push(Object::new("lamp", "lamp", ball));
    scene
        .lights
        .push(Light::new("of the lamp", Area { object: "lamp".to_owned(), sampling: None }));
    scene
}

fn check_pbrt(what: &str, (how, _): (How, &str), scene: &Scene) {
    let said = pbrt::write("scene", scene, Path::new("")).unwrap_or_else(|e| panic!("{what}: {e}"));
    assert_eq!(said.is_ok(), how != How::None, "{what}: {:?}", said.err());
}

/// Law: so for pbrt.
#[test]
fn the_table_of_pbrt_is_true() {
    for entry in shapes::Kind::ENTRIES {
        let Some(shape) = (entry.specimens)().into_iter().next() else { continue };
        let how = pbrt::kinds::shape(&shape);
        let mut scene = seen_from_above();
        scene.objects.push(Object::new("it", "grey", shape));
        check_pbrt(entry.module, how, &scene);
    }
    for entry in lights::Kind::ENTRIES {
        let Some(light) = (entry.specimens)().into_iter().next() else { continue };
        let how = pbrt::kinds::light(&light);
        let mut scene = seen_from_above();
        scene.lights = vec![Light::new("it", light)];
        check_pbrt(entry.module, how, &scene);
    }
    for entry in cameras::Kind::ENTRIES {
        let Some(lens) = (entry.specimens)().into_iter().next() else { continue };
        let how = pbrt::kinds::camera(&lens);
        let mut scene = seen_from_above();
        scene.camera.lens = lens;
        check_pbrt(entry.module, how, &scene);
    }
}

/// Law: so for the materials and textures of pbrt.
#[test]
fn the_table_of_looks_of_pbrt_is_true() {
    let ball = || shapes::Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
    for entry in materials::Kind::ENTRIES {
        let Some(mut recipe) = (entry.specimens)().into_iter().next() else { continue };
        match &mut recipe {
            materials::Kind::Phong(it) => it.ks = 0.0.into(),
            materials::Kind::Reflective(it) => it.phong.ks = 0.0.into(),
            materials::Kind::Emissive(it) => it.matte = None,
            materials::Kind::Dielectric(it) => it.phong = materials::Phong::default(),
            _ => {}
        }
        let how = pbrt::kinds::material(&recipe);
        let mut scene = seen_from_above();
        scene.materials.push(Material::new("it", recipe));
        scene.objects = vec![Object::new("ball", "it", ball())];
        scene.lights.clear();
        check_pbrt(entry.module, how, &scene);
    }
    for entry in textures::Kind::ENTRIES {
        let Some(mut texture) = (entry.specimens)().pop() else { continue };
        match &mut texture {
            textures::Kind::PlaneChecker(it) => it.outline_width = 0.0,
            // the specimen needs a mesh with texture coordinates
            textures::Kind::Image(_) => continue,
            _ => {}
        }
        let how = pbrt::kinds::texture(&texture);
        let mut scene = seen_from_above();
        let cd = textures::Paint::Textured(Box::new(texture));
        scene.materials.push(Material::new("it", Matte { ka: 0.1.into(), kd: 0.5.into(), cd }));
        scene.objects.push(Object::new("ball", "it", ball()));
        check_pbrt(entry.module, how, &scene);
    }
}
