//! The transformation step that is given as a matrix.

use testkit::properties::*;

use super::{linear, product, size, steps, transform};
use crate::prelude::*;
use testkit::scaling::scaled;

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

/// Law: an instance with a matrix has the same hits as the instance with the steps of that matrix.
/// Oracle: that instance. `t` is at most 20, and a thousand roundings of it are allowed, as the matrices
/// have a small condition.
#[test]
fn an_instance_by_its_matrix_is_hit_where_the_one_by_steps_is() {
    let mut draw = Draw::new(2013);
    let block = || {
        Kind::from(Cuboid { min: Point::new(-1.0, -0.5, -0.75), max: Point::new(0.5, 1.0, 1.0) })
    };
    let mut hits = 0;
    for _ in 0..400 {
        let steps = vec![
            Step::Scale(Vector::new(draw.between(0.5, 2.0), -1.5, draw.between(0.5, 2.0))),
            Step::RotateAbout {
                point: draw.point(1.0),
                direction: draw.direction().into(),
                degrees: draw.between(-180.0, 180.0),
            },
            Step::Shear([draw.between(-0.5, 0.5), 0.0, 0.0, 0.25, 0.0, 0.0]),
            Step::Translate(draw.vector(1.0)),
        ];
        let matrix = as_matrix(&transform(&steps));
        let [by_steps, by_matrix] = [steps, vec![matrix]].map(|steps| {
            let kind = Kind::from(Instance::new(block(), steps));
            kind.build(&mut Context::default()).expect("valid")
        });
        let from = draw.point(1.0) + 9.0 * Vector::from(draw.direction());
        let ray = Ray::new(from, draw.point(1.0) - from);
        let [one, other] = [by_steps, by_matrix].map(|it| it.hit(&ray, Span::AHEAD));
        assert_eq!(one.is_some(), other.is_some(), "{ray:?}");
        if let (Some(one), Some(other)) = (one, other) {
            hits += 1;
            assert!((one.t - other.t).abs() <= 20_000.0 * U, "{} {}", one.t, other.t);
            assert_eq!(one.part, other.part);
        }
    }
    assert!(hits > 100, "{hits}");
}

/// Law: a matrix with dependent rows is singular; scaling a matrix step scales only its translation.
/// Oracle: a second row that is twice the first; the rows with their last column doubled.
#[test]
fn singular_matrices_are_refused_and_scenes_scale() {
    let last = [0.0, 0.0, 0.0, 1.0];
    let flat = [[1.0, 2.0, 3.0, 0.0], [2.0, 4.0, 6.0, 0.0], [0.0, 1.0, 0.0, 0.0], last];
    assert!(Transform::from_steps(&[Step::Matrix(flat)]).is_err());
    let rows = [[1.0, 2.0, 3.0, 4.0], [0.0, 1.0, 5.0, 6.0], [0.0, 0.0, 1.0, 7.0], last];
    let doubled = transform(&[scaled(&Step::Matrix(rows), 2.0)]);
    assert_eq!(linear(&doubled), linear(&transform(&[Step::Matrix(rows)])));
    assert_eq!(doubled.rows().map(|row| row[3]), [8.0, 12.0, 14.0]);
}
