//! Chapter 25: glossy reflection.

use super::List;
use super::ch24::hall_of_mirrors;
use groundtruth::lobes::GlossyRule;
use groundtruth::materials::{GlossyReflector, Kind as MaterialKind, Phong};
use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Scene, Tracer, Whitted};
use groundtruth::shapes::{Disk, Rectangle};

pub const SCENES: List = &[
    ("ch25/sphere", || {
        let about =
            "figure 25.7: a glossy sphere (e = 10) in uniform surroundings: a constant colour";
        in_uniform_surroundings(about, GlossyRule::Book)
    }),
    ("ch25/sphere-normalised", || {
        let about = "as figure 25.7, normalised: darker towards the outline, by about the cosine of the viewer's angle";
        in_uniform_surroundings(about, GlossyRule::Normalised)
    }),
    ("ch25/boxes", boxes),
    ("ch25/glossy-hall", glossy_hall),
    ("ch25/sphere-over-checker", over_checker),
];

fn glossy(phong: Phong, kr: f64, exponent: f64) -> GlossyReflector {
    GlossyReflector {
        phong,
        kr: kr.into(),
        cr: Rgb::WHITE.into(),
        exponent: exponent.into(),
        rule: GlossyRule::Book,
    }
}

fn in_uniform_surroundings(about: &str, rule: GlossyRule) -> Scene {
    let view = [point(0.0, 0.0, 20.0), Point::ORIGIN];
    let mut scene = pinhole(about, [400, 400], view, 3500.0);
    scene.image.samples = 100;
    scene.background = rgb(0.8, 0.9, 1.0).into();
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 1 });
    let finish = GlossyReflector { rule, ..glossy(Phong::default(), 0.8, 10.0) };
    add(&mut scene, "sphere", sphere(Point::ORIGIN, 1.0), finish);
    scene
}

/// The exponents are the book's; the positions of the boxes are ours.
fn boxes() -> Scene {
    let about = "figure 25.9: four boxes of e = 100000, 10000, 1000 and 100 over a checker";
    let mut scene =
        pinhole(about, [600, 300], [point(0.0, 6.0, 16.0), point(0.0, 1.3, 0.0)], 700.0);
    scene.image.samples = 100;
    scene.background = grey(0.5).into();
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 2 });
    scene.lights.push(ambient(0.5));
    scene.lights.push(directional("sun", vector(10.0, 20.0, 20.0), 2.5));
    for (i, exponent) in [1e5, 1e4, 1e3, 100.0].into_iter().enumerate() {
        let left = -5.9 + 3.1 * i as f64;
        let slab = boxed(point(left, 0.0, -1.0), point(left + 2.4, 4.0, 1.0));
        let finish = glossy(phong(0.3, 0.3, rgb(0.3, 0.5, 0.7), 0.0, 1.0), 0.5, exponent);
        add(&mut scene, &format!("box of {exponent}"), slab, finish);
    }
    let floor = matte(0.5, 0.7, checker3d(1.5, Rgb::WHITE, grey(0.35)));
    let (corner, side) = (point(-40.0, 0.0, -40.0), 80.0);
    let floor_shape = Rectangle { corner, a: side * Vector::Z, b: side * Vector::X };
    add(&mut scene, "floor", floor_shape, floor);
    scene
}

fn glossy_hall() -> Scene {
    let mut scene = hall_of_mirrors();
    scene.about = "figure 25.10: the hall of mirrors with glossy mirrors (e = 25000)".to_owned();
    scene.image.samples = 64;
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 10 });
    for material in &mut scene.materials {
        if let MaterialKind::Reflective(mirror) = &material.recipe
            && material.name.ends_with("mirror")
        {
            let (phong, cr) = (mirror.phong.clone(), mirror.cr.clone());
            let blurred = glossy(phong, 1.0, 25_000.0);
            material.recipe = GlossyReflector { kr: mirror.kr.clone(), cr, ..blurred }.into();
        }
    }
    scene
}

/// The exponent is the book's; the rest of the numbers is ours.
fn over_checker() -> Scene {
    let about = "figure 25.12: a glossy sphere (e = 100) over a checker, sharp near the contact";
    let mut scene =
        pinhole(about, [400, 400], [point(4.0, 3.5, 9.0), point(0.0, 0.9, 0.0)], 1100.0);
    scene.image.samples = 100;
    scene.background = rgb(0.6, 0.7, 0.8).into();
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 2 });
    scene.lights.push(ambient(0.5));
    scene.lights.push(point_light("lamp", point(10.0, 20.0, 10.0), 2.5));
    let finish = glossy(phong(0.05, 0.1, Rgb::WHITE, 0.2, 2000.0), 0.9, 100.0);
    add(&mut scene, "sphere", sphere(point(0.0, 1.0, 0.0), 1.0), finish);
    let disk = Disk { center: Point::ORIGIN, normal: Vector::Y, radius: 30.0 };
    add(&mut scene, "floor", disk, matte(0.5, 0.7, checker3d(0.7, Rgb::WHITE, rgb(0.6, 0.2, 0.1))));
    scene
}
