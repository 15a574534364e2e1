//! Statistical tests: goodness of fit and significance.
//!
//! χ² and Kolmogorov–Smirnov assume independent samples: never feed them stratified points. A test
//! that runs `m` of them at a family-wise level `α` asks each for [`sidak`]`(α, m)`.

use statrs::distribution::{ChiSquared, ContinuousCDF};

use crate::math::{exp, power};

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
}
