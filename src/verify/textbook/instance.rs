//! The instance (Suffern, ch. 21): the ray is moved back by the inverse matrix.

use super::Textbook;
use crate::math::{Point, Ray, Vector};

/// Something transformed.
#[derive(Debug)]
pub struct Instance {
    inverse: [[f64; 4]; 3],
    of: Box<dyn Textbook>,
}

impl Instance {
    /// `of`, moved by a matrix whose rows have the translation last. The inverse is by cofactors.
    pub fn new(matrix: [[f64; 4]; 3], of: Box<dyn Textbook>) -> Self {
        let [a, b, c] = matrix.map(|[x, y, z, _]| Vector::new(x, y, z));
        let columns = [b.cross(c), c.cross(a), a.cross(b)];
        let inv_det = 1.0 / a.dot(columns[0]);
        let shift = Vector::new(matrix[0][3], matrix[1][3], matrix[2][3]);
        let inverse = std::array::from_fn(|i| {
            let [x, y, z] = columns.map(|column| column.along(i) * inv_det);
            [x, y, z, -Vector::new(x, y, z).dot(shift)]
        });
        Self { inverse, of }
    }
}

impl Textbook for Instance {
    /// The direction is not normalised, so `t` means the same on both sides.
    fn hit(&self, ray: &Ray) -> Option<f64> {
        let (o, d) = (ray.origin.to_vector(), ray.direction);
        let row = |i: usize| {
            let [x, y, z, shift] = self.inverse[i];
            (Vector::new(x, y, z), shift)
        };
        let origin: [f64; 3] = std::array::from_fn(|i| row(i).0.dot(o) + row(i).1);
        let direction: [f64; 3] = std::array::from_fn(|i| row(i).0.dot(d));
        self.of.hit(&Ray::new(Point::from(origin), Vector::from(direction)))
    }
}
