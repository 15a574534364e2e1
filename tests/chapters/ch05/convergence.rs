//! How fast the mean over a set converges to the integral.

use groundtruth::samplers::{
    CorrelatedMultiJittered, Hammersley, Key, Kind, NRooks, Purpose, SampleSets, Sobol,
};
use statistics::slope::power_law;

use crate::prelude::*;
use crate::support::samples::built;

const COUNTS: [u32; 5] = [4, 16, 64, 256, 1024];

/// The variance of the mean of `g(x)` over `n` points, equally many in each of `strata` equal columns: the
/// mean variance within a column, divided by `n`, in closed form for `g = x` and `eˣ`.
fn variance_of_strata(g: Integrand, n: u32, strata: u32) -> f64 {
    let (count, columns) = (f64::from(n), f64::from(strata));
    let within = |k: u32| {
        let (from, to) = (f64::from(k) / columns, f64::from(k + 1) / columns);
        match g {
            Integrand::Linear => 1.0 / (12.0 * columns * columns),
            Integrand::Exponential => {
                let mean = columns * (exp(to) - exp(from));
                // for narrow strata the difference of the moments cancels completely
                if strata > 100 {
                    return mean * mean / (12.0 * columns * columns);
                }
                0.5 * columns * (exp(2.0 * to) - exp(2.0 * from)) - mean * mean
            }
        }
    };
    (0..strata).map(within).sum::<f64>() / (columns * count)
}

#[derive(Clone, Copy, Debug)]
enum Integrand {
    Linear,
    Exponential,
}

impl Integrand {
    fn at(self, x: f64) -> f64 {
        match self {
            Self::Linear => x,
            Self::Exponential => exp(x),
        }
    }

    fn integral(self) -> f64 {
        match self {
            Self::Linear => 0.5,
            Self::Exponential => exp(1.0) - 1.0,
        }
    }
}

/// The errors of the means of `replicas` sets, along x or y.
fn errors(kind: &Kind, g: Integrand, n: u32, axis: usize, replicas: u32) -> Vec<f64> {
    let (sampler, mut random) = (built(kind.clone()), Pcg32::new(12, u64::from(n)));
    let error = |_| {
        let set = sampler.fill(n, &mut random);
        set.iter().map(|p| g.at(p[axis])).sum::<f64>() / f64::from(n) - g.integral()
    };
    (0..replicas).map(error).collect()
}

/// Each kind, the number of columns that its n points stratify, and the exponent of n in the variance.
fn kinds(n: u32) -> [(Kind, u32, f64); 6] {
    [
        (Random {}.into(), 1, -1.0),
        (Jittered {}.into(), n.isqrt(), -2.0),
        (NRooks {}.into(), n, -3.0),
        (MultiJittered {}.into(), n, -3.0),
        (CorrelatedMultiJittered {}.into(), n, -3.0),
        (Sobol {}.into(), n, -3.0),
    ]
}

/// Law: the mean of x or `eˣ` over a set has the variance of its strata: one column for random points, √N for
/// jittered ones, N for all others; it has no bias. The same holds along y. Oracle: the closed form; for x it
/// is `1/(12 N)`, `1/(12 N²)` and `1/(12 N³)`.
/// Book: what makes a pattern good.
#[test]
fn means_have_the_variance_of_their_strata() {
    const TESTS: u32 = 2 * 2 * 2 * 2 * 6;
    for n in [16, 64] {
        for (kind, strata, _) in kinds(n) {
            for g in [Integrand::Linear, Integrand::Exponential] {
                let variance = variance_of_strata(g, n, strata);
                for axis in 0..2 {
                    let errors = errors(&kind, g, n, axis, 2000);
                    let squares: Vec<f64> = errors.iter().map(|e| e * e).collect();
                    let (bias, spread) = (sigmas(&errors, 0.0), sigmas(&squares, variance));
                    assert!(bias.abs() < most_sigmas(TESTS), "{kind:?} {g:?} {n}: {bias}");
                    assert!(spread.abs() < most_sigmas(TESTS), "{kind:?} {g:?} {n}: {spread}");
                }
            }
        }
    }
}

/// Law: the variance of the mean of a smooth function of x falls as 1/N for random points, `1/N²` for
/// jittered ones and `1/N³` for n rooks, the multi-jittered ones and Sobol's. Oracle: these powers; each
/// variance of 400 sets has an error of 7 %, a fitted slope one of 0.016, five times which is allowed.
/// Book: what makes a pattern good.
#[test]
fn variances_fall_at_the_rate_of_the_strata() {
    for kind in 0..6 {
        let (name, _, rate) = kinds(4)[kind].clone();
        let points: Vec<(f64, f64)> = COUNTS
            .into_iter()
            .map(|n| {
                let errors = errors(&name, Integrand::Exponential, n, 0, 400);
                let variance = errors.iter().map(|e| e * e).sum::<f64>() / 400.0;
                (f64::from(n), variance)
            })
            .collect();
        let fit = power_law(&points, 0.95).expect("five counts");
        assert!((fit.exponent - rate).abs() < 0.08, "{name:?}: {fit:?}");
    }
}

/// Law: shifted Hammersley draws have no bias, and the mean of a smooth function has the variance of equally
/// spaced points with a random shift, `(g(1) − g(0))²/(12 N²)`; without the shift the error is always that of
/// `x = i/N`. Oracle: for `eˣ` the sum is geometric, so that the error at each shift is known.
#[test]
fn a_shift_takes_away_the_bias_of_hammersley() {
    const N: u32 = 16;
    let n = f64::from(N);
    let integral = Integrand::Exponential.integral();
    let means = |shifted: bool| -> Vec<f64> {
        let sets = SampleSets::new(&*built(Hammersley { shifted }), N, 1);
        let mean = |x: u32| {
            let key = Key::new(5, [x, 0], Purpose::Pixel);
            (0..N).map(|i| exp(sets.draw(key, i)[0])).sum::<f64>() / n
        };
        (0..4000).map(mean).collect()
    };
    let fixed = integral / (n * (exp(1.0 / n) - 1.0));
    means(false).iter().for_each(|mean| near!(*mean, fixed, 1e-14));
    let errors: Vec<f64> = means(true).iter().map(|mean| mean - integral).collect();
    near!(sigmas(&errors, 0.0), 0.0, most_sigmas(2));
    // the mean is fixed · exp(t/n), t uniform
    let of_squares = 0.5 * n * (exp(2.0 / n) - 1.0) * fixed * fixed;
    let squares: Vec<f64> = errors.iter().map(|e| e * e).collect();
    let variance = of_squares - integral * integral;
    near!(variance / (integral * integral / (12.0 * n * n)), 1.0, 0.01);
    near!(sigmas(&squares, variance), 0.0, most_sigmas(2));
}
