//! The bounding box of a compound: a ray that misses it needs no further tests.

use crate::prelude::*;

/// A box, a corner of it, the direction of a line that touches the box only in this corner (or runs
/// along an edge or a face), and a direction perpendicular to the line that points away from the box.
/// All numbers are integers, so that this test computes with them exactly.
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

/// Law: a line that touches a box in a corner may meet it, wherever the ray starts and however long its
/// direction is. Moved outward by about 10⁻¹² of the coordinates, it does not meet it. Oracle: integer
/// arithmetic; the whole box is on one side of a plane through the corner.
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

/// Law: a ray may meet a box if it starts before the point where it leaves the box, and not if it starts
/// beyond that, up to rounding. Oracle: worked by hand.
/// Book: listing 19.1, the bounding box.
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

/// Law: the test of a box is right for rays along an axis, in the plane of a face and beside it, with
/// zeros of either sign; also for empty and infinite boxes. Oracle: worked by hand.
/// Book: listing 19.1, the bounding box.
#[test]
fn zeros_and_infinite_boxes_are_handled() {
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
