//! Lamps that lie on another object's surface, or in its plane.

use testkit::properties::*;

use super::*;
use crate::prelude::*;
use testkit::scaling::scaled_scene;

const SAMPLES: u32 = 1024;
/// The largest standard error that a mean may have here.
const POWER: f64 = 8e-3;

/// A black plane: it hides what is behind it and reflects nothing.
fn black_plane(scene: &mut Scene, point: Point, normal: Vector) {
    let black = Matte { ka: 0.0.into(), kd: 0.0.into(), cd: Rgb::BLACK.into() };
    put(scene, Plane { point, normal }, black);
}

/// A rectangle with these side lengths, in the plane through `center` with this normal; its front is on the
/// normal's side.
fn flat_panel(center: Point, normal: Normal, [long, wide]: [f64; 2], turn: f64) -> Rectangle {
    let a = at_angle(normal, 0.0, turn);
    let b = normal.cross(a);
    panel(center, long * a, wide * b)
}

fn corners(r: &Rectangle) -> [Point; 4] {
    [r.corner, r.corner + r.a, r.corner + r.a + r.b, r.corner + r.b]
}

proptest! {
    #![proptest_config(laws())]

    /// Law: a ceiling does not shadow a lamp in its plane, at any tilt, distance and scale, however grazing
    /// the light: the floor is 1 below, the lamp up to 1000 to the side. Oracle: the same samples without
    /// shadows, bit for bit.
    #[test]
    fn a_ceiling_does_not_shadow_a_lamp_in_its_plane(
        (n, turn) in (unit(), 0.0..6.3_f64),
        aside in -1.0..3.0_f64,
        exponent in -1.0..3.0_f64,
        away in unit(),
        scale in -20..20_i32,
        is_round in any::<bool>(),
        by_area in any::<bool>(),
    ) {
        let origin = Point::ORIGIN + power(10.0, exponent) * away;
        let mut scene = stage(Rgb::BLACK);
        put(&mut scene, Plane { point: origin, normal: n.into() }, white());
        let above = origin + 1.0 * n;
        let center = above + power(10.0, aside) * at_angle(n, 0.0, turn);
        black_plane(&mut scene, above - 3.0 * at_angle(n, 0.0, turn + 1.0), -Vector::from(n));
        let shape: shapes::Kind = match is_round {
            true => Disk { center, normal: -Vector::from(n), radius: 0.5 }.into(),
            false => flat_panel(center, -n, [1.0, 0.7], turn + 0.3).into(),
        };
        let sampling = if by_area || is_round { Sampling::Area } else { Sampling::SolidAngle };
        hang(&mut scene, shape, Some(sampling));
        let mut free = scene.clone();
        free.lights[0].shadows = false;
        let [found, expected] = [scene, free].map(|scene| {
            let world = built(&with_samples(scaled_scene(&scene, scale), 16));
            let eye = (origin + 1e-3 * n).scaled(power_of_two(scale));
            view(&world, eye, -Vector::from(n))
        });
        prop_assert!(!expected.is_black(), "the lamp does not light the floor");
        prop_assert_eq!(found, expected);
    }
}

/// Law: a disk in the plane of a ceiling lights the floor like one that hangs freely, whichever of the two
/// the scene lists first. Oracle: the closed form of a parallel disk beside the point (Howell's catalogue,
/// B-13).
#[test]
fn a_disk_in_the_plane_of_the_ceiling_gives_its_closed_form() {
    let n = Normal::new(Vector::new(0.3, 1.0, -0.6)).expect("not zero");
    for (radius, aside) in [(1.0, 0.0), (0.5, 2.0), (1.5, 6.0)] {
        let (height, t) = (1.3, 1.3 * 1.3 + aside * aside);
        let (sum, r): (f64, f64) = (t + radius * radius, 4.0 * radius * radius * aside * aside);
        let share = 0.5 * (1.0 - (t - radius * radius) / (sum * sum - r).sqrt());
        for lamp_first in [false, true] {
            let center = Point::ORIGIN + height * n + aside * at_angle(n, 0.0, 2.0);
            let disk = Disk { center, normal: -Vector::from(n), radius };
            let ceiling = Point::ORIGIN + height * n - 7.0 * at_angle(n, 0.0, 1.0);
            let mut scene = floor(n);
            if !lamp_first {
                black_plane(&mut scene, ceiling, -Vector::from(n));
            }
            hang(&mut scene, disk, None);
            if lamp_first {
                black_plane(&mut scene, ceiling, -Vector::from(n));
            }
            let values = seen(&scene, SAMPLES, Point::ORIGIN, n);
            let what = format!("radius {radius}, aside {aside}, lamp first: {lamp_first}");
            assert_color(&what, &values, lit(share), 6, POWER);
        }
    }
}

/// Law: a sphere that lies on the floor lights it with `(R/D)² cosθ = (R/D)³`: the floor is the tangent
/// plane, so the horizon cuts nothing off. Oracle: that closed form, for points from a tenth of the radius to
/// ten radii away from the point of contact.
#[test]
fn a_sphere_that_lies_on_the_floor_gives_its_closed_form() {
    const RADIUS: f64 = 0.8;
    for sampling in [Sampling::SolidAngle, Sampling::Area] {
        for aside in [0.1, 0.5, 1.0, 3.0, 10.0_f64] {
            let aside = aside * RADIUS;
            // by area, a sample next to the point of contact is rare and bright
            if sampling == Sampling::Area && aside < RADIUS {
                continue;
            }
            let n = Normal::new(Vector::new(-0.5, 1.0, 0.2)).expect("not zero");
            let mut scene = floor(n);
            let center = Point::ORIGIN + RADIUS * n + aside * at_angle(n, 0.0, 1.0);
            hang(&mut scene, ball(center, RADIUS), Some(sampling));
            let values = seen(&scene, SAMPLES, Point::ORIGIN, n);
            let squared = 1.0 / (1.0 + (aside / RADIUS) * (aside / RADIUS));
            let share = squared * squared.sqrt();
            let what = format!("{sampling:?}, {aside} from where it touches");
            assert_color(&what, &values, lit(share), 8, 2.0 * POWER);
        }
    }
}

/// Law: a rectangle flush with a floor, or with the top of a box, lights a wall and a ceiling like one that
/// hangs freely; the floor around it is in its plane and gets no light. Oracle: Lambert's formula.
#[test]
fn a_rectangle_flush_with_a_floor_or_a_box_gives_lamberts_light() {
    let top = 0.7;
    let lamp = panel(Point::new(0.3, top, -0.2), 1.6 * Vector::Z, 0.9 * Vector::X);
    for on_box in [false, true] {
        let mut scene = stage(Rgb::BLACK);
        match on_box {
            false => put(
                &mut scene,
                Plane { point: Point::new(0.0, top, 0.0), normal: Vector::Y },
                white(),
            ),
            true => {
                let (min, max) = (Point::new(-1.0, 0.0, -1.5), Point::new(1.0, top, 1.5));
                put(&mut scene, shapes::Cuboid { min, max }, white())
            }
        };
        put(&mut scene, Plane { point: Point::new(2.0, 0.0, 0.0), normal: -Vector::X }, white());
        put(&mut scene, Plane { point: Point::new(0.0, 3.0, 0.0), normal: -Vector::Y }, white());
        hang(&mut scene, lamp.clone(), None);
        let wall = -Normal::X;
        for (point, n) in [
            (Point::new(2.0, 0.9, 0.0), wall),
            (Point::new(2.0, 2.5, 1.0), wall),
            (Point::new(0.3, 3.0, -0.2), -Normal::Y),
            (Point::new(-1.0, 3.0, 2.0), -Normal::Y),
        ] {
            let share = share(point, n, &corners(&lamp));
            let values = seen(&scene, SAMPLES, point, n);
            assert_color(
                &format!("on a box: {on_box}, at {point:?}"),
                &values,
                lit(share),
                8,
                POWER,
            );
        }
        let beside = seen(&scene, 16, Point::new(-0.5, top, 0.1), up());
        assert!(
            beside.iter().all(|seen| seen.is_black()),
            "beside the lamp, in its plane: {beside:?}"
        );
    }
}

/// Law: if a lamp and a ceiling lie in one horizontal plane, the one that the scene lists first is seen,
/// everywhere on the lamp. Oracle: the radiance `l_s c_e`, and black. (In a tilted plane the rounding of each
/// hit decides.)
#[test]
fn of_a_lamp_and_a_ceiling_in_one_plane_the_first_is_seen() {
    let center = Point::new(0.2, 1.7, -0.4);
    let shapes: [shapes::Kind; 2] = [
        panel(center, Vector::X, 0.7 * Vector::Z).into(),
        Disk { center, normal: -Vector::Y, radius: 0.5 }.into(),
    ];
    let mut random = Pcg32::new(18, 3);
    for shape in shapes {
        for lamp_first in [true, false] {
            let mut scene = stage(Rgb::BLACK);
            if !lamp_first {
                black_plane(&mut scene, Point::new(5.0, center.y(), 3.0), -Vector::Y);
            }
            hang(&mut scene, shape.clone(), None);
            if lamp_first {
                black_plane(&mut scene, Point::new(5.0, center.y(), 3.0), -Vector::Y);
            }
            let world = built(&scene);
            for _ in 0..1000 {
                let mut c = || random.uniform() - 0.5;
                let spot = center + Vector::new(0.6 * c(), 0.0, 0.6 * c());
                let eye = Point::new(6.0 * c(), 1.6 * random.uniform(), 6.0 * random.uniform());
                let found = look(&world, eye, spot - eye);
                let expected = if lamp_first { LS * CE } else { Rgb::BLACK };
                assert_eq!(found, expected, "{shape:?}, seen from {eye:?} at {spot:?}");
            }
        }
    }
}
