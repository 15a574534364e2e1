//! The table of kinds: whole, as the page says it, and true.

use std::fs;

use exchange::export::{AnyKind, How, Row, Target, kinds};
use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::kinds::Entry;
use groundtruth::materials::Matte;
use groundtruth::math::Point;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Depth, Image, Light, Material, Object, Scene, Tracer, Whitted};
use groundtruth::{cameras, lights, materials, shapes, textures};

/// Law: docs/renderers.md has a line for each kind of shape, material, light and camera, and no other.
#[test]
fn the_page_has_the_table_of_kinds() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/renderers.md");
    let page = fs::read_to_string(file).expect("the page is there");
    let cell = |how: &How| match how.words() {
        (word, "") => word.to_owned(),
        (word, note) => format!("{word}: {note}"),
    };
    let line = |Row { list, kind, cells }: &Row| {
        let cells: Vec<String> = cells.iter().map(cell).collect();
        format!("| {list} | `{kind}` | {} |", cells.join(" | "))
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

/// A lit scene, for a target that sees nothing in the dark.
fn lit() -> Scene {
    let mut scene = empty();
    let direction = groundtruth::math::Vector::Y;
    let sun = lights::Directional { ls: 1.0, color: Rgb::WHITE, direction };
    scene.lights.push(Light::new("sun", sun));
    scene.background = Rgb::WHITE.into();
    scene
}

fn floor(material: &str) -> Object {
    use groundtruth::math::Vector;
    let [a, b] = [Vector::X, Vector::Z];
    Object::new("floor", material, shapes::Rectangle { corner: Point::ORIGIN, a, b })
}

/// A specimen with as few textured colours of its own as any.
fn plainest(entry: &Entry<textures::Kind>) -> Option<textures::Kind> {
    let textured = |it: &textures::Kind| format!("{it:?}").matches("Textured").count();
    (entry.specimens)().into_iter().min_by_key(textured)
}

fn check(what: &str, target: Target, kind: &AnyKind, scene: &Scene) {
    let said = target.write("scene", "scene", scene, "".as_ref());
    let is_said = !matches!(target.how(kind), How::None(_));
    assert_eq!(said.is_ok(), is_said, "{what} for {target:?}: {:?}", said.err());
}

/// Law: a kind that the table calls sayable is written, and any other is refused.
#[test]
fn the_table_is_true() {
    for target in [Target::Pov, Target::Mitsuba] {
        for entry in shapes::Kind::ENTRIES {
            let Some(shape) = (entry.specimens)().into_iter().next() else { continue };
            let mut scene = lit();
            scene.objects.push(Object::new("it", "grey", shape.clone()));
            check(entry.module, target, &AnyKind::Shape(shape), &scene);
        }
        for entry in lights::Kind::ENTRIES {
            let Some(light) = (entry.specimens)().into_iter().next() else { continue };
            let mut scene = lit();
            scene.objects.push(floor("grey"));
            scene.materials.push(Material::new("lamp", materials::Emissive::new(1.0, Rgb::WHITE)));
            scene.objects.push(Object { name: "lamp".into(), ..floor("lamp") });
            scene.lights.push(Light::new("it", light.clone()));
            check(entry.module, target, &AnyKind::Light(light), &scene);
        }
        for entry in textures::Kind::ENTRIES {
            let Some(texture) = plainest(entry) else { continue };
            let mut scene = lit();
            let cd = textures::Paint::Textured(Box::new(texture.clone()));
            scene.materials.push(Material::new("it", Matte { ka: 0.1.into(), kd: 0.5.into(), cd }));
            scene.objects.push(floor("it"));
            check(entry.module, target, &AnyKind::Texture(texture), &scene);
        }
        for entry in cameras::Kind::ENTRIES {
            let Some(lens) = (entry.specimens)().into_iter().next() else { continue };
            let mut scene = lit();
            scene.camera.lens = lens.clone();
            check(entry.module, target, &AnyKind::Camera(lens), &scene);
        }
    }
}

/// Law: so for materials, whose specimens have highlights, which are refused: without those, and with a tracer that sees
/// all of them.
#[test]
fn the_table_of_materials_is_true() {
    for target in [Target::Pov, Target::Mitsuba] {
        for entry in materials::Kind::ENTRIES {
            let Some(mut recipe) = (entry.specimens)().into_iter().next() else { continue };
            match &mut recipe {
                materials::Kind::Phong(it) => it.ks = 0.0.into(),
                materials::Kind::Reflective(it) => {
                    it.phong.ks = 0.0.into();
                    it.kr = 0.25.into();
                }
                materials::Kind::Dielectric(it) => it.phong.ks = 0.0.into(),
                materials::Kind::Transparent(it) => it.phong.ks = 0.0.into(),
                materials::Kind::Emissive(it) => it.matte = None,
                _ => {}
            }
            let mut scene = lit();
            scene.tracer = match target {
                Target::Mitsuba => Tracer::Path(Depth { max_depth: 2 }),
                _ => Tracer::Whitted(Whitted { max_depth: 2 }),
            };
            scene.materials.push(Material::new("it", recipe.clone()));
            let sphere = shapes::Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
            scene.objects.push(Object::new("ball", "it", sphere));
            check(entry.module, target, &AnyKind::Material(recipe), &scene);
        }
    }
}
