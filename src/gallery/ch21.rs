//! Chapter 21: instances.

use super::List;
use super::parts::*;
use crate::cameras::{Pinhole, Viewpoint};
use crate::math::{Pcg32, Point, Step, Vector};
use crate::scene::{Image, Scene};
use crate::shapes::{Compound, Kind, TessellatedSphere};
use crate::textures::{Kind as TextureKind, Paint, RandomColors};

pub const SCENES: List = &[
    ("ch21/many-meshes", many_meshes),
    ("ch21/ellipsoid", ellipsoid),
    ("ch21/squashed-spheres", squashed_spheres),
];

/// What the figures of this chapter stand in.
pub(super) fn stage(about: &str, eye: Point, look_at: Point, distance: f64) -> Scene {
    let camera = Viewpoint::new(eye, look_at, Pinhole { distance, zoom: 1.0 });
    let image = Image { samples: 16, ..Image::new(400, 400) };
    let mut scene = Scene::new(about, image, camera);
    scene.lights.push(ambient(0.25));
    scene
}

fn random_colors(seed: u64) -> Paint {
    Paint(TextureKind::from(RandomColors { seed }))
}

fn many_meshes() -> Scene {
    let about = "as figure 21.4: 8 × 8 instances of one bumpy mesh, turned at random, in a grid";
    let mut scene = stage(about, point(20.0, 30.0, 40.0), Point::ORIGIN, 900.0);
    scene.lights.push(directional("light", vector(1.0, 2.0, 0.5), 3.0));
    let mesh = TessellatedSphere { bumps: 0.15, ..TessellatedSphere::new(96, 48, true) };
    let mut random = Pcg32::new(1000, 0);
    let instance = |i: u32| {
        let place = |k: u32| 2.5 * f64::from(k) - 8.75;
        let steps = vec![
            Step::RotateX(360.0 * random.uniform()),
            Step::RotateY(360.0 * random.uniform()),
            Step::Translate(vector(place(i % 8), 0.0, place(i / 8))),
        ];
        transformed(mesh.clone(), steps)
    };
    let meshes =
        Compound { accel: Some(crate::accel::Method::Grid), ..Compound::of((0..64).map(instance)) };
    let (object, material) = object("meshes", meshes, matte(0.25, 0.75, random_colors(21)));
    scene.objects.push(object);
    scene.materials.push(material);
    scene
}

fn ellipsoid() -> Scene {
    let about =
        "figure 21.5b, plain: a unit sphere scaled (2, 3, 1), turned by −45° about x, raised by 1";
    let mut scene = stage(about, point(100.0, 0.0, 100.0), Point::new(0.0, 1.0, 0.0), 8000.0);
    scene.lights.push(point_light("lamp", point(100.0, 100.0, 60.0), 3.0));
    let steps =
        vec![Step::Scale(vector(2.0, 3.0, 1.0)), Step::RotateX(-45.0), Step::Translate(Vector::Y)];
    let (object, material) = object(
        "ellipsoid",
        transformed(sphere(Point::ORIGIN, 1.0), steps),
        phong(0.25, 0.75, rgb(1.0, 0.75, 0.0), 0.2, 20.0),
    );
    scene.objects.push(object);
    scene.materials.push(material);
    scene
}

fn squashed_spheres() -> Scene {
    let about = "as figure 21.15: 5 × 5 spheres, each scaled in y by four times a random number";
    let mut scene = stage(about, point(30.0, 40.0, 60.0), point(0.0, 1.0, 0.0), 2000.0);
    scene.lights.push(directional("light", vector(20.0, 25.0, 10.0), 3.0));
    let mut random = Pcg32::new(1000, 0);
    let ellipsoid = |i: u32| -> Kind {
        let height = 4.0 * random.uniform();
        let place =
            vector(2.25 * (f64::from(i % 5) - 2.0), height, 2.25 * (f64::from(i / 5) - 2.0));
        let steps = vec![Step::Scale(vector(1.0, height, 1.0)), Step::Translate(place)];
        transformed(sphere(Point::ORIGIN, 1.0), steps)
    };
    let spheres = Compound::of((0..25).map(ellipsoid));
    for (object, material) in [
        object("ellipsoids", spheres, phong(0.25, 0.75, random_colors(4), 0.2, 20.0)),
        object("ground", ground(0.0), matte(0.5, 0.5, grey(0.5))),
    ] {
        scene.objects.push(object);
        scene.materials.push(material);
    }
    scene
}
