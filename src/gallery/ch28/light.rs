//! What transparent things do to the light on others.

use super::super::parts::*;
use super::{in_air, medium};
use crate::lights::Area;
use crate::materials::{Dielectric, Emissive};
use crate::math::Vector;
use crate::rgb::Rgb;
use crate::scene::{Depth, Light, Scene, Tracer, Transparency, TransparentShadows, Whitted};
use crate::shapes::Rectangle;

/// Figure 28.42. Sphere and samples are as in the book, the other numbers are ours.
pub fn caustic() -> Scene {
    let about = "figure 28.42: a red glass sphere gathers light into a caustic in its shadow";
    let stand = [point(0.0, 4.5, 9.0), point(0.3, 0.6, 0.0)];
    let mut scene = pinhole(about, [400, 300], stand, 700.0);
    scene.image.samples = 256;
    scene.tracer = Tracer::Path(Depth { max_depth: 8 });
    scene.background = grey(0.1).into();
    let lamp = sphere(point(-5.0, 8.0, 1.0), 1.5);
    add(&mut scene, "lamp", lamp, Emissive::new(20.0, Rgb::WHITE));
    let source = Area { object: "lamp".to_owned(), sampling: None };
    scene.lights.push(Light::new("lamp", source));
    let red = Dielectric { inside: medium(1.5, rgb(0.9, 0.35, 0.3)), ..Dielectric::default() };
    add(&mut scene, "glass", sphere(point(0.0, 1.2, 0.0), 1.0), red);
    let (corner, side) = (point(-5.0, 0.0, -5.0), 10.0);
    let floor = Rectangle { corner, a: side * Vector::Z, b: side * Vector::X };
    add(&mut scene, "floor", floor, matte(0.0, 0.8, Rgb::WHITE));
    scene
}

/// Two balls and a pane of tinted glass on a white floor, with these shadows.
pub fn shadows(about: &str, shadows: TransparentShadows) -> Scene {
    let stand = [point(0.0, 5.0, 9.0), point(0.2, 0.6, 0.0)];
    let mut scene = pinhole(about, [600, 400], stand, 900.0);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 6 });
    scene.transparency = Transparency { shadows, ..Transparency::default() };
    scene.background = rgb(0.7, 0.8, 0.95).into();
    scene.lights.push(ambient(0.3));
    scene.lights.push(directional("sun", vector(-3.0, 5.0, 2.0), 2.2));
    for (name, x, cf) in
        [("red ball", -2.0, rgb(0.9, 0.3, 0.3)), ("blue ball", 0.3, rgb(0.3, 0.5, 0.95))]
    {
        add(&mut scene, name, sphere(point(x, 1.0, 0.0), 1.0), in_air(medium(1.5, cf)));
    }
    let pane = boxed(point(1.8, 0.01, -1.0), point(2.0, 2.0, 1.0));
    add(&mut scene, "green pane", pane, in_air(medium(1.5, rgb(0.02, 0.6, 0.05))));
    add(&mut scene, "floor", ground(0.0), matte(0.8, 0.8, Rgb::WHITE));
    scene
}
