//! The light of skies by image, under every tracer.

use groundtruth::background::{Dome, Image};
use groundtruth::materials::Kind as MaterialKind;
use groundtruth::textures::Filtering;

use super::sky::{DOMES, all_around, image, ragged, texel, written};
use crate::prelude::*;
use crate::support::replicas::mean_and_error;

/// A plane of this normal under the sky.
fn under(sky: Image, normal: Vector, recipe: impl Into<MaterialKind>) -> Scene {
    let mut scene = stage(Rgb::BLACK);
    scene.background = sky.into();
    put(&mut scene, Plane { point: Point::ORIGIN, normal }, recipe);
    shine(&mut scene, Environment {});
    scene
}

fn matte() -> Matte {
    Matte { ka: 0.0.into(), kd: 0.8.into(), cd: Rgb::WHITE.into() }
}

/// Every tracer that sees the sky's light on a matte surface.
fn tracers() -> [Tracer; 4] {
    let depth = Depth { max_depth: 1 };
    [Tracer::RayCast, Tracer::PathTrace(depth), Tracer::GlobalTrace(depth), Tracer::Path(depth)]
}

/// Law: a matte plane under a sky has the radiance `ρ/π ∫ L cosθ dω`, under every tracer: whether directions
/// are sampled from the light, from the surface, or from both. Oracle: the midpoint rule over all directions,
/// with texels computed independently.
#[test]
fn every_strategy_finds_the_light_of_the_sky() {
    let normal = Vector::new(0.3, 0.8, 0.4);
    let n = Normal::new(normal).expect("not zero");
    for dome in DOMES {
        let (all, part) = all_around(400);
        let light = |w: Vector| {
            let seen = texel(dome, w).map_or(Rgb::BLACK, ragged);
            part * n.dot(w).max(0.0) * seen
        };
        let expected = 0.8 / PI * all.map(light).sum::<Rgb>();
        for tracer in tracers() {
            let sky = image("light", dome, Filtering::Nearest);
            let scene = Scene { tracer, ..with_samples(under(sky, normal, matte()), 1024) };
            let eye = Point::ORIGIN + 2.0 * n;
            let found = replicas(&scene, |world| view(world, eye, -1.0 * n));
            assert_color(&format!("{dome:?}, {tracer:?}"), &found, expected, 16, 0.05);
        }
    }
}

/// A sky of 64 × 32 texels, one of which is the sun.
fn sunny() -> Image {
    let file =
        written(
            "sun",
            [64, 32],
            |at| {
                if at == [5, 22] { Rgb::grey(8192.0) } else { Rgb::grey(0.125) }
            },
        );
    Image::of_file(file, Dome::Spherical)
}

/// Law: a tiny bright sun gives little noise if it is sampled, and much if paths must hit it by chance; the
/// mean is the same. Oracle: the sum of the closed forms: `∫ cosθ dω` of a texel is
/// `(cos²θ₀ − cos²θ₁)/2 · 2π/n`.
#[test]
fn a_tiny_sun_converges() {
    let edge = |row: f64| cos(PI * (1.0 - row / 32.0));
    let sun = 0.5 * (edge(23.0) * edge(23.0) - edge(22.0) * edge(22.0)) * TAU / 64.0;
    let expected = 0.8 / PI * (0.125 * PI + (8192.0 - 0.125) * sun);
    let found = tracers().map(|tracer| {
        let scene = Scene { tracer, ..with_samples(under(sunny(), Vector::Y, matte()), 256) };
        replicas(&scene, |world| view(world, Point::new(0.0, 2.0, 0.0), -Vector::Y).g)
    });
    let [ray_cast, path_trace, global_trace, path] = &found;
    for (name, values) in [("ray_cast", ray_cast), ("global", global_trace), ("path", path)] {
        assert_mean(name, values, expected, 3, 2e-3);
    }
    let [(_, blind), (_, aware)] = [path_trace, path].map(|values| mean_and_error(values));
    assert!(blind > 20.0 * aware, "the errors are {blind:e} unsampled and {aware:e} sampled");
}
