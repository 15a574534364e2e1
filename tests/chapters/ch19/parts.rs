//! Part objects: ranges of angles and their seams.

use groundtruth::shapes::{
    Annulus, OpenCylinder, PartAnnulus, PartCylinder, PartSphere, PartTorus, Torus,
};

use crate::prelude::*;

const ALL: [f64; 2] = [0.0, 360.0];

const CENTER: Point = Point::new(0.25, -0.5, 0.125);

/// The centres of the shapes below.
const CENTERS: [Point; 4] = [CENTER, Point::ORIGIN, CENTER, Point::ORIGIN];

/// The direction of an azimuth as the book measures it: 0 is +z, 90 is +x.
fn outward(phi: f64) -> Vector {
    Vector::new(sin_degrees(phi), 0.0, cos_degrees(phi))
}

/// The parts of a sphere, cylinder, annulus and torus in one range of azimuths; that of the sphere in the range
/// `polar`, that of the torus in `around` its tube.
fn parts(phi: [f64; 2], polar: [f64; 2], around: [f64; 2]) -> [Kind; 4] {
    let (y0, y1, inward) = (-1.0, 0.5, false);
    let (inner_radius, outer_radius) = (0.25, 0.75);
    [
        PartSphere { center: CENTER, radius: 0.75, phi, theta: polar, inward }.into(),
        PartCylinder { y0, y1, radius: 0.75, phi, inward }.into(),
        PartAnnulus { center: CENTER, normal: Vector::Y, inner_radius, outer_radius, phi }.into(),
        PartTorus { swept_radius: 0.5, tube_radius: 0.25, phi, theta: around, inward }.into(),
    ]
}

/// The shapes they are parts of.
fn wholes() -> [Arc<dyn Shape>; 4] {
    let inward = false;
    [
        shape_of(Sphere { center: CENTER, radius: 0.75, inward }),
        shape_of(OpenCylinder { y0: -1.0, y1: 0.5, radius: 0.75, inward }),
        shape_of(Annulus {
            center: CENTER,
            normal: Vector::Y,
            inner_radius: 0.25,
            outer_radius: 0.75,
        }),
        shape_of(Torus { swept_radius: 0.5, tube_radius: 0.25, inward }),
    ]
}

/// The points of each of them at this azimuth; `share` in [0, 1] says where from end to end.
fn points(phi: f64, [low, high]: [f64; 2], around: f64, share: f64) -> [Point; 4] {
    let n = outward(phi);
    let polar = low + (high - low) * share;
    let ring = 0.5 + 0.25 * cos_degrees(around);
    [
        CENTER + 0.75 * (sin_degrees(polar) * n + cos_degrees(polar) * Vector::Y),
        Point::new(0.0, -1.0 + 1.5 * share, 0.0) + 0.75 * n,
        CENTER + (0.25 + 0.5 * share) * n,
        Point::new(0.0, 0.25 * sin_degrees(around), 0.0) + ring * n,
    ]
}

/// Two angles, or the whole turn.
fn range(draw: &mut Draw, [low, high]: [f64; 2]) -> [f64; 2] {
    match draw.below(4) {
        0 => ALL,
        _ => [draw.between(low, high), draw.between(low, high)],
    }
}

/// The angle from the first end of a range to the second.
fn turn([from, to]: [f64; 2]) -> f64 {
    if to < from { (to - from).rem_euclid(360.0) } else { to - from }
}

/// Law: a part has the hits of the whole whose azimuth, polar angle or angle around the tube, `atan2(y, √(x² + z²) −
/// a)`, are in its ranges, which may pass through 360°: the far one, too, where the near one is missing. Azimuths run
/// from +z to +x, polar angles from +y. Oracle: the whole; the arc tangent, in degrees.
/// Book: part objects.
#[test]
fn a_part_has_the_hits_whose_angles_are_in_its_ranges() {
    let mut draw = Draw::new(1932);
    let wholes = wholes();
    let mut counts = [[0; 2]; 4];
    for _ in 0..6_000 {
        let (phi, around) = (range(&mut draw, [-360.0, 360.0]), range(&mut draw, [-360.0, 360.0]));
        if phi[0] == phi[1] || phi[1] - phi[0] > 360.0 || around[1] - around[0] > 360.0 {
            continue;
        }
        let polar = [draw.between(0.0, 90.0), draw.between(90.0, 180.0)];
        let ray = some_ray(&mut draw, 1.0);
        let is_in = |range: [f64; 2], angle: f64| {
            (to_degrees(angle) - range[0]).rem_euclid(360.0) <= turn(range) || turn(range) >= 360.0
        };
        for (i, part) in parts(phi, polar, around).map(shape_of).into_iter().enumerate() {
            let whole = &wholes[i];
            let (kept, dropped): (Vec<_>, Vec<_>) =
                whole.roots(&ray, Span::LINE).into_iter().partition(|root| {
                    let [x, y, z] = (ray.at(root.t) - CENTERS[i]).to_array();
                    let rho = (x * x + z * z).sqrt();
                    let second = match i {
                        0 => is_in(polar, atan2(rho, y)),
                        3 => is_in(around, atan2(y, rho - 0.5)),
                        _ => true,
                    };
                    second && is_in(phi, atan2(x, z))
                });
            let found = part.roots(&ray, Span::LINE);
            let of = |all: &[Candidate]| Vec::from_iter(all.iter().map(|root| root.t));
            assert_eq!(of(&found), of(&kept), "{part:?}: {ray:?}");
            for (a, b) in found.iter().zip(&kept) {
                let [a, b] = [part.surface(&ray, a), whole.surface(&ray, b)];
                assert_eq!((a.point, a.normal), (b.point, b.normal), "{part:?}: {ray:?}");
            }
            counts[i][0] += kept.len();
            counts[i][1] += dropped.len();
        }
    }
    assert!(counts.as_flattened().iter().all(|&n| n > 300), "{counts:?}");
}

/// Law: a part of a sphere, cylinder, annulus or torus and its complement are the whole, bit for bit, also for rays aimed
/// at the ends of the range, where both may have the hit. Oracle: the whole.
/// Book: part objects.
#[test]
fn a_part_and_its_complement_are_the_whole() {
    let mut draw = Draw::new(1930);
    let (mut hits, mut shared) = (0, 0);
    let wholes = wholes();
    for _ in 0..4_000 {
        let mut end = || match draw.below(3) {
            0 => 15.0 * draw.below(24) as f64,
            _ => draw.between(0.0, 360.0),
        };
        let (a, b) = (end(), end());
        if a == b {
            continue;
        }
        // the second angle of the sphere and of the torus
        let theta = draw.pick(&[30.0, 90.0, 1e-5, 179.0]);
        let by_azimuth = draw.coin();
        let [one, rest] = match by_azimuth {
            true => [[a, b], [b, a]].map(|phi| parts(phi, [0.0, 180.0], ALL)),
            false => [parts(ALL, [0.0, theta], [a, b]), parts(ALL, [theta, 180.0], [b, a])],
        };
        let other = draw.between(0.0, 360.0);
        let (phi, around) = if by_azimuth { (a, other) } else { (other, a) };
        let share = if by_azimuth { draw.between(0.0, 1.0) } else { theta / 180.0 };
        let ends = points(phi, [0.0, 180.0], around, share);
        for (i, (one, rest)) in one.into_iter().zip(rest).enumerate() {
            if !by_azimuth && !matches!(i, 0 | 3) {
                continue; // they have no second angle
            }
            let both = [one, rest].map(shape_of);
            for at_end in [false, true] {
                let mut ray = some_ray(&mut draw, 1.0);
                if at_end {
                    ray.direction = ends[i] - ray.origin;
                }
                let mut union = both.each_ref().map(|part| ts(&**part, &ray)).concat();
                union.sort_by(f64::total_cmp);
                let doubled = union.len();
                union.dedup();
                assert_eq!(union, ts(&*wholes[i], &ray), "{a} {b} {theta}: {both:?} {ray:?}");
                shared += doubled - union.len();
                hits += union.len();
            }
        }
    }
    assert!(hits > 20_000 && shared > 50, "{hits} hits, {shared} of both parts");
}

/// Law: the ranges 350 to 360 and 0 to 10 meet at +z without a gap, each covers only its own side, and
/// 350 to 10 covers both. Oracle: the azimuths aimed at.
/// Book: part objects.
#[test]
fn ranges_meet_at_azimuth_zero() {
    let ranges = [[350.0, 360.0], [0.0, 10.0], [350.0, 10.0], [-10.0, 10.0]];
    let parts = ranges.map(|phi| parts(phi, [0.0, 180.0], ALL).map(shape_of));
    for (phi, expected) in [
        (352.0, [true, false, true, true]),
        (359.999, [true, false, true, true]),
        (0.0, [true, true, true, true]),
        (0.001, [false, true, true, true]),
        (8.0, [false, true, true, true]),
        (12.0, [false; 4]),
        (180.0, [false; 4]),
    ] {
        for (i, center) in CENTERS.into_iter().enumerate() {
            let start = center + 0.5 * outward(phi);
            // from within, or from above through the annulus
            let ray = match i {
                2 => Ray::new(start + Vector::Y, -Vector::Y),
                _ => Ray::new(start, outward(phi)),
            };
            let found = parts.each_ref().map(|parts| parts[i].hit(&ray, Span::AHEAD).is_some());
            assert_eq!(found, expected, "azimuth {phi}, part {i}");
        }
    }
}

/// Law: the bounds of a part contain all of it and are tight. Oracle: a dense set of its points.
#[test]
fn bounds_of_parts_are_tight() {
    let mut draw = Draw::new(1935);
    for _ in 0..60 {
        let phi = [draw.between(0.0, 360.0), 30.0 * draw.below(13) as f64];
        let polar = [draw.between(0.0, 120.0), draw.between(121.0, 180.0)];
        let polar = if draw.coin() { polar } else { [polar[0] / 2.0, polar[0]] };
        let around = [draw.between(0.0, 360.0), draw.between(0.0, 360.0)];
        let sample = |i: usize| {
            let share = (i % 61) as f64 / 60.0;
            let phi = phi[0] + turn(phi) * (i / 61) as f64 / 360.0;
            points(phi, polar, around[0] + turn(around) * share, share)
        };
        let samples = Vec::from_iter((0..361 * 61).map(sample));
        for (i, kind) in parts(phi, polar, around).into_iter().enumerate() {
            let points = Aabb::around(samples.iter().map(|sample| sample[i]));
            let bounds = shape_of(kind.clone()).bounds();
            for (inner, outer) in [(points.min, bounds.min), (points.max, bounds.max)] {
                let off = (inner - outer).max_abs();
                assert!(off < 1e-3, "{kind:?}: {bounds:?}, points {points:?}");
                assert!(bounds.padded().contains(inner), "{inner:?} is not in {bounds:?}");
            }
        }
    }
}
