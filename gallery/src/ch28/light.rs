//! Caustics and shadows of transparent objects.

use super::{in_air, medium};
use groundtruth::lights::Area;
use groundtruth::materials::{Dielectric, Emissive, Medium};
use groundtruth::math::Vector;
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Depth, Light, Scene, Tracer, Transparency, TransparentShadows, Whitted};
use groundtruth::shapes::{Materials, Rectangle, SolidCylinder};

/// Figure 28.42. Sphere and samples are as in the book, the other numbers are ours.
pub fn caustic() -> Scene {
    let about = "figure 28.42: a red glass sphere focuses light to a caustic in its shadow";
    let view = [point(0.0, 4.5, 9.0), point(0.3, 0.6, 0.0)];
    let mut scene = pinhole(about, [400, 300], view, 700.0);
    scene.image.samples = 256;
    scene.tracer = Tracer::Path(Depth { max_depth: 8 });
    scene.background = grey(0.2).into();
    let lamp = sphere(point(-5.0, 8.0, 1.0), 2.5);
    add(&mut scene, "lamp", lamp, Emissive::new(8.0, Rgb::WHITE));
    let source = Area { object: "lamp".to_owned(), sampling: None };
    scene.lights.push(Light::new("lamp", source));
    let red = Dielectric { inside: medium(1.5, rgb(0.9, 0.35, 0.3)), ..Dielectric::default() };
    add(&mut scene, "glass", sphere(point(0.0, 1.2, 0.0), 1.0), red);
    let (corner, side) = (point(-5.0, 0.0, -5.0), 10.0);
    let floor = Rectangle { corner, a: side * Vector::Z, b: side * Vector::X };
    add(&mut scene, "floor", floor, matte(0.0, 0.8, Rgb::WHITE));
    scene
}

/// Three filters and a ball of tinted glass over a white floor, with these shadows.
pub fn shadows(about: &str, shadows: TransparentShadows) -> Scene {
    const THICKNESS: f64 = 0.05;
    let view = [point(0.0, 4.5, 10.0), point(0.2, 0.8, 0.0)];
    let mut scene = pinhole(about, [600, 400], view, 950.0);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 6 });
    scene.transparency = Transparency { shadows, ..Transparency::default() };
    scene.background = rgb(0.7, 0.8, 0.95).into();
    scene.lights.push(ambient(0.3));
    scene.lights.push(directional("sun", vector(-1.0, 4.0, -0.5), 2.2));
    let filters = [
        ("cyan", rgb(0.1, 1.0, 1.0), -1.9, -0.35),
        ("yellow", rgb(1.0, 1.0, 0.1), -0.9, -0.35),
        ("magenta", rgb(1.0, 0.1, 1.0), -1.4, 0.5),
    ];
    for (i, (name, cf, x, z)) in (0..).zip(filters) {
        let y0 = 1.7 + 0.2 * f64::from(i);
        let (y1, radius, materials) = (y0 + THICKNESS, 1.0, Materials::new());
        let disk = SolidCylinder { y0, y1, radius, materials };
        let glass = Medium { eta: 1.5, absorption: (1.0 / THICKNESS) * filter(cf) };
        add(&mut scene, name, moved(disk, vector(x, 0.0, z)), in_air(glass));
    }
    let amber = in_air(medium(1.5, rgb(0.9, 0.6, 0.2)));
    add(&mut scene, "ball", sphere(point(2.0, 1.0, 0.0), 1.0), amber);
    add(&mut scene, "floor", ground(0.0), matte(0.8, 0.8, Rgb::WHITE));
    scene
}
