//! Orthonormal frames (Suffern, section 2.13): local coordinates around a direction.

use super::vectors::{Normal, Vector};

/// Three unit vectors at right angles, right-handed: `u × v = w`; left-handed if it is the frame of
/// a mirrored camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// First axis.
    pub u: Vector,
    /// Second axis.
    pub v: Vector,
    /// Third axis; in shading frames the normal.
    pub w: Vector,
}

impl Frame {
    /// A frame whose `w` is this normal, orthonormal within 8u for every unit vector.
    ///
    /// Source: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017. It needs
    /// no jittered up-vector, the book's workaround.
    pub fn around(w: Normal) -> Self {
        let [x, y, z] = w.to_array();
        let sign = 1.0_f64.copysign(z);
        let a = -1.0 / (sign + z);
        let b = x * y * a;
        Self {
            u: Vector::new(1.0 + sign * x * x * a, sign * b, -sign * x),
            v: Vector::new(b, sign + y * y * a, -y),
            w: w.into(),
        }
    }

    /// The book's viewing frame: `w` along `back`, `u = up × w` normalised, `v = w × u`. `None` if
    /// `back` is zero or parallel to `up` (the camera then looks straight up or down).
    pub fn looking(back: Vector, up: Vector) -> Option<Self> {
        let w = back.unit()?;
        let u = up.unit()?.cross(w);
        // parallel up to rounding: the cross product of the unit vectors is only rounding error
        if u.max_abs() < 16.0 * super::UNIT_ROUNDOFF {
            return None;
        }
        let u = u.unit()?;
        let v = w.cross(u).unit()?;
        Some(Self { u, v, w })
    }

    /// `a u + b v + c w`, for `local = (a, b, c)`.
    pub fn to_world(&self, local: Vector) -> Vector {
        local.x() * self.u + local.y() * self.v + local.z() * self.w
    }

    /// The coordinates of `v` in this frame.
    pub fn to_local(&self, v: Vector) -> Vector {
        Vector::new(v.dot(self.u), v.dot(self.v), v.dot(self.w))
    }
}
