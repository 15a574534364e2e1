//! The visible share of the sky on smooth surfaces, and the noise of its estimate.

use super::*;
use crate::prelude::*;
use crate::support::replicas::*;

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
