//! Formulas that lose digits or hold for some shapes only, as people write them.

use super::local::Local;
use groundtruth::math::Vector;
use groundtruth::math::polynomial::real_roots;
use oracle::{Root, Shape};

/// How near to a formula's own value an answer has to be, as a share of the value's error: the order of the operations
/// is a program's own.
const NEAR: f64 = 0.02;

/// The roots of `a t² + b t + c = 0` by `b² − 4ac`, as the book and others print it, in double and single precision;
/// empty for each formula by which the ray misses.
///
/// Source: Suffern, ch. 3 and 19: sphere and cylinder; with `c = |o − c|² − r²`.
fn by_formulas(local: &Local<'_>) -> Vec<Vec<f64>> {
    let (center, radius, is_used) = match *local.shape {
        Shape::Sphere { center, radius } | Shape::PartSphere { center, radius, .. } => {
            (center, radius, [true; 3])
        }
        Shape::OpenCylinder { radius, .. } | Shape::PartCylinder { radius, .. } => {
            ([0.0; 3], radius, [true, false, true])
        }
        _ => return Vec::new(),
    };
    let (o, d) = (local.ray.origin.to_array(), local.ray.direction.to_array());
    let length = Vector::from(d).length();
    // some programs make every direction unit
    [1.0, length]
        .into_iter()
        .flat_map(|by| {
            let d = d.map(|x| x / by);
            let double = double_roots(o, d, center, radius, is_used);
            let single = single_roots(o, d, center, radius, is_used);
            double.into_iter().chain(single).map(move |roots| roots.map(|t| t / by))
        })
        .map(|roots| roots.into_iter().filter(|t| t.is_finite()).collect())
        .collect()
}

macro_rules! roots {
    ($name:ident, $real:ty) => {
        /// By the printed formula, and by the one with half of b.
        fn $name(
            o: [f64; 3],
            d: [f64; 3],
            center: [f64; 3],
            radius: f64,
            is_used: [bool; 3],
        ) -> [[f64; 2]; 2] {
            let [o, d, center] = [o, d, center].map(|v| v.map(|x| x as $real));
            let radius = radius as $real;
            let f: [$real; 3] = std::array::from_fn(|i| o[i] - center[i]);
            let dot = |x: [$real; 3], y: [$real; 3]| -> $real {
                (0..3).filter(|&i| is_used[i]).map(|i| x[i] * y[i]).sum()
            };
            let (a, half, c) = (dot(d, d), dot(f, d), dot(f, f) - radius * radius);
            let b = 2.0 * half;
            let e = (b * b - 4.0 * a * c).sqrt();
            let whole = [(-b - e) / (2.0 * a), (-b + e) / (2.0 * a)];
            let e = (half * half - a * c).sqrt();
            [whole, [(-half - e) / a, (-half + e) / a]].map(|roots| roots.map(f64::from))
        }
    };
}
roots!(double_roots, f64);
roots!(single_roots, f32);

/// Whether their `t` is the wrong one of a formula with `b² − 4ac`.
pub fn is_cancellation(local: &Local<'_>, t: f64, root: &Root) -> bool {
    // the other root of a formula is no error of this one
    let nearest = |roots: Vec<f64>| {
        let errors = roots.into_iter().map(|other| (other, (other - root.t).abs()));
        errors.min_by(|a, b| a.1.total_cmp(&b.1))
    };
    let mut all = by_formulas(local).into_iter().filter_map(nearest);
    all.any(|(other, error)| error > 0.0 && (t - other).abs() <= NEAR * error)
}

/// Whether a formula with `b² − 4ac` finds as many roots in the span as they do, and not as many as there are.
pub fn is_count_of_cancellation(
    local: &Local<'_>,
    [min, max]: [f64; 2],
    theirs: &[f64],
    right: usize,
) -> bool {
    let has = |roots: Vec<f64>| {
        let inside: Vec<f64> = roots.into_iter().filter(|t| min < *t && *t < max).collect();
        match theirs {
            [] => inside.is_empty(),
            [t] => matches!(*inside, [other] if (t - other).abs() <= NEAR * t.abs()),
            _ => inside.len() == theirs.len(),
        }
    };
    theirs.len() != right && is_round(local.shape) && by_formulas(local).into_iter().any(has)
}

/// Whether their `t` is a root in the span of the book's quartic of a torus, one of whose terms is left out, halved, doubled
/// or has the other sign.
///
/// Source: Suffern, ch. 19, with `e = |o|² − a² − b²`.
pub fn is_torus_coefficient(local: &Local<'_>, [min, max]: [f64; 2], theirs: f64) -> bool {
    let Shape::Torus { swept_radius: a, tube_radius: b } = *local.shape else { return false };
    let (o, d) = (local.ray.origin.to_vector(), local.ray.direction);
    let (dd, od, e) = (d.dot(d), o.dot(d), o.dot(o) - a * a - b * b);
    let four = 4.0 * a * a;
    // with the power of t
    let terms = [
        (0, e * e),
        (0, -four * b * b),
        (0, four * o.y() * o.y()),
        (1, 4.0 * od * e),
        (1, 2.0 * four * o.y() * d.y()),
        (2, 2.0 * dd * e),
        (2, 4.0 * od * od),
        (2, four * d.y() * d.y()),
        (3, 4.0 * dd * od),
        (4, dd * dd),
    ];
    let changed = |wrong: usize, factor: f64| {
        let mut quartic = [0.0; 5];
        for (i, (power, term)) in terms.iter().enumerate() {
            quartic[*power] += if i == wrong { factor * term } else { *term };
        }
        let is_theirs =
            |t: &f64| min < *t && *t < max && super::super::mistakes::same(&[theirs], &[*t]);
        real_roots(&quartic).iter().any(is_theirs)
    };
    (0..terms.len()).any(|wrong| [0.0, 0.5, 2.0, -1.0].iter().any(|by| changed(wrong, *by)))
}

/// Whether all of the quadric is the shape: parts of it have borders.
fn is_round(shape: &Shape) -> bool {
    matches!(shape, Shape::Sphere { .. })
}

/// Whether a cone's normal is `(k x, h − y, k z)` with a `k` that is right for h = r² only, or for h = r only.
pub fn cone_normal(local: &Local<'_>, root: &Root, theirs: Vector) -> Option<bool> {
    let Shape::Cone { height: h, radius: r } = *local.shape else { return None };
    let p = local.point(root);
    let is = |k: f64| {
        let normal = Vector::new(k * p.x(), h - p.y(), k * p.z());
        let out = local.out(normal, |transform, n| {
            groundtruth::math::Normal::new(n).map_or(n, |n| transform.covector(n))
        });
        out.is_some_and(|n| n.dot(theirs).abs() > 1.0 - 1e-9)
    };
    let is_any = |all: &[f64]| all.iter().any(|k| is(*k));
    match () {
        // normals along the axis or across it are the same for every k
        () if (p.x() * p.x() + p.z() * p.z()).sqrt() < 1e-6 * r || (h - p.y()).abs() < 1e-6 * h => {
            None
        }
        () if is(h * h / (r * r)) => None,
        () if is_any(&[h, r * r]) => Some(true),
        () if is_any(&[1.0, h / r, r / h, r * r / (h * h)]) => Some(false),
        () => None,
    }
}
