//! Statistical tests: goodness of fit and significance.
//!
//! χ² and Kolmogorov–Smirnov assume independent samples: never feed them stratified points. A test
//! that runs `m` of them at a family-wise level `α` asks each for [`sidak`]`(α, m)`.

use statrs::distribution::{ChiSquared, ContinuousCDF, StudentsT};

use crate::math::{exp, ln, power};

/// The level of each of `tests` independent tests that together raise a false alarm with
/// probability `level` (Šidák 1967): `1 − (1 − α)^(1/m)`.
pub fn sidak(level: f64, tests: usize) -> f64 {
    1.0 - power(1.0 - level, 1.0 / tests as f64)
}

/// Cells that expect fewer are put together: the χ² distribution is a limit for large counts.
const FEWEST: f64 = 5.0;

/// The probability of counts at least as far from the expected ones, if samples are independent
/// and fall into the cells as expected (Pearson's χ²).
///
/// Cells are pooled, the rarest first, until each pool expects at least 5. A sample in a cell that
/// expects none gives 0 at once. `expected` must add up to the number of samples: a density
/// that does not integrate to 1 is no density, and gives 0 too.
///
/// Power: with `n` samples in `k` cells at level 1e-6, a density that is wrong by `±ε` in
/// alternate cells is found if `n ε² > 10 √k + 60`.
pub fn chi_square(observed: &[u64], expected: &[f64]) -> f64 {
    assert_eq!(observed.len(), expected.len(), "one count for each cell");
    let total: u64 = observed.iter().sum();
    let whole: f64 = expected.iter().sum();
    let impossible = observed.iter().zip(expected).any(|(&o, &e)| o > 0 && e <= 0.0);
    // a quadrature's error is far below the noise of the counts, √n
    let off = (whole - total as f64).abs() > 0.1 * (total as f64).sqrt();
    if impossible || off || whole.is_nan() {
        return 0.0;
    }

    let mut cells: Vec<(f64, f64)> =
        expected.iter().zip(observed).map(|(&e, &o)| (e, o as f64)).collect();
    cells.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut pools: Vec<(f64, f64)> = Vec::new();
    let mut pool = (0.0, 0.0);
    for (e, o) in cells {
        pool = (pool.0 + e, pool.1 + o);
        if pool.0 >= FEWEST {
            pools.push(pool);
            pool = (0.0, 0.0);
        }
    }
    if let (true, Some(last)) = (pool.0 > 0.0, pools.last_mut()) {
        *last = (last.0 + pool.0, last.1 + pool.1);
    }
    let statistic: f64 = pools.iter().map(|(e, o)| (o - e) * (o - e) / e).sum();
    let freedom = pools.len().saturating_sub(1);
    match ChiSquared::new(freedom as f64) {
        Ok(distribution) => distribution.sf(statistic),
        Err(_) => 1.0, // one pool: nothing can be told
    }
}

/// The probability of samples at least as far from the uniform distribution on `[0, 1)`, if they
/// are independent and uniform (Kolmogorov–Smirnov, with Stephens' correction for small `n`).
/// Other distributions: pass `F(x)` for each sample.
///
/// Power: at level 1e-6, a distribution whose F is off by `δ` somewhere is found if
/// `n δ² > 14`.
pub fn kolmogorov_smirnov(samples: &[f64]) -> f64 {
    let mut sorted = samples.to_vec();
    sorted.sort_by(f64::total_cmp);
    let n = sorted.len() as f64;
    let mut distance = 0.0_f64;
    for (i, &x) in sorted.iter().enumerate() {
        if !(0.0..=1.0).contains(&x) {
            return 0.0;
        }
        distance = distance.max(x - i as f64 / n).max((i + 1) as f64 / n - x);
    }
    let root = n.sqrt();
    kolmogorov((root + 0.12 + 0.11 / root) * distance)
}

/// `2 Σ (−1)^(j−1) exp(−2 j² λ²)`, the tail of Kolmogorov's distribution.
fn kolmogorov(lambda: f64) -> f64 {
    if lambda < 0.2 {
        return 1.0; // the series converges slowly, and the tail is 1 to twelve digits
    }
    let term = |j: u32| {
        let size = exp(-2.0 * f64::from(j * j) * lambda * lambda);
        if j.is_multiple_of(2) { -size } else { size }
    };
    let sum: f64 = (1..=50).map(term).sum();
    (2.0 * sum).clamp(0.0, 1.0)
}

/// A straight line through points of a log–log plot: `y = factor · x^exponent`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerLaw {
    /// The fitted slope.
    pub exponent: f64,
    /// An interval that contains the true slope with the probability asked for, if the scatter of
    /// `ln y` about the line is normal and the same everywhere.
    pub interval: [f64; 2],
    /// The value at `x = 1`.
    pub factor: f64,
}

/// The line of least squares through `(ln x, ln y)`, with an interval for its slope at this
/// confidence (such as 0.95), by Student's t of `n − 2` degrees. `None` for fewer than three points,
/// for a number that is not positive and finite, and if all `x` are the same.
///
/// Power: an interval's half-width is `t · s / (σ_x √n)`, with s the scatter of `ln y` and `σ_x` the
/// spread of `ln x`; a slope that is wrong by more than twice that is left outside.
pub fn power_law(points: &[(f64, f64)], confidence: f64) -> Option<PowerLaw> {
    let usable = |&(x, y): &(f64, f64)| x > 0.0 && y > 0.0 && x.is_finite() && y.is_finite();
    if points.len() < 3 || !points.iter().all(usable) {
        return None;
    }
    let logs: Vec<(f64, f64)> = points.iter().map(|&(x, y)| (ln(x), ln(y))).collect();
    let n = logs.len() as f64;
    let mean = |f: fn(&(f64, f64)) -> f64| logs.iter().map(f).sum::<f64>() / n;
    let (mean_x, mean_y) = (mean(|p| p.0), mean(|p| p.1));
    let spread: f64 = logs.iter().map(|(x, _)| (x - mean_x) * (x - mean_x)).sum();
    if spread == 0.0 {
        return None;
    }
    let together: f64 = logs.iter().map(|(x, y)| (x - mean_x) * (y - mean_y)).sum();
    let exponent = together / spread;
    let start = mean_y - exponent * mean_x;
    let residual = |&(x, y): &(f64, f64)| y - start - exponent * x;
    let squares: f64 = logs.iter().map(|p| residual(p) * residual(p)).sum();
    let student = StudentsT::new(0.0, 1.0, n - 2.0).ok()?;
    let quantile = student.inverse_cdf(0.5 + 0.5 * confidence);
    let half = quantile * (squares / (n - 2.0) / spread).sqrt();
    Some(PowerLaw { exponent, interval: [exponent - half, exponent + half], factor: exp(start) })
}

/// The value below or at which a share of the values lies (nearest rank): 0.5 for the median. `None`
/// if there are none. With fewer than 1000 values, the 99.9th percentile is the largest.
pub fn quantile(values: &[f64], share: f64) -> Option<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let rank = (share * sorted.len() as f64).ceil() as usize;
    sorted.get(rank.clamp(1, sorted.len().max(1)) - 1).copied()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Pcg32, sin};

    /// Each checker below passes on the truth at this level: no false alarm for fixed seeds.
    const LEVEL: f64 = 1e-6;

    const CELLS: usize = 99;

    /// Counts of samples whose density is `1 + ε` in even cells and `1 − ε` in odd ones.
    fn counts(n: u64, epsilon: f64, seed: u64) -> Vec<u64> {
        let mut random = Pcg32::new(seed, 1);
        let mut counts = vec![0; CELLS];
        let mut drawn = 0;
        while drawn < n {
            let cell = random.below(CELLS as u32) as usize;
            // rejection
            let density = if cell.is_multiple_of(2) { 1.0 + epsilon } else { 1.0 - epsilon };
            if random.uniform() * (1.0 + epsilon) < density {
                counts[cell] += 1;
                drawn += 1;
            }
        }
        counts
    }

    #[test]
    fn chi_square_has_the_tables_values() {
        // two cells, 50 each, found 60 and 40: χ² = 4, one degree of freedom, p = 0.0455003 (erfc(√2))
        let p = chi_square(&[60, 40], &[50.0, 50.0]);
        assert!((p - 0.045_500_263_896_358_4).abs() < 1e-12, "{p}");
        let p = chi_square(&[110, 90, 80, 120], &[100.0, 100.0, 100.0, 100.0]);
        // χ² = 10, three degrees: erfc(√5) + 2 √(5/π) e⁻⁵
        let exact = 0.018_566_135_463_043_2;
        assert!((p - exact).abs() < 1e-10, "{p}");
    }

    #[test]
    fn chi_square_passes_the_truth_and_finds_an_error_just_above_its_power() {
        let n = 200_000;
        let expected = vec![n as f64 / CELLS as f64; CELLS];
        let smallest = ((10.0 * (CELLS as f64).sqrt() + 60.0) / n as f64).sqrt();
        assert!(smallest < 0.03, "an error of 3 % is found");
        for seed in 0..8 {
            assert!(chi_square(&counts(n, 0.0, seed), &expected) > LEVEL);
            assert!(chi_square(&counts(n, 1.1 * smallest, seed), &expected) < LEVEL);
        }
    }

    #[test]
    fn chi_square_finds_samples_where_there_can_be_none_and_densities_of_the_wrong_sum() {
        assert_eq!(chi_square(&[1, 1_000_000], &[0.0, 1_000_001.0]), 0.0);
        assert_eq!(chi_square(&[500, 500], &[600.0, 500.0]), 0.0);
        assert_eq!(chi_square(&[500, 500], &[f64::NAN, 500.0]), 0.0);
    }

    #[test]
    fn chi_square_pools_rare_cells_instead_of_trusting_them() {
        // 1000 cells of 0.01 each beside one of 990: ten samples spread over ten of them are likely,
        // though cell by cell (1 − 0.01)²/0.01 = 98 each would look impossible
        let mut expected = vec![0.01; 1000];
        expected.push(990.0);
        let mut observed = vec![0; 1000];
        (0..10).for_each(|i| observed[100 * i] = 1);
        observed.push(990);
        assert!(chi_square(&observed, &expected) > 0.01);
    }

    #[test]
    fn kolmogorov_smirnov_has_the_tables_values() {
        // critical values of the limit distribution: 1.3581 at 5 %, 1.6276 at 1 %
        assert!((kolmogorov(1.358_1) - 0.05).abs() < 1e-5);
        assert!((kolmogorov(1.627_6) - 0.01).abs() < 1e-5);
        assert_eq!(kolmogorov(0.0), 1.0);
    }

    #[test]
    fn kolmogorov_smirnov_passes_the_truth_and_finds_an_error_just_above_its_power() {
        let n = 20_000;
        let smallest = (14.0 / f64::from(n)).sqrt();
        for seed in 0..8 {
            let mut random = Pcg32::new(seed, 2);
            let uniform: Vec<f64> = (0..n).map(|_| random.uniform()).collect();
            assert!(kolmogorov_smirnov(&uniform) > LEVEL);
            // F(x) = x − δ sin(πx): off by δ in the middle
            let bent: Vec<f64> = uniform
                .iter()
                .map(|&x| x + 1.1 * smallest * sin(std::f64::consts::PI * x))
                .collect();
            assert!(kolmogorov_smirnov(&bent) < LEVEL);
        }
        assert_eq!(kolmogorov_smirnov(&[0.5, f64::NAN]), 0.0);
        assert_eq!(kolmogorov_smirnov(&[0.5, 1.5]), 0.0);
    }

    #[test]
    fn sidak_keeps_the_level_of_the_family() {
        assert_eq!(sidak(0.05, 1), 1.0 - 0.95);
        let each = sidak(0.01, 100);
        assert!((power(1.0 - each, 100.0) - 0.99).abs() < 1e-12);
        assert!(each > 0.01 / 100.0, "a little less strict than Bonferroni");
    }
    /// Points of `3 x^slope` with noise of this relative size.
    fn power_of(slope: f64, noise: f64, seed: u64) -> Vec<(f64, f64)> {
        let mut random = Pcg32::new(seed, 3);
        (0..12)
            .map(|i| {
                let x = exp(f64::from(i));
                // the sum of twelve uniforms: normal, with variance 1
                let normal = (0..12).map(|_| random.uniform()).sum::<f64>() - 6.0;
                (x, 3.0 * exp(slope * f64::from(i) + noise * normal))
            })
            .collect()
    }

    /// Law: a power law without noise is found; with noise, its interval has the true slope as often
    /// as it says, and leaves a false one out. Oracle: how the points were made.
    #[test]
    fn a_fitted_slope_is_the_true_one_and_not_another() {
        let exact = power_law(&power_of(0.25, 0.0, 0), 0.95).expect("twelve points");
        assert!((exact.exponent - 0.25).abs() < 1e-12 && (exact.factor - 3.0).abs() < 1e-11);
        let fits =
            || (0..400).map(|seed| power_law(&power_of(-1.5, 0.1, seed), 0.95).expect("fit"));
        let holds = |slope: f64| {
            fits().filter(|fit| fit.interval[0] <= slope && slope <= fit.interval[1]).count()
        };
        // 95 % of 400 is 380 ± 4.4; five standard deviations are allowed
        assert!((358..=400).contains(&holds(-1.5)), "{}", holds(-1.5));
        // the half-width is 2.23 · 0.1 / √143 = 0.019: three times that is off
        assert!(holds(-1.5 + 0.06) < 10, "{}", holds(-1.5 + 0.06));
    }

    #[test]
    fn a_slope_needs_three_positive_points_that_differ() {
        assert_eq!(power_law(&[(1.0, 1.0), (2.0, 4.0)], 0.95), None);
        assert_eq!(power_law(&[(1.0, 1.0), (2.0, 4.0), (3.0, 0.0)], 0.95), None);
        assert_eq!(power_law(&[(1.0, 1.0), (2.0, f64::NAN), (3.0, 1.0)], 0.95), None);
        assert_eq!(power_law(&[(2.0, 1.0), (2.0, 4.0), (2.0, 1.0)], 0.95), None);
    }

    #[test]
    fn quantiles_are_the_nearest_ranks() {
        let values: Vec<f64> = (1..=1000).rev().map(f64::from).collect();
        assert_eq!(quantile(&values, 0.5), Some(500.0));
        assert_eq!(quantile(&values, 0.999), Some(999.0));
        assert_eq!(quantile(&values, 1.0), Some(1000.0));
        assert_eq!(quantile(&values[..3], 0.5), Some(999.0));
        assert_eq!(quantile(&[], 0.5), None);
    }
}
