//! Parts of a torus: ranges that cross a seam, that leave no gap, and that add up to the whole.

use groundtruth::shapes::PartTorus;

use super::torus::{built, torus, ts};
use crate::prelude::*;

/// The part of the torus of radii 2 and 0.5 in these ranges.
fn part(phi: [f64; 2], theta: [f64; 2]) -> PartTorus {
    PartTorus { swept_radius: 2.0, tube_radius: 0.5, phi, theta, inward: false }
}

const ALL: [f64; 2] = [0.0, 360.0];

fn some_ray(draw: &mut Draw) -> Ray {
    let target = draw.point(2.5).with(1, draw.between(-0.5, 0.5));
    let origin = draw.point(6.0);
    Ray::new(origin, target - origin)
}

/// Law: a part of a torus has the hits of the whole whose azimuth and whose angle around the tube,
/// `atan2(y, √(x² + z²) − a)`, are in its ranges, which may pass through 360°. Oracle: the arc tangent,
/// in degrees, with ranges that wrap.
/// Book: part objects.
#[test]
fn a_part_has_the_hits_whose_angles_are_in_its_ranges() {
    let mut draw = Draw::new(1960);
    let whole = built(torus(2.0, 0.5));
    let (mut kept, mut dropped) = (0, 0);
    for _ in 0..5_000 {
        let mut range = || {
            let ends = [draw.between(-360.0, 360.0), draw.between(-360.0, 360.0)];
            if draw.below(4) == 0 { ALL } else { ends }
        };
        let (phi, theta) = (range(), range());
        let Ok(shape) = Kind::from(part(phi, theta)).build(&mut Context::default()) else {
            continue;
        };
        let inside = |[from, to]: [f64; 2], angle: f64| {
            let turn = if to < from { (to - from).rem_euclid(360.0) } else { to - from };
            turn >= 360.0 || (angle - from).rem_euclid(360.0) <= turn
        };
        for _ in 0..8 {
            let ray = some_ray(&mut draw);
            let expected = whole.roots(&ray, Span::LINE).into_iter().filter(|root| {
                let [x, y, z] = ray.at(root.t).to_array();
                let around = atan2(y, (x * x + z * z).sqrt() - 2.0);
                inside(phi, to_degrees(atan2(x, z))) && inside(theta, to_degrees(around))
            });
            let expected: Vec<_> = expected.collect();
            assert_eq!(shape.roots(&ray, Span::LINE), expected, "{phi:?} {theta:?} {ray:?}");
            kept += expected.len();
            dropped += whole.roots(&ray, Span::LINE).len() - expected.len();
        }
    }
    assert!(kept > 5_000 && dropped > 5_000, "{kept} {dropped}");
}

/// Law: a part of a torus and its complement are the whole: each hit of the whole is a hit of one of
/// them, bit for bit. This holds also for rays aimed at the ends of the range, where both may have the
/// hit. Oracle: the whole.
/// Book: part objects.
#[test]
fn a_part_and_the_rest_are_the_whole() {
    let mut draw = Draw::new(1961);
    let whole = built(torus(2.0, 0.5));
    let (mut shared, mut hits) = (0, 0);
    for _ in 0..4_000 {
        let angle = |draw: &mut Draw| match draw.below(3) {
            0 => 15.0 * draw.below(24) as f64,
            _ => draw.between(0.0, 360.0),
        };
        let (a, b) = (angle(&mut draw), angle(&mut draw));
        if a == b {
            continue;
        }
        let around_axis = draw.coin();
        let parts = [[a, b], [b, a]]
            .map(|range| built(if around_axis { part(range, ALL) } else { part(ALL, range) }));
        for at_end in [false, true, true] {
            let mut ray = some_ray(&mut draw);
            if at_end {
                let other = draw.between(0.0, 360.0);
                let (phi, theta) = if around_axis { (a, other) } else { (other, a) };
                let rho = 2.0 + 0.5 * cos_degrees(theta);
                let (x, z) = (rho * sin_degrees(phi), rho * cos_degrees(phi));
                ray.direction = Point::new(x, 0.5 * sin_degrees(theta), z) - ray.origin;
            }
            let found = parts.each_ref().map(|part| ts(&**part, &ray));
            let mut union: Vec<f64> = found.concat();
            union.sort_by(f64::total_cmp);
            let doubled = union.len();
            union.dedup();
            assert_eq!(union, ts(&*whole, &ray), "{a} {b} {ray:?}: {found:?}");
            shared += doubled - union.len();
            hits += union.len();
        }
    }
    assert!(hits > 10_000 && shared > 50, "{hits} hits, {shared} of both parts");
}

/// Law: parts of a torus with the azimuths 350°…360° and 0°…10° meet at +z without a gap, and 350°…10°
/// covers both. Oracle: points aimed at.
/// Book: part objects.
#[test]
fn the_seam_at_azimuth_zero_has_no_gap() {
    let parts = [[350.0, 360.0], [0.0, 10.0], [350.0, 10.0], [-10.0, 10.0]]
        .map(|phi| built(part(phi, ALL)));
    let mut draw = Draw::new(1962);
    for _ in 0..10_000 {
        let x = draw.pick(&[0.0, -0.0, 5e-324, 1e-17, -1e-17, 1e-9, -1e-9, 0.2, -0.2]);
        let ray = Ray::new(Point::new(x, draw.between(-0.4, 0.4), 9.0), -Vector::Z);
        let hits = parts.each_ref().map(|part| ts(&**part, &ray).len());
        assert!(hits[0] + hits[1] >= 2, "{x}: {hits:?}");
        assert_eq!((hits[2], hits[3]), (2, 2), "{x}");
        if x.abs() > 1e-10 {
            assert_eq!((hits[0], hits[1]), if x < 0.0 { (2, 0) } else { (0, 2) });
        }
    }
}

/// Law: where the near hit of a torus is outside the ranges of its part, the far one is found. Oracle: by
/// hand.
/// Book: part objects.
#[test]
fn the_far_side_is_seen_through_the_missing_part() {
    let ray = Ray::new(Point::new(-5.0, 0.0, 0.0), Vector::X);
    let cases: [([f64; 2], [f64; 2], &[f64]); 5] = [
        ([0.0, 180.0], ALL, &[6.5, 7.5]),   // x > 0
        ([180.0, 360.0], ALL, &[2.5, 3.5]), // x < 0
        (ALL, [90.0, 270.0], &[3.5, 6.5]),  // the inner half of the tube
        (ALL, [270.0, 90.0], &[2.5, 7.5]),  // the outer half, by a range that wraps
        ([45.0, 135.0], [300.0, 60.0], &[7.5]),
    ];
    for (phi, theta, expected) in cases {
        let found = ts(&*built(part(phi, theta)), &ray);
        let close = found.iter().zip(expected).all(|(t, e)| (t - e).abs() < 1e-14);
        assert!(found.len() == expected.len() && close, "{phi:?} {theta:?}: {found:?}");
    }
}

/// Law: the box of a part is no larger than it must be: a hit comes near each of its six sides.
/// Oracle: a few thousand points of the surface, by its parameters.
#[test]
fn the_box_of_a_part_is_tight() {
    let mut draw = Draw::new(1963);
    for _ in 0..200 {
        let mut range = || {
            let from = draw.between(0.0, 360.0);
            let to = from + draw.between(5.0, 355.0);
            [from, if to > 360.0 { to - 360.0 } else { to }]
        };
        let (phi, theta) = (range(), range());
        let bounds = built(part(phi, theta)).bounds();
        let turn = |[from, to]: [f64; 2]| if to < from { to - from + 360.0 } else { to - from };
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for i in 0..=90 {
            for j in 0..=90 {
                let phi = phi[0] + turn(phi) * f64::from(i) / 90.0;
                let theta = theta[0] + turn(theta) * f64::from(j) / 90.0;
                let rho = 2.0 + 0.5 * cos_degrees(theta);
                let p = [rho * sin_degrees(phi), 0.5 * sin_degrees(theta), rho * cos_degrees(phi)];
                for axis in 0..3 {
                    low[axis] = low[axis].min(p[axis]);
                    high[axis] = high[axis].max(p[axis]);
                }
            }
        }
        for axis in 0..3 {
            let ends = [bounds.min.along(axis) - low[axis], high[axis] - bounds.max.along(axis)];
            // steps of up to 4° miss an extreme by 1 − cos 2° of a radius
            assert!(
                ends.iter().all(|end| (-2e-3..1e-12).contains(end)),
                "{phi:?} {theta:?} {ends:?}"
            );
        }
    }
}

/// Law: an inward part of a torus has the hits of the outward one, with opposite normals. Oracle: the
/// outward part.
/// Book: part objects.
#[test]
fn an_inward_part_has_opposite_normals() {
    let mut draw = Draw::new(1964);
    let plain = part([30.0, 200.0], [100.0, 20.0]);
    let [out, inward] = [built(plain.clone()), built(PartTorus { inward: true, ..plain })];
    for _ in 0..2_000 {
        let ray = some_ray(&mut draw);
        let roots = out.roots(&ray, Span::LINE);
        assert_eq!(roots, inward.roots(&ray, Span::LINE));
        for root in roots {
            let [a, b] = [&out, &inward].map(|shape| shape.surface(&ray, &root));
            assert_eq!((a.point, a.normal), (b.point, -b.normal));
        }
    }
}

/// Law: invalid ranges are refused; the message names the field and what is needed.
#[test]
fn invalid_ranges_are_refused() {
    let text = |phi, theta| {
        let kind = Kind::from(part(phi, theta));
        kind.build(&mut Context::default()).expect_err("no range").to_string()
    };
    let wanted = "but a range between angles from -360 to 360 degrees is needed that is not empty; \
                  [350, 10] passes through 360, [0, 360] goes all around";
    for (phi, theta, found) in [
        ([20.0, 20.0], ALL, "part_torus.phi: found [20.0, 20.0]"),
        (ALL, [0.0, 400.0], "part_torus.theta: found [0.0, 400.0]"),
        ([f64::INFINITY, 0.0], ALL, "part_torus.phi: found [inf, 0.0]"),
    ] {
        assert_eq!(text(phi, theta), format!("{found}, {wanted}"));
    }
}
