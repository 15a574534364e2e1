//! Lamps that lie on another object's surface, or in its plane.

use testkit::properties::*;

use super::*;
use crate::prelude::*;
use testkit::scaling::scaled_scene;

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
        let ceiling = Plane { point: above - 3.0 * at_angle(n, 0.0, turn + 1.0), normal: -Vector::from(n) };
        put(&mut scene, ceiling, matte(0.0, 0.0, Rgb::BLACK));
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
