//! The box that ends the work for a ray that passes a compound by.

use groundtruth::math::{Aabb, Point, Ray, Vector};
use groundtruth::verify::Draw;

/// A box, a line that touches it in one corner alone (or along an edge), and a direction from there
/// away from the box, perpendicular to the line: integers, exact in all that is done with them here.
fn touched(draw: &mut Draw) -> (Aabb, Point, Vector, Vector) {
    const SCALE: f64 = (1_u64 << 30) as f64;
    let whole = |draw: &mut Draw, n: usize| draw.below(n) as f64;
    let mut low = || SCALE * (whole(draw, 2000) - 1000.0);
    let min = Point::new(low(), low(), low());
    let mut side = || SCALE * (1.0 + whole(draw, 1000));
    let max = min + Vector::new(side(), side(), side());
    let mut corner = || if draw.coin() { (min, -1.0) } else { (max, 1.0) };
    let ends = [corner(), corner(), corner()];
    let mut outward = |sign: f64| sign * whole(draw, 9);
    let away = Vector::new(outward(ends[0].1), outward(ends[1].1), outward(ends[2].1));
    let mut any = || whole(draw, 9) - 4.0;
    let along = away.cross(Vector::new(any(), any(), any()));
    let corner = Point::new(ends[0].0.x(), ends[1].0.y(), ends[2].0.z());
    (Aabb { min, max }, corner, along, away)
}

/// Law: a line that touches a box in a corner may meet it, wherever it starts and however long its
/// direction; 10⁻¹² of the coordinates farther out it does not. Oracle: integers, in which a plane
/// through the corner has all of the box on one side.
#[test]
fn a_line_may_meet_a_box_up_to_its_corner_and_no_farther() {
    let mut draw = Draw::new(1966);
    let mut lines = 0;
    while lines < 100_000 {
        let (bounds, corner, along, away) = touched(&mut draw);
        if along == Vector::ZERO {
            continue;
        }
        lines += 1;
        let steps = draw.sign() * (draw.below(1 << 31) as f64);
        let length = [1.0, 0.125, 1024.0][draw.below(3)];
        let through = |p: Point| Ray::new(p - steps * along, length * along);
        assert!(
            bounds.may_meet(&through(corner), f64::NEG_INFINITY),
            "{:?} {bounds:?}",
            through(corner)
        );
        let beside = through(corner + away);
        assert!(!bounds.may_meet(&beside, f64::NEG_INFINITY), "{beside:?} {bounds:?}");
        let inside = through(corner - away);
        assert!(bounds.may_meet(&inside, f64::NEG_INFINITY), "{inside:?} {bounds:?}");
    }
}

/// Law: a box is met up to where the ray leaves it, and not beyond, but for roundings. Oracle: worked
/// by hand.
#[test]
fn a_ray_may_meet_a_box_up_to_where_it_leaves_it() {
    let unit = Aabb { min: Point::ORIGIN, max: Point::new(1.0, 1.0, 1.0) };
    let ray = Ray::new(Point::new(0.25, 0.5, -1.0), Vector::new(0.0, -0.0, 0.5));
    for (start, meets) in
        [(-1.0, true), (0.0, true), (3.0, true), (4.0, true), (4.0 + 1e-12, false)]
    {
        assert_eq!(unit.may_meet(&ray, start), meets, "{start}");
        assert_eq!(unit.may_meet(&Ray::new(ray.at(start), ray.direction), 0.0), meets, "{start}");
        assert!(Aabb::EVERYTHING.may_meet(&ray, start));
        assert!(!Aabb::EMPTY.may_meet(&ray, start));
    }
}

/// Law: lines along an axis, in the plane of a face, and beside it; and boxes without bounds. Oracle:
/// worked by hand.
#[test]
fn zeros_and_infinities_decide_as_they_should() {
    let unit = Aabb { min: Point::ORIGIN, max: Point::new(1.0, 1.0, 1.0) };
    for zero in [0.0, -0.0] {
        for (y, meets) in [(-1e-12, false), (0.0, true), (0.5, true), (1.0, true), (1.5, false)] {
            let ray = Ray::new(Point::new(7.0, y, 0.5), Vector::new(1.0, zero, -zero));
            assert_eq!(unit.may_meet(&ray, f64::NEG_INFINITY), meets, "{ray:?}");
            let ray = Ray::new(Point::new(-7.0, y, 0.5), Vector::new(-2.0, zero, zero));
            assert_eq!(unit.may_meet(&ray, f64::NEG_INFINITY), meets, "{ray:?}");
            assert!(Aabb::EVERYTHING.may_meet(&ray, f64::NEG_INFINITY));
            assert!(!Aabb::EMPTY.may_meet(&ray, f64::NEG_INFINITY));
        }
    }
}
