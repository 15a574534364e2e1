//! Instances, checked against the transformed shapes that they represent.

use crate::prelude::*;

fn built(kind: impl Into<Kind>) -> Arc<dyn Shape> {
    kind.into().build(&mut Context::default()).expect("valid")
}

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

/// Law: an instance of a sphere is the analytic ellipsoid `|A⁻¹(p − b)| = 1`: every hit lies on it,
/// and a line hits it exactly when the quadratic has roots. Oracle: Cramer's rule on the rows of
/// the forward matrix, and the textbook quadratic.
/// Book: ray tracing transformed objects.
#[test]
fn an_instance_of_a_sphere_is_the_analytic_ellipsoid() {
    let mut draw = Draw::new(2120);
    let mut hits = 0;
    for _ in 0..4_000 {
        let transform = steps(&mut draw);
        let map = Transform::from_steps(&transform).expect("not singular");
        let shape = built(instance(unit_sphere(), transform));
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

/// Law: `t` is the same in world space and in object space: a rotated and moved sphere is hit at the `t`
/// of the moved sphere, whatever the length of the direction. Oracle: the sphere placed there.
/// Book: ray tracing transformed objects.
#[test]
fn an_instance_keeps_t() {
    let mut draw = Draw::new(2121);
    for _ in 0..4_000 {
        let shift = draw.vector(4.0);
        let turn = Step::RotateAbout {
            point: Point::ORIGIN,
            direction: draw.direction().into(),
            degrees: draw.between(-180.0, 180.0),
        };
        let moved = built(instance(unit_sphere(), vec![turn, Step::Translate(shift)]));
        let placed = built(Sphere { center: Point::ORIGIN + shift, radius: 1.0, inward: false });
        let target = Point::ORIGIN + shift + draw.vector(0.5);
        let ray = ray_to(&mut draw, target);
        let [a, b] = [&moved, &placed].map(|shape| shape.hit(&ray, Span::AHEAD));
        let (a, b) = (a.expect("aimed at"), b.expect("aimed at"));
        assert!((a.t - b.t).abs() <= CLOSE * b.t, "{} {}", a.t, b.t);
        let [a, b] = [moved.surface(&ray, &a), placed.surface(&ray, &b)];
        below!(a.point.distance(b.point), CLOSE);
        below!((a.normal + -b.normal).length(), CLOSE);
    }
}

/// Law: the normal of a sphere stretched by (1, 2, 1), where it was at 45°, tilts to (2, 1)/√5, away from
/// the stretch. Oracle: worked by hand.
/// Book: transforming normals.
#[test]
fn normals_tilt_by_the_inverse_transpose() {
    let shape = built(instance(unit_sphere(), vec![Step::Scale(Vector::new(1.0, 2.0, 1.0))]));
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
        let nested = built(instance(instance(cuboid.clone(), inner.clone()), outer.clone()));
        let all: Vec<Step> = inner.into_iter().chain(outer).collect();
        let map = Transform::from_steps(&all).expect("not singular");
        let flat = built(instance(cuboid, all));
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

/// Law: of an object mirrored in an axis the outward normals stay outward, and hits are mirror images.
/// Oracle: the mirrored ray on the shape itself.
/// Book: transforming normals.
#[test]
fn a_reflection_keeps_outward_normals_outward() {
    let mut draw = Draw::new(2123);
    let sphere = Sphere { center: Point::new(0.5, -0.25, 0.75), radius: 0.5, inward: false };
    let plain = built(sphere.clone());
    for (i, axis) in [Axis::X, Axis::Y, Axis::Z].into_iter().enumerate() {
        let mirrored = built(instance(sphere.clone(), vec![Step::Reflect(axis)]));
        for _ in 0..500 {
            let target = sphere.center + draw.vector(0.25);
            let ray = ray_to(&mut draw, target);
            let flip = |v: Vector| {
                Vector::from(std::array::from_fn(|k| if k == i { -v.along(k) } else { v.along(k) }))
            };
            let flip_point = |p: Point| Point::ORIGIN + flip(p.to_vector());
            let image = Ray::new(flip_point(ray.origin), flip(ray.direction));
            let (a, b) = (plain.hit(&ray, Span::AHEAD), mirrored.hit(&image, Span::AHEAD));
            assert_eq!(a, b);
            let hit = a.expect("aimed at");
            let (a, b) = (plain.surface(&ray, &hit), mirrored.surface(&image, &hit));
            assert_eq!(flip_point(a.point), b.point);
            below!((flip(a.normal.into()) + -b.normal).length(), 4.0 * U);
            above!(b.normal.dot(b.point - flip_point(sphere.center)), 0.0);
        }
    }
}

/// Law: every hit lies in the padded bounds of the instance. Oracle: comparison.
/// Book: 21.4, instances.
#[test]
fn the_bounds_of_an_instance_contain_its_hits() {
    let mut draw = Draw::new(2124);
    let mut hits = 0;
    for _ in 0..1_000 {
        let mut kind = crate::support::bodies::body(&mut draw, 1.0).0;
        let transform = steps(&mut draw);
        kind = instance(kind, transform);
        let shape = built(kind);
        let bounds = shape.bounds();
        for _ in 0..100 {
            let (low, extent) = (bounds.min, bounds.extent());
            if !bounds.is_bounded() {
                break;
            }
            let within = |k: usize, f: f64| low.along(k) + f * extent.along(k);
            let f = [(); 3].map(|()| draw.between(0.0, 1.0));
            let target = Point::new(within(0, f[0]), within(1, f[1]), within(2, f[2]));
            let ray = ray_to(&mut draw, target);
            let Some(hit) = shape.hit(&ray, Span::AHEAD) else { continue };
            let surface = shape.surface(&ray, &hit);
            let grown = bounds.padded();
            assert!(grown.contains(surface.point), "{surface:?} outside {bounds:?}");
            hits += 1;
        }
    }
    assert!(hits > 10_000, "only {hits} hits");
}

/// Law: the local point is in the space of the innermost shape, where textures are evaluated: the
/// forward map takes it to the hit point. Oracle: the forward map.
/// Book: the texture of an instance.
#[test]
fn the_local_point_stays_in_object_space() {
    let mut draw = Draw::new(2125);
    for _ in 0..2_000 {
        let (inner, outer) = (steps(&mut draw), steps(&mut draw));
        let kind = instance(instance(unit_sphere(), inner.clone()), outer.clone());
        let all: Vec<Step> = inner.into_iter().chain(outer).collect();
        let map = Transform::from_steps(&all).expect("not singular");
        let shape = built(kind);
        let target = map.point(draw.point(0.5));
        let ray = ray_to(&mut draw, target);
        let hit = shape.hit(&ray, Span::AHEAD).expect("aimed inside");
        let surface = shape.surface(&ray, &hit);
        near!(surface.local.to_vector().length(), 1.0, CLOSE);
        below!(map.point(surface.local).distance(surface.point), CLOSE * 100.0);
        below!(ray.at(hit.t).distance(surface.point), CLOSE * 100.0);
    }
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

/// Law: a uniform scale is never called singular, however large or small it is; a scale that leaves the
/// supported range of lengths is refused for that reason. Oracle: the message.
#[test]
fn a_scale_beyond_all_lengths_is_not_singular() {
    for factor in [1e-160, 1e-100, 1e100, 1e200] {
        let scaled =
            instance(unit_sphere(), vec![Step::Scale(factor * Vector::new(1.0, 1.0, 1.0))]);
        let problem = scaled.build(&mut Context::default()).expect_err("out of range").to_string();
        assert!(!problem.contains("singular") && problem.contains("1e40"), "{factor:e}: {problem}");
    }
}

/// Law: a singular transformation is refused, and the message names the field and the condition.
#[test]
fn an_instance_that_is_flattened_is_refused() {
    let flat = instance(unit_sphere(), vec![Step::Scale(Vector::new(1.0, 0.0, 1.0))]);
    let problem = flat.build(&mut Context::default()).expect_err("singular").to_string();
    assert!(problem.contains("transform") && problem.contains("condition number inf"), "{problem}");
    let flat = instance(unit_sphere(), vec![Step::Shear([1.0, 0.0, 1.0, 0.0, 0.0, 0.0])]);
    let problem = flat.build(&mut Context::default()).expect_err("singular").to_string();
    assert!(problem.contains("singular"), "{problem}");
}
