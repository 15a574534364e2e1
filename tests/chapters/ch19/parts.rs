//! Part objects: ranges of angles and their seams.

use groundtruth::shapes::{Annulus, OpenCylinder, PartAnnulus, PartCylinder, PartSphere};

use crate::prelude::*;

pub fn built(kind: impl Into<Kind>) -> Arc<dyn Shape> {
    kind.into().build(&mut Context::default()).expect("valid")
}

pub fn ts(shape: &dyn Shape, ray: &Ray) -> Vec<f64> {
    shape.roots(ray, Span::LINE).iter().map(|root| root.t).collect()
}

/// A ray aimed at a random point near the origin, at most about `extent` away.
pub fn some_ray(draw: &mut Draw, extent: f64) -> Ray {
    let target = draw.point(extent);
    let origin = target + draw.between(0.0, 4.0) * draw.direction();
    Ray::new(origin, draw.decades(-2.0, 2.0) * (target - origin))
}

pub const CENTER: Point = Point::new(0.25, -0.5, 0.125);

/// The direction of an azimuth as the book measures it: 0 is +z, 90 is +x.
fn outward(phi: f64) -> Vector {
    Vector::new(sin_degrees(phi), 0.0, cos_degrees(phi))
}

pub fn part_sphere(phi: [f64; 2], theta: [f64; 2]) -> PartSphere {
    PartSphere { center: CENTER, radius: 0.75, phi, theta, inward: false }
}

pub fn part_cylinder(phi: [f64; 2]) -> PartCylinder {
    PartCylinder { y0: -1.0, y1: 0.5, radius: 0.75, phi, inward: false }
}

fn part_annulus(phi: [f64; 2]) -> PartAnnulus {
    let normal = Vector::Y;
    PartAnnulus { center: CENTER, normal, inner_radius: 0.25, outer_radius: 0.75, phi }
}

/// The three parts of one range of azimuths.
fn all_parts(phi: [f64; 2]) -> [Kind; 3] {
    [part_sphere(phi, [0.0, 180.0]).into(), part_cylinder(phi).into(), part_annulus(phi).into()]
}

/// The shapes they are parts of.
fn wholes() -> [Kind; 3] {
    [
        Sphere { center: CENTER, radius: 0.75, inward: false }.into(),
        OpenCylinder { y0: -1.0, y1: 0.5, radius: 0.75, inward: false }.into(),
        Annulus { center: CENTER, normal: Vector::Y, inner_radius: 0.25, outer_radius: 0.75 }
            .into(),
    ]
}

/// The roots of both shapes in ascending order; a root on the seam, which both may have, counts once.
fn together(a: &Kind, b: &Kind, ray: &Ray) -> Vec<f64> {
    let mut all = ts(&*built(a.clone()), ray);
    all.extend(ts(&*built(b.clone()), ray));
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// Law: a part of a sphere, cylinder or annulus and its complement are the whole, bit for bit. Oracle:
/// the whole.
/// Book: part objects.
#[test]
fn a_part_and_its_complement_are_the_whole() {
    let mut draw = Draw::new(1930);
    let mut hits = 0;
    for _ in 0..4_000 {
        let [a, b] = [draw.between(-180.0, 360.0), 45.0 * draw.below(9) as f64];
        let (a, b) = if draw.coin() { (a, b) } else { (b, a) };
        let ray = some_ray(&mut draw, 1.0);
        for ((part, rest), whole) in all_parts([a, b]).iter().zip(&all_parts([b, a])).zip(wholes())
        {
            let expected = ts(&*built(whole), &ray);
            assert_eq!(together(part, rest, &ray), expected, "{part:?} and {rest:?}: {ray:?}");
            hits += expected.len();
        }
        let theta = draw.pick(&[30.0, 90.0, 1e-5, 179.0]);
        let caps = [[0.0, theta], [theta, 180.0]];
        let [upper, lower] = caps.map(|theta| part_sphere([0.0, 360.0], theta).into());
        let [sphere, ..] = wholes();
        assert_eq!(together(&upper, &lower, &ray), ts(&*built(sphere), &ray), "at {theta}");
    }
    assert!(hits > 6_000, "{hits}");
}

/// Law: a range of 360 degrees, wherever it starts, gives the whole shape, bit for bit. Oracle: the
/// whole.
#[test]
fn a_full_turn_is_the_whole() {
    let mut draw = Draw::new(1931);
    for _ in 0..1_000 {
        let ray = some_ray(&mut draw, 1.0);
        for phi in [[0.0, 360.0], [-180.0, 180.0], [-360.0, 360.0]] {
            for (part, whole) in all_parts(phi).into_iter().zip(wholes()) {
                assert_eq!(ts(&*built(part), &ray), ts(&*built(whole), &ray));
            }
        }
    }
}

/// Whether an azimuth is in a range, by adding and subtracting full turns.
fn in_range(phi: f64, [from, to]: [f64; 2]) -> bool {
    let mut phi = phi;
    while phi > from {
        phi -= 360.0;
    }
    while phi < from {
        phi += 360.0;
    }
    phi <= if to < from { to + 360.0 } else { to }
}

/// Law: a point of a sphere, cylinder or annulus is hit on its part exactly if its angles are in the
/// range. Oracle: degrees compared.
/// Book: part objects.
#[test]
fn a_point_is_hit_if_its_angles_are_in_range() {
    let mut draw = Draw::new(1932);
    let mut hits = [0; 3];
    for _ in 0..6_000 {
        let range = [draw.between(0.0, 360.0), draw.between(0.0, 360.0)];
        let theta = [draw.between(0.0, 90.0), draw.between(90.0, 180.0)];
        let (phi, polar) = (draw.between(0.0, 360.0), draw.between(0.0, 180.0));
        let near = |angle: f64, end: f64| ((angle - end + 540.0) % 360.0 - 180.0).abs() < 1e-9;
        if range.iter().any(|&end| near(phi, end)) || theta.iter().any(|&end| near(polar, end)) {
            continue;
        }
        let n = sin_degrees(polar) * outward(phi) + cos_degrees(polar) * Vector::Y;
        let inside = in_range(phi, range);
        let height = draw.between(-0.99, 0.49);
        let aims = [
            (
                Kind::from(part_sphere(range, theta)),
                CENTER + 0.75 * n,
                n,
                inside && theta[0] < polar && polar < theta[1],
            ),
            (
                part_cylinder(range).into(),
                Point::new(0.0, height, 0.0) + 0.75 * outward(phi),
                outward(phi),
                inside,
            ),
            (part_annulus(range).into(), CENTER + 0.5 * outward(phi), Vector::Y, inside),
        ];
        for (i, (kind, point, normal, expected)) in aims.into_iter().enumerate() {
            let away = draw.direction();
            if normal.dot(away).abs() < 0.1 {
                continue; // a grazing ray's two hits are close
            }
            let ray = Ray::new(point + 2.0 * away, -2.0 * away);
            let found = ts(&*built(kind.clone()), &ray);
            let hit = found.iter().any(|t| (t - 1.0).abs() < 1e-9);
            assert_eq!(hit, expected, "azimuth {phi}, polar angle {polar}: {kind:?}");
            hits[i] += usize::from(hit);
        }
    }
    assert!(hits.iter().all(|&n| n > 800), "{hits:?}");
}

/// Law: the ranges 350 to 360 and 0 to 10 meet at +z without a gap, each covers only its own side, and
/// 350 to 10 covers both. Oracle: the azimuths aimed at.
/// Book: part objects.
#[test]
fn ranges_meet_at_azimuth_zero() {
    let ranges = [[350.0, 360.0], [0.0, 10.0], [350.0, 10.0], [-10.0, 10.0]];
    for (phi, expected) in [
        (352.0, [true, false, true, true]),
        (359.999, [true, false, true, true]),
        (0.0, [true, true, true, true]),
        (0.001, [false, true, true, true]),
        (8.0, [false, true, true, true]),
        (12.0, [false; 4]),
        (180.0, [false; 4]),
    ] {
        for i in 0..3 {
            let start = [CENTER, Point::new(0.0, 0.0, 0.0), CENTER][i] + 0.5 * outward(phi);
            // from within, or from above through the annulus
            let ray = match i {
                2 => Ray::new(start + Vector::Y, -Vector::Y),
                _ => Ray::new(start, outward(phi)),
            };
            let found =
                ranges.map(|phi| built(all_parts(phi)[i].clone()).hit(&ray, Span::AHEAD).is_some());
            assert_eq!(found, expected, "azimuth {phi}, part {i}");
        }
    }
}

/// Law: rays aimed exactly at a common end of two ranges meet one of them. Oracle: the azimuth aimed
/// at, which rounding puts on either side.
#[test]
fn ranges_with_a_common_end_leave_no_gap() {
    let mut draw = Draw::new(1933);
    for _ in 0..4_000 {
        let seam = draw.between(0.0, 360.0);
        let ray = Ray::new(CENTER, outward(seam) + draw.between(-3.0, 3.0) * Vector::Y);
        let parts = [[seam - 20.0, seam], [seam, (seam + 30.0) % 360.0]]
            .map(|phi| built(part_sphere(phi, [0.0, 180.0])));
        assert!(parts.iter().any(|part| part.hit(&ray, Span::AHEAD).is_some()), "{seam}");
    }
}

/// Law: azimuths run from +z to +x, polar angles from +y. Oracle: worked by hand.
/// Book: part objects.
#[test]
fn azimuths_run_from_z_to_x_and_polar_angles_from_y() {
    let hit = |phi, theta, toward: Vector| {
        let ray = Ray::new(CENTER, toward);
        built(part_sphere(phi, theta)).hit(&ray, Span::AHEAD).is_some()
    };
    let (belt, quarter) = ([80.0, 100.0], [45.0, 135.0]);
    let all = [0.0, 360.0];
    for (phi, theta, toward, expected) in [
        (quarter, belt, Vector::X, true),
        (quarter, belt, -Vector::X, false),
        (quarter, belt, Vector::Z, false),
        ([315.0, 45.0], belt, Vector::Z, true),
        (all, [0.0, 10.0], Vector::Y, true),
        (all, [170.0, 180.0], -Vector::Y, true),
        (all, [0.0, 10.0], -Vector::Y, false),
    ] {
        let found = hit(phi, theta, toward);
        assert_eq!(found, expected, "azimuths {phi:?}, polar angles {theta:?}, towards {toward:?}");
    }
}

/// Law: where the first root is outside the range of a part, as at the opening of a bowl, the second is
/// found. Oracle: worked by hand.
/// Book: part objects.
#[test]
fn the_inside_of_a_bowl_is_seen_from_above() {
    let bowl = PartSphere {
        center: Point::ORIGIN,
        radius: 1.25,
        phi: [0.0, 360.0],
        theta: [90.0, 180.0],
        inward: true,
    };
    let bowl = built(bowl);
    let ray = Ray::new(Point::new(0.75, 5.0, 0.0), -Vector::Y);
    let hit = bowl.hit(&ray, Span::AHEAD).expect("the bottom");
    assert_eq!((hit.t, bowl.roots(&ray, Span::LINE).len()), (6.0, 1));
    let n = Vector::from(bowl.surface(&ray, &hit).normal);
    assert!((n - Vector::new(-0.6, 0.8, 0.0)).length() < 1e-15, "{n:?}");

    let half = PartCylinder { phi: [180.0, 360.0], ..part_cylinder([0.0, 1.0]) };
    let ray = Ray::new(Point::new(2.0, 0.0, 0.0), -Vector::X);
    let half = built(half);
    let hit = half.hit(&ray, Span::AHEAD).expect("the far wall");
    assert_eq!((hit.t, half.surface(&ray, &hit).normal), (2.75, -Normal::X));
}

/// Law: hits of part spheres have their angles in range. Oracle: angles by atan2 and acos.
/// Book: part objects.
#[test]
fn hits_of_part_spheres_have_angles_in_range() {
    const CLOSE: f64 = 1e-9;
    let mut draw = Draw::new(1934);
    let mut hits = 0;
    for _ in 0..4_000 {
        let (phi, theta) = ([draw.between(0.0, 180.0), draw.between(180.0, 360.0)], [20.0, 130.0]);
        let shape = built(part_sphere(phi, theta));
        let ray = some_ray(&mut draw, 1.0);
        for root in shape.roots(&ray, Span::AHEAD) {
            let v = shape.surface(&ray, &root).point - CENTER;
            near!(v.length(), 0.75, 1e-14);
            let azimuth = to_degrees(atan2(v.x(), v.z())).rem_euclid(360.0);
            let polar = to_degrees(acos(v.y() / v.length()));
            assert!((phi[0] - CLOSE..phi[1] + CLOSE).contains(&azimuth), "{azimuth}");
            assert!((theta[0] - CLOSE..theta[1] + CLOSE).contains(&polar), "{polar}");
            hits += 1;
        }
    }
    assert!(hits > 1_000, "{hits}");
}

/// Law: the bounds of a part contain all of it and are tight. Oracle: a dense set of its points.
#[test]
fn bounds_of_parts_are_tight() {
    let mut draw = Draw::new(1935);
    for _ in 0..200 {
        let phi = [draw.between(0.0, 360.0), 30.0 * draw.below(13) as f64];
        let theta = [draw.between(0.0, 120.0), draw.between(121.0, 180.0)];
        let theta = if draw.coin() { theta } else { [theta[0] / 2.0, theta[0]] };
        let width = if phi[1] < phi[0] { phi[1] + 360.0 - phi[0] } else { phi[1] - phi[0] };
        let sample = |i: usize| {
            let n = outward(phi[0] + width * (i / 60) as f64 / 360.0);
            let polar = theta[0] + (theta[1] - theta[0]) * (i % 60) as f64 / 59.0;
            let round = sin_degrees(polar) * n + cos_degrees(polar) * Vector::Y;
            let share = (i % 60) as f64 / 59.0;
            [
                CENTER + 0.75 * round,
                Point::new(0.0, -1.0 + 1.5 * share, 0.0) + 0.75 * n,
                CENTER + (0.25 + 0.5 * share) * n,
            ]
        };
        let samples = Vec::from_iter((0..361 * 60).map(sample));
        let mut kinds = all_parts(phi);
        kinds[0] = part_sphere(phi, theta).into();
        for (i, kind) in kinds.into_iter().enumerate() {
            let points = groundtruth::math::Aabb::around(samples.iter().map(|sample| sample[i]));
            let bounds = built(kind.clone()).bounds();
            for (inner, outer) in [(points.min, bounds.min), (points.max, bounds.max)] {
                let off = (inner - outer).max_abs();
                assert!(off < 1e-3, "{kind:?}: {bounds:?}, points {points:?}");
            }
            for point in [points.min, points.max] {
                assert!(bounds.padded().contains(point), "{point:?} is not in {bounds:?}");
            }
        }
    }
}

/// Law: invalid ranges are refused, and the message says what is needed. Oracle: the text.
#[test]
fn empty_and_impossible_ranges_are_refused() {
    let problem = |kind: Kind| {
        kind.build(&mut Context::default()).map(drop).expect_err("refused").to_string()
    };
    let angles = "but a range between angles from -360 to 360 degrees is needed that is not empty; \
                  [350, 10] passes through 360, [0, 360] goes all around";
    for phi in [[30.0, 30.0], [0.0, 361.0], [f64::NAN, 1.0], [0.0, f64::INFINITY], [360.0, 0.0]] {
        for kind in all_parts(phi) {
            let text = problem(kind);
            assert!(text.contains(&format!(".phi: found {phi:?}, {angles}")), "{text}");
        }
    }
    for theta in [[90.0, 90.0], [100.0, 20.0], [-1.0, 90.0], [0.0, 181.0], [f64::NAN, 90.0]] {
        let text = problem(part_sphere([0.0, 90.0], theta).into());
        let rest = "but two ascending angles from 0 to 180 are needed";
        assert_eq!(text, format!("part_sphere.theta: found {theta:?}, {rest}"));
    }
    let ring = Annulus { center: CENTER, normal: Vector::Y, inner_radius: 2.0, outer_radius: 1.0 };
    assert_eq!(
        problem(ring.into()),
        "annulus.outer_radius: found 1, but it must be above inner_radius, 2"
    );
    for normal in [Vector::new(0.0, 1.0, 1e-9), Vector::X, -Vector::Z] {
        let (found, tilted) =
            (normal.to_array(), PartAnnulus { normal, ..part_annulus([0.0, 9.0]) });
        let rest = "but a part annulus is level: [0, 1, 0] or [0, -1, 0]; an instance tilts it";
        assert_eq!(problem(tilted.into()), format!("part_annulus.normal: found {found:?}, {rest}"));
    }
}
