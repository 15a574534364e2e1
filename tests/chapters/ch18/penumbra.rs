//! Soft shadows: umbra and penumbra by similar triangles.

use groundtruth::trace::Outcome;

use super::*;
use crate::prelude::*;

/// A narrow lamp of this width at height `LAMP`, and a long beam across it at height `BEAM`.
const WIDTH: f64 = 0.6;
const LAMP: f64 = 4.0;
const BEAM: f64 = 1.0;

/// Samples: multi-jittered, so that along each axis of the lamp there is one in each of 256 strips.
const SAMPLES: u32 = 256;

/// The visible share is a whole number of strips, except for the one that the edge cuts, and for rounding.
const STRIP: f64 = 1.0 / 256.0 + 1e-9;

/// A floor under a lamp, with a beam from `−half` to `half` in between. The lamp is sampled by
/// area, so that samples are spread evenly over its width.
fn under_a_beam(half: f64) -> Scene {
    let mut scene = floor(up());
    let lamp = panel(Point::new(0.0, LAMP, 0.0), WIDTH * Vector::X, 1e-3 * Vector::Z);
    hang(&mut scene, lamp, Some(Sampling::Area));
    let beam = boxed(Point::new(-half, BEAM, -9.0), Point::new(half, BEAM + 1e-9, 9.0));
    put(&mut scene, beam, matte(0.0, 0.0, Rgb::BLACK));
    with_samples(scene, SAMPLES)
}

/// The share of the shadow rays from the floor at x that reach the lamp, and the radiance there.
fn unblocked(world: &World, x: f64) -> (f64, Rgb) {
    let ray = ray(Point::new(x, 0.01, 0.02), Vector::new(0.0, -0.01, -0.02));
    let (mut free, mut sum) = (0, Rgb::BLACK);
    for i in 0..SAMPLES {
        let mut tree = RayTree::of(world);
        sum += radiance(world, &ray, world.draws([1, 2], i), &mut tree);
        let shadows =
            tree.rays().into_iter().filter(|node| node.kind == RayKind::Shadow { light: 0 });
        free += shadows.filter(|node| node.outcome == Outcome::Unblocked { boundaries: 0 }).count();
    }
    (free as f64 / f64::from(SAMPLES), (1.0 / f64::from(SAMPLES)) * sum)
}

/// The share of the lamp's width that is visible from the floor at x past a beam from `−half` to `half`.
fn visible(x: f64, half: f64) -> f64 {
    // the beam's edge, projected onto the lamp from x: similar triangles
    let onto_lamp = |edge: f64| x + (edge - x) * LAMP / BEAM;
    let inside = |x: f64| (x / WIDTH + 0.5).clamp(0.0, 1.0);
    1.0 - (inside(onto_lamp(half)) - inside(onto_lamp(-half)))
}

/// Law: the share of a lamp that is visible past a beam is that by similar triangles, everywhere: the umbra
/// is `B − (w − B) h/(H − h)` wide if that is positive, umbra and penumbra together `B + (B + w) h/(H − h)`,
/// for a beam B at height h under a lamp w at height H. Oracle: the projected edges, to two strips of the
/// stratified lamp; in the umbra black, and beyond the penumbra the radiance without the beam, bit for bit.
/// Book: umbra and penumbra.
#[test]
fn umbra_and_penumbra_have_the_widths_of_similar_triangles() {
    for half in [0.05, 0.2, 0.5] {
        let scene = under_a_beam(half);
        let mut free = scene.clone();
        free.lights[0].shadows = false;
        let [world, free] = [scene, free].map(|scene| built(&scene));
        let shift = BEAM / (LAMP - BEAM);
        let outer = half + (half + 0.5 * WIDTH) * shift;
        let inner = half + (half - 0.5 * WIDTH) * shift;
        for i in -60..=60 {
            let x = 0.023 * f64::from(i);
            let (share, seen) = unblocked(&world, x);
            let (_, without) = unblocked(&free, x);
            let expected = visible(x, half);
            let what =
                format!("beam ±{half}, x = {x}: {share} of the lamp is seen, expected {expected}");
            // two edges may each cut a strip
            assert!((share - expected).abs() <= 2.0 * STRIP, "{what}");
            if x.abs() > outer + 1e-6 {
                assert!(
                    share == 1.0 && seen == without,
                    "{what}: {seen:?}, without the beam {without:?}"
                );
            }
            if x.abs() < inner - 1e-6 {
                assert!(share == 0.0 && seen.is_black(), "{what}: {seen:?}");
            }
            assert!(!without.is_black(), "the lamp is there");
        }
    }
}
