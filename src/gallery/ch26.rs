//! Chapter 26: global illumination.

use super::List;
use super::parts::*;
use crate::cameras::{Pinhole, Viewpoint};
use crate::lights::Area;
use crate::materials::Emissive;
use crate::math::{Point, Vector};
use crate::rgb::Rgb;
use crate::scene::{Depth, Image, Light, Material, Object, Scene, Tracer};
use crate::shapes::Rectangle;

pub const SCENES: List = &[("ch26/cornell-box", cornell_box)];

/// The box of the figures 26.7 to 26.12, in units of 10 cm; rectangles by a corner and two sides.
const WHITE: [([f64; 3], [f64; 3], [f64; 3]); 13] = [
    // back wall, floor, ceiling
    ([0.0, 0.0, 55.92], [0.0, 54.88, 0.0], [55.28, 0.0, 0.0]),
    ([0.0, 0.0, 0.0], [0.0, 0.0, 55.92], [55.28, 0.0, 0.0]),
    ([0.0, 54.88, 0.0], [55.28, 0.0, 0.0], [0.0, 0.0, 55.92]),
    // short block: top and sides
    ([13.0, 16.5, 6.5], [-4.8, 0.0, 16.0], [16.0, 0.0, 4.9]),
    ([13.0, 0.0, 6.5], [-4.8, 0.0, 16.0], [0.0, 16.5, 0.0]),
    ([8.2, 0.0, 22.5], [15.8, 0.0, 4.7], [0.0, 16.5, 0.0]),
    ([24.2, 0.0, 27.4], [4.8, 0.0, -16.0], [0.0, 16.5, 0.0]),
    ([29.0, 0.0, 11.4], [-16.0, 0.0, -4.9], [0.0, 16.5, 0.0]),
    // tall block
    ([42.3, 33.0, 24.7], [-15.8, 0.0, 4.9], [4.9, 0.0, 15.9]),
    ([42.3, 0.0, 24.7], [-15.8, 0.0, 4.9], [0.0, 33.0, 0.0]),
    ([26.5, 0.0, 29.6], [4.9, 0.0, 15.9], [0.0, 33.0, 0.0]),
    ([31.4, 0.0, 45.5], [15.8, 0.0, -4.9], [0.0, 33.0, 0.0]),
    ([47.2, 0.0, 40.6], [-4.9, 0.0, -15.9], [0.0, 33.0, 0.0]),
];

/// The published sides are not quite perpendicular: the second is turned in the plane of both until it
/// is.
fn rectangle(corner: [f64; 3], a: [f64; 3], b: [f64; 3]) -> Rectangle {
    let (a, b) = (Vector::from(a), Vector::from(b));
    let b = b - (a.dot(b) / a.length_squared()) * a;
    Rectangle { corner: Point::from(corner), a, b }
}

fn cornell_box() -> Scene {
    let lens = Pinhole { distance: 400.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(27.6, 27.4, -80.0), point(27.6, 27.4, 0.0), lens);
    let image = Image { samples: 100, ..Image::new(300, 300) };
    let about = "figure 26.12: the Cornell box, whose red and green walls colour the white ones";
    let mut scene = Scene::new(about, image, camera);
    scene.tracer = Tracer::Path(Depth { max_depth: 10 });
    scene.lights.push(Light::new("lamp", Area { object: "lamp".to_owned(), sampling: None }));
    scene.materials.push(Material::new("lamp", Emissive::new(100.0, rgb(1.0, 0.73, 0.4))));
    let lamp = rectangle([21.3, 54.879, 22.7], [0.0, 0.0, 10.5], [13.0, 0.0, 0.0]);
    // it faces down
    let lamp = Rectangle { corner: lamp.corner + lamp.b, b: -lamp.b, ..lamp };
    scene.objects.push(Object::new("lamp", "lamp", lamp));
    let left = rectangle([55.28, 0.0, 0.0], [0.0, 0.0, 55.92], [0.0, 54.88, 0.0]);
    add(&mut scene, "left wall", left, matte(0.0, 0.6, rgb(0.57, 0.025, 0.025)));
    let right = rectangle([0.0, 0.0, 0.0], [0.0, 54.88, 0.0], [0.0, 0.0, 55.92]);
    add(&mut scene, "right wall", right, matte(0.0, 0.6, rgb(0.37, 0.59, 0.2)));
    let mut white = Material::new("white", matte(0.0, 0.6, Rgb::WHITE));
    white.two_sided = true;
    scene.materials.push(white);
    let names = ["back wall", "floor", "ceiling"].map(str::to_owned);
    let blocks = ["short", "tall"]
        .into_iter()
        .flat_map(|block| (1..6).map(move |i| format!("{block} block {i}")));
    for (name, (corner, a, b)) in names.into_iter().chain(blocks).zip(WHITE) {
        scene.objects.push(Object::new(&name, "white", rectangle(corner, a, b)));
    }
    scene
        .materials
        .iter_mut()
        .filter(|m| m.name.ends_with("wall"))
        .for_each(|m| m.two_sided = true);
    scene
}
