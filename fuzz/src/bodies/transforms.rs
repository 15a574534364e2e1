//! Transformations. For any finite numbers: no panic, and an accepted transformation is finite. For integers,
//! powers of two and quarter turns: exactly equal to a second implementation that moves coordinates.

use groundtruth::math::{Aabb, Axis, Normal, Point, Ray, Step, Transform, Vector};

use super::input::{Input, Mode};

/// Reads steps, a point and a vector, and checks the transformation.
pub fn run(data: &[u8]) {
    let mut input = Input::new(data);
    let count = input.byte() % 6;
    let steps: Vec<Step> = (0..count).map(|_| step(&mut input)).collect();
    let (p, v) = (input.point(), input.vector());
    let built = Transform::from_steps(&steps);
    if input.mode == Mode::Grid {
        let transform = built.expect("steps of the grid have an inverse");
        exact(&steps, &transform, p, v);
        let first = Transform::from_steps(&steps[..steps.len() / 2]).expect("as above");
        let second = Transform::from_steps(&steps[steps.len() / 2..]).expect("as above");
        assert_eq!(second.after(&first).rows(), transform.rows(), "one after the other");
    } else {
        match built {
            Ok(transform) => {
                let rows = [transform.rows(), transform.inverse().rows()];
                assert!(rows.as_flattened().as_flattened().iter().all(|x| x.is_finite()));
                assert!(transform.condition() <= 1e12);
                let ray = Ray::new(p, v);
                transform.ray_back(&ray);
                transform.bounds(&Aabb::around([p, p + v]));
            }
            Err(singular) => assert!(singular.condition > 1e12 || overflows(&steps)),
        }
    }
}

/// Whether the steps may be refused for extreme numbers: nonzero and far from 1.
fn overflows(steps: &[Step]) -> bool {
    let is_extreme = |x: f64| !(x == 0.0 || (1e-20..=1e20).contains(&x.abs()));
    steps.iter().any(|step| match *step {
        Step::Translate(v) | Step::Scale(v) => v.to_array().into_iter().any(is_extreme),
        Step::RotateAbout { point, direction, .. } => {
            point.to_array().into_iter().chain(direction.to_array()).any(is_extreme)
        }
        Step::Shear(factors) => factors.into_iter().any(is_extreme),
        Step::Matrix(rows) => rows.into_iter().flatten().any(is_extreme),
        _ => false,
    })
}

/// A step; in grid mode one whose inverse is exact.
pub(super) fn step(input: &mut Input<'_>) -> Step {
    let chaos = input.mode == Mode::Chaos;
    let kind = input.byte() % 9;
    let axis = [Axis::X, Axis::Y, Axis::Z][usize::from(input.byte() % 3)];
    let degrees = if chaos { input.number() } else { 90.0 * input.number() };
    match kind {
        0 => Step::Translate(input.vector()),
        1 if chaos => Step::Scale(input.vector()),
        1 => Step::Scale(Vector::from(std::array::from_fn(|_| {
            let exponent = input.integer() / 3;
            let sign = if input.byte().is_multiple_of(2) { 1.0 } else { -1.0 };
            sign * groundtruth::math::power_of_two(exponent as i32)
        }))),
        2 => Step::RotateX(degrees),
        3 => Step::RotateY(degrees),
        4 => Step::RotateZ(degrees),
        5 => Step::Reflect(axis),
        6 if chaos => Step::Shear(std::array::from_fn(|_| input.number())),
        6 => {
            // a single factor: the inverse is the shear by its negative
            let mut factors = [0.0; 6];
            factors[usize::from(input.byte() % 6)] = input.number();
            Step::Shear(factors)
        }
        7 => {
            // a cyclic permutation of the axes, and a translation
            let mut rows = [[0.0; 4]; 4];
            for (i, row) in rows.iter_mut().enumerate().take(3) {
                row[(i + axis as usize) % 3] = 1.0;
                row[3] = input.number();
                if chaos {
                    row.iter_mut().for_each(|entry| *entry = input.number());
                }
            }
            rows[3][3] = 1.0;
            Step::Matrix(rows)
        }
        _ if chaos => {
            Step::RotateAbout { point: input.point(), direction: input.vector(), degrees }
        }
        _ => {
            let direction = [Vector::X, Vector::Y, Vector::Z][axis as usize];
            Step::RotateAbout { point: input.point(), direction, degrees }
        }
    }
}

/// The coordinates after one step.
fn moved(step: &Step, p: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = p;
    match step {
        Step::Translate(v) => [x + v.x(), y + v.y(), z + v.z()],
        Step::Scale(s) => [x * s.x(), y * s.y(), z * s.z()],
        Step::RotateX(degrees) => turned(p, 0, *degrees),
        Step::RotateY(degrees) => turned(p, 1, *degrees),
        Step::RotateZ(degrees) => turned(p, 2, *degrees),
        Step::RotateAbout { point, direction, degrees } => {
            let c = point.to_array();
            let axis = direction.dominant_axis();
            let from: [f64; 3] = std::array::from_fn(|i| p[i] - c[i]);
            let to = turned(from, axis, *degrees);
            std::array::from_fn(|i| to[i] + c[i])
        }
        Step::Reflect(axis) => {
            let mut q = p;
            q[*axis as usize] = -q[*axis as usize];
            q
        }
        Step::Shear([a, b, c, d, e, f]) => {
            [x + a * y + b * z, c * x + y + d * z, e * x + f * y + z]
        }
        Step::Matrix([first, second, third, _]) => {
            [first, second, third].map(|[a, b, c, d]| a * x + b * y + c * z + d)
        }
    }
}

/// Quarter turns about `axis`, one at a time: with axes in cyclic order `axis`, i, j, each turn takes i to j
/// and j to −i.
fn turned(mut p: [f64; 3], axis: usize, degrees: f64) -> [f64; 3] {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    for _ in 0..(degrees / 90.0).rem_euclid(4.0) as u32 {
        (p[i], p[j]) = (-p[j], p[i]);
    }
    p
}

fn exact(steps: &[Step], transform: &Transform, p: Point, v: Vector) {
    let own = |p: Point| Point::from(steps.iter().fold(p.to_array(), |p, step| moved(step, p)));
    assert_eq!(transform.point(p), own(p), "the coordinates, step by step");
    assert_eq!(transform.vector(v), own(p + v) - own(p), "a vector is a difference of points");
    let inverse = transform.inverse();
    assert_eq!(inverse.point(transform.point(p)), p, "there and back");
    assert_eq!(inverse.vector(transform.vector(v)), v, "there and back");
    let ray = Ray::new(transform.point(p), transform.vector(v));
    assert_eq!(transform.ray_back(&ray), Ray::new(p, v), "a ray that was moved");
    for n in [Normal::X, Normal::Y, Normal::Z] {
        let outside = transform.covector(n).dot(transform.vector(v));
        assert_eq!(outside, n.dot(v), "normals stay perpendicular");
    }
    let bounds = transform.bounds(&Aabb::around([p, p + v]));
    assert!(bounds.contains(transform.point(p)) && bounds.contains(transform.point(p + v)));
}
