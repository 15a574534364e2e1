//! The table of kinds: whole, as the page says it, and true; and scenes of their specimens.

use std::fs;

use exchange::export::{AnyKind, How, KindRow, Target, Term, kinds};
use groundtruth::cameras::ThinLens;
use groundtruth::kinds::Entry;
use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::{add, directional, matte, pinhole, point, sphere};
use groundtruth::scene::{Depth, Light, Object, Scene, Tracer, Whitted};
use groundtruth::textures::Paint;
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
    let line = |KindRow { list, kind, cells }: &KindRow| {
        let cells: Vec<String> = cells.iter().map(cell).collect();
        format!("| {list} | `{kind}` | {} |", cells.join(" | "))
    };
    let expected: Vec<String> = kinds().iter().map(line).collect();
    let is_row =
        |line: &&str| lists().iter().any(|(list, _)| line.starts_with(&format!("| {list} |")));
    let found: Vec<&str> = page.lines().filter(is_row).collect();
    assert_eq!(found, expected, "write the table as it is:\n{}", expected.join("\n"));
}

/// The specimens of each kind of each list.
pub fn lists() -> [(&'static str, Vec<Vec<AnyKind>>); 5] {
    fn of<K>(entries: &[Entry<K>], any: fn(K) -> AnyKind) -> Vec<Vec<AnyKind>> {
        let specimens =
            |entry: &Entry<K>| (entry.specimens)().into_iter().map(any).collect::<Vec<_>>();
        entries.iter().map(specimens).filter(|all| !all.is_empty()).collect()
    }
    [
        ("shape", of(shapes::Kind::ENTRIES, AnyKind::Shape)),
        ("material", of(materials::Kind::ENTRIES, AnyKind::Material)),
        ("light", of(lights::Kind::ENTRIES, AnyKind::Light)),
        ("texture", of(textures::Kind::ENTRIES, AnyKind::Texture)),
        ("camera", of(cameras::Kind::ENTRIES, AnyKind::Camera)),
    ]
}

/// A scene that a target can say, with these specimens of one list: materials on balls in a row, without highlights,
/// which are refused; textures on a rectangle each.
pub fn combined(target: Target, specimens: &[AnyKind]) -> Scene {
    let mut scene = pinhole("kinds", [4, 4], [point(0.0, 0.0, 50.0), Point::ORIGIN], 10.0);
    scene.image.samples = 1;
    scene.tracer = match (specimens, target) {
        // tracers that see all of a material
        ([AnyKind::Material(_), ..], Target::Mitsuba) => Tracer::Path(Depth { max_depth: 2 }),
        ([AnyKind::Material(_), ..], Target::Pov) => Tracer::Whitted(Whitted { max_depth: 2 }),
        _ => Tracer::RayCast,
    };
    if let ([AnyKind::Light(_), ..], Target::Mitsuba) = (specimens, target) {
        // a lens is drawn from: then several lights can be said
        scene.camera.lens =
            ThinLens { distance: 40.0, focal_distance: 74.0, lens_radius: 1.0, zoom: 0.5 }.into();
    }
    scene.lights.push(directional("sun", Vector::Y, 1.0));
    let floor = shapes::Rectangle { corner: Point::ORIGIN, a: Vector::X, b: Vector::Z };
    add(&mut scene, "grey", floor.clone(), matte(0.1, 0.5, Rgb::WHITE));
    for (index, specimen) in (0..).zip(specimens) {
        let name = format!("it {index}");
        match specimen.clone() {
            AnyKind::Shape(it) => scene.objects.push(Object::new(&name, "grey", it)),
            AnyKind::Material(mut it) => {
                // the reflectances of a blend add up to at most 1
                if let materials::Kind::Reflective(it) = &mut it {
                    it.kr = 0.25.into();
                }
                let ball = sphere(point(3.0 * f64::from(index), 5.0, 0.0), 1.0);
                add(&mut scene, &name, ball, it);
            }
            AnyKind::Light(it) => {
                if let lights::Kind::Area(area) = &it {
                    let lamp = materials::Emissive::new(1.0, Rgb::WHITE);
                    add(&mut scene, &area.object, floor.clone(), lamp);
                }
                scene.lights.push(Light::new(&name, it));
            }
            AnyKind::Texture(it) => {
                let cd = Paint::Textured(Box::new(it));
                add(&mut scene, &name, floor.clone(), matte(0.1, 0.5, cd));
            }
            AnyKind::Camera(it) => scene.camera.lens = it,
        }
    }
    Term::Phong.remove(&mut scene);
    scene
}

/// Whether a target can say a scene with this specimen.
pub fn can_write(target: Target, specimen: &AnyKind) -> bool {
    let scene = combined(target, std::slice::from_ref(specimen));
    target.write("scene", "scene", &scene, "".as_ref()).is_ok()
}

/// Law: a kind that the table calls exported is written, at least one of its specimens, and of any other none.
#[test]
fn the_table_is_true() {
    for target in Target::ALL {
        for kind in lists().into_iter().flat_map(|(_, kinds)| kinds) {
            let is_exported = !matches!(target.how(&kind[0]), How::None(_));
            let is_written = kind.iter().any(|specimen| can_write(target, specimen));
            assert_eq!(is_written, is_exported, "{:?} for {target:?}", kind[0]);
        }
    }
}
