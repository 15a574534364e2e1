//! Leaving a surface: a ray does not hit the point again that it starts from, and it does not miss the
//! next surface.

use std::ops::Range;

use crate::prelude::*;
use crate::support::bodies::Form;
use crate::support::bodies::body;
use crate::support::bodies::built;
use crate::support::bodies::check_leaving;
use crate::support::bodies::random_hit;
use crate::support::leaving::check_kinds;

fn check_shapes(cases: Range<usize>, seed: u64) {
    let count = cases.len();
    let (mut largest, mut hits) = (0.0_f64, 0);
    for i in cases {
        let mut draw = Draw::case(seed, i);
        let size = draw.decades(-6.0, 6.0);
        let (kind, form, middle) = body(&mut draw, size);
        let shape = built(&kind);
        let Some(surface) = random_hit(&mut draw, &*shape, middle, size) else { continue };
        hits += 1;
        let case = format!("case {i}: {kind:?}");
        let coordinates = surface.point.to_vector().max_abs() + size;
        largest = largest.max(surface.error / (U * coordinates));
        assert!(
            surface.error <= MAX * U * coordinates,
            "{case}: the bound {surface:?} is too wide"
        );
        let skipped = check_leaving(&mut draw, &kind, &*shape, form, &surface, &case);
        assert!(!skipped, "{case}: no shape here is thin enough to be skipped");
    }
    assert!(10 * hits > 8 * count, "only {hits} hits");
    println!("widest bound: {largest:.1} u of the coordinates");
}

/// Error bounds may be a few dozen roundings of the largest coordinate or size, no more.
const MAX: f64 = 100.0;

/// Law: a ray that leaves a surface does not hit it again at the same point. It finds the far side of
/// the solid that it is inside of, and every surface that is more than 8 error bounds away. Scales are
/// from 1e-6 to 1e6, angles to the surface down to 1e-9. Oracle: how often a line meets convex and flat
/// shapes.
#[test]
fn a_ray_that_leaves_does_not_meet_the_same_point_again() {
    check_shapes(0..as_many(40_000, 4_000_000), 1900);
}

/// Law: a segment between two points of a convex surface, offset at both ends, meets nothing, even if
/// the points are only a millionth of the size apart. Oracle: convexity.
#[test]
fn a_shadow_segment_is_free_of_both_its_ends() {
    let mut draw = Draw::new(1902);
    let mut checked = 0;
    for i in 0..60_000 {
        let size = draw.decades(-6.0, 6.0);
        let (kind, form, middle) = body(&mut draw, size);
        if form == Form::Flat {
            continue;
        }
        let shape = built(&kind);
        let Some(p) = random_hit(&mut draw, &*shape, middle, size) else { continue };
        // another point of the surface: seen from a point inside, which may be very near
        let inside = p.point - (size * draw.decades(-6.0, -1.0)) * p.normal;
        let other = Ray::new(inside, draw.leaving(p.normal));
        let Some(hit) = shape.hit(&other, Span::AHEAD) else { continue };
        let q = shape.surface(&other, &hit);
        let line = q.point - p.point;
        let same_face = form != Form::Tube && p.normal.dot(line) >= -1e-12 * size;
        if same_face || line.length() < 1e-6 * size || q.normal.dot(line) <= 1e-12 * size {
            continue; // in a face of a box: the chord lies in the surface
        }
        if p.normal.dot(line) >= -1e-12 * size {
            continue; // along a generator
        }
        let (from, to) = (p.leave(line), q.leave(-line));
        let segment = Ray::new(from, to - from);
        let blocked = shape.shadow_hit(&segment, Span::SEGMENT);
        assert_eq!(blocked, None, "case {i}: {kind:?} between {p:?} and {q:?}");
        checked += 1;
    }
    assert!(checked > 10_000, "only {checked} segments");
}

/// Law: a segment between two parallel planes meets neither of them, but finds a third one half-way,
/// even if the gap is only 1e-9 of their distance from the origin. Oracle: geometry.
#[test]
fn a_shadow_segment_between_planes_meets_only_what_is_between() {
    let mut draw = Draw::new(1903);
    for i in 0..20_000 {
        let size = draw.decades(-6.0, 6.0);
        let base = draw.point(size);
        let n = draw.direction();
        let gap = size * draw.decades(-9.0, 0.0);
        let plane = |point| built(&Plane { point, normal: n.into() }.into());
        let [low, middle, high] = [0.0, 0.5, 1.0].map(|f| plane(base + (f * gap) * n));
        let aim = draw.leaving(n);
        let down = Ray::new(base + (10.0 * gap) * n, -aim);
        let up = Ray::new(base - (10.0 * gap) * n, draw.leaving(n));
        let surface = |shape: &Arc<dyn Shape>, ray: &Ray| {
            shape.hit(ray, Span::AHEAD).map(|hit| shape.surface(ray, &hit))
        };
        let (Some(p), Some(q)) = (surface(&low, &down), surface(&high, &up)) else {
            panic!("case {i}: a plane is missed")
        };
        if p.point.to_vector().max_abs() > 4.0 * size || q.point.to_vector().max_abs() > 4.0 * size
        {
            continue; // the segment itself is rounded by more than the bound of its nearer end
        }
        let line = q.point - p.point;
        let (from, to) = (p.leave(line), q.leave(-line));
        let segment = Ray::new(from, to - from);
        let hits = [&low, &middle, &high].map(|s| s.shadow_hit(&segment, Span::SEGMENT).is_some());
        assert_eq!(hits, [false, true, false], "case {i}: gap {gap:e} of {size:e}: {p:?} to {q:?}");
    }
}

/// Law: a ray that leaves a surface of any kind of the chapter does not hit the same point again. If it
/// leaves to the outside, it hits the next surface from outside, and if to the inside, from inside. It
/// finds every surface that is more than 8 error bounds away. Scales are from 1e-6 to 1e6, distances
/// from the origin up to a thousand sizes, angles to the surface down to 1e-9. Oracle: a ray leaves and
/// enters a closed solid in turn.
#[test]
fn every_kind_of_the_chapter_is_left_for_good() {
    check_kinds("ch19", 1905);
}
