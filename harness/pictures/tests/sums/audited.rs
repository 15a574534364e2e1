//! Audits of rows, also where values are not finite.

use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::film::Film;
use groundtruth::lights::Directional;
use groundtruth::materials::Matte;
use groundtruth::math::{Point, Vector};
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Image, Light, Material, Object, Scene};
use groundtruth::shapes::Sphere;
use groundtruth::world::World;
use pictures::sums::{Contradiction, MergeError, Sums, SumsFile, audit};

use super::header::header;
use crate::verbs::equal;

const SIDE: u32 = 8;

/// A ball in the upper half.
fn world() -> World {
    let lens = Pinhole { distance: 8.0, zoom: 1.0 };
    let eye = Viewpoint::new(Point::new(0.0, 0.0, 10.0), Point::ORIGIN, lens);
    let mut image = Image::new(SIDE, SIDE);
    image.samples = 1;
    let mut scene = Scene::new("a ball", image, eye);
    let matte = Matte { ka: 0.0.into(), kd: 1.0.into(), cd: Rgb::WHITE.into() };
    scene.materials.push(Material::new("matte", matte));
    let ball = Sphere { center: Point::new(0.0, 2.5, 0.0), radius: 1.5, inward: false };
    scene.objects.push(Object::new("ball", "matte", ball));
    let direction = Vector::new(0.0, 0.0, 1.0);
    scene.lights.push(Light::new("sun", Directional { ls: 3.0, color: Rgb::WHITE, direction }));
    World::build(&scene).expect("it is valid")
}

/// Law: an audit of any rows finds nothing in a right part, and each change of a value in one of them, also to one that is not
/// finite, by its pixel; of a change in another row it says nothing. Oracle: the renderer, and the pixel that was changed.
#[test]
fn an_audit_is_of_its_rows() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut world = world();
    let film = render::render(&world);
    let part = |film: &Film| {
        let mut sums = Sums::new(header([SIDE; 2]));
        sums.add(film, 3).expect("it fits");
        let file = folder.path().join("a.sums");
        sums.write(&file).expect("written");
        SumsFile::open(&file).expect("whole")
    };
    let right = part(&film);
    for rows in [vec![0], vec![7], vec![1, 2], (0..SIDE).collect()] {
        audit(&right, &mut world, &rows, || ())
            .unwrap_or_else(|error| panic!("rows {rows:?}: {error}"));
    }
    for (at, value) in [([3, 2], f64::NAN), ([0, 5], 0.25), ([7, 0], f64::INFINITY)] {
        let mut changed = film.clone();
        let [r, _, b] = film.get(at).to_array();
        changed.set(at, Rgb::new(r, value, b));
        let wrong = part(&changed);
        for row in 0..SIDE {
            let found = match audit(&wrong, &mut world, &[row], || ()) {
                Ok(()) => None,
                Err(MergeError::Contradiction(Contradiction::Audit { pixel, .. })) => Some(pixel),
                Err(error) => panic!("{error}"),
            };
            let expected = (row == at[1]).then_some(at);
            equal(format!("pixel that differs in row {row}"), found, expected);
        }
    }
}
