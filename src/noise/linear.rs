//! Linear noise (Suffern, ch. 31): trilinear interpolation of the 8 corners of a cell.

use std::ops::{Add, Mul, Sub};

use super::lattice::{LatticePoint, cell};
use crate::math::Point;

pub fn noise<T>(p: Point, corner: impl Fn(LatticePoint) -> T) -> T
where
    T: Copy + Add<Output = T> + Sub<Output = T>,
    f64: Mul<T, Output = T>,
{
    let [(ix, fx), (iy, fy), (iz, fz)] = p.to_array().map(cell);
    let along_x = |iy, iz| lerp(fx, corner([ix, iy, iz]), corner([ix.wrapping_add(1), iy, iz]));
    let along_y = |iz| lerp(fy, along_x(iy, iz), along_x(iy.wrapping_add(1), iz));
    lerp(fz, along_y(iz), along_y(iz.wrapping_add(1)))
}

/// `a + f (b − a)`: exactly `a` for `f = 0`.
fn lerp<T>(f: f64, a: T, b: T) -> T
where
    T: Copy + Add<Output = T> + Sub<Output = T>,
    f64: Mul<T, Output = T>,
{
    a + f * (b - a)
}
