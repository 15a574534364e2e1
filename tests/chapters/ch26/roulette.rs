//! Russian roulette and the choice of a lobe: two decisions that do not depend on each other.

use crate::prelude::*;
use crate::support::stage::ray;

/// So many reflections are told apart; all longer paths are counted together.
const SHORT: usize = 7;

/// Deep enough that what is cut off is below 1e-5 of the light.
const DEPTH: u32 = 24;

/// The eye is in a closed sphere that mirrors a share `a` of all light, scatters `d` and lets `b` through, straight
/// on from a white sky.
fn leaking_sphere(a: f64, d: f64, b: f64) -> Scene {
    let mut scene = with_samples(stage(Rgb::WHITE), 2048);
    scene.tracer = Tracer::Path(Depth { max_depth: DEPTH });
    let wall = Sphere { center: Point::ORIGIN, radius: 3.0, inward: true };
    let phong = Phong { kd: d.into(), cd: Rgb::WHITE.into(), ..Phong::default() };
    let (kr, cr, kt) = (a.into(), Rgb::WHITE.into(), b.into());
    let leaking = Transparent { phong, kr, cr, kt, eta: 1.0 };
    put(&mut scene, wall, leaking);
    scene
}

/// The radiance along one ray from within, divided among the numbers of reflections of its paths.
fn by_reflections(world: &World) -> [f64; SHORT + 1] {
    let ray = ray(Point::new(0.3, -0.2, 0.4), Vector::new(0.4, 0.5, -1.0));
    let n = world.samples_per_pixel();
    let mut found = [0.0; SHORT + 1];
    for i in 0..n {
        let mut counts = RayCounts::default();
        let seen = radiance(world, &ray, world.draws([0, 0], i), &mut counts).g;
        found[(counts.reflected as usize).min(SHORT)] += seen / f64::from(n);
    }
    found
}

/// Law: Russian roulette does not ask which lobe a path took: in a sphere that mirrors a, scatters d and transmits
/// b of all light, paths with k reflections bring `(a + d)ᵏ b` at every depth, also where roulette ends most of
/// them. Oracle: the terms of the series, each by itself (their sum would hide the deep ones); means of 24
/// replicas.
#[test]
fn roulette_does_not_depend_on_the_choice_of_the_lobe() {
    let cases = [(0.4, 0.0, 0.2), (0.25, 0.25, 0.3)];
    for (a, d, b) in cases {
        let found = replicas(&leaking_sphere(a, d, b), by_reflections);
        for k in 0..=SHORT {
            let from = |k: usize| power(a + d, k as f64) * b / (1.0 - (a + d));
            let expected = if k < SHORT { from(k) - from(k + 1) } else { from(k) };
            let values: Vec<f64> = found.iter().map(|of| of[k]).collect();
            let what = format!("mirrored {a}, scattered {d}, transmitted {b}, {k} reflections");
            assert_mean(&what, &values, expected, cases.len() * (SHORT + 1), 0.35);
        }
    }
}
