//! The contract of [`Lobe`]: a test of each property that a lobe claims, and a counterexample for each
//! property that it does not claim. That samples agree with f and pdf are laws of anybody's lobes:
//! `harness/claims/tests/own.rs`.
//!
//! Sources: Suffern, ch. 13 (BRDFs, reciprocity, energy), 15, 24, 27, 28.

use std::f64::consts::PI;

use groundtruth::lobes::Lobe;
use groundtruth::math::{ONE_MINUS, Pcg32, Vector, cos, sin};
use groundtruth::rgb::Rgb;
use libtest_mimic::Trial;

use super::{Holds, ensure};

pub fn trials() -> Vec<Trial> {
    let mut trials = super::trials(
        Lobe::ENTRIES,
        &[
            ("reciprocity_holds_if_claimed", reciprocity_holds_if_claimed),
            ("albedo_is_the_integral_of_f", albedo_is_the_integral_of_f),
            ("energy_is_conserved_if_claimed", energy_is_conserved_if_claimed),
            ("no_sample_counts_without_bound", no_sample_counts_without_bound),
        ],
    );
    for entry in Lobe::ENTRIES {
        let name = |law: &str| format!("{}::{}::contract::{law}", entry.chapter, entry.module);
        let claims = (entry.specimens)().first().map(Lobe::claims);
        if claims.is_some_and(|claims| !claims.reciprocal) {
            trials.push(Trial::test(name("reciprocity_is_broken_as_it_says"), || {
                let broken = (entry.specimens)().iter().any(|l| reciprocal(l).is_err());
                if broken { Ok(()) } else { Err("it is reciprocal after all".into()) }
            }));
        }
        if claims.is_some_and(|claims| !claims.conserves_energy) {
            trials.push(Trial::test(name("energy_is_gained_as_it_says"), || {
                let broken = (entry.specimens)().iter().any(|l| conserves_energy(l).is_err());
                if broken { Ok(()) } else { Err("it conserves energy after all".into()) }
            }));
        }
    }
    trials
}

/// Viewers from straight above to grazing, and two on the inner side.
fn viewers() -> Vec<Vector> {
    let direction = |z: f64, phi: f64| {
        let sine = f64::sqrt((1.0 - z) * (1.0 + z));
        Vector::new(sine * cos(phi), sine * sin(phi), z)
    };
    [(1.0, 0.0), (0.8, 0.7), (0.5, 3.0), (0.1, 5.0), (1e-3, 2.0), (-0.8, 1.0), (-0.1, 4.0)]
        .map(|(z, phi)| direction(z, phi))
        .to_vec()
}

/// A direction, uniform on the sphere.
pub fn anywhere(random: &mut Pcg32) -> Vector {
    let z = 2.0 * random.uniform() - 1.0;
    let (phi, sine) = (2.0 * PI * random.uniform(), f64::sqrt((1.0 - z) * (1.0 + z)));
    Vector::new(sine * cos(phi), sine * sin(phi), z)
}

const PAIRS: u32 = 2000;

/// A few roundings in each of two evaluations, and in a power of up to 2000.
const ROUNDING: f64 = 1e-11;

fn close(a: Rgb, b: Rgb, relative: f64) -> bool {
    let pairs = a.to_array().into_iter().zip(b.to_array());
    pairs.into_iter().all(|(a, b)| (a - b).abs() <= relative * a.abs().max(b.abs()))
}

fn reciprocity_holds_if_claimed(lobe: &Lobe) -> Holds {
    if lobe.claims().reciprocal { reciprocal(lobe) } else { Ok(()) }
}

/// Law: `f(ω_i, ω_o) = f(ω_o, ω_i)`; for a single direction, light goes back along the same path with the
/// same weight.
fn reciprocal(lobe: &Lobe) -> Holds {
    let mut random = Pcg32::new(13, 1);
    for i in 0..PAIRS {
        let (wo, mut wi) = (anywhere(&mut random), anywhere(&mut random));
        if let Some(sample) = lobe.sample(wo, [random.uniform(), random.uniform()])
            && (i % 2 == 0 || lobe.is_specular())
        {
            wi = sample.wi; // where the lobe is large
        }
        if !lobe.is_specular() {
            let (there, back) = (lobe.f(wo, wi), lobe.f(wi, wo));
            let same = close(there, back, ROUNDING);
            ensure!(same, "f({wo:?}, {wi:?}) is {there:?}, exchanged {back:?}");
            continue;
        }
        let Some(there) = lobe.sample(wo, [0.5; 2]) else { continue };
        let Some(back) = lobe.sample(there.wi, [0.5; 2]) else {
            return Err(format!("{wo:?}: nothing comes back from {:?}", there.wi));
        };
        ensure!((back.wi - wo).length() < 1e-7, "{wo:?} comes back as {:?}", back.wi);
        let same = close(there.weight, back.weight, 1e-7);
        ensure!(same, "{wo:?}: weights {:?} and {:?}", there.weight, back.weight);
    }
    Ok(())
}

/// Law: the albedo is `∫ f |cosθ_i| dω_i`; of a single direction, its weight. Oracle: the midpoint
/// rule in θ and φ.
fn albedo_is_the_integral_of_f(lobe: &Lobe) -> Holds {
    /// The rule errs by `h²/24σ²` at the pole, and the narrowest specimen's width σ is six steps h.
    const QUADRATURE: f64 = 2e-3;
    const STEPS: u32 = 900;
    let step = PI / f64::from(STEPS);
    let around: Vec<(f64, f64)> = (0..2 * STEPS)
        .map(|j| (f64::from(j) + 0.5) * step)
        .map(|phi| (cos(phi), sin(phi)))
        .collect();
    for wo in viewers() {
        let mut integral = Rgb::BLACK;
        if lobe.is_specular() {
            integral = lobe.sample(wo, [0.5; 2]).map_or(Rgb::BLACK, |sample| sample.weight);
        } else {
            for i in 0..STEPS {
                let theta = (f64::from(i) + 0.5) * step;
                let (sine, cosine) = (sin(theta), cos(theta));
                let mut ring = Rgb::BLACK;
                for (x, y) in &around {
                    ring += lobe.f(wo, Vector::new(sine * x, sine * y, cosine));
                }
                integral += (cosine.abs() * sine * step * step) * ring;
            }
        }
        let albedo = lobe.albedo(wo);
        ensure!(close(albedo, integral, QUADRATURE), "{wo:?}: {albedo:?}, but {integral:?}");
    }
    Ok(())
}

fn energy_is_conserved_if_claimed(lobe: &Lobe) -> Holds {
    if lobe.claims().conserves_energy { conserves_energy(lobe) } else { Ok(()) }
}

/// Law: the albedo is at most 1. Radiance that crosses into another medium is counted as `L/η²`,
/// which is what light conserves; `η = sinθ_o/sinθ_t` by Snell's law.
fn conserves_energy(lobe: &Lobe) -> Holds {
    for wo in viewers() {
        let mut albedo = lobe.albedo(wo);
        if lobe.relative_eta(wo).is_none() {
            let albedo = lobe.albedo(wo);
            let most = albedo.to_array().into_iter().fold(0.0, f64::max);
            ensure!(most <= 1.0 + ROUNDING, "albedo({wo:?}) is {albedo:?}, expected at most 1");
            continue;
        }
        let across = lobe.sample(wo, [0.5; 2]).filter(|sample| sample.wi.z() * wo.z() < 0.0);
        if let Some(sample) = across {
            let sine_squared = |w: Vector| w.x() * w.x() + w.y() * w.y();
            let eta_squared = sine_squared(wo) / sine_squared(sample.wi);
            if eta_squared.is_finite() && sine_squared(wo) > 0.0 {
                albedo = eta_squared * albedo;
            } else {
                continue; // straight through: the angles do not determine η
            }
        }
        ensure!(albedo.max() <= 1.0 + ROUNDING, "{wo:?}: albedo {albedo:?}");
    }
    Ok(())
}

/// Law: `f |cosθ_i| / pdf` is bounded, for grazing viewers and directions too: with coefficients of at most 1
/// the bound is 2π, reached by the broadest highlight, in the medium of the viewer. Oracle: the bound.
fn no_sample_counts_without_bound(lobe: &Lobe) -> Holds {
    let mut random = Pcg32::new(13, 3);
    for wo in viewers() {
        let eta = lobe.relative_eta(wo).unwrap_or(1.0);
        for i in 0..20_000 {
            // some of the numbers are near the ends of the interval, where directions are grazing
            let tiny = [1.0, 1e-3, 1e-9][i % 3];
            let mut one = || match random.below(2) {
                0 => tiny * random.uniform(),
                _ => (1.0 - tiny * random.uniform()).min(ONE_MINUS),
            };
            let Some(sample) = lobe.sample(wo, [one(), one()]) else { continue };
            let most = eta * eta * sample.weight.max();
            ensure!(most <= 2.0 * PI * (1.0 + ROUNDING), "{wo:?}: {:?} counts {most}", sample.wi);
        }
    }
    Ok(())
}
