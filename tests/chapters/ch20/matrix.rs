//! The transformation step that is given as a matrix.

use super::transform;
use crate::prelude::*;

/// Law: a matrix is written row by row, with the translation in the last column. Oracle: worked by hand.
/// Book: points, vectors and homogeneous matrices.
#[test]
fn a_matrix_has_its_entries_in_rows() {
    let t = transform(&[Step::Matrix([
        [0.5, 0.25, -0.5, 3.0],
        [0.125, 0.75, -0.25, -2.0],
        [1.0, 2.0, 4.0, 8.0],
        [0.0, 0.0, 0.0, 1.0],
    ])]);
    assert_eq!(t.point(Point::new(2.0, 4.0, 8.0)), Point::new(1.0, -0.75, 50.0));
    assert_eq!(t.vector(Vector::new(2.0, 4.0, 8.0)), Vector::new(-2.0, 1.25, 42.0));
}
