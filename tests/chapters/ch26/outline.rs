//! The outline of a smooth mesh, where the interpolated normal faces away from a viewer who sees the surface.

use super::tracers;
use crate::prelude::*;
use crate::support::replicas::LEVEL;

/// The shading normal of the triangle, not unit; its true normal is y.
const SHADING: Vector = Vector::new(-0.9, 0.5, 0.0);

/// A triangle in uniform light of radiance 1 from a sky that is also sampled.
fn triangle(recipe: impl Into<materials::Kind>, tracer: Tracer) -> Scene {
    let mut scene = stage(Rgb::WHITE);
    scene.tracer = tracer;
    shine(&mut scene, Environment {});
    let vertices = [[-1.0, 0.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, -1.0]].map(Point::from);
    put(&mut scene, Triangle { vertices, normals: Some([SHADING; 3]) }, recipe);
    with_samples(scene, 256)
}

/// The radiance towards a viewer in front of the triangle and behind its shading normal's horizon.
fn seen(world: &World) -> f64 {
    from(world, Vector::new(2.0, 0.4, 0.1))
}

fn from(world: &World, to_viewer: Vector) -> f64 {
    assert!(to_viewer.dot(SHADING) < 0.0, "the shading normal faces away");
    view(world, Point::ORIGIN + to_viewer, -to_viewer).g
}

/// Law: in uniform light a matte surface sends `ρ (1 + cos γ)/2` to such a viewer under every path tracer,
/// with the angle γ between its two normals. Oracle: that integral of `ρ/π cos θ` over the directions above
/// both, a hemisphere and a half, projected on the plane of the shading normal.
#[test]
fn paths_go_on_from_a_matte_surface_whose_shading_normal_faces_away() {
    let cos_gamma = SHADING.y() / SHADING.length();
    for tracer in tracers(3) {
        let scene =
            triangle(Matte { ka: 0.0.into(), kd: 0.8.into(), cd: Rgb::WHITE.into() }, tracer);
        let expected = 0.8 * 0.5 * (1.0 + cos_gamma);
        assert_mean(tracer.name(), &replicas(&scene, seen), expected, 3, 0.01);
    }
}

/// Law: the path tracers have one mean there, of a highlight too. Oracle: each other; Welch's t over 24
/// replicas.
#[test]
fn path_tracers_agree_on_a_highlight_whose_normal_faces_away() {
    let [path_trace, global_trace, path] = tracers(3).map(|tracer| {
        let phong = Phong { ks: 0.4.into(), exponent: 2.0.into(), ..Phong::default() };
        let grazing = Vector::new(0.7, 1.1, 0.1);
        replicas(&triangle(phong, tracer), |world| from(world, grazing))
    });
    for (name, other) in [("path_trace", path_trace), ("global_trace", global_trace)] {
        let p = means::two_samples(&other, &path);
        assert!(p > sidak(LEVEL, 2), "{name} finds {other:?}, path {path:?}: p = {p:e}");
        assert!(path.iter().all(|value| *value > 0.0), "black: {path:?}");
    }
}

/// Law: a sharp glossy reflector has no black outline: where its mirror direction about the shading normal
/// falls behind the true surface, it shows uniform surroundings times the reflectance, as a mirror does.
/// Oracle: the book's weight `k_r c_r` of every reflected ray.
#[test]
fn a_glossy_reflector_has_no_black_outline() {
    let depth = Depth { max_depth: 3 };
    for tracer in
        [Tracer::Whitted(Whitted { max_depth: 3 }), Tracer::PathTrace(depth), Tracer::Path(depth)]
    {
        let (phong, cr, rule) = (Phong::default(), Rgb::WHITE.into(), GlossyRule::Book);
        let glossy = GlossyReflector { phong, kr: 0.8.into(), cr, exponent: 1e5.into(), rule };
        assert_mean(tracer.name(), &replicas(&triangle(glossy, tracer), seen), 0.8, 3, 1e-3);
    }
}
