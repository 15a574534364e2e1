//! Lamps that lie on another object's surface, or in its plane.

use testkit::properties::*;

use super::*;
use crate::prelude::*;
use testkit::scaling::scaled_scene;

/// A black plane: it hides what is behind it and reflects nothing.
fn black_plane(scene: &mut Scene, point: Point, normal: Vector) {
    put(scene, Plane { point, normal }, matte(0.0, 0.0, Rgb::BLACK));
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
            false => {
                let a = at_angle(-n, 0.0, turn + 0.3);
                panel(center, a, 0.7 * (-n).cross(a)).into()
            }
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

/// Law: a rectangle flush with a floor, or with the top of a box, lights a wall and a ceiling like one that
/// hangs freely; the floor around it is in its plane and gets no light. Oracle: Lambert's formula.
#[test]
fn a_rectangle_flush_with_a_floor_or_a_box_gives_lamberts_light() {
    let top = 0.7;
    let lamp = panel(Point::new(0.3, top, -0.2), 1.6 * Vector::Z, 0.9 * Vector::X);
    for on_box in [false, true] {
        let mut scene = stage(Rgb::BLACK);
        let under = match on_box {
            false => shapes::Kind::from(ground(top)),
            true => boxed(Point::new(-1.0, 0.0, -1.5), Point::new(1.0, top, 1.5)).into(),
        };
        put(&mut scene, under, white());
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
            let values = seen(&scene, 1024, point, n);
            let what = format!("on a box: {on_box}, at {point:?}");
            assert_color(&what, &values, lit(share), 8, 8e-3);
        }
        let beside = seen(&scene, 16, Point::new(-0.5, top, 0.1), up());
        assert_color("beside the lamp, in its plane", &beside, Rgb::BLACK, 8, 0.0);
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
