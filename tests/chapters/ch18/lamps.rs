//! Lamps as objects: what they shadow, which side emits, and their switches.

use groundtruth::trace::Outcome;

use super::*;
use crate::prelude::*;
use testkit::scaling::scaled_scene;

const SAMPLES: u32 = 64;

/// What blocks each shadow ray of all samples from a point on the floor, if anything does.
fn outcomes(scene: &Scene, at: Point) -> Vec<Option<u32>> {
    let world = built(&with_samples(scene.clone(), SAMPLES));
    let ray =
        ray(at + Vector::new(0.0, 1e-3 * (at.to_vector().max_abs() + 1e-30), 0.0), -Vector::Y);
    let mut met = Vec::new();
    for i in 0..SAMPLES {
        let mut tree = RayTree::of(&world);
        radiance(&world, &ray, world.draws([0, 0], i), &mut tree);
        for node in tree.rays() {
            match node.outcome {
                Outcome::Unblocked { .. } => met.push(None),
                Outcome::Blocked { blocked_by } => met.push(Some(blocked_by)),
                _ => assert_eq!(node.kind, RayKind::Camera),
            }
        }
    }
    met
}

/// Points on the floor below the lamps and beside them.
fn floor_points() -> Vec<Point> {
    let mut random = Pcg32::new(18, 7);
    let mut c = || 6.0 * (random.uniform() - 0.5);
    (0..24).map(|_| Point::new(c(), 0.0, c())).collect()
}

/// Law: no lamp shadows itself, of any shape, however it is sampled, at scales from 2⁻²⁰ to 2²⁰: each sample
/// gives the same light as without shadows. An object in between does shadow it, and is the one that is
/// named. Oracle: the same scene without shadows, bit for bit; a screen that hides all of the lamp.
/// Book: lights do not shadow themselves.
#[test]
fn a_lamp_does_not_shadow_itself_but_others_shadow_it() {
    for (name, shape) in every_lamp() {
        for sampling in samplings(&shape) {
            for exponent in [-20, 0, 20] {
                let mut scene = floor(up());
                hang(&mut scene, shape.clone(), Some(sampling));
                let mut free = scene.clone();
                free.lights[0].shadows = false;
                let mut hidden = scene.clone();
                let screen = panel(Point::new(0.0, 1.0, 0.0), 30.0 * Vector::X, 30.0 * Vector::Z);
                let screen = put(&mut hidden, screen, white()) as u32;
                let [scene, free, hidden] =
                    [scene, free, hidden].map(|scene| scaled_scene(&scene, exponent));
                let mut rays = 0;
                for point in floor_points() {
                    let at = point.scaled(power_of_two(exponent));
                    let met = outcomes(&scene, at);
                    let what = format!("{name}, {sampling:?}, 2^{exponent}, at {point:?}");
                    assert!(met.iter().all(Option::is_none), "{what}: {met:?}");
                    rays += met.len();
                    let [seen, expected] = [&scene, &free].map(|scene| {
                        let eye = at + Vector::new(0.0, 1e-3 * power_of_two(exponent), 0.0);
                        view(&built(&with_samples(scene.clone(), 4)), eye, -Vector::Y)
                    });
                    assert_eq!(seen, expected, "{what}");
                    let met = outcomes(&hidden, at);
                    assert!(met.iter().all(|by| *by == Some(screen)), "{what}, hidden: {met:?}");
                }
                assert!(rays > 500, "{name}, {sampling:?}: {rays} shadow rays only");
            }
        }
    }
}

/// Law: a lamp whose light is off does not light and does not glow: its object is black, but still blocks
/// light. An emissive object that no light names is seen, and lights nothing. Oracle: the radiance `l_s c_e`,
/// and black.
#[test]
fn a_lamp_that_is_off_is_dark_and_one_without_light_is_only_seen() {
    let (below, spot) = (Point::new(0.1, 0.5, 0.2), Point::new(0.1, 3.0, 0.1));
    for (name, shape) in every_lamp() {
        let mut scene = floor(up());
        hang(&mut scene, shape, None);
        // some samples of a round lamp face away
        let mut scene = with_samples(scene, SAMPLES);
        let on = built(&scene);
        assert_eq!(look(&on, below, spot - below), LS * CE, "{name} on, seen");
        assert!(!view(&on, below, -Vector::Y).is_black(), "{name} on, lighting");
        scene.lights[0].enabled = false;
        let off = built(&scene);
        assert_eq!(look(&off, below, spot - below), Rgb::BLACK, "{name} off, seen");
        assert_eq!(view(&off, below, -Vector::Y), Rgb::BLACK, "{name} off, lighting");
        // it hides the sun, which is right behind it
        let direction = spot - Point::new(0.1, 0.0, 0.2);
        shine(&mut scene, Directional { ls: 1.0, color: Rgb::WHITE, direction });
        assert!(look(&built(&scene), below, -Vector::Y).is_black(), "{name} off, blocking the sun");
        scene.lights.clear();
        let unnamed = built(&scene);
        assert_eq!(look(&unnamed, below, spot - below), LS * CE, "{name} without light, seen");
        assert_eq!(view(&unnamed, below, -Vector::Y), Rgb::BLACK, "{name} without light, lighting");
    }
}
