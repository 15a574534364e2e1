//! Real roots of quadratics, without the cancellation of the textbook formula; and one root of any
//! function between two points where its signs differ.

use super::UNIT_ROUNDOFF;
use super::vectors::Vector;

/// The roots of `a t² + 2 b t + c`, in ascending order. The caller computes
/// `discriminant = b² − a c`. `None` if it is negative or NaN, or if a and b are 0 and c is not.
/// For `a = 0` one root is infinite or NaN, which no span contains.
#[inline(always)] // a call would hand the roots over in memory, which stalls
pub fn quadratic(a: f64, b: f64, c: f64, discriminant: f64) -> Option<[f64; 2]> {
    if discriminant.is_nan() || discriminant < 0.0 {
        return None;
    }
    // root away from −b first: no cancellation when b² ≫ a c
    let q = -(b + discriminant.sqrt().copysign(b));
    if q == 0.0 {
        return (c == 0.0).then_some([0.0; 2]);
    }
    if b == 0.0 {
        let root = (q / a).abs(); // `abs`: the sign of a zero does not matter
        return Some([-root, root]);
    }
    let (first, second) = (q / a, c / q);
    Some(if first <= second { [first, second] } else { [second, first] })
}

/// Where `|f + t·d| = r`, in ascending order: a sphere about the origin.
///
/// The discriminant `b² − a c` cancels for far, small and huge spheres. With `l`, the part of `f`
/// perpendicular to `d`, it is `a (r² − |l|²)` (Haines et al., "Precision Improvements for
/// Ray/Sphere Intersection", Ray Tracing Gems, ch. 7), computed here as `a r² − |f × d|²`, without
/// a division or a square root.
#[inline(always)] // a call would hand the roots over in memory, which stalls
pub fn perpendicular_roots(f: Vector, d: Vector, r: f64) -> Option<[f64; 2]> {
    let a = d.length_squared();
    let discriminant = a * (r * r) - f.cross(d).length_squared();
    quadratic(a, f.dot(d), f.length_squared() - r * r, discriminant)
}

/// The same in a plane, a circle about the origin: where a ray meets a cylinder. `None` for a ray
/// along its axis.
#[inline(always)] // a call would hand the roots over in memory, which stalls
pub fn circle_roots([fx, fy]: [f64; 2], [dx, dy]: [f64; 2], r: f64) -> Option<[f64; 2]> {
    let a = dx * dx + dy * dy;
    let across = fx * dy - fy * dx;
    let roots =
        quadratic(a, fx * dx + fy * dy, (fx * fx + fy * fy) - r * r, a * (r * r) - across * across);
    roots.filter(|_| a > 0.0)
}

/// When [`bracketed_root`] stops. Zero: at the last bit.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tolerance {
    /// The largest value that may be only rounding, for a function like a squared distance: its
    /// second derivative is about 2.
    pub(crate) value: f64,
    /// The largest step that does not matter.
    pub(crate) step: f64,
}

/// More halvings than `f64` has exponents and digits.
const MAX_STEPS: usize = 1200;

/// A root of `f` (value and slope). `bracket` holds a point where `f` is negative, then one where
/// it is positive. Newton's method; it halves the bracket if a step would leave it or is not half
/// as long as the step before.
pub(crate) fn bracketed_root(
    f: impl Fn(f64) -> [f64; 2],
    [mut below, mut above]: [f64; 2],
    start: f64,
    tolerance: Tolerance,
) -> f64 {
    let inside = |x: f64, a: f64, b: f64| a.min(b) < x && x < a.max(b);
    let middle = |a: f64, b: f64| 0.5 * a + 0.5 * b;
    let mut x = if inside(start, below, above) { start } else { middle(below, above) };
    let mut last_step = (above - below).abs();
    for _ in 0..MAX_STEPS {
        let [value, slope] = f(x);
        if value == 0.0 {
            return x;
        }
        *(if value < 0.0 { &mut below } else { &mut above }) = x;
        let newton = x - value / slope;
        let shorter = (newton - x).abs() <= 0.5 * last_step;
        let good = inside(newton, below, above) && shorter;
        if value.abs() <= tolerance.value {
            // a Newton step δ leaves a value of about δ²: more if the step is long, where `f` is flat
            let better = good && value.abs() <= slope * slope;
            return if better { newton } else { x };
        }
        let next = if good { newton } else { middle(below, above) };
        last_step = (next - x).abs();
        if last_step <= tolerance.step.max(UNIT_ROUNDOFF * next.abs()) {
            return next;
        }
        x = next;
    }
    x
}
