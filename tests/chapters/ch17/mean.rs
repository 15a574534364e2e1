//! The visible share of the sky on smooth surfaces, and the noise of its estimate.

use super::*;
use crate::prelude::*;
use crate::support::lamps::seen;
use crate::support::replicas::*;

/// Law: where an interpolated normal leans by δ from the true one, directions below the true
/// surface are blocked by the surface itself: `(1 + cos δ)/2` is visible on a smooth convex mesh
/// alone. Oracle: the share of a tilted plane; δ from the normals that are recorded.
#[test]
fn directions_below_the_true_surface_are_blocked() {
    let mut scene = stage(Rgb::BLACK);
    put(&mut scene, TessellatedSphere::new(5, 4, true), chalk());
    shine(&mut scene, occluder());
    let world = built(&scene);
    let mut leans = 0;
    for i in 0..8 {
        let to_eye = at_angle(Normal::Y, 0.2 * f64::from(i) - 0.7, 1.3 * f64::from(i));
        let tree = recorded(&world, Point::ORIGIN + 3.0 * to_eye, -to_eye);
        let Some(hit) = &tree.root().hit else { panic!("the sphere is there") };
        let cosine = Vector::from(hit.normal).dot(hit.shading_normal);
        leans += u32::from(cosine < 0.97);
        let values = seen(&scene, 1024, hit.point, hit.normal);
        let what = format!("point {i}, where the normals' cosine is {cosine}");
        assert_color(&what, &values, shade(0.5 * (1.0 + cosine)), 8, 2e-3);
    }
    assert!(leans >= 3, "the normals lean at {leans} points only");
}

/// Law: N independent samples of a point of which the share A is occluded have the standard
/// deviation `√(A (1 − A)/N) (1 − min)`, that of a coin; multi-jittered ones less. Oracle: the
/// binomial distribution (ch. 17), by the variance over reseeded pixels.
/// Book: fig. 17.7, noise by the number of samples.
#[test]
fn noise_is_that_of_a_coin() {
    let mut scene = floor(Vector::Y);
    let (corner, a) = (Point::new(1.0, 0.0, -1e5), 2e5 * Vector::Z);
    put(&mut scene, Rectangle { corner, a, b: 2.0 * Vector::Y }, chalk());
    let eye = Point::new(-1e-3, 1e-3, 0.0);
    let seen = |world: &World| view(world, eye, Point::ORIGIN - eye).g / shade(1.0).g;
    let occluded = 0.5 * (1.0 - 1.0 / 5.0_f64.sqrt());
    for samples in [4, 16] {
        let expected = occluded * (1.0 - occluded) / f64::from(samples) * (1.0 - MIN) * (1.0 - MIN);
        near!(variance(&scene, Random {}, samples, seen) / expected, 1.0, VARIANCE_ERROR);
        below!(variance(&scene, MultiJittered {}, samples, seen) / expected, 0.7);
    }
}
