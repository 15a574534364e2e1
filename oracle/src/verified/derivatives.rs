//! Derivatives against difference quotients in high precision.

use super::{
    everything,
    inputs::{Case, length},
};
use crate::{
    answer::answer,
    real::{Real, V, nearest, real},
    shape::Shape,
};

fn tiny(exponent: usize) -> Real {
    (0..exponent).fold(real(1.0), |x, _| x / real(10.0))
}

/// A function that is 0 on the surface and grows in the direction of the normal.
fn implicit(shape: &Shape<Real>, p: &V) -> Real {
    let v = |x: &[Real; 3]| V(x.clone());
    match shape {
        Shape::Plane { point: c, normal }
        | Shape::Disk { center: c, normal, .. }
        | Shape::Annulus { center: c, normal, .. } => (p - &v(c)).dot(&v(normal)),
        Shape::PartAnnulus { center, .. } => &p.0[1] - &center[1],
        Shape::CutFace { .. } => p.0[1].clone(),
        Shape::Solid(_) => unreachable!("solids have laws of their own"),
        Shape::Sphere { center, radius } | Shape::PartSphere { center, radius, .. } => {
            (p - &v(center)).norm() - radius
        }
        Shape::Cuboid { min, max } => {
            (0..3).flat_map(|i| [&min[i] - &p.0[i], &p.0[i] - &max[i]]).max().expect("six faces")
        }
        Shape::Triangle { vertices } => {
            let [a, b, c] = vertices.each_ref().map(v);
            (p - &a).dot(&(&b - &a).cross(&(&c - &a)))
        }
        Shape::Rectangle { corner, a, b } => (p - &v(corner)).dot(&v(a).cross(&v(b))),
        Shape::OpenCylinder { radius, .. } | Shape::PartCylinder { radius, .. } => rho(p) - radius,
        Shape::Cone { height, radius } => rho(p) / radius + &p.0[1] / height,
        Shape::Paraboloid { height, radius } => {
            rho(p) * rho(p) / (radius * radius) - &p.0[1] / height
        }
        Shape::Torus { swept_radius, tube_radius }
        | Shape::PartTorus { swept_radius, tube_radius, .. } => {
            let k = (&p.0[0] * &p.0[0] + &p.0[2] * &p.0[2]).sqrt() - swept_radius;
            (&k * &k + &p.0[1] * &p.0[1]).sqrt() - tube_radius
        }
        Shape::Algebraic { terms, .. } => terms.iter().fold(real(0.0), |sum, (c, powers)| {
            let factors = (0..3).flat_map(|i| vec![&p.0[i]; powers[i] as usize]);
            sum + factors.fold(c.clone(), |product, x| product * x)
        }),
        Shape::Instance { matrix, of } => {
            let column = |j: usize| V(std::array::from_fn(|i| matrix[i][j].clone()));
            let [a, b, c] = [column(0), column(1), column(2)];
            let (x, det) = (p - &column(3), a.dot(&b.cross(&c)));
            let minors = [x.dot(&b.cross(&c)), a.dot(&x.cross(&c)), a.dot(&b.cross(&x))];
            implicit(of, &V(minors.map(|minor| minor / &det)))
        }
    }
}

fn rho(p: &V) -> Real {
    (&p.0[0] * &p.0[0] + &p.0[2] * &p.0[2]).sqrt()
}

/// Oracle: central differences of the implicit function with steps of 10⁻⁵⁰.
#[test]
fn the_normal_is_the_direction_in_which_the_implicit_function_grows() {
    let step = tiny(50);
    for (kind, family, shape, ray) in everything(12) {
        let case = Case::new(&shape, &ray);
        let before = answer(&case.shape, &case.ray);
        if before.margin < 1e-30 {
            continue; // such as a ray within a face, where the function has no gradient
        }
        for root in before.roots.iter().filter(|root| root.face_margin > 1e-30) {
            let d = V(case.ray.direction.clone());
            let p = &V(case.ray.origin.clone()) + &(&d * &root.exact_t);
            let slope = V(std::array::from_fn(|i| {
                let mut there = [p.clone(), p.clone()];
                there[0].0[i] += &step;
                there[1].0[i] -= &step;
                implicit(&case.shape, &there[0]) - implicit(&case.shape, &there[1])
            }));
            let expected = slope.unit().expect("the function is regular");
            let error = (&expected - &root.exact_normal).len();
            assert!(error < 1e-30, "{kind:?} {family:?} {error:e}\n{shape:?}\n{ray:?}");
            let rounded = expected.0.each_ref().map(nearest);
            let same = (0..3).all(|i| (rounded[i] - root.normal[i]).abs() < 2e-16);
            assert!(same, "the normal {:?}, expected {rounded:?}", root.normal);
        }
    }
}

/// Oracle: every component of every input is moved by 10⁻⁴⁰ of its group's length.
#[test]
fn the_condition_is_how_far_t_moves() {
    let step = tiny(40);
    for (kind, family, shape, ray) in everything(5) {
        let mut case = Case::new(&shape, &ray);
        let before = answer(&case.shape, &case.ray);
        let thread = before.roots.iter().map(|root| root.face_margin).fold(before.margin, f64::min);
        if thread < 1e-25 * shape.condition() {
            continue; // t jumps, or has a kink
        }
        let mut sums = vec![0.0; before.roots.len()];
        for g in 0..case.groups().len() {
            let size = length(case.groups()[g].iter().map(|x| &**x));
            let mut squares = vec![0.0; sums.len()];
            for i in 0..case.groups()[g].len() {
                *case.groups()[g][i] += &step * &size;
                let after = answer(&case.shape, &case.ray);
                *case.groups()[g][i] -= &step * &size;
                for (k, square) in squares.iter_mut().enumerate() {
                    let moved = &after.roots[k].exact_t - &before.roots[k].exact_t;
                    let rate = nearest(&(moved / &step));
                    *square += rate * rate;
                }
            }
            for (sum, square) in sums.iter_mut().zip(squares) {
                *sum += square.sqrt();
            }
        }
        for (root, sum) in before.roots.iter().zip(sums) {
            let error = (root.cond / sum - 1.0).abs();
            assert!(
                error < 1e-9,
                "{kind:?} {family:?} cond {:e}, moved {sum:e}\n{shape:?}\n{ray:?}",
                root.cond
            );
        }
    }
}
