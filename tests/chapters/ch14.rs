//! Chapter 14: lights and materials.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | directional and point lights | a directional light is the same everywhere, and depends on its direction only, not on its length | `a_directional_light_is_the_same_everywhere` |
//! | fig. 14.11, distance attenuation | a point light straight above at distance d gives `k_d l_s/(π d^k)`; with k = 0 it does not depend on d | `a_point_light_fades_with_the_power_of_its_distance` |
//! | diffuse shading: the material Matte | a matte surface has the radiance `L = k_a c_d L_a + (k_d c_d/π) l_s c_l (n·ω_i)`, wherever the eye is | `lambert_shading_is_exact_on_a_plane` |
//! |  | a light of strength π straight above a white surface gives it the radiance 1 | `light_of_strength_pi_makes_a_white_surface_white` |
//! |  | a point that faces away from a light gets ambient light only, and no shadow ray is cast for it | `points_that_face_away_get_ambient_light_only` |
//! |  | lights add, and two equal ones are one of twice the strength, bit for bit | `lights_add` |
//! | listing 14.18, colours out of gamut | out-of-gamut colours are divided by their largest channel, or become red; others do not change | `a_colour_out_of_gamut_keeps_its_hue_or_turns_red` |
//! | coloured lights | green light on a red surface gives black; coloured ambient light is multiplied by the same colour `c_d`, times `k_a` | `green_light_on_a_red_surface_is_black` |
//! | shading both sides of a surface | a two-sided surface is lit and seen on its back as on its front; a one-sided one shows its back in ambient light only | `only_two_sided_surfaces_are_lit_from_behind` |
//!
//! Beyond the book: 2 in `sources`.

mod sources;

use groundtruth::film::{OutOfGamut, Tone};
use groundtruth::lights::PointLight as Lamp;
use testkit::properties::*;

use crate::prelude::*;
use crate::support::stage::*;

laws_of_light!(
    "ch14":
    light_of_strength_pi_makes_a_white_surface_white,
    green_light_on_a_red_surface_is_black,
);

/// A few products and one sum of positive terms: each rounds once or twice.
const PRODUCTS: f64 = 12.0 * U;

/// A plane through the origin, without lights yet.
fn lit_plane(normal: Normal, matte: Matte) -> Scene {
    let mut scene = stage(Rgb::BLACK);
    put(&mut scene, Plane { point: Point::ORIGIN, normal: normal.into() }, matte);
    scene
}

fn sun(ls: f64, color: Rgb, direction: Vector) -> Directional {
    Directional { ls, color, direction }
}

fn lamp(ls: f64, location: Point, attenuation: f64) -> Lamp {
    Lamp { ls, color: Rgb::WHITE, location, attenuation }
}

/// The radiance for an eye that looks along `−towards` at the origin.
fn seen(scene: &Scene, towards: Vector) -> Rgb {
    look(&built(scene), Point::ORIGIN + 3.0 * towards, -towards)
}

proptest! {
    #![proptest_config(laws())]

    /// Law: a matte surface has the radiance `L = k_a c_d L_a + (k_d c_d/π) l_s c_l (n·ω_i)`, wherever the
    /// eye is. Oracle: the formula (ch. 14), channel by channel: the colours of light and surface multiply
    /// component-wise.
    /// Book: diffuse shading: the material Matte.
    #[test]
    fn lambert_shading_is_exact_on_a_plane(
        (n, wi) in normal_and_direction_above(),
        (to_eye, length) in (0.05..1.0_f64, 1e-3..1e3_f64),
        (cd, ca, cl) in (color(), color(), color()),
        (ka, kd, ls) in (0.0..1.0_f64, 0.0..1.0_f64, 0.0..10.0_f64),
    ) {
        let mut scene = lit_plane(n, matte(ka, kd, cd));
        shine(&mut scene, Ambient { ls: 0.5, color: ca });
        shine(&mut scene, sun(ls, cl, length * wi));
        let seen = seen(&scene, at_angle(n, to_eye, 5.0));
        let cosine = n.dot(wi);
        let expected = (ka * 0.5) * (cd * ca) + (kd * ls * cosine * FRAC_1_PI) * (cd * cl);
        // the cosine of a grazing light has an absolute error of u
        let rounding = kd * ls * 4.0 * U;
        for (a, b) in seen.to_array().into_iter().zip(expected.to_array()) {
            prop_assert!((a - b).abs() <= PRODUCTS * b + rounding, "{a} {b}");
        }
    }

    /// Law: lights add, and two equal ones are one of twice the strength, bit for bit. Oracle: the
    /// sum of the pictures of each light alone (linearity of the reflection equation).
    /// Book: diffuse shading: the material Matte.
    #[test]
    fn lights_add(n in unit(), a in unit(), location in point(5.0), cd in color()) {
        let alone = |scene: &mut Scene, which: &[usize]| {
            for (i, light) in scene.lights.iter_mut().enumerate() {
                light.enabled = which.contains(&i);
            }
            seen(scene, at_angle(n, 0.5, 1.0))
        };
        let mut scene = lit_plane(n, matte(0.25, 0.75, cd));
        shine(&mut scene, sun(2.0, Rgb::new(1.0, 0.5, 0.2), a.into()));
        shine(&mut scene, lamp(3.0, location, 2.0));
        shine(&mut scene, Ambient { ls: 0.3, color: Rgb::WHITE });
        shine(&mut scene, sun(2.0, Rgb::new(1.0, 0.5, 0.2), a.into()));
        shine(&mut scene, sun(4.0, Rgb::new(1.0, 0.5, 0.2), a.into()));
        let sum = alone(&mut scene, &[0]) + alone(&mut scene, &[1]) + alone(&mut scene, &[2]);
        prop_assert_eq!(alone(&mut scene, &[0, 1, 2]), sum);
        prop_assert_eq!(alone(&mut scene, &[0, 3]), alone(&mut scene, &[4]));
    }

    /// Law: a directional light is the same everywhere, and depends on its direction only, not on its length.
    /// Oracle: the same scene moved, and the direction doubled; bit for bit.
    /// Book: directional and point lights.
    #[test]
    fn a_directional_light_is_the_same_everywhere(
        (n, wi) in normal_and_direction_above(),
        at in point(1e6),
    ) {
        let shading = |at: Point, wi: Vector| {
            let mut scene = stage(Rgb::BLACK);
            put(&mut scene, Plane { point: at, normal: n.into() }, matte(0.0, 1.0, Rgb::WHITE));
            shine(&mut scene, sun(1.0, Rgb::WHITE, wi));
            let to_eye = at_angle(n, 0.5, 1.0);
            look(&built(&scene), at + 3.0 * to_eye, -to_eye)
        };
        prop_assert_eq!(shading(at, wi), shading(Point::ORIGIN, wi));
        prop_assert_eq!(shading(at, 2.0 * wi), shading(at, wi));
        close!(shading(at, 0.3 * wi), shading(at, wi), 8.0 * U / n.dot(wi));
    }

    /// Law: a point light straight above at distance d gives `k_d l_s/(π d^k)`; with k = 0 it does not depend
    /// on d. Oracle: the formula, with the power by repeated division (ch. 14, exercises).
    /// Book: fig. 14.11, distance attenuation.
    #[test]
    fn a_point_light_fades_with_the_power_of_its_distance(
        n in unit(),
        d in 1e-3..1e3_f64,
        k in 0_u32..4,
    ) {
        let mut scene = lit_plane(n, matte(0.0, 1.0, Rgb::WHITE));
        shine(&mut scene, lamp(PI, Point::ORIGIN + d * n, f64::from(k)));
        let expected = (0..k).fold(1.0, |light, _| light / d);
        // the error of the hit point is a few u of the eye's distance, which matters for a near lamp
        let tolerance = PRODUCTS + f64::from(k + 1) * 64.0 * U / d;
        let seen = seen(&scene, n.into());
        close!(seen, Rgb::grey(expected), tolerance);
    }

    /// Law: a point that faces away from a light gets ambient light only, and no shadow ray is cast
    /// for it. Oracle: the ambient term, and the counters.
    /// Book: diffuse shading: the material Matte.
    #[test]
    fn points_that_face_away_get_ambient_light_only((n, up) in normal_and_direction_above()) {
        let mut scene = stage(Rgb::BLACK);
        put(&mut scene, sphere(Point::ORIGIN, 1.0), matte(0.5, 1.0, Rgb::WHITE));
        shine(&mut scene, sun(1.0, Rgb::WHITE, -up));
        shine(&mut scene, lamp(1.0, Point::ORIGIN - 5.0 * up, 0.0));
        shine(&mut scene, Ambient { ls: 0.5, color: Rgb::WHITE });
        let world = built(&scene);
        let eye = Point::ORIGIN + 3.0 * n;
        prop_assert_eq!(look(&world, eye, -Vector::from(n)), Rgb::grey(0.25));
        prop_assert_eq!(counted(&world, eye, -Vector::from(n)).shadow, 0);
    }

    /// Law: a two-sided surface is lit and seen on its back as on its front; a one-sided one shows
    /// its back in ambient light only. Oracle: the mirror image of light and eye.
    /// Book: shading both sides of a surface.
    #[test]
    fn only_two_sided_surfaces_are_lit_from_behind((n, wi) in normal_and_direction_above()) {
        let shading = |two_sided: bool, side: f64| {
            let mut scene = lit_plane(n, matte(0.5, 1.0, Rgb::new(0.9, 0.6, 0.3)));
            scene.materials[0].two_sided = two_sided;
            shine(&mut scene, Ambient { ls: 0.5, color: Rgb::WHITE });
            shine(&mut scene, sun(2.0, Rgb::WHITE, side * wi));
            seen(&scene, side * at_angle(n, 0.5, 2.0))
        };
        let front = shading(true, 1.0);
        prop_assert_eq!(front, shading(false, 1.0));
        close!(front, shading(true, -1.0), 4.0 * U);
        prop_assert_eq!(shading(false, -1.0), 0.25 * Rgb::new(0.9, 0.6, 0.3));
    }

    /// Law: out-of-gamut colours are divided by their largest channel, or become red; others do not change.
    /// Oracle: ratios of channels, by cross-multiplication (ch. 3, 14).
    /// Book: listing 14.18, colours out of gamut.
    #[test]
    fn a_colour_out_of_gamut_keeps_its_hue_or_turns_red(c in color(), strength in 0.1..20.0_f64) {
        let tone = |out_of_gamut| Tone { exposure: 1.0, gamma: 1.0, out_of_gamut };
        let radiance = strength * c;
        let shown = tone(OutOfGamut::MaxToOne).map(radiance);
        let flagged = tone(OutOfGamut::ClampToColor).map(radiance);
        if radiance.max() > 1.0 {
            prop_assert_eq!(shown.max(), 1.0);
            for (a, b) in [(0, 1), (1, 2), (2, 0)] {
                let (s, r) = (shown.to_array(), radiance.to_array());
                near!(s[a] * r[b], s[b] * r[a], 4.0 * U * r[a].max(r[b]));
            }
            prop_assert_eq!(flagged, Rgb::new(1.0, 0.0, 0.0));
        } else {
            prop_assert_eq!(shown, radiance);
            prop_assert_eq!(flagged, radiance);
        }
    }
}
