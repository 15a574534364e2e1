//! Vectors of `f64`, for the generation of cases.

pub(super) type V = [f64; 3];

pub(super) fn add(a: V, b: V) -> V {
    std::array::from_fn(|i| a[i] + b[i])
}

pub(super) fn scale(s: f64, a: V) -> V {
    a.map(|x| s * x)
}

/// `a + s·b`.
pub(super) fn along(a: V, s: f64, b: V) -> V {
    add(a, scale(s, b))
}

pub(super) fn minus(a: V, b: V) -> V {
    along(a, -1.0, b)
}

pub(super) fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn length(a: V) -> f64 {
    dot(a, a).sqrt()
}

pub(super) fn unit(a: V) -> V {
    scale(1.0 / length(a), a)
}

/// The part of `a` perpendicular to the unit vector `n`; projected twice, for accuracy to rounding.
pub(super) fn perpendicular(a: V, n: V) -> V {
    let once = along(a, -dot(a, n), n);
    along(once, -dot(once, n), n)
}
