//! The space in which all boxes are small numbers.

use groundtruth::math::BoxRay;
use groundtruth::mesh_bvh::space::Space;

use crate::prelude::*;

/// Law: a ray towards a point of the boxes, from near or far, starts near the centre and has
/// the point at its `t`. If the span is a line, no part of the boxes is behind its start. A ray
/// that passes beside the boxes is `None` or crosses nothing. Oracle: the point itself.
#[test]
fn a_ray_enters_with_all_that_it_meets() {
    let mut random = Pcg32::new(2210, 0);
    let [mut stayed, mut moved] = [0; 2];
    for case in 0..30_000 {
        let mut x = || 2.0 * random.uniform() - 1.0;
        let size = power(10.0, 30.0 * x());
        let center = Point::ORIGIN + size * (3.0 * Vector::new(x(), x(), x()));
        let half = size * Vector::new(0.1 + x().abs(), 0.1 + x().abs(), 0.1 + x().abs());
        let bounds = Aabb { min: center - half, max: center + half };
        let space = Space::around(&bounds);
        let offset = Vector::new(x() * half.x(), x() * half.y(), x() * half.z());
        let target = center + offset;
        let distance = power(10.0, 6.0 * x()) * half.max_abs();
        let thin = [1.0, 1e-3, 1e-12, 0.0][case % 4];
        let way = Vector::from([[x(), thin, x()], [x(), x(), thin], [thin, x(), x()]][case % 3]);
        let t = distance / power(10.0, 6.0 * x());
        let ray = Ray::new(target - distance * way, (distance / t) * way);
        let at = space.boxed(&Aabb { min: target, max: target }).min.to_vector();
        let boxed = space.boxed(&bounds);
        for span in [Span::AHEAD, Span::LINE] {
            let inside = space.ray(&ray, span).expect("it meets the box");
            *[&mut stayed, &mut moved][usize::from(inside.start != 0.0)] += 1;
            assert!(inside.origin.max_abs() <= 4.0 + 1e-6, "{inside:?}");
            let there = inside.origin + inside.at(t) * inside.direction;
            let from = space.offset_from_center(ray.origin).max_abs().max(4.0);
            let off = (there - at).max_abs();
            assert!(off <= 64.0 * f64::EPSILON * from, "off by {off:e}: {ray:?} {inside:?}");
            let in_space = Ray::new(Point::ORIGIN + inside.origin, inside.direction);
            let box_ray = BoxRay::new(&in_space, 1.0);
            let (enter, _) = box_ray.crossing(&boxed, f64::NEG_INFINITY, f64::INFINITY);
            assert!(span == Span::AHEAD || enter >= 0.0, "{inside:?} starts behind {enter}");
        }
        let side = (8.0 * half.max_abs()) * Vector::new(x().signum(), x().signum(), 0.0);
        let beside = Ray::new(ray.origin + 2.0 * side, ray.direction);
        let across = (side - (side.dot(way) / way.dot(way)) * way).max_abs();
        if across > 4.0 * half.max_abs()
            && let Some(passing) = space.ray(&beside, Span::AHEAD)
        {
            let in_space = Ray::new(Point::ORIGIN + passing.origin, passing.direction);
            assert!(!boxed.may_meet(&in_space, f64::NEG_INFINITY), "{beside:?}");
        }
    }
    assert!(stayed > 5_000 && moved > 5_000, "{stayed} {moved}");
}

/// Law: a ray that cannot be represented crosses every box, and no hit is too far. Oracle: the
/// definition.
#[test]
fn a_ray_without_numbers_crosses_everything() {
    let space = Space::around(&Aabb::around([Point::ORIGIN, Point::new(1.0, 1.0, 1.0)]));
    for (origin, direction) in [(1e30, 1.0), (0.5, 1e200), (0.5, 1e-310), (1e300, 1e300)] {
        let ray = Ray::new(Point::new(origin, 0.0, 0.0), Vector::new(0.0, direction, 0.0));
        let inside = space.ray(&ray, Span::AHEAD).expect("it crosses all");
        assert!(inside.slack > 1e20, "{inside:?}");
        assert!(inside.first(Span::AHEAD) <= 0.0 && inside.last(17.0) >= 0.0, "{inside:?}");
    }
}
