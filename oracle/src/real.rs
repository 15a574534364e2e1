//! Numbers of 512 bits and their vectors.

use std::{
    cmp::Ordering,
    ops::{Add, Mul, Sub},
};

use dashu_float::{FBig, round::mode::HalfEven};

/// A binary floating-point number of [`BITS`] bits, rounded to nearest.
pub(crate) type Real = FBig<HalfEven, 2>;

/// Enough for every product of four `f64` to be exact over a wide range of exponents, and for 300
/// good bits after the worst cancellation of the hard cases.
const BITS: usize = 512;

/// The number itself.
///
/// # Panics
/// If it is infinite or NaN: the oracle has no answer for such input.
pub(crate) fn real(x: f64) -> Real {
    // + 0.0 turns −0.0 into 0.0, which is the same number
    let exact = Real::try_from(x + 0.0).expect("the oracle's inputs are finite");
    exact.with_precision(BITS).value()
}

/// The nearest `f64`.
pub(crate) fn nearest(x: &Real) -> f64 {
    x.to_f64().value()
}

/// The sign of `x` as an ordering against 0.
pub(crate) fn sign(x: &Real) -> Ordering {
    x.cmp(&real(0.0))
}

/// `|x|` as an `f64`.
pub(crate) fn magnitude(x: &Real) -> f64 {
    nearest(x).abs()
}

/// A point or vector.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct V(pub(crate) [Real; 3]);

impl V {
    pub(crate) fn dot(&self, b: &V) -> Real {
        let ([x, y, z], [u, v, w]) = (&self.0, &b.0);
        x * u + y * v + z * w
    }

    pub(crate) fn cross(&self, b: &V) -> V {
        let ([x, y, z], [u, v, w]) = (&self.0, &b.0);
        V([y * w - z * v, z * u - x * w, x * v - y * u])
    }

    pub(crate) fn norm(&self) -> Real {
        self.dot(self).sqrt()
    }

    /// The length, as an `f64`.
    pub(crate) fn len(&self) -> f64 {
        // squares of f64 may leave its range
        nearest(&self.norm())
    }

    /// The vector with length 1, or `None` for the zero vector.
    pub(crate) fn unit(&self) -> Option<V> {
        let norm = self.norm();
        (sign(&norm).is_gt()).then(|| V(self.0.each_ref().map(|x| x / &norm)))
    }
}

impl Add for &V {
    type Output = V;
    fn add(self, b: &V) -> V {
        V(std::array::from_fn(|i| &self.0[i] + &b.0[i]))
    }
}

impl Sub for &V {
    type Output = V;
    fn sub(self, b: &V) -> V {
        V(std::array::from_fn(|i| &self.0[i] - &b.0[i]))
    }
}

impl Mul<&Real> for &V {
    type Output = V;
    fn mul(self, s: &Real) -> V {
        V(self.0.each_ref().map(|x| x * s))
    }
}

/// A 3×3 matrix, by rows.
#[derive(Clone, Debug)]
pub(crate) struct M(pub(crate) [V; 3]);

impl M {
    pub(crate) fn identity() -> M {
        M::diagonal([1.0, 1.0, 1.0])
    }

    pub(crate) fn diagonal(d: [f64; 3]) -> M {
        M(std::array::from_fn(|i| {
            V(std::array::from_fn(|j| real(if i == j { d[i] } else { 0.0 })))
        }))
    }

    pub(crate) fn times(&self, v: &V) -> V {
        V(self.0.each_ref().map(|row| row.dot(v)))
    }

    pub(crate) fn transposed(&self) -> M {
        M(std::array::from_fn(|i| V(std::array::from_fn(|j| self.0[j].0[i].clone()))))
    }

    pub(crate) fn product(&self, b: &M) -> M {
        let columns = b.transposed();
        M(self.0.each_ref().map(|row| columns.times(row)))
    }

    /// The inverse, by cofactors: the columns are cross products of the rows over the determinant.
    pub(crate) fn inverse(&self) -> Option<M> {
        let [a, b, c] = &self.0;
        let cofactors = [b.cross(c), c.cross(a), a.cross(b)];
        let determinant = a.dot(&cofactors[0]);
        sign(&determinant)
            .is_ne()
            .then(|| M(cofactors.map(|column| V(column.0.map(|x| x / &determinant)))).transposed())
    }

    /// The Frobenius norm.
    pub(crate) fn len(&self) -> f64 {
        let [a, b, c] = &self.0;
        nearest(&(a.dot(a) + b.dot(b) + c.dot(c)).sqrt())
    }
}
