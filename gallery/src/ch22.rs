//! Chapter 22: regular grids.

use super::List;
use groundtruth::accel::Method;
use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::math::{Point, Step, cbrt};
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Material, Scene};
use groundtruth::shapes::{Compound, Instance, Kind, Part, RandomSpheres};
use groundtruth::textures::{Paint, RandomColors};

pub const SCENES: List = &[
    ("ch22/thousand-spheres", || {
        far_away("figure 22.11: a thousand random spheres of total volume 0.1", 1000)
    }),
    ("ch22/hundred-thousand-spheres", || {
        far_away("figure 22.11: a hundred thousand spheres of the same total volume", 100_000)
    }),
    ("ch22/in-the-grid", in_the_grid),
    ("ch22/squashed", squashed),
];

/// Random spheres in a grid; their total volume does not depend on their number.
fn random_spheres(count: u32) -> RandomSpheres {
    let volume = 0.1 / f64::from(count);
    let radius = cbrt(0.75 * volume / std::f64::consts::PI);
    RandomSpheres { count, radius, half_side: 1.0, seed: 15, accel: Some(Method::Grid) }
}

fn stage(
    about: &str,
    eye: Point,
    look_at: Point,
    distance: f64,
    spheres: impl Into<Kind>,
) -> Scene {
    let camera = Viewpoint::new(eye, look_at, Pinhole { distance, zoom: 1.0 });
    let mut scene = Scene::new(about, Image::new(400, 400), camera);
    scene.lights.push(ambient(0.25));
    scene.lights.push(directional("light", vector(-10.0, 20.0, 20.0), 3.0).without_shadows());
    let colors = Paint::from(RandomColors { seed: 15 });
    let (object, material) = object("spheres", spheres, matte(0.25, 0.75, colors));
    scene.objects.push(object);
    scene.materials.push(material);
    scene
}

fn far_away(about: &str, count: u32) -> Scene {
    let eye = point(0.0, 0.0, 20.0);
    stage(about, eye, Point::ORIGIN, 3600.0, random_spheres(count))
}

fn in_the_grid() -> Scene {
    let about = "figure 22.16: the camera inside the grid, in a box that is part of the grid";
    let eye = point(0.0, 0.0, 0.9);
    let room = boxed(point(-1.1, -1.1, -1.1), point(1.1, 1.1, 1.1));
    let mut scene = stage(about, eye, Point::ORIGIN, 150.0, random_spheres(1000));
    scene.objects[0].shape = Kind::from(Compound {
        accel: Some(Method::Grid),
        parts: vec![
            Part::new(random_spheres(1000)),
            Part { name: "room".into(), ..Part::new(room).of_material("room") },
        ],
    });
    let room = Material::new("room", matte(0.5, 0.75, grey(0.75)));
    scene.materials.push(Material { two_sided: true, ..room });
    scene
}

fn squashed() -> Scene {
    let about =
        "figure 22.18: grids of spheres, of squashed spheres, and a grid squashed as a whole";
    let eye = point(0.0, 3.0, 20.0);
    let squash = Step::Scale(vector(1.0, 0.25, 1.0));
    let plain = random_spheres(1000);
    let each = |sphere: groundtruth::shapes::Sphere| {
        let to = Step::Translate(sphere.center.to_vector());
        let at_origin = groundtruth::shapes::Sphere { center: Point::ORIGIN, ..sphere };
        Instance::new(at_origin, vec![squash.clone(), to])
    };
    let of_squashed = Compound {
        accel: Some(Method::Grid),
        ..Compound::of(plain.spheres().into_iter().map(each))
    };
    let whole = transformed(plain.clone(), vec![squash.clone()]);
    let side_by_side = Compound::of([
        moved(plain, vector(-2.3, 0.0, 0.0)),
        of_squashed.into(),
        moved(whole, vector(2.3, 0.0, 0.0)),
    ]);
    let mut scene = stage(about, eye, Point::ORIGIN, 1500.0, side_by_side);
    scene.image = Image { samples: 4, ..Image::new(600, 240) };
    scene
}
