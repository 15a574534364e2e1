//! Bumped surfaces in uniform light.

use groundtruth::bumps::{self, Height, Kind as Bump};
use groundtruth::textures::Fbm;

use crate::prelude::*;
use crate::support::replicas::mean_and_error;

/// A bumped ball of radius 1 in white light from all sides. The background is a light as well, so that
/// tracers which sample lights meet it.
fn in_white(recipe: materials::Kind, bump: Bump, mut tracer: Tracer) -> Scene {
    if let Some(depth) = tracer.max_depth() {
        *depth = 3;
    }
    let mut scene = stage(Rgb::WHITE);
    scene.tracer = tracer;
    put(&mut scene, Sphere { center: Point::ORIGIN, radius: 1.0, inward: false }, recipe);
    scene.materials[0].bump = Some(bump);
    shine(&mut scene, Environment {});
    with_samples(scene, 64)
}

/// Materials, each with the largest radiance that a smooth surface of it shows in uniform light from any
/// direction: a highlight shows most straight on, `2π/(e + 2)` times `k_s`.
fn materials() -> [(materials::Kind, f64); 3] {
    let matte = Matte { ka: 0.0.into(), kd: 1.0.into(), cd: Rgb::grey(0.8).into() };
    let phong = Phong {
        ka: 0.0.into(),
        kd: 0.5.into(),
        cd: Rgb::WHITE.into(),
        ks: 0.25.into(),
        exponent: 5.0.into(),
        ..Phong::default()
    };
    let dark = Phong { kd: 0.0.into(), ks: 0.0.into(), ..phong.clone() };
    let mirror = Reflective { phong: dark, kr: 0.9.into(), cr: Rgb::WHITE.into() };
    [(matte.into(), 0.8), (phong.into(), 0.5 + 0.25 * TAU / 7.0), (mirror.into(), 0.9)]
}

/// Law: in uniform light a bumped surface reflects at most what a smooth one does, under every tracer, seen
/// straight on and at an angle. A mirror reflects all of it, as directions that bumps would send below the
/// surface are mirrored at the true surface. Other materials lose the part that falls below the true horizon,
/// which shows that the bumps have an effect. Oracle: the closed forms of smooth surfaces; means of 24
/// replicas, five standard errors.
#[test]
fn bumps_gain_no_energy() {
    let noise = Noise::of_octaves(2);
    let bumps = [
        Bump::from(bumps::Noise { noise, size: 0.05, perturbation: 1.5 }),
        Height::new(Fbm::new(noise, 0.1), 0.2).into(),
    ];
    for (recipe, most) in materials() {
        let is_mirror = matches!(recipe, materials::Kind::Reflective(_));
        for tracer in Tracer::ALL {
            if is_mirror && tracer == Tracer::RayCast {
                continue;
            }
            for bump in &bumps {
                let scene = in_white(recipe.clone(), bump.clone(), tracer);
                let mut lost = 0.0;
                let spots = [[0.05, 0.1], [0.3, -0.2], [-0.5, 0.4], [0.7, 0.5], [-0.85, -0.3]];
                for [x, y] in spots {
                    let seen =
                        replicas(&scene, |world| view(world, Point::new(x, y, 5.0), -Vector::Z).g);
                    let (mean, error) = mean_and_error(&seen);
                    let what = format!("{} at {x}, {y} under {}", most, tracer.name());
                    assert!(mean <= most + 5.0 * error + 1e-12, "{mean} ± {error} of {what}");
                    // a viewer behind the bumped normal sees black
                    lost += (1.0 - mean / most) / spots.len() as f64;
                }
                let what = format!("{recipe:?} under {}: {lost} is lost", tracer.name());
                match is_mirror {
                    true => assert!(lost.abs() < 1e-12, "{what}, expected nothing"),
                    false => assert!((0.02..0.7).contains(&lost), "{what}"),
                }
            }
        }
    }
}
