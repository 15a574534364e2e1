//! What the laws of both languages share: scenes, and numbers that are the same.

use groundtruth::cameras::{Kind, Pinhole, Viewpoint};
use groundtruth::math::{Point, Ray, Span, Step, Vector};
use groundtruth::render;
use groundtruth::scene::build::{add, directional, ground, matte, pinhole, point, rgb, vector};
use groundtruth::scene::{Image, Light, Scene};
use groundtruth::shapes;
use groundtruth::world::World;

/// A few roundings of numbers of magnitude 1 to 100.
const ROUNDING: f64 = 1e-12;

pub fn near(found: f64, expected: f64) {
    let error = (found - expected).abs();
    assert!(error <= ROUNDING * (1.0 + expected.abs()), "found {found}, expected {expected}");
}

pub fn near_all(found: &[f64], expected: [f64; 3]) {
    assert_eq!(found.len(), 3);
    found.iter().zip(expected).for_each(|(found, expected)| near(*found, expected));
}

pub fn unit(numbers: [f64; 3]) -> [f64; 3] {
    Vector::from(numbers).unit().expect("not zero").to_array()
}

/// The law's pinhole.
pub fn narrow() -> Pinhole {
    Pinhole { distance: 6.0, zoom: 1.0 }
}

/// A red object under a sun, by a camera that is askew: no axis along those of the world, no side like another.
pub fn askew(lens: impl Into<Kind>, shape: impl Into<shapes::Kind>) -> Scene {
    let camera = Viewpoint::new(point(3.0, 4.0, 7.0), point(-1.0, 0.5, 0.25), lens);
    let image = Image { pixel_size: 0.25, ..Image::new(9, 5) };
    let mut scene = Scene::new("askew", image, Viewpoint { roll: 20.0, ..camera });
    add(&mut scene, "red", shape, matte(0.0, 0.8, rgb(0.9, 0.2, 0.1)));
    scene.lights.push(directional("sun", vector(1.0, 2.0, 3.0), 1.0));
    scene
}

/// A matte plane y = 0 that a camera 8 above it looks down on, near the origin, at half the exposure.
pub fn plane_below(light: Light) -> Scene {
    let mut scene = pinhole("a plane", [1, 1], [point(0.0, 8.0, 0.0), Point::ORIGIN], 100.0);
    scene.image.samples = 1;
    scene.camera.exposure_time = 0.5;
    add(&mut scene, "floor", ground(0.0), matte(0.25, 0.8, rgb(0.9, 0.4, 0.1)));
    scene.lights.push(light);
    scene
}

/// Our value of the first pixel.
pub fn ours(scene: &Scene) -> [f64; 3] {
    render::pixel(&World::build(scene).expect("it is valid"), [0, 0]).to_array()
}

/// A reflection that turns: the side of a triangle's normal changes with its corners.
pub fn mirrored() -> Vec<Step> {
    vec![Step::Scale(vector(-1.0, 1.0, 2.0)), Step::RotateZ(40.0)]
}

/// Each triangle is where ours is; whether its normal, `(b − a) × (c − a)`, is ours. Oracle: our hit of a ray through its centre.
pub fn are_fronts(scene: &Scene, triangles: &[[Vector; 3]]) -> Vec<bool> {
    let world = World::build(scene).expect("it is valid");
    let is_front = |[a, b, c]: &[Vector; 3]| {
        let normal = (*b - *a).cross(*c - *a).unit().expect("an area");
        let middle = Point::ORIGIN + (*a + *b + *c) / 3.0;
        let ray = Ray::new(middle + 1e-3 * normal, -normal);
        let hit = world.hit(&ray, Span::AHEAD).expect("it is there");
        near_all(&hit.surface.point.to_array(), middle.to_array());
        near(hit.surface.normal.dot(normal).abs(), 1.0);
        hit.surface.normal.dot(normal) > 0.0
    };
    triangles.iter().map(is_front).collect()
}
