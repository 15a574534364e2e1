//! Maps from the unit square to disk, hemisphere and sphere, and back (Suffern, ch. 6 and 7).
//!
//! Equal areas become equal areas, or equal shares of the density: stratified points stay so.

use std::f64::consts::PI;

use super::{ONE_MINUS, Vector, atan, atan2, exp_m1, ln_1p, power, sin_cos};

/// A point of the unit disk: concentric squares become concentric circles, areas keep their ratio
/// (Suffern, ch. 6; Shirley & Chiu, "A Low Distortion Map Between Disk and Square", 1997).
///
/// The book has four sectors. Opposite sectors have the same formula, because r and the angle
/// change sign together. In the upper and lower sectors φ is measured from the y axis (the book's
/// `2 − a/b`), so that a rotation of the square by 90° rotates the disk exactly.
pub fn disk([u1, u2]: [f64; 2]) -> [f64; 2] {
    let (a, b) = (2.0 * u1 - 1.0, 2.0 * u2 - 1.0);
    if a.abs() > b.abs() {
        let (sin, cos) = sin_cos(0.25 * PI * (b / a));
        [a * cos, a * sin]
    } else if b != 0.0 {
        let (sin, cos) = sin_cos(0.25 * PI * (a / b));
        [b * sin, b * cos]
    } else {
        [0.0, 0.0]
    }
}

/// The point of the square that [`disk`] maps to this one of the closed unit disk.
pub fn disk_inverse([x, y]: [f64; 2]) -> [f64; 2] {
    let r = (x * x + y * y).sqrt();
    let (a, b) = if x.abs() > y.abs() {
        let a = r.copysign(x);
        (a, a * (4.0 / PI) * atan(y / x))
    } else if y != 0.0 {
        let b = r.copysign(y);
        (b * (4.0 / PI) * atan(x / y), b)
    } else {
        (0.0, 0.0)
    };
    [a, b].map(|c| in_range(0.5 * (c + 1.0)))
}

/// Rejection: the points of the square that lie in its inscribed disk, as points of the unit disk.
/// About π/4 of them remain, and their stratification is lost. Only for comparison with [`disk`]
/// (Suffern, ch. 6).
pub fn disk_by_rejection(
    points: impl IntoIterator<Item = [f64; 2]>,
) -> impl Iterator<Item = [f64; 2]> {
    let centered = points.into_iter().map(|u| u.map(|u| 2.0 * u - 1.0));
    centered.filter(|[x, y]| x * x + y * y < 1.0)
}

/// A unit vector about the z axis with density proportional to `cos^e θ`:
/// `cosθ = (1 − u₂)^(1/(e+1))`, `φ = 2π u₁` (Suffern, ch. 7). `e ≥ 0` is any real number; 0 is
/// uniform, 1 weighs by the cosine.
pub fn hemisphere([u1, u2]: [f64; 2], e: f64) -> Vector {
    let (sin_phi, cos_phi) = sin_cos(2.0 * PI * u1);
    let (cos_theta, sin_theta) = if e == 1.0 {
        // by far the most frequent case, and four times as fast
        ((1.0 - u2).sqrt(), u2.sqrt())
    } else {
        // sin²θ = 1 − (1 − u₂)^(2/(e+1)), without the cancellation near the pole
        let sin_squared = -exp_m1(2.0 * ln_1p(-u2) / (e + 1.0));
        (power(1.0 - u2, 1.0 / (e + 1.0)), sin_squared.sqrt())
    };
    Vector::new(sin_theta * cos_phi, sin_theta * sin_phi, cos_theta)
}

/// The point of the square that [`hemisphere`] maps to this direction, of any length and `z ≥ 0`.
pub fn hemisphere_inverse(direction: Vector, e: f64) -> [f64; 2] {
    let [x, y, z] = direction.to_array();
    let tan_squared = (x * x + y * y) / (z * z);
    // u₂ = 1 − cos^(e+1) θ with cos²θ = 1/(1 + tan²θ)
    let u2 = -exp_m1(-0.5 * (e + 1.0) * ln_1p(tan_squared));
    [turns(x, y), in_range(u2)]
}

/// A unit vector, uniform over the sphere: `z = 1 − 2u₁`, `φ = 2π u₂` (Suffern, ch. 7).
pub fn sphere([u1, u2]: [f64; 2]) -> Vector {
    let z = 1.0 - 2.0 * u1;
    // √(1 − z²), without the cancellation near the poles
    let r = 2.0 * (u1 * (1.0 - u1)).sqrt();
    let (sin_phi, cos_phi) = sin_cos(2.0 * PI * u2);
    Vector::new(r * cos_phi, r * sin_phi, z)
}

/// The point of the square that [`sphere`] maps to this unit vector.
pub fn sphere_inverse(direction: Vector) -> [f64; 2] {
    let [x, y, z] = direction.to_array();
    // (1 − z)/2, without the cancellation near the upper pole
    let u1 = if z > 0.0 { 0.5 * (x * x + y * y) / (1.0 + z) } else { 0.5 * (1.0 - z) };
    [in_range(u1), turns(x, y)]
}

/// Barycentric coordinates `β, γ ≥ 0`, `β + γ ≤ 1`, of a point of a triangle; equal areas become
/// equal areas (Heitz, "A Low-Distortion Map Between Triangle and Square", 2019).
pub fn triangle([u1, u2]: [f64; 2]) -> [f64; 2] {
    if u2 > u1 { [0.5 * u1, u2 - 0.5 * u1] } else { [u1 - 0.5 * u2, 0.5 * u2] }
}

/// The angle from the x axis in turns, in `[0, 1)`.
fn turns(x: f64, y: f64) -> f64 {
    let turns = atan2(y, x) / (2.0 * PI);
    in_range(if turns < 0.0 { turns + 1.0 } else { turns })
}

/// Clamps a number that rounding moved slightly outside `[0, 1)`.
fn in_range(u: f64) -> f64 {
    u.clamp(0.0, ONE_MINUS)
}
