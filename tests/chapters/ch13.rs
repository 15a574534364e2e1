//! Chapter 13: theoretical foundations.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | radiance and irradiance | radiance does not change along a ray: an emitter is as bright from any distance and at any angle, to the last bit | `radiance_is_constant_along_a_ray` |
//! |  | uniform radiance within half angle α of the normal has the irradiance `π L sin²α`; a white diffuse surface reflects the radiance `L sin²α` | `a_cone_of_light_gives_the_irradiance_of_its_projected_solid_angle` |
//! | properties of BRDFs: reciprocity and energy | `f(ω_i, ω_o) = f(ω_o, ω_i)` and `f ≥ 0`, for each lobe that claims reciprocity | `reflection_is_reciprocal_and_never_negative` |
//! |  | a lobe's albedo is the share of uniform light that it scatters, and a lobe that claims to conserve energy scatters no more than arrives | `albedo::no_lobe_that_conserves_energy_reflects_more_than_all` |
//! | reflectance | the albedo of the glossy lobe is `k_s c_s ∫ cosᵉα cosθ_i dω`, to a relative error of 1e-12: for lobes from the broadest to the narrowest, seen from straight above to within 1e-6 of grazing, where the horizon cuts off half of them | `albedo::the_glossy_albedo_is_exact_to_twelve_digits` |
//! | the perfect diffuse BRDF | the BRDF `f = k_d c_d/π` has the reflectance `∫ f cosθ dω = k_d c_d`, and `albedo` returns the same | `lambertian_reflectance_is_the_integral_of_its_brdf` |
//! | the reflection equation in uniform light | a convex body of albedo ρ in uniform light L reflects ρL everywhere: each point is lit from its whole hemisphere, and no part of the body shades another | `a_convex_body_in_a_furnace_shines_with_its_albedo` |
//! | Monte Carlo integration | a sample of a BRDF has the weight `f cosθ_i / pdf` | `a_sample_weighs_its_brdf_by_its_density` |
//! |  | samples follow the density they state: the mean of any function over all samples is its integral times the density | `samples_follow_the_density_they_state` |
//! |  | four times as many samples halve the standard error of a Monte Carlo estimate (slope −1/2) | `four_times_as_many_samples_halve_the_error` |
//! |  | with directions drawn in proportion to the cosine, the estimate of a diffuse surface's reflection has no variance: each sample gives `ρ` | `cosine_sampling_of_a_diffuse_surface_has_no_variance` |
//!
//! Beyond the book: 1 in `albedo`.

pub mod albedo;

use std::f64::consts::FRAC_PI_2;

use groundtruth::lobes::{GlossySpecular, Lambertian};
use testkit::properties::*;

use crate::prelude::*;
use crate::support::stage::*;

laws_of_light!("ch13": a_convex_body_in_a_furnace_shines_with_its_albedo);

/// Steps of a quadrature in each of two angles.
const STEPS: u32 = 400;

/// The midpoint rule errs by `h²/6` in `∫ sin 2θ`, `h = π/800`; cosine powers up to 20 have second
/// derivatives up to 40 times as large.
const QUADRATURE: f64 = 40.0 * (FRAC_PI_2 / 400.0) * (FRAC_PI_2 / 400.0) / 6.0;

/// `∫ g(ω) cosθ dω` over directions within `half_angle` of the normal, by midpoints of the angles.
fn projected_integral(half_angle: f64, g: impl Fn(Vector) -> f64) -> f64 {
    let (dtheta, dphi) = (half_angle / f64::from(STEPS), TAU / f64::from(STEPS));
    let mut sum = 0.0;
    for i in 0..STEPS {
        let theta = (f64::from(i) + 0.5) * dtheta;
        let (s, c) = (sin(theta), cos(theta));
        for j in 0..STEPS {
            let phi = (f64::from(j) + 0.5) * dphi;
            sum += g(Vector::new(s * cos(phi), s * sin(phi), c)) * c * s;
        }
    }
    sum * dtheta * dphi
}

fn every_lobe() -> impl Iterator<Item = Lobe> {
    Lobe::ENTRIES.iter().flat_map(|entry| (entry.specimens)())
}

/// Law: the BRDF `f = k_d c_d/π` has the reflectance `∫ f cosθ dω = k_d c_d`, and `albedo` returns the same.
/// Oracle: quadrature in angles (ch. 13).
/// Book: the perfect diffuse BRDF.
#[test]
fn lambertian_reflectance_is_the_integral_of_its_brdf() {
    let reflectance = Rgb::new(0.8, 0.4, 0.1);
    let lobe = Lobe::from(Lambertian { reflectance });
    for cosine in [1.0, 0.5, 1e-3] {
        let wo = at_angle(Normal::Z, cosine, 1.0);
        for (channel, expected) in reflectance.to_array().into_iter().enumerate() {
            let integral = projected_integral(FRAC_PI_2, |wi| lobe.f(wo, wi).to_array()[channel]);
            assert!((integral - expected).abs() <= QUADRATURE * expected, "{integral} {expected}");
        }
        assert_eq!(lobe.albedo(wo), reflectance);
    }
}

/// Law: uniform radiance within half angle α of the normal has the irradiance `π L sin²α`; a white diffuse
/// surface reflects the radiance `L sin²α`. Oracle: the closed form.
/// Book: radiance and irradiance.
#[test]
fn a_cone_of_light_gives_the_irradiance_of_its_projected_solid_angle() {
    let lobe = Lobe::from(Lambertian { reflectance: Rgb::WHITE });
    for alpha in [0.1, 0.5, 1.0, FRAC_PI_2] {
        let radiance = projected_integral(alpha, |wi| lobe.f(Vector::Z, wi).r);
        let expected = sin(alpha) * sin(alpha);
        assert!((radiance - expected).abs() <= QUADRATURE * expected, "{alpha}: {radiance}");
    }
}

/// Law: samples follow the density they state: the mean of any function over all samples is its integral
/// times the density. Oracle: quadrature in angles of seven functions of the direction, against a grid of 400
/// × 400 samples; both err by some steps of `1/400` times the lobe's height.
/// Book: Monte Carlo integration.
#[test]
fn samples_follow_the_density_they_state() {
    let functions: [fn(Vector) -> f64; 7] = [
        |_| 1.0,
        |w| w.z(),
        |w| w.z() * w.z(),
        |w| w.x(),
        |w| w.y(),
        |w| w.x() * w.y(),
        |w| w.x() * w.x(),
    ];
    let wo = at_angle(Normal::Z, 0.6, 0.7);
    let glossy = |exponent| GlossySpecular { reflectance: Rgb::WHITE, exponent }.into();
    let diffuse = Lobe::from(Lambertian { reflectance: Rgb::WHITE });
    for lobe in [diffuse, glossy(1.0), glossy(7.5), glossy(100.0)] {
        let grid = |i: u32| (f64::from(i) + 0.5) / f64::from(STEPS);
        let mut means = [0.0; 7];
        for i in 0..STEPS * STEPS {
            let u = [grid(i % STEPS), grid(i / STEPS)];
            let Some(sample) = lobe.sample(wo, u) else { continue };
            for (mean, g) in means.iter_mut().zip(functions) {
                *mean += g(sample.wi) / f64::from(STEPS * STEPS);
            }
        }
        for (mean, g) in means.into_iter().zip(functions) {
            let integral = projected_integral(FRAC_PI_2, |wi| g(wi) * lobe.pdf(wo, wi) / wi.z());
            assert!((mean - integral).abs() < 2e-3, "{lobe:?}: {mean} {integral}");
        }
    }
}

proptest! {
    #![proptest_config(laws())]

    /// Law: `f(ω_i, ω_o) = f(ω_o, ω_i)` and `f ≥ 0`, for each lobe that claims reciprocity. Oracle:
    /// the other order (Helmholtz; ch. 13).
    /// Book: properties of BRDFs: reciprocity and energy.
    #[test]
    fn reflection_is_reciprocal_and_never_negative(a in local(), b in local()) {
        for lobe in every_lobe().filter(|lobe| lobe.claims().reciprocal) {
            let (there, back) = (lobe.f(a, b), lobe.f(b, a));
            close!(there, back, 4.0 * U, "{lobe:?}");
            there.to_array().into_iter().for_each(|c| at_least!(c, 0.0, "{lobe:?}"));
        }
    }

    /// Law: a sample of a BRDF has the weight `f cosθ_i / pdf`. Oracle: that quotient from `f` and `pdf` (the
    /// Monte Carlo estimator of the reflection equation).
    /// Book: Monte Carlo integration.
    #[test]
    fn a_sample_weighs_its_brdf_by_its_density(
        wo in local(),
        u in 0.0..1.0_f64,
        v in 0.0..1.0_f64,
    ) {
        for lobe in every_lobe().filter(|lobe| !lobe.is_specular()) {
            let Some(sample) = lobe.sample(wo, [u, v]) else { continue };
            let expected = (sample.wi.z() / lobe.pdf(wo, sample.wi)) * lobe.f(wo, sample.wi);
            near!(sample.wi.length(), 1.0, 16.0 * U);
            close!(sample.weight, expected, 8.0 * U, "{lobe:?} {sample:?}");
        }
    }

    /// Law: with directions drawn in proportion to the cosine, the estimate of a diffuse surface's reflection
    /// has no variance: each sample gives `ρ`. Oracle: the closed form (ch. 13).
    /// Book: Monte Carlo integration.
    #[test]
    fn cosine_sampling_of_a_diffuse_surface_has_no_variance(
        wo in local(),
        u in 0.0..1.0_f64,
        v in 0.0..1.0_f64,
    ) {
        let lobe = Lobe::from(Lambertian { reflectance: Rgb::grey(0.7) });
        let Some(sample) = lobe.sample(wo, [u, v]) else { return Ok(()) };
        prop_assert_eq!(sample.weight, Rgb::grey(0.7));
        let estimate =
            lobe.f(wo, sample.wi).r * sample.wi.z() / sample.pdf.expect("no single direction");
        near!(estimate, 0.7, 4.0 * U);
    }

    /// Law: radiance does not change along a ray: an emitter is as bright from any distance and at
    /// any angle, to the last bit. Oracle: its `l_s c_e` (ch. 13).
    /// Book: radiance and irradiance.
    #[test]
    fn radiance_is_constant_along_a_ray(to_eye in unit(), far in 1.5..1e9_f64) {
        let mut scene = stage(Rgb::BLACK);
        let emitter = Emissive::new(2.5, Rgb::new(1.0, 0.5, 0.25));
        put(&mut scene, sphere(Point::ORIGIN, 1.0), emitter);
        let eye = Point::ORIGIN + far * to_eye;
        let seen = look(&built(&scene), eye, -Vector::from(to_eye));
        prop_assert_eq!(seen, Rgb::new(2.5, 1.25, 0.625));
    }
}

/// Replicas of an estimate, and how far the ratio of two sample variances of that many normal values
/// may be from its expectation: five standard deviations `√(2·2/4096)` (one test, significance 1e-6).
const REPLICAS: u32 = 4096;
const VARIANCE_RATIO: f64 = 5.0 * 0.03125;

/// Law: four times as many samples halve the standard error of a Monte Carlo estimate (slope −1/2).
/// Oracle: the variance of replicas, against that of the mean of one sample (ch. 13).
/// Book: Monte Carlo integration.
#[test]
fn four_times_as_many_samples_halve_the_error() {
    let lobe = Lobe::from(GlossySpecular { reflectance: Rgb::WHITE, exponent: 10.0 });
    let wo = at_angle(Normal::Z, 0.3, 0.0);
    let mut random = Pcg32::new(13, 1);
    let mut variance = |samples: u32| {
        let (mut sum, mut squares) = (0.0, 0.0);
        for _ in 0..REPLICAS {
            let one = |random: &mut Pcg32| {
                let u = [random.uniform(), random.uniform()];
                lobe.sample(wo, u).map_or(0.0, |sample| sample.weight.r)
            };
            let mean = (0..samples).map(|_| one(&mut random)).sum::<f64>() / f64::from(samples);
            sum += mean;
            squares += mean * mean;
        }
        let n = f64::from(REPLICAS);
        (squares - sum * sum / n) / (n - 1.0)
    };
    let (four, sixteen, sixty_four) = (variance(4), variance(16), variance(64));
    assert!((four / sixteen / 4.0 - 1.0).abs() < VARIANCE_RATIO, "{four} {sixteen}");
    assert!((sixteen / sixty_four / 4.0 - 1.0).abs() < VARIANCE_RATIO, "{sixteen} {sixty_four}");
}
