//! A shape transformed by an affine map: the ray is transformed back, and t stays the same.

use super::{Beam, Found, solve};
use crate::{
    real::{M, Real, V, real},
    shape::Shape,
};

/// The condition `‖A‖·‖A⁻¹‖` of the 3×3 part of an affine matrix, in the Frobenius norm (so 3 for a
/// rotation); infinite if it is singular.
pub fn condition(matrix: &[[f64; 4]; 3]) -> f64 {
    let (linear, _) = parts(&matrix.map(|row| row.map(real)));
    linear.inverse().map_or(f64::INFINITY, |inverse| linear.len() * inverse.len())
}

fn parts(matrix: &[[Real; 4]; 3]) -> (M, V) {
    let row = |[x, y, z, _]: &[Real; 4]| V([x.clone(), y.clone(), z.clone()]);
    (M(matrix.each_ref().map(row)), V(matrix.each_ref().map(|row| row[3].clone())))
}

/// With `x = A p + b`: `F_world(x) = F(A⁻¹ (x − b))`, so the gradient is `A⁻ᵀ g`, the Hessian
/// `A⁻ᵀ H A⁻¹`, and a change of A and b moves `p` by `−A⁻¹ (ΔA p + Δb)`, which gives
/// `F_A = −(A⁻ᵀ g) pᵀ` and `F_b = −A⁻ᵀ g`.
///
/// A relative change by ε moves the inner origin by at most
/// `‖A⁻¹‖ (reach of o + |b| + ‖A‖ |o'|) ε`. The caller divides the margin by the condition `‖A‖ ‖A⁻¹‖`;
/// the other factor is the inner ray's reach. The same holds for the direction.
pub(super) fn instance(matrix: &[[Real; 4]; 3], of: &Shape<Real>, beam: &Beam) -> Found {
    let (linear, shift) = parts(matrix);
    let back = linear.inverse().expect("an instance's matrix is not singular");
    let (o, d) = (back.times(&(&beam.o - &shift)), back.times(&beam.d));
    let (size, shift) = (linear.len(), shift.len());
    let inner = Beam {
        o_shift: (beam.o_shift + shift) / size + o.len(),
        d_shift: beam.d_shift / size + d.len(),
        o,
        d,
    };
    let mut found = solve(of, &inner);
    let normal_map = back.transposed();
    for hit in &mut found.hits {
        let inside = hit.gradient.len();
        hit.gradient = normal_map.times(&hit.gradient);
        hit.squeeze *= back.len() * inside / hit.gradient.len();
        hit.hessian = hit.hessian.as_ref().map(|h| normal_map.product(h).product(&back));
        hit.inputs += hit.gradient.len() * (size * inner.at(&hit.t).len() + shift);
    }
    found
}
