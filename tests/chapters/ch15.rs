//! Chapter 15: specular reflection.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | the glossy specular BRDF: (r·ω_o)ᵉ | the BRDF of a highlight is `f = k_s c_s cosᵉα`, α the angle between the mirror direction of the light and the eye; the diffuse term beside it is `k_d c_d/π` | `the_highlight_falls_with_the_power_of_the_cosine` |
//! |  | the lobe of a highlight is the same if light and eye are exchanged, bit for bit, and if both are turned about the normal | `the_highlight_is_reciprocal_and_isotropic` |
//! |  | there is no highlight beyond 90° from the mirror direction or below the surface, and it is never negative or NaN, whatever the exponent | `a_highlight_is_never_negative_or_nan` |
//! | the mirror direction | in the mirror direction the highlight is `k_s c_s l_s c_l (n·ω_i)`, whatever the exponent: with the cosine, and not tinted by `c_d` | `the_highlight_peaks_at_the_mirror_direction_whatever_its_exponent` |
//! | the material Phong | without highlights (`k_s = 0`) a Phong surface is a matte one, bit for bit | `phong_without_highlights_is_matte` |
//! | fig. 15.7, the exponent and the size of a highlight | in a whole picture the highlight's brightest pixel is the one whose sphere point bisects light and eye, and its half-peak disc has the size that the exponent says | `a_highlight_in_a_picture_has_the_size_of_its_exponent` |
//! |  | seen straight from above, the highlight reflects `2π k_s/(e + 2)` of uniform light, in addition to the diffuse share, under every tracer | `the_energy_of_a_highlight_is_two_pi_over_e_plus_two` |
//! |  | a highlight is half as bright as at its peak at `acos 2^(−1/e)` from the mirror direction: 60° for e = 1, 21.09° for 10, 6.74° for 100 and 2.13° for 1000 | `highlights_are_half_as_bright_at_known_angles` |
//!
//! Beyond the book: 1 in this file.

use std::f64::consts::FRAC_PI_2;

use groundtruth::cameras;
use groundtruth::lobes::GlossySpecular;
use testkit::properties::*;

use crate::prelude::*;
use crate::support::stage::*;

laws_of_light!("ch15": the_energy_of_a_highlight_is_two_pi_over_e_plus_two);

fn lobe(ks: f64, exponent: f64) -> Lobe {
    GlossySpecular { reflectance: Rgb::grey(ks), exponent }.into()
}

/// Exponents from the broadest lobe to very narrow ones, many of them fractional.
fn exponents() -> impl Strategy<Value = f64> {
    prop_oneof![0.0..4.0_f64, 0.0..1e4_f64, Just(0.0), Just(0.25), (0..50_u32).prop_map(f64::from)]
}

fn phong(ka: f64, kd: f64, cd: Rgb, ks: f64, cs: Rgb, exponent: f64) -> Phong {
    Phong {
        ka: ka.into(),
        kd: kd.into(),
        cd: cd.into(),
        ks: ks.into(),
        cs: cs.into(),
        exponent: exponent.into(),
    }
}

/// A plane through the origin under one light, seen along `−to_eye`.
fn plane_seen(
    n: Normal,
    recipe: impl Into<groundtruth::materials::Kind>,
    wi: Vector,
    wo: Vector,
) -> Rgb {
    let mut scene = stage(Rgb::BLACK);
    put(&mut scene, Plane { point: Point::ORIGIN, normal: n.into() }, recipe);
    shine(&mut scene, light(wi));
    look(&built(&scene), Point::ORIGIN + 3.0 * wo, -wo)
}

const LIGHT: Rgb = Rgb::new(3.0, 1.5, 0.75);

fn light(direction: Vector) -> Directional {
    Directional { ls: 3.0, color: Rgb::new(1.0, 0.5, 0.25), direction }
}

/// Reflecting a direction and the rounding of a cosine near 1 give errors of some 10u, which an exponent
/// multiplies.
fn rounding(exponent: f64) -> f64 {
    (16.0 + 16.0 * exponent) * U
}

proptest! {
    #![proptest_config(laws())]

    /// Law: without highlights (`k_s = 0`) a Phong surface is a matte one, bit for bit. Oracle: matte.
    /// Book: the material Phong.
    #[test]
    fn phong_without_highlights_is_matte((n, wi) in normal_and_direction_above(), cd in color()) {
        let wo = at_angle(n, 0.3, 1.0);
        let matte = matte(0.3, 0.6, cd);
        let plain = phong(0.3, 0.6, cd, 0.0, Rgb::WHITE, 7.0);
        prop_assert_eq!(plane_seen(n, plain, wi, wo), plane_seen(n, matte, wi, wo));
    }

    /// Law: in the mirror direction the highlight is `k_s c_s l_s c_l (n·ω_i)`, whatever the exponent: with
    /// the cosine, and not tinted by `c_d`. Oracle: the formula (ch. 15).
    /// Book: the mirror direction.
    #[test]
    fn the_highlight_peaks_at_the_mirror_direction_whatever_its_exponent(
        n in unit(),
        cos_i in 0.05..1.0_f64,
        phi in 0.0..TAU,
        e in exponents(),
        cs in color(),
    ) {
        let (wi, wo) = (at_angle(n, cos_i, phi), at_angle(n, cos_i, phi + PI));
        let seen = plane_seen(n, phong(0.0, 0.0, Rgb::BLACK, 0.5, cs, e), wi, wo);
        let expected = (0.5 * n.dot(wi)) * (cs * LIGHT);
        close!(seen, expected, rounding(e) / cos_i);
    }

    /// Law: the BRDF of a highlight is `f = k_s c_s cosᵉα`, α the angle between the mirror direction of the
    /// light and the eye; the diffuse term beside it is `k_d c_d/π`. Oracle: α from the bisector of light and
    /// eye in the plane of incidence, where angles add.
    /// Book: the glossy specular BRDF: (r·ω_o)ᵉ.
    #[test]
    fn the_highlight_falls_with_the_power_of_the_cosine(
        (theta, alpha) in (-1.5..1.5_f64, -1.5..1.5_f64),
        e in 0.0..500.0_f64,
    ) {
        let in_plane = |angle: f64| Vector::new(sin(angle), 0.0, cos(angle));
        prop_assume!((alpha - theta).abs() < FRAC_PI_2 - 0.01);
        let (wi, wo) = (in_plane(theta), in_plane(alpha - theta));
        let recipe = phong(0.0, 0.4, Rgb::WHITE, 0.5, Rgb::WHITE, e);
        let seen = plane_seen(Normal::Z, recipe, wi, wo);
        let expected = (cos(theta) * (0.4 / PI + 0.5 * power(cos(alpha), e))) * LIGHT;
        let tolerance = rounding(e) / cos(alpha) + 16.0 * U / cos(theta);
        close!(seen, expected, tolerance);
    }

    /// Law: the lobe of a highlight is the same if light and eye are exchanged, bit for bit, and if both are
    /// turned about the normal. Oracle: the lobe before (`r(ω_i)·ω_o = r(ω_o)·ω_i`; ch. 15).
    /// Book: the glossy specular BRDF: (r·ω_o)ᵉ.
    #[test]
    fn the_highlight_is_reciprocal_and_isotropic(
        (ci, co) in (cosine(), cosine()),
        (phi, turn) in (0.0..TAU, 0.0..TAU),
        e in 0.0..100.0_f64,
    ) {
        let turned = |turn| (at_angle(Normal::Z, ci, turn), at_angle(Normal::Z, co, phi + turn));
        let ((a, b), (c, d)) = (turned(0.0), turned(turn));
        let f = lobe(0.5, e).f(a, b);
        prop_assert_eq!(f, lobe(0.5, e).f(b, a));
        // an absolute tolerance: far from the peak the cosine is of the size of its rounding error
        near!(f.r, lobe(0.5, e).f(c, d).r, rounding(e));
    }

    /// Law: there is no highlight beyond 90° from the mirror direction or below the surface, and it is never
    /// negative or NaN, whatever the exponent. Oracle: the sign of `r·ω_o`.
    /// Book: the glossy specular BRDF: (r·ω_o)ᵉ.
    #[test]
    fn a_highlight_is_never_negative_or_nan(wo in unit(), wi in unit(), e in exponents()) {
        let (wo, wi) = (Vector::from(wo), Vector::from(wi));
        let f = lobe(0.5, e).f(wo, wi).r;
        prop_assert!((0.0..=0.5 * (1.0 + rounding(e))).contains(&f), "{f}");
        let r = 2.0 * wi.z() * Vector::Z - wi;
        if r.dot(wo) < -4.0 * U || wo.z() < 0.0 || wi.z() < 0.0 {
            prop_assert_eq!(f, 0.0);
        }
    }
}

/// Law: in a whole picture the highlight's brightest pixel is the one whose sphere point bisects light
/// and eye, and its half-peak disc has the size that the exponent says. Oracle: the closed form for a
/// unit sphere under parallel rays with light and eye on one line: the normal turns by half of α.
/// Book: fig. 15.7, the exponent and the size of a highlight.
#[test]
fn a_highlight_in_a_picture_has_the_size_of_its_exponent() {
    for exponent in [20.0, 100.0] {
        let mut scene: Scene = stage(Rgb::BLACK);
        let shiny = phong(0.0, 0.0, Rgb::BLACK, 1.0, Rgb::WHITE, exponent);
        put(&mut scene, sphere(Point::ORIGIN, 1.0), shiny);
        shine(&mut scene, light(Vector::Z));
        scene.camera.lens = cameras::Orthographic { zoom: 1.0 }.into();
        (scene.image.width, scene.image.height, scene.image.pixel_size) = (101, 101, 0.02);
        let film = render::render(&built(&scene));
        let peak = film.get([50, 50]).r;
        near!(peak, LIGHT.r, 1e-12);
        for (i, pixel) in film.pixels().iter().enumerate() {
            let (x, y) = ((i % 101) as f64 - 50.0, (i / 101) as f64 - 50.0);
            // the surface is turned by θ, sinθ = distance from the middle; then α = 2θ
            let sine_squared = 0.0004 * (x * x + y * y);
            if sine_squared < 0.45 {
                let (cosine, cos_alpha) = ((1.0 - sine_squared).sqrt(), 1.0 - 2.0 * sine_squared);
                let expected = LIGHT.r * cosine * power(cos_alpha, exponent);
                assert!((pixel.r - expected).abs() < 1e-12 * LIGHT.r, "{x} {y}: {pixel:?}");
            }
        }
    }
}

/// Law: a highlight too faint for the single precision of a picture, below 2⁻¹⁴⁹, casts no shadow ray; a
/// brighter one does, and no light is lost. Oracle: `(cos 60°)^e = 2^−e`, on both sides of the limit.
#[test]
fn no_shadow_ray_is_cast_for_what_no_picture_can_show() {
    for (exponent, rays) in [(1000.0, 0), (151.0, 0), (147.0, 1), (1.0, 1)] {
        let mut scene = stage(Rgb::BLACK);
        let gloss = Phong { ks: 1.0.into(), exponent: exponent.into(), ..Phong::default() };
        put(&mut scene, ground(0.0), gloss);
        shine(&mut scene, Directional { ls: 1.0, color: Rgb::WHITE, direction: Vector::Y });
        let (eye, down) =
            (Point::new(-3.0_f64.sqrt(), 1.0, 0.0), Vector::new(3.0_f64.sqrt(), -1.0, 0.0));
        let world = built(&scene);
        assert_eq!(counted(&world, eye, down).shadow, rays, "exponent {exponent}");
        let found = look(&world, eye, down).r;
        let expected = if rays > 0 { power(0.5, exponent) } else { 0.0 };
        assert!((found - expected).abs() <= 1e-12 * expected, "{found:e} for exponent {exponent}");
    }
}

/// Law: a highlight is half as bright as at its peak at `acos 2^(−1/e)` from the mirror direction: 60° for e = 1, 21.09°
/// for 10, 6.74° for 100 and 2.13° for 1000. Oracle: those angles, to their last digit.
/// Book: fig. 15.7, the exponent and the size of a highlight.
#[test]
fn highlights_are_half_as_bright_at_known_angles() {
    let in_plane = |degrees: f64| Vector::new(sin_degrees(degrees), 0.0, cos_degrees(degrees));
    for (e, half) in [(1.0, 60.0), (10.0, 21.09), (100.0, 6.74), (1e3, 2.13)] {
        let highlight = |alpha: f64| lobe(1.0, e).f(in_plane(-20.0), in_plane(20.0 + alpha)).g;
        near!(highlight(0.0), 1.0, 1e-9, "exponent {e}");
        below!(highlight(half + 0.01), 0.5, "exponent {e}");
        above!(highlight(half - 0.01), 0.5, "exponent {e}");
    }
}
