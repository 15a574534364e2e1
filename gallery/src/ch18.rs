//! Chapter 18: area lights and the environment light.

use super::List;
use groundtruth::lights::{Area, Directional, Environment, FakeSpherical, JitteredDirectional};
use groundtruth::materials::{Emissive, Kind as MaterialKind, Matte, Phong};
use groundtruth::math::{Point, Step, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Light, Scene};
use groundtruth::shapes::{Disk, Kind, Materials, Rectangle, SolidCylinder};

pub const SCENES: List = &[
    ("ch18/rectangle-one-sample", || {
        let about = "figure 18.4a: a rectangular light, one sample per pixel: noise in the shadows";
        let mut scene = lit_boxes(about, 40.0, square(4.0, 7.0));
        scene.image.samples = 1;
        scene
    }),
    ("ch18/rectangle", || {
        let about = "figure 18.4b: a rectangular light; shadows are softer at larger distances";
        lit_boxes(about, 40.0, square(4.0, 7.0))
    }),
    ("ch18/small-rectangle", || {
        let about = "figure 18.4c: a quarter of the light's area: less light, sharper shadows";
        lit_boxes(about, 40.0, square(2.0, 7.0))
    }),
    ("ch18/disk", || {
        let about = "figure 18.5a: a disk of about the square's area";
        let disk = Disk { center: LAMP, normal: Vector::Z, radius: LAMP_RADIUS };
        lit_boxes(about, 40.0, disk)
    }),
    ("ch18/sphere", || {
        let about = "figure 18.5b: a sphere, which also lights what is behind it";
        lit_boxes(about, 20.0, sphere(LAMP, LAMP_RADIUS))
    }),
    ("ch18/stretched-lamp", || {
        let about =
            "a sphere stretched to an ellipsoid as the lamp: its area is not stretched evenly";
        let steps = vec![Step::Scale(vector(5.0, 1.0, 0.5)), Step::Translate(LAMP - Point::ORIGIN)];
        lit_boxes(about, 20.0, transformed(sphere(Point::ORIGIN, 1.0), steps))
    }),
    ("ch18/mirrored-lamp", || {
        let about =
            "the square of figure 18.4 as a mirrored instance: it shines on the boxes as before";
        lit_boxes(
            about,
            40.0,
            transformed(square(4.0, 7.0), vec![Step::Scale(vector(-1.0, 1.0, 1.0))]),
        )
    }),
    ("ch18/on-the-ground", || {
        let about = "figure 18.6: a rectangular light on the ground: long shadows";
        lit_boxes(about, 40.0, square(4.0, 2.0))
    }),
    ("ch18/fake-spherical", fake_spherical),
    ("ch18/occlusion-only", || {
        solids("figure 18.7a: ambient occlusion alone", Rgb::WHITE, &[Part::Occlusion], plain)
    }),
    ("ch18/environment-only", || {
        solids("figure 18.7b: a white sky alone", Rgb::WHITE, &[Part::Sky], plain)
    }),
    ("ch18/environment", || {
        solids("figure 18.7c: a white sky and ambient occlusion", Rgb::WHITE, BOTH, plain)
    }),
    ("ch18/yellow-sky", || {
        solids("figure 18.8a: a yellow sky tints everything", rgb(1.0, 1.0, 0.5), BOTH, plain)
    }),
    ("ch18/blue-sky", || solids("figure 18.8b: a blue sky", rgb(0.5, 0.65, 0.75), BOTH, plain)),
    ("ch18/sunset", || {
        let about = "figure 18.9: an orange sun and a white sky, which lights the shadows";
        let source = Directional { ls: SUN_LS, color: SUN_COLOR, direction: SUN };
        with_sun(about, Light::new("sun", source))
    }),
    ("ch18/page-one", || {
        let about = "as the picture of page one: a sun jittered by 0.2 has soft shadows";
        let (ls, color, direction) = (SUN_LS, SUN_COLOR, SUN);
        with_sun(
            about,
            Light::new("sun", JitteredDirectional { ls, color, direction, jitter: 0.2 }),
        )
    }),
    ("ch18/glossy-10", || {
        let about =
            "figure 18.11a: red highlights of e = 10, where the mirror direction points to the sky";
        solids(about, Rgb::WHITE, BOTH, |matte| glossy(matte, 10.0))
    }),
    ("ch18/glossy-200", || {
        let about =
            "figure 18.11c: highlights of e = 200 collect little light of the sky: a faint red";
        solids(about, Rgb::WHITE, BOTH, |matte| glossy(matte, 200.0))
    }),
];

/// The centre of the lamps of figures 18.4 and 18.5.
const LAMP: Point = Point::new(0.0, 7.0, -7.0);
/// The radius of the disk and of the sphere.
const LAMP_RADIUS: f64 = 2.24;

/// A square in the plane of the lamps that faces the boxes, with its centre at height `y`.
fn square(side: f64, y: f64) -> Rectangle {
    let corner = point(-0.5 * side, y - 0.5 * side, LAMP.z());
    Rectangle { corner, a: side * Vector::X, b: side * Vector::Y }
}

/// Figures 18.4 to 18.6: four green boxes before a lamp of this shape and radiance.
fn lit_boxes(about: &str, ls: f64, lamp: impl Into<Kind>) -> Scene {
    let area = Area { object: "lamp".to_owned(), sampling: None };
    let mut scene = boxes(about, Light::new("lamp light", area));
    let (mut lamp, glow) = object("lamp", lamp, Emissive::new(ls, Rgb::WHITE));
    lamp.casts_shadows = false;
    scene.objects.push(lamp);
    scene.materials.push(glow);
    scene
}

/// Figure 18.12.
fn fake_spherical() -> Scene {
    let about = "figure 18.12: a point light jittered in a cube, like an invisible sphere";
    let source = FakeSpherical {
        ls: 250.0,
        color: Rgb::WHITE,
        location: LAMP,
        jitter: LAMP_RADIUS,
        attenuation: 2.0,
    };
    boxes(about, Light::new("fake sphere", source))
}

fn boxes(about: &str, light: Light) -> Scene {
    let view = [point(-20.0, 10.0, 20.0), point(0.0, 2.0, 0.0)];
    let mut scene = pinhole(about, [600, 600], view, 1080.0);
    scene.image.samples = 64;
    scene.background = grey(0.5).into();
    scene.lights.push(ambient(1.0));
    scene.lights.push(light);
    for (i, left) in (1..).zip([-6.5, -2.5, 1.5, 5.5]) {
        let shape = boxed(point(left, 0.0, -0.5), point(left + 1.0, 4.5, 0.5));
        add(&mut scene, &format!("box {i}"), shape, matte(0.25, 0.75, rgb(0.4, 0.7, 0.4)));
    }
    add(&mut scene, "ground", ground(0.0), matte(0.1, 0.9, Rgb::WHITE));
    scene
}

/// The lights of the solids of figures 18.7 to 18.11.
#[derive(Clone, Copy)]
pub(super) enum Part {
    Occlusion,
    Sky,
}
const BOTH: &[Part] = &[Part::Occlusion, Part::Sky];

/// The sun of figure 18.9.
const SUN: Vector = Vector::new(150.0, 50.0, -50.0);
const SUN_LS: f64 = 4.0;
const SUN_COLOR: Rgb = Rgb::new(1.0, 0.25, 0.0);

/// Figures 18.7 to 18.11: solids under a sky of this colour; `finish` makes their materials. The
/// scene's background is the visible sky and the radiance of the environment light.
pub(super) fn solids(
    about: &str,
    sky: Rgb,
    parts: &[Part],
    finish: impl Fn(Matte) -> MaterialKind,
) -> Scene {
    let view = [point(100.0, 45.0, 100.0), point(-10.0, 40.0, 0.0)];
    let mut scene = pinhole(about, [600, 400], view, 400.0);
    scene.image.samples = 64;
    scene.background = (0.9 * sky).into();
    scene.lights.extend(parts.iter().map(|part| match part {
        Part::Occlusion => occluder(0.5),
        Part::Sky => Light::new("sky", Environment {}),
    }));
    let cylinder = SolidCylinder { y0: 0.0, y1: 85.0, radius: 22.0, materials: Materials::new() };
    let solids: [(&str, Kind, f64, f64); 5] = [
        ("large sphere", sphere(point(38.0, 20.0, -24.0), 20.0).into(), 0.6, 0.75),
        ("small sphere", sphere(point(34.0, 12.0, 13.0), 12.0).into(), 0.5, 0.85),
        ("middle sphere", sphere(point(-7.0, 15.0, 42.0), 16.0).into(), 0.5, 0.75),
        ("cylinder", cylinder.into(), 0.5, 0.6),
        ("box", boxed(point(-35.0, 0.0, -110.0), point(-25.0, 60.0, 65.0)).into(), 0.5, 0.95),
    ];
    for (name, shape, kd, cd) in solids {
        add(&mut scene, name, shape, finish(matte(0.2, kd, grey(cd))));
    }
    add(&mut scene, "ground", ground(0.01), matte(0.15, 0.5, grey(0.7)));
    scene
}

fn with_sun(about: &str, sun: Light) -> Scene {
    let mut scene = solids(about, Rgb::WHITE, BOTH, plain);
    scene.lights.push(sun);
    scene
}

pub(super) fn plain(matte: Matte) -> MaterialKind {
    matte.into()
}

/// The red highlights of figure 18.11.
fn glossy(Matte { ka, kd, cd }: Matte, exponent: f64) -> MaterialKind {
    Phong { ka, kd, cd, ks: 1.0.into(), cs: rgb(1.0, 0.0, 0.0).into(), exponent: exponent.into() }
        .into()
}
