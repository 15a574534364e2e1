//! How fast the mean over a set converges to the integral.

use groundtruth::samplers::{
    CorrelatedMultiJittered, Hammersley, Kind, NRooks, Purpose, SampleSets, SetKey, Sobol,
};

use crate::prelude::*;
use crate::support::samples::built;

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

/// The errors of the means of 2000 sets, along x or y.
fn errors(kind: &Kind, g: Integrand, n: u32, axis: usize) -> Vec<f64> {
    let (sampler, mut random) = (built(kind.clone()), Pcg32::new(12, u64::from(n)));
    let error = |_| {
        let set = sampler.fill(n, &mut random);
        set.iter().map(|p| g.at(p[axis])).sum::<f64>() / f64::from(n) - g.integral()
    };
    (0..2000).map(error).collect()
}

/// Each kind, and the number of columns that its n points stratify.
fn kinds(n: u32) -> [(Kind, u32); 6] {
    [
        (Random {}.into(), 1),
        (Jittered {}.into(), n.isqrt()),
        (NRooks {}.into(), n),
        (MultiJittered {}.into(), n),
        (CorrelatedMultiJittered {}.into(), n),
        (Sobol {}.into(), n),
    ]
}

/// Law: the mean of x or `eˣ` over a set has the variance of its strata: one column for random points, √N for
/// jittered ones, N for all others; it has no bias. The same holds along y. Oracle: the closed form; for x it
/// is `1/(12 N)`, `1/(12 N²)` and `1/(12 N³)`: these are the rates.
/// Book: what makes a pattern good.
#[test]
fn means_have_the_variance_of_their_strata() {
    const TESTS: u32 = 2 * 2 * 2 * 2 * 6;
    for n in [16, 64] {
        for (kind, strata) in kinds(n) {
            for g in [Integrand::Linear, Integrand::Exponential] {
                let variance = variance_of_strata(g, n, strata);
                for axis in 0..2 {
                    let errors = errors(&kind, g, n, axis);
                    let squares: Vec<f64> = errors.iter().map(|e| e * e).collect();
                    let (bias, spread) = (sigmas(&errors, 0.0), sigmas(&squares, variance));
                    assert!(
                        bias.abs() < most_sigmas(TESTS.try_into().unwrap()),
                        "{kind:?} {g:?} {n}: {bias}"
                    );
                    assert!(
                        spread.abs() < most_sigmas(TESTS.try_into().unwrap()),
                        "{kind:?} {g:?} {n}: {spread}"
                    );
                }
            }
        }
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
            let key = SetKey::new(5, [x, 0], Purpose::Pixel);
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
