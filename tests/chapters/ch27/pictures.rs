//! What glass does to whole pictures, against closed forms of geometrical optics.

use groundtruth::render::{film_point, render};
use groundtruth::textures::{Checker3d, Kind as Texture};

use super::{ball, glass};
use crate::prelude::*;

/// Emissive cubes in two colours. They are not their own mirror image, as no border passes through the
/// origin.
fn checker(size: f64) -> Emissive {
    let checker =
        Checker3d { size, color1: Rgb::WHITE.into(), color2: Rgb::new(0.8, 0.3, 0.1).into() };
    Emissive::new(1.0, Paint::from(Texture::from(checker)))
}

fn picture(scene: &mut Scene, side: u32, pixel_size: f64) {
    (scene.image.width, scene.image.height, scene.image.pixel_size) = (side, side, pixel_size);
}

/// Law: a wall seen at an angle through a slab is the same picture, moved by `s = T sin(θ_i − θ_t)/cosθ_t`
/// towards the foot of the normal, and `k_t²` times as bright. Oracle: the picture without glass, four rows
/// further down, with pixels of the side s/4.
/// Book: the transmitted radiance: k_t/η².
#[test]
fn a_wall_behind_a_slab_is_seen_shifted() {
    const ROWS: u32 = 4;
    let theta = std::f64::consts::FRAC_PI_4;
    let theta_t = std::f64::consts::FRAC_PI_2 - acos(sin(theta) / 1.5);
    let shift = sin(theta - theta_t) / cos(theta_t);
    let mut scene = deep_stage(Rgb::BLACK, 2);
    scene.camera.eye = Point::new(-10.0, 10.0, 0.0);
    picture(&mut scene, 32, shift / f64::from(ROWS));
    let slab = boxed(Point::new(-50.0, -1.0, -50.0), Point::new(50.0, 0.0, 50.0));
    let slab = put(&mut scene, slab, glass(0.0, 0.9, 1.5));
    put(&mut scene, Plane { point: Point::new(0.0, -3.0, 0.0), normal: Vector::Y }, checker(0.37));
    let through = render(&built(&scene));
    scene.objects[slab].enabled = false;
    let without = render(&built(&scene));
    let mut moved = 0;
    for (x, y) in (0..32 * (32 - ROWS)).map(|i| (i % 32, i / 32)) {
        let expected = 0.81 * without.get([x, y + ROWS]);
        let seen = through.get([x, y]);
        close!(seen, expected, 16.0 * U, "[{x}, {y}]");
        moved += u32::from(without.get([x, y]) != without.get([x, y + ROWS]));
    }
    assert!(moved > 200, "a shift would be seen in {moved} pixels only");
}

/// Law: a ball of glass shows the wall behind it upside down. A ray at distance b from the axis is turned by
/// `δ = 2 (θ_i − θ_t)`, `sinθ_i = b = η sinθ_t`. It leaves the ball at the angle `2θ_t − θ_i` from the axis,
/// meets the wall at `sin(2θ_t − θ_i) − tanδ (D − cos(2θ_t − θ_i))`, and has the weight k_t². Oracle: the
/// wall at that point, without glass; near the axis the point is on the other side, as D lies beyond the
/// focus at 1.5 radii.
/// Book: the image in a glass ball.
#[test]
fn a_ball_of_glass_turns_the_wall_behind_it_around() {
    const D: f64 = 2.5;
    let mut scene = deep_stage(Rgb::BLACK, 2);
    picture(&mut scene, 48, 0.0413);
    let sphere = put(&mut scene, ball(), glass(0.0, 0.9, 1.5));
    let wall = Plane { point: Point::new(0.0, 0.0, -D), normal: Vector::Z };
    let aside = vec![
        Step::Translate(Vector::new(0.21, 0.13, 0.1 + D)),
        Step::Translate(Vector::new(0.0, 0.0, -0.1 - D)),
    ];
    put(&mut scene, Instance::new(wall, aside), checker(0.31));
    let through = render(&built(&scene));
    scene.objects[sphere].enabled = false;
    let without = built(&scene);
    let (mut turned, mut other) = (0, 0);
    for at in (0..48 * 48).map(|i| [i % 48, i / 48]) {
        let [x, y] = film_point(&scene.image, at, [0.5; 2]);
        let b = (x * x + y * y).sqrt();
        let angle = |sine: f64| atan2(sine, ((1.0 - sine) * (1.0 + sine)).sqrt());
        let wall = |scale: f64| look(&without, Point::new(scale * x, scale * y, 5.0), -Vector::Z);
        if b >= 1.0 {
            assert_eq!(through.get(at), wall(1.0), "{at:?} is beside the ball");
            continue;
        }
        let (i, t) = (angle(b), angle(b / 1.5));
        let delta = 2.0 * (i - t);
        if delta > 1.4 {
            continue; // nearly along the wall, or away from it
        }
        let place = sin(2.0 * t - i) - tan(delta) * (D - cos(2.0 * t - i));
        let expected = 0.81 * wall(place / b);
        let seen = through.get(at);
        close!(seen, expected, 16.0 * U, "{at:?}, b = {b}");
        turned += u32::from(place < 0.0);
        other += u32::from(wall(place / b) != wall(-place / b) && wall(place / b) != wall(1.0));
    }
    assert!(turned > 1000 && other > 150, "{turned} pixels are turned around, {other} tell");
}
