//! Cubic noise (Suffern, ch. 31): interpolation by Catmull–Rom splines of 4 × 4 × 4 lattice points.

use std::ops::{Add, Mul};

use super::lattice::{LatticePoint, cell};
use crate::math::Point;

/// The value of the splines, which may overshoot the values at the lattice points.
pub fn noise<T>(p: Point, knot: impl Fn(LatticePoint) -> T) -> T
where
    T: Copy + Add<Output = T>,
    f64: Mul<T, Output = T>,
{
    let [(ix, fx), (iy, fy), (iz, fz)] = p.to_array().map(cell);
    let row = |iy, iz| spline(fx, four_planes(ix).map(|ix| knot([ix, iy, iz])));
    let slice = |iz| spline(fy, four_planes(iy).map(|iy| row(iy, iz)));
    spline(fz, four_planes(iz).map(slice))
}

/// The indices of four lattice planes: −1, 0, 1 and 2 planes from plane `i`.
fn four_planes(i: u8) -> [u8; 4] {
    [i.wrapping_sub(1), i, i.wrapping_add(1), i.wrapping_add(2)]
}

/// The four-knot spline: `k₁` at `x = 0`, `k₂` at `x = 1`, with continuous derivatives at both.
fn spline<T>(x: f64, [k0, k1, k2, k3]: [T; 4]) -> T
where
    T: Copy + Add<Output = T>,
    f64: Mul<T, Output = T>,
{
    let c3 = -0.5 * k0 + 1.5 * k1 + -1.5 * k2 + 0.5 * k3;
    let c2 = k0 + -2.5 * k1 + 2.0 * k2 + -0.5 * k3;
    let c1 = 0.5 * k2 + -0.5 * k0;
    let c0 = k1;
    x * (x * (x * c3 + c2) + c1) + c0
}
