//! Beveled solids: the points at most the bevel away from a smaller solid.

use groundtruth::shapes::{BeveledBox, BeveledCylinder, BeveledRing, BeveledWedge, Materials};

use super::bevels::{Case, KINDS};
use crate::prelude::*;
use crate::support::solids::{built, check_pieces, line};

/// Law: a beveled box, cylinder, ring or wedge is closed; its inside is what is at most the bevel away
/// from the solid that is smaller by the bevel on each side. Oracle: that distance in closed form,
/// between the hits of a line (`check_pieces`).
/// Book: 21.5, beveled objects.
#[test]
fn a_beveled_solid_is_what_is_within_the_bevel_of_a_smaller_one() {
    let mut draw = Draw::new(2130);
    for make in KINDS {
        for _ in 0..60 {
            let Case { kind, bevel, from_inset, .. } = make(&mut draw);
            check_pieces(&kind, &mut draw, 150, |p| from_inset(p) <= bevel);
        }
    }
}

/// Law: every point of the surface of a beveled solid is as far from the smaller solid as the bevel.
/// Oracle: the distance in closed form.
/// Book: 21.5, beveled objects.
#[test]
fn points_of_a_beveled_solid_are_at_the_bevel_from_the_smaller_one() {
    /// Some tens of roundings of coordinates up to 4.
    const CLOSE: f64 = 4.0 * 64.0 * f64::EPSILON;
    let mut draw = Draw::new(2131);
    for make in KINDS {
        let mut hits = 0;
        for _ in 0..60 {
            let Case { kind, bevel, from_inset, .. } = make(&mut draw);
            let shape = built(&kind);
            for _ in 0..150 {
                let ray = line(&mut draw, &*shape);
                for root in shape.roots(&ray, Span::LINE) {
                    let point = shape.surface(&ray, &root).point;
                    let off = from_inset(point) - bevel;
                    assert!(off.abs() <= CLOSE, "{kind:?}: {point:?} is off by {off:e}");
                    hits += 1;
                }
            }
        }
        above!(hits, 4_000);
    }
}

/// Law: a ray from inside crosses the surface an odd number of times, and only once if the solid is
/// convex. Oracle: parity.
#[test]
fn beveled_solids_are_watertight_from_inside() {
    let mut draw = Draw::new(2132);
    for make in KINDS {
        let mut rays = 0;
        while rays < 25_000 {
            let Case { kind, bevel, from_inset, convex } = make(&mut draw);
            let shape = built(&kind);
            let bounds = shape.bounds();
            for _ in 0..500 {
                let v = draw.vector(0.5);
                let extent = bounds.extent();
                let [x, y, z] = [0, 1, 2].map(|i| v.along(i) * extent.along(i));
                let origin = bounds.center() + Vector::new(x, y, z);
                if from_inset(origin) > 0.999 * bevel {
                    continue;
                }
                let ray = Ray::new(origin, draw.direction().into());
                let roots = shape.roots(&ray, Span::AHEAD).len();
                assert!(roots % 2 == 1 && (roots == 1 || !convex), "{kind:?}: {roots} of {ray:?}");
                assert!(shape.hit(&ray, Span::AHEAD).is_some(), "{ray:?} misses");
                rays += 1;
            }
        }
    }
}

/// The volume inside the shape by line integrals over `n²` parallel rays through its box.
fn volume(shape: &dyn Shape, n: u32) -> f64 {
    let bounds = shape.bounds();
    let extent = bounds.extent();
    let cell = extent.x() * extent.y() / f64::from(n * n);
    let mut sum = 0.0;
    for i in 0..n {
        for j in 0..n {
            let [u, v] = [i, j].map(|k| (f64::from(k) + 0.5) / f64::from(n));
            let origin = Point::new(
                bounds.min.x() + u * extent.x(),
                bounds.min.y() + v * extent.y(),
                bounds.min.z() - 1.0,
            );
            let roots = shape.roots(&Ray::new(origin, Vector::Z), Span::AHEAD);
            sum += roots.chunks(2).map(|pair| pair[1].t - pair[0].t).sum::<f64>();
        }
    }
    cell * sum
}

/// Law: volumes of beveled solids are those of the closed forms, and so tend to the plain solids' as the
/// square of the bevel. Oracle: Steiner's formula for box and cylinder, Pappus's for the ring.
/// Book: 21.5, beveled objects.
#[test]
fn the_volume_of_a_beveled_solid_is_known_and_tends_to_the_plain_one() {
    /// The error of the midpoint rule with 128² cells: part of a cell along borders that are parallel to
    /// the grid.
    const CLOSE: f64 = 2e-3;
    let materials = Materials::new;
    for bevel in [0.3, 0.1, 0.01] {
        let (min, max) = (Point::new(-0.5, -0.5, 0.0), Point::new(0.5, 1.0, 2.0));
        let cuboid = BeveledBox { min, max, bevel, materials: materials() };
        let [a, b, c] = [1.0, 1.5, 2.0].map(|side| side - 2.0 * bevel);
        let ball = 4.0 / 3.0 * PI * bevel * bevel * bevel;
        let square = bevel * bevel;
        let box_volume =
            a * b * c + 2.0 * bevel * (a * b + b * c + c * a) + PI * square * (a + b + c) + ball;
        let (y0, y1) = (-0.5, 0.5);
        let cylinder = BeveledCylinder { y0, y1, radius: 1.0, bevel, materials: materials() };
        let (r, h) = (1.0 - bevel, 1.0 - 2.0 * bevel);
        let cylinder_volume =
            PI * r * r * h + 2.0 * PI * r * (r + h) * bevel + PI * (h + PI * r) * square + ball;
        let ring = BeveledRing {
            y0,
            y1,
            inner_radius: 1.0,
            outer_radius: 2.0,
            bevel,
            materials: materials(),
        };
        let ring_volume = 2.0 * PI * 1.5 * (1.0 - (4.0 - PI) * square);
        for (kind, expected, plain) in [
            (Kind::from(cuboid), box_volume, 3.0),
            (cylinder.into(), cylinder_volume, PI),
            (ring.into(), ring_volume, 3.0 * PI),
        ] {
            let found = volume(&*built(&kind), 128);
            assert!((found / expected - 1.0).abs() < CLOSE, "{kind:?}: {found}, not {expected}");
            below!((plain - expected) / plain, 6.0 * square);
            below!(found, plain * (1.0 + CLOSE));
        }
    }
}

/// Law: a beveled cylinder whose bevel is its radius and half its height is a sphere, here the unit
/// sphere. Oracle: that sphere.
/// Book: fig. 21.13, a beveled cylinder that is a sphere.
#[test]
fn the_cylinder_of_figure_21_13_is_a_unit_sphere() {
    let materials = Materials::new();
    let cylinder = BeveledCylinder { y0: -0.75, y1: 1.25, radius: 1.0, bevel: 1.0, materials };
    let center = Point::new(0.0, 0.25, 0.0);
    let shape = built(&cylinder.into());
    let sphere = built(&Sphere { center, radius: 1.0, inward: false }.into());
    let mut draw = Draw::new(2133);
    let mut hits = 0;
    for _ in 0..20_000 {
        let ray = line(&mut draw, &*sphere);
        let [ours, theirs] = [&shape, &sphere].map(|shape| shape.roots(&ray, Span::LINE));
        assert_eq!(ours.len(), theirs.len(), "{ray:?}");
        for (a, b) in ours.iter().zip(&theirs) {
            let [p, q] = [shape.surface(&ray, a), sphere.surface(&ray, b)];
            // where the ray grazes the sphere, rounding moves the hit along the ray
            let cosine = q.normal.dot(ray.direction).abs();
            assert!((a.t - b.t).abs() * cosine < 1e-14, "{ray:?}: {} and {}", a.t, b.t);
            below!((Vector::from(p.normal) + -Vector::from(q.normal)).length() * cosine, 1e-14);
            hits += 1;
        }
    }
    above!(hits, 15_000);
}

/// Law: scaling after beveling distorts the bevel: a cylinder that is beveled and then stretched is not
/// the stretched cylinder beveled, though both have the same bounding box. Oracle: the cross-sections of
/// their edges, an ellipse and a circle, at 45°.
/// Book: fig. 21.12, scaled bevels.
#[test]
fn stretching_a_beveled_cylinder_stretches_its_bevel() {
    let cylinder = |y: f64, bevel| {
        let materials = Materials::new();
        Kind::from(BeveledCylinder { y0: -y, y1: y, radius: 1.0, bevel, materials })
    };
    let steps = vec![Step::Scale(Vector::new(1.0, 3.0, 1.0))];
    let stretched = built(&Instance::new(cylinder(1.0, 0.5), steps).into());
    let made_so = built(&cylinder(3.0, 0.5));
    let height = |shape: &dyn Shape, x: f64| {
        let ray = Ray::new(Point::new(x, 5.0, 0.0), -Vector::Y);
        5.0 - shape.hit(&ray, Span::AHEAD).expect("aimed at").t
    };
    let side = 0.5 * std::f64::consts::FRAC_1_SQRT_2;
    near!(height(&*stretched, 0.5 + side), 1.5 + 3.0 * side, 1e-14);
    near!(height(&*made_so, 0.5 + side), 2.5 + side, 1e-14);
    for shape in [stretched, made_so] {
        near!(height(&*shape, 0.25), 3.0, 1e-14);
    }
}

/// Law: a bevel that does not fit is refused; the message says the largest one that fits.
#[test]
fn a_bevel_that_does_not_fit_is_refused_with_one_that_does() {
    let m = Materials::new;
    let (min, max) = (Point::ORIGIN, Point::new(1.0, 0.5, 2.0));
    let wedge = |inner_radius, phi, bevel| {
        Kind::from(BeveledWedge {
            y0: 0.0,
            y1: 9.0,
            inner_radius,
            outer_radius: 9.0,
            phi,
            bevel,
            materials: m(),
        })
    };
    let cylinder = |radius, bevel| {
        Kind::from(BeveledCylinder { y0: 0.0, y1: 1.0, radius, bevel, materials: m() })
    };
    let ring = BeveledRing {
        y0: 0.0,
        y1: 1.0,
        inner_radius: 1.0,
        outer_radius: 1.25,
        bevel: 0.2,
        materials: m(),
    };
    let turn = "two azimuths in degrees from -360 to 360 are needed, less than a turn apart; [350, 10] \
                passes through 360";
    for (kind, problem) in [
        (
            BeveledBox { min, max, bevel: 0.3, materials: m() }.into(),
            "beveled_box.bevel: found 0.3, but at most 0.25 fits, half the side along y".to_owned(),
        ),
        (
            BeveledBox { min, max, bevel: 0.0, materials: m() }.into(),
            "beveled_box.bevel: found 0, but a positive, finite number is needed".to_owned(),
        ),
        (
            BeveledBox { min: max, max: min, bevel: 0.1, materials: m() }.into(),
            "beveled_box.max: found x = 0, but it must be above min's, 1".to_owned(),
        ),
        (
            cylinder(0.25, 0.5),
            "beveled_cylinder.bevel: found 0.5, but at most 0.25 fits, the radius".to_owned(),
        ),
        (
            cylinder(2.0, 0.75),
            "beveled_cylinder.bevel: found 0.75, but at most 0.5 fits, half the height".to_owned(),
        ),
        (
            ring.into(),
            "beveled_ring.bevel: found 0.2, but at most 0.125 fits, half the distance between the \
             radii"
                .to_owned(),
        ),
        (
            // sin 30° = b/(1 + b)
            wedge(1.0, [0.0, 60.0], 1.25),
            "beveled_wedge.bevel: found 1.25, but at most 0.9999999999999999 fits: the inner wall is \
             too narrow"
                .to_owned(),
        ),
        (wedge(1.0, [30.0, 30.0], 0.1), format!("beveled_wedge.phi: found [30.0, 30.0], but {turn}")),
        (wedge(1.0, [0.0, 360.0], 0.1), format!("beveled_wedge.phi: found [0.0, 360.0], but {turn}")),
    ] {
        let found = kind.build(&mut Context::default()).expect_err("refused").to_string();
        assert!(found == problem, "{found}\ninstead of\n{problem}");
    }
}
