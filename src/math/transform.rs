//! Affine transformations (Suffern, ch. 20): a list of steps, applied in order, and its inverse.

use glam::{DAffine3, DMat3, DVec3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::exact::less_products;
use super::functions::{cos_degrees, sin_degrees};
use super::vectors::{Normal, Point, Vector};
use super::{Aabb, Ray, UNIT_ROUNDOFF, lists};

/// One step of a transformation, as a person types it: angles in degrees, counter-clockwise for an
/// eye on the positive axis that looks at the origin.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
#[schemars(title = "transform steps")]
pub enum Step {
    /// Moves by this vector.
    Translate(#[schemars(extend("x-dimension" = "length"))] Vector),
    /// Scales along the axes by these factors, none of them zero; one number is the factor of all
    /// three.
    Scale(
        #[serde(deserialize_with = "lists::number_or_vector")]
        #[schemars(with = "lists::NumberOrVector")]
        Vector,
    ),
    /// Rotates about the x axis.
    RotateX(f64),
    /// Rotates about the y axis.
    RotateY(f64),
    /// Rotates about the z axis.
    RotateZ(f64),
    /// Rotates about the line through `point` along `direction`.
    RotateAbout {
        /// A point of the line.
        point: Point,
        /// The direction of the line; not zero.
        direction: Vector,
        /// Angle in degrees.
        degrees: f64,
    },
    /// Reflects across a coordinate plane: `"x"` sends x to −x.
    Reflect(Axis),
    /// The six-factor shear `x' = x + a y + b z`, `y' = c x + y + d z`, `z' = e x + f y + z`, as
    /// `[a, b, c, d, e, f]`.
    Shear(#[serde(deserialize_with = "lists::exactly")] [f64; 6]),
    /// Any affine map, by the four rows of its matrix: it sends x to
    /// `m[0][0] x + m[0][1] y + m[0][2] z + m[0][3]`. The last row is `[0, 0, 0, 1]`.
    Matrix(
        #[serde(deserialize_with = "lists::rows")]
        #[schemars(extend("x-dimension" = "length in the last column"))]
        [[f64; 4]; 4],
    ),
}

/// A coordinate axis.
#[kind]
#[allow(missing_docs)]
#[schemars(title = "axes")]
pub enum Axis {
    X,
    Y,
    Z,
}

/// A transformation that has no inverse, or whose inverse would have no correct digits.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("the transformation is singular (condition number {condition:.1e}; at most 1e12 fits)")]
pub struct Singular {
    /// Frobenius norm of the matrix times that of its inverse; infinite if there is none.
    pub condition: f64,
}

/// Inverses of matrices of larger condition would have too few correct digits.
const MAX_CONDITION: f64 = 1e12;

/// An affine map and its inverse. Points, vectors and normals each transform in their own way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    forward: DAffine3,
    inverse: DAffine3,
}

impl Step {
    /// The matrix of the step and that of its inverse; an inverse that does not exist is not
    /// finite.
    fn matrices(&self) -> [DAffine3; 2] {
        let linear = |m: DMat3, inverse: DMat3| [m, inverse].map(DAffine3::from_mat3);
        let rotation = |m: DMat3| linear(m, m.transpose());
        match *self {
            Step::Translate(v) => [v, -v].map(|v| DAffine3::from_translation(v.0)),
            Step::Scale(s) => linear(DMat3::from_diagonal(s.0), DMat3::from_diagonal(s.0.recip())),
            Step::RotateX(degrees) => rotation(rotation_about(DVec3::X, degrees)),
            Step::RotateY(degrees) => rotation(rotation_about(DVec3::Y, degrees)),
            Step::RotateZ(degrees) => rotation(rotation_about(DVec3::Z, degrees)),
            Step::RotateAbout { point, direction, degrees } => {
                let axis = Normal::new(direction).map_or(DVec3::NAN, |n| n.0);
                rotation(rotation_about(axis, degrees)).map(|turn| {
                    DAffine3::from_translation(point.0)
                        * turn
                        * DAffine3::from_translation(-point.0)
                })
            }
            Step::Reflect(axis) => {
                let mut s = DVec3::ONE;
                s[axis as usize] = -1.0;
                linear(DMat3::from_diagonal(s), DMat3::from_diagonal(s))
            }
            Step::Shear([a, b, c, d, e, f]) => {
                let m = DMat3::from_cols_array(&[1.0, c, e, a, 1.0, f, b, d, 1.0]);
                linear(m, inverse_of(m))
            }
            Step::Matrix([x, y, z, _]) => {
                let column = |j: usize| DVec3::new(x[j], y[j], z[j]);
                let matrix3 = DMat3::from_cols(column(0), column(1), column(2));
                let forward = DAffine3 { matrix3, translation: column(3) };
                let matrix3 = inverse_of(matrix3);
                let translation = -(matrix3 * forward.translation);
                [forward, DAffine3 { matrix3, translation }]
            }
        }
    }
}

/// The inverse of `m` to the last bits, by Newton's iteration from `x`; `None` if `x` is too far
/// off.
fn improved(m: DMat3, mut x: DMat3) -> Option<DMat3> {
    /// Each step doubles the number of correct digits; there are 53.
    const MAX_STEPS: usize = 8;
    for _ in 0..MAX_STEPS {
        let entry = |i: usize, j: usize| {
            let identity = if i == j { 1.0 } else { 0.0 };
            less_products(identity, m.row(i).to_array(), x.col(j).to_array())
        };
        let column = |j| DVec3::new(entry(0, j), entry(1, j), entry(2, j));
        let residual = DMat3::from_cols(column(0), column(1), column(2));
        if !residual.is_finite() {
            return x.is_finite().then_some(x); // beyond the range of error-free products
        }
        if frobenius(residual) >= 0.5 {
            return None;
        }
        let step = x * residual;
        x += step;
        if frobenius(step) <= 4.0 * UNIT_ROUNDOFF * frobenius(x) {
            return Some(x);
        }
    }
    None
}

/// The inverse by cofactors; not finite if there is none. (glam's panics instead.)
fn inverse_of(m: DMat3) -> DMat3 {
    let rows = [m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis)];
    let determinant = m.x_axis.dot(rows[0]);
    DMat3::from_cols(rows[0], rows[1], rows[2]).transpose() * (1.0 / determinant)
}

fn frobenius(m: DMat3) -> f64 {
    let all = m.to_cols_array();
    if !m.is_finite() {
        return f64::INFINITY;
    }
    let largest = all.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if largest == 0.0 {
        return 0.0;
    }
    // scaled: the squares of very large and very small numbers overflow or underflow
    largest * all.iter().map(|x| (x / largest) * (x / largest)).sum::<f64>().sqrt()
}

/// Rodrigues' rotation about a unit axis.
fn rotation_about(axis: DVec3, degrees: f64) -> DMat3 {
    let (s, c) = (sin_degrees(degrees), cos_degrees(degrees));
    let turned = |v: DVec3| v * c + axis.cross(v) * s + axis * (axis.dot(v) * (1.0 - c));
    DMat3::from_cols(turned(DVec3::X), turned(DVec3::Y), turned(DVec3::Z))
}

impl Transform {
    /// Changes nothing.
    pub const IDENTITY: Self = Self { forward: DAffine3::IDENTITY, inverse: DAffine3::IDENTITY };

    /// Moves everything by this vector.
    pub fn translation(by: Vector) -> Self {
        let [forward, inverse] = [by, -by].map(|v| DAffine3::from_translation(v.0));
        Self { forward, inverse }
    }

    /// The steps applied one after the other: `M = Tₙ … T₂ T₁`, `M⁻¹ = T₁⁻¹ T₂⁻¹ … Tₙ⁻¹`.
    ///
    /// # Errors
    /// [`Singular`] if the result has no inverse worth the name.
    pub fn from_steps(steps: &[Step]) -> Result<Self, Singular> {
        let whole = steps.iter().fold(Self::IDENTITY, |so_far, step| {
            let [forward, inverse] = step.matrices();
            Self { forward: forward * so_far.forward, inverse: so_far.inverse * inverse }
        });
        whole.refined()?.invertible()
    }

    /// This map after `first`.
    ///
    /// # Errors
    /// As [`Transform::from_steps`], of the two together.
    pub fn checked_after(&self, first: &Self) -> Result<Self, Singular> {
        self.after(first).invertible()
    }

    fn invertible(self) -> Result<Self, Singular> {
        let condition = self.condition();
        if condition <= MAX_CONDITION && self.forward.is_finite() && self.inverse.is_finite() {
            Ok(self)
        } else {
            Err(Singular { condition: if condition.is_nan() { f64::INFINITY } else { condition } })
        }
    }

    /// The product `X` of the steps' inverses is only as accurate as the worst of them, and not
    /// exactly the inverse of the rounded product `M` of the steps. Newton's iteration
    /// `X + X (I − M X)` corrects it. If `X` is too far off to start from, the iteration starts
    /// from the inverse by cofactors.
    fn refined(self) -> Result<Self, Singular> {
        let (m, x) = (self.forward.matrix3, self.inverse.matrix3);
        let cofactors = inverse_of(m);
        let Some(matrix3) = improved(m, x).or_else(|| improved(m, cofactors)) else {
            let condition = frobenius(m) * frobenius(x).max(frobenius(cofactors));
            let known = condition > MAX_CONDITION;
            return Err(Singular { condition: if known { condition } else { f64::INFINITY } });
        };
        let translation = DVec3::ZERO - matrix3 * self.forward.translation;
        Ok(Self { inverse: DAffine3 { matrix3, translation }, ..self })
    }

    /// Frobenius norm of the linear part times that of its inverse.
    pub fn condition(&self) -> f64 {
        frobenius(self.forward.matrix3) * frobenius(self.inverse.matrix3)
    }

    /// The determinant of the linear part: by how much volumes grow, negative for a mirror image.
    pub fn determinant(&self) -> f64 {
        self.forward.matrix3.determinant()
    }

    /// Whether it preserves angles up to rounding, as rotations, reflections and uniform scalings
    /// do.
    pub fn is_similarity(&self) -> bool {
        /// More than the rounding of typed factors, and invisible.
        const SKEW: f64 = 1e-9;
        let m = self.forward.matrix3;
        let columns = [m.x_axis, m.y_axis, m.z_axis];
        let size = m.x_axis.length_squared();
        let close = |a: f64, b: f64| (a - b).abs() <= SKEW * size;
        (0..3).all(|i| {
            (0..3).all(|j| close(columns[i].dot(columns[j]), if i == j { size } else { 0.0 }))
        })
    }

    /// The map that undoes this one.
    pub fn inverse(&self) -> Self {
        Self { forward: self.inverse, inverse: self.forward }
    }

    /// This map after `first`.
    pub fn after(&self, first: &Self) -> Self {
        Self { forward: self.forward * first.forward, inverse: first.inverse * self.inverse }
    }

    /// The three rows `[m0, m1, m2, translation]` of the matrix.
    pub fn rows(&self) -> [[f64; 4]; 3] {
        let (m, t) = (self.forward.matrix3, self.forward.translation);
        std::array::from_fn(|i| [m.x_axis[i], m.y_axis[i], m.z_axis[i], t[i]])
    }

    /// Transforms a point.
    pub fn point(&self, p: Point) -> Point {
        Point(self.forward.transform_point3(p.0))
    }

    /// Transforms a vector; translations do not change it.
    pub fn vector(&self, v: Vector) -> Vector {
        Vector(self.forward.transform_vector3(v.0))
    }

    /// `M⁻ᵀ n`, not normalised: perpendicular to the transformed surface. Distances along the
    /// normal are divided by its length.
    pub fn covector(&self, n: Normal) -> Vector {
        Vector(self.inverse.matrix3.transpose() * n.0)
    }

    /// The ray in the coordinates before the transformation; its direction is not normalised, so
    /// `t` means the same on both sides.
    pub fn ray_back(&self, ray: &Ray) -> Ray {
        Ray::new(
            Point(self.inverse.transform_point3(ray.origin.0)),
            Vector(self.inverse.transform_vector3(ray.direction.0)),
        )
    }

    /// The box around the transformed corners of a box.
    pub fn bounds(&self, bounds: &Aabb) -> Aabb {
        if bounds.is_bounded() {
            Aabb::around(bounds.corners().map(|corner| self.point(corner)))
        } else {
            Aabb::EVERYTHING
        }
    }

    /// `|M| |v|` for each coordinate: the largest result for a vector of at most `|v|` along each
    /// axis.
    pub fn stretch(&self, v: Vector) -> Vector {
        let (m, v) = (self.forward.matrix3, v.0.abs());
        Vector(m.x_axis.abs() * v.x + m.y_axis.abs() * v.y + m.z_axis.abs() * v.z)
    }

    /// `|M| |p| + |t|` for each coordinate; a few u of it bound the rounding error of
    /// [`Transform::point`].
    pub fn magnitude(&self, p: Point) -> Vector {
        let (m, t) = (self.forward.matrix3, self.forward.translation.abs());
        let p = p.0.abs();
        Vector(m.x_axis.abs() * p.x + m.y_axis.abs() * p.y + m.z_axis.abs() * p.z + t)
    }
}
