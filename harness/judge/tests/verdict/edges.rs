//! Pixels on edges, for renderers of single precision.

use std::f64::consts::PI;

use groundtruth::film::Film;
use groundtruth::math::Point;
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::world::World;
use judge::verdict::{Exclusion, RayTolerance, Stored};

/// A matte ball of this radius before a black background, 16 × 16 pixels without noise.
fn ball(radius: f64, ls: f64) -> World {
    let view = [point(0.0, 0.0, 10.0), Point::ORIGIN];
    let mut scene = pinhole("a ball", [16; 2], view, 16.0);
    scene.image.samples = 1;
    add(&mut scene, "ball", sphere(Point::ORIGIN, radius), matte(0.0, 0.5, Rgb::WHITE));
    scene.lights.push(directional("sun", vector(1.0, 1.0, 2.0), ls));
    World::build(&scene).expect("it is valid")
}

const STORED: Stored = Stored::Floats { bits: 24 };

/// The number of pixels of a picture that are set apart, and of those that still differ.
fn apart(theirs: &Film, ours: &World, tolerance: RayTolerance) -> (usize, usize) {
    let known = vec![STORED.values(&render::render(ours)); 3];
    let mut values = STORED.values(theirs);
    let apart = Exclusion { world: ours, stored: STORED, tolerance }.exclude(&mut values, &known);
    let differ = |(x, y): &(&f32, &f32)| (**x - **y).abs() > 1e-4 * y.abs();
    (apart.len(), values.iter().zip(&known[0]).filter(differ).count())
}

/// Law: for a renderer of single precision, a value between those of rays 0.03 pixels away is set apart, and no other, also on
/// edges. Oracle: pictures of balls that are a hundredth of a pixel larger, and of lamps that are 1 % brighter.
#[test]
fn only_values_between_those_of_near_rays_are_set_apart() {
    // a pixel is 10/16 units wide at the ball
    let (ours, larger) = (ball(4.0, PI), render::render(&ball(4.0 + 0.01 * 10.0 / 16.0, PI)));
    let (some, differ) = apart(&larger, &ours, RayTolerance::SINGLE);
    assert!(some > 50, "the shading differs everywhere: {some}");
    assert_eq!(differ, 0);
    let (_, differ) = apart(&larger, &ours, RayTolerance::DOUBLE);
    assert!(differ > 50, "{differ}");
    let brighter = render::render(&ball(4.0, 1.01 * PI));
    let (_, differ) = apart(&brighter, &ours, RayTolerance::SINGLE);
    assert!(differ > 50, "{differ}");
}
