//! Instances, checked against the transformed shapes that they represent.

use crate::prelude::*;

fn instance(of: impl Into<Kind>, transform: Vec<Step>) -> Kind {
    Instance::new(of.into(), transform).into()
}

fn unit_sphere() -> Sphere {
    Sphere { center: Point::ORIGIN, radius: 1.0, inward: false }
}

/// Steps of every kind, scales from 1/3 to 3.
fn steps(draw: &mut Draw) -> Vec<Step> {
    let factor = |draw: &mut Draw| draw.sign() * draw.between(0.34, 3.0);
    vec![
        Step::Scale(Vector::new(factor(draw), factor(draw), factor(draw))),
        Step::RotateY(draw.between(-180.0, 180.0)),
        Step::Shear([0.0, draw.between(-0.5, 0.5), 0.0, 0.0, draw.between(-0.5, 0.5), 0.0]),
        Step::RotateX(draw.between(-180.0, 180.0)),
        Step::Reflect(Axis::Z),
        Step::Translate(draw.vector(2.0)),
    ]
}

fn ray_to(draw: &mut Draw, target: Point) -> Ray {
    let origin = target + draw.between(1.0, 12.0) * draw.direction();
    Ray::new(origin, draw.decades(-2.0, 2.0) * (target - origin))
}

/// Scales near 1, ten steps, distances near 10: errors are well below this.
const CLOSE: f64 = 1e-9;

/// Law: an instance of a sphere, mirrored too, is the analytic ellipsoid `|A⁻¹(p − b)| = 1`: every hit lies on it, its
/// normal outward, and a line hits it exactly when the quadratic has roots, at its `t`. Oracle: Cramer's rule on the
/// rows of the forward matrix, and the textbook quadratic.
/// Book: ray tracing transformed objects.
#[test]
fn an_instance_of_a_sphere_is_the_analytic_ellipsoid() {
    let mut draw = Draw::new(2120);
    let mut hits = 0;
    for _ in 0..4_000 {
        let transform = steps(&mut draw);
        let map = Transform::from_steps(&transform).expect("not singular");
        let shape = shape_of(instance(unit_sphere(), transform));
        let rows = map.rows();
        let column = |j: usize| Vector::new(rows[0][j], rows[1][j], rows[2][j]);
        let [a, b, c, shift] = [0, 1, 2, 3].map(column);
        let volume = a.dot(b.cross(c));
        let solve = |v: Vector| {
            let x = [v.dot(b.cross(c)), a.dot(v.cross(c)), a.dot(b.cross(v))];
            Vector::from(x.map(|x| x / volume))
        };
        let target = map.point(draw.point(1.2));
        let ray = ray_to(&mut draw, target);
        let (o, d) = (solve(ray.origin.to_vector() - shift), solve(ray.direction));
        let (qa, qb, qc) = (d.dot(d), o.dot(d), o.dot(o) - 1.0);
        let discriminant = qb * qb - qa * qc;
        if discriminant.abs() < 1e-6 * qb * qb {
            continue; // nearly tangent
        }
        let roots = shape.roots(&ray, Span::LINE);
        assert_eq!(roots.len(), if discriminant > 0.0 { 2 } else { 0 });
        for (root, sign) in roots.iter().zip([-1.0, 1.0]) {
            let t = (-qb + sign * discriminant.sqrt()) / qa;
            assert!((root.t - t).abs() <= CLOSE * (1.0 + t.abs()), "{} for {t}", root.t);
            let surface = shape.surface(&ray, root);
            let local = solve(surface.point.to_vector() - shift);
            near!(local.length(), 1.0, CLOSE);
            // the gradient 2 A⁻ᵀ A⁻¹ (p − b) is perpendicular to A w for every w perpendicular to the
            // local point
            let w = local.cross(draw.direction());
            near!(surface.normal.dot(map.vector(w)), 0.0, CLOSE);
            assert!(surface.normal.dot(surface.point.to_vector() - shift) > 0.0, "inward");
            hits += 1;
        }
    }
    above!(hits, 1_000);
}

/// Law: the normal of a sphere stretched by (1, 2, 1), where it was at 45°, tilts to (2, 1)/√5, away from
/// the stretch. Oracle: worked by hand.
/// Book: transforming normals.
#[test]
fn normals_tilt_by_the_inverse_transpose() {
    let shape = shape_of(instance(unit_sphere(), vec![Step::Scale(Vector::new(1.0, 2.0, 1.0))]));
    let half = 0.5_f64.sqrt();
    let point = Point::new(half, 2.0 * half, 0.0);
    let ray = Ray::new(point + Vector::X, -Vector::X);
    let hit = shape.hit(&ray, Span::AHEAD).expect("aimed at");
    let normal = shape.surface(&ray, &hit).normal;
    let expected = (1.0 / 5.0_f64.sqrt()) * Vector::new(2.0, 1.0, 0.0);
    assert!((Vector::from(normal) - expected).length() < 16.0 * U, "{normal:?}");
}

/// Law: an instance of an instance is the instance of the product. Oracle: the steps in one list.
/// Book: nested objects and their materials.
#[test]
fn an_instance_of_an_instance_is_the_instance_of_the_product() {
    let mut draw = Draw::new(2122);
    let mut hits = 0;
    for _ in 0..2_000 {
        let (inner, outer) = (steps(&mut draw), steps(&mut draw));
        let cuboid =
            shapes::Cuboid { min: Point::new(-1.0, -0.5, -1.0), max: Point::new(0.5, 1.0, 1.0) };
        let nested = shape_of(instance(instance(cuboid.clone(), inner.clone()), outer.clone()));
        let all: Vec<Step> = inner.into_iter().chain(outer).collect();
        let map = Transform::from_steps(&all).expect("not singular");
        let flat = shape_of(instance(cuboid, all));
        let target = map.point(draw.point(0.7));
        let ray = ray_to(&mut draw, target);
        let (a, b) = (nested.hit(&ray, Span::AHEAD), flat.hit(&ray, Span::AHEAD));
        let (Some(a), Some(b)) = (a, b) else {
            assert_eq!(a.is_some(), b.is_some());
            continue;
        };
        hits += 1;
        assert_eq!(a.part, b.part);
        near!(a.t, b.t, CLOSE * b.t);
        let (a, b) = (nested.surface(&ray, &a), flat.surface(&ray, &b));
        below!(a.local.distance(b.local), CLOSE);
        below!((a.normal + -b.normal).length(), CLOSE);
    }
    above!(hits, 1_000);
}

/// Law: nested instances whose product is singular are refused as a single one would be; a scaling that
/// the outer instance undoes is accepted. Oracle: the condition number of the product, by hand.
#[test]
fn instances_that_flatten_together_are_refused() {
    let thin = |y: f64| vec![Step::Scale(Vector::new(1.0, y, 1.0))];
    let nested =
        |inner: f64, outer: f64| instance(instance(unit_sphere(), thin(inner)), thin(outer));
    for [inner, outer] in [[1e-7, 1e-7], [1e-3, 1e-11], [1e7, 1e7]] {
        let built = nested(inner, outer).build(&mut Context::default());
        let problem = built.expect_err("flat").to_string();
        let said = ["of.instance.transform", "with the instances around it", "singular"];
        assert!(said.iter().all(|words| problem.contains(words)), "{problem}");
    }
    for [inner, outer] in [[1e-5, 1e-5], [1e-9, 1e9], [1e10, 1e-10]] {
        nested(inner, outer).build(&mut Context::default()).expect("round enough");
    }
    let mut context = Context::default();
    nested(1e-7, 1e-7).build(&mut context).expect_err("flat");
    nested(1e-5, 1e-5).build(&mut context).expect("the next one stands alone");
}

/// Law: a ray that leaves a stretched rectangle beside its border starts as far inside as one that leaves a rectangle of
/// that size: 4,096 roundings of its coordinates or more, not 16 times as many, wherever within them it was hit. Oracle:
/// the coordinates of the stretched corner, which the test multiplies itself; stretches from 1e-6 to 1e6.
#[test]
fn a_stretched_border_is_left_like_a_large_one() {
    let (mut draw, mut hits) = (Draw::new(2117), 0);
    for case in 0..2_000 {
        let corner = draw.point(8.0);
        let [a, b] = [Vector::X, Vector::Z].map(|axis| draw.between(0.5, 4.0) * axis);
        let stretch = draw.sign() * draw.decades(-6.0, 6.0);
        let scale = Vector::new(stretch, 1.0, draw.decades(-1.0, 1.0));
        let flat = Instance::new(Rectangle { corner, a, b }, vec![Step::Scale(scale)]);
        let shape = shape_of(flat);
        let size = corner.to_vector().max_abs().max((corner + a + b).to_vector().max_abs());
        let rounding = stretch.abs() * U * size;
        let inside = draw.decades(0.0, 3.0) * rounding;
        let x = stretch * corner.x() + stretch.signum() * inside;
        let target = Point::new(x, corner.y(), scale.z() * (corner + 0.5 * b).z());
        let up = Vector::new(0.0, 1.0, 0.1 * draw.between(-1.0, 1.0));
        let ray = Ray::new(target + up, -up);
        let Some(hit) = shape.hit(&ray, Span::AHEAD) else { continue };
        hits += 1;
        let start = shape.surface(&ray, &hit).leave(up);
        let roundings = stretch.signum() * (start.x() - stretch * corner.x()) / rounding;
        at_least!(roundings, 4095.0, "case {case}, stretch {stretch:e}, hit {inside:e} inside");
        at_most!(
            roundings,
            16.0 * 4096.0,
            "case {case}, stretch {stretch:e}, hit {inside:e} inside"
        );
    }
    at_least!(hits, 1_900);
}
