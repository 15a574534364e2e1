//! The transformation step that is given as a matrix.

use testkit::properties::*;

use super::{product, size, steps, transform};
use crate::prelude::*;

/// The matrix of these steps as a step.
fn as_matrix(t: &Transform) -> Step {
    let [x, y, z] = t.rows();
    Step::Matrix([x, y, z, [0.0, 0.0, 0.0, 1.0]])
}

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

proptest! {
    #![proptest_config(laws())]

    /// Law: a matrix step does the same as the steps from which its matrix is made. Alone it has the
    /// same rows, bit for bit; after other steps the result is the product. Oracle: the steps
    /// themselves, and the schoolbook product.
    #[test]
    fn a_matrix_is_what_its_steps_are(before in steps(), of in steps(), p in point(3.0)) {
        let (first, then) = (transform(&before), transform(&of));
        let alone = transform(&[as_matrix(&then)]);
        prop_assert_eq!(alone.rows(), then.rows());
        let mut list = before;
        list.push(as_matrix(&then));
        let both = transform(&list);
        let expected = product(&then, &first);
        for (row, expected) in both.rows().iter().zip(expected) {
            for (x, y) in row.iter().zip(expected) {
                near!(x, y, 100.0 * U * size(&first) * size(&then));
            }
        }
        let there = both.inverse().point(both.point(p));
        at_most!(there.distance(p), 1000.0 * U * size(&both) * size(&both.inverse()));
    }
}
