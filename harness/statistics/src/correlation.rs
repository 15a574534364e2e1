//! Pearson's correlation, and its significance.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// A correlation that was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correlation {
    /// From −1 to 1.
    pub r: f64,
    /// The two-sided p-value: the probability of an `r` at least as far from 0 without correlation.
    pub p: f64,
}

/// Pearson's `r = Σ (x − x̄)(y − ȳ) / √(Σ (x − x̄)² Σ (y − ȳ)²)` of the pairs `(xs[i], ys[i])`, with the
/// probability that Student's t of `n − 2` degrees gives to `t = r √((n − 2)/(1 − r²))` (Fisher
/// 1915). `None` for fewer than three pairs, for a number that is not finite, and if all x or
/// all y are the same.
///
/// The pairs must be independent of each other. The probability is exact if x or y is normal, and in the
/// limit of many pairs with finite variances. At level 1e-3 ten pairs of uniform numbers raise 1.3 times
/// as many false alarms as they should, 30 pairs of exponential ones 2.8 times; lower levels are worse.
/// With heavy tails use ranks, or more pairs. No correlation does not mean no dependence: see
/// [`chi_square::independence`](super::chi_square::independence).
///
/// Power: at level 1e-6 a true correlation ρ is found, 98 times in 100 or more, if `|ρ| √n > 7.2`
/// (and `n` above 500): the quantile 4.9 of the level and 2.1 of the power, and a little.
///
/// # Panics
/// If there are not as many y as x.
pub fn pearson(xs: &[f64], ys: &[f64]) -> Option<Correlation> {
    assert_eq!(xs.len(), ys.len(), "pairs");
    let n = xs.len() as f64;
    let mean = |values: &[f64]| values.iter().sum::<f64>() / n;
    let (mean_x, mean_y) = (mean(xs), mean(ys));
    let (mut xx, mut yy, mut xy) = (0.0, 0.0, 0.0);
    for (x, y) in xs.iter().zip(ys) {
        let (x, y) = (x - mean_x, y - mean_y);
        xx += x * x;
        yy += y * y;
        xy += x * y;
    }
    let constant = |values: &[f64]| values.iter().all(|x| *x == values[0]);
    let spread = (xx * yy).sqrt();
    if xs.len() < 3 || !spread.is_finite() || spread == 0.0 || constant(xs) || constant(ys) {
        return None;
    }
    // rounding may exceed ±1
    let r = (xy / spread).clamp(-1.0, 1.0);
    let student = StudentsT::new(0.0, 1.0, n - 2.0).ok()?;
    let t = r.abs() * ((n - 2.0) / ((1.0 - r) * (1.0 + r))).sqrt();
    let p = if t.is_finite() { 2.0 * student.sf(t) } else { 0.0 };
    Some(Correlation { r, p: p.min(1.0) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verify::biased_samples::{LEVEL, correlated};
    use crate::verify::judge::{near, passes};

    /// Oracle: by hand. x = 1 … 5 and y = 2, 1, 4, 3, 5 have Σxy = 8, Σxx = Σyy = 10: r = 0.8, and
    /// t = 0.8 √(3/0.36) = 4/√3; Student's t of three degrees is `½ + (arctan(t/√3) + (t/√3)/(1 +
    /// t²/3))/π` in closed form.
    #[test]
    fn it_has_the_values_found_by_hand() {
        let found = pearson(&[1.0, 2.0, 3.0, 4.0, 5.0], &[2.0, 1.0, 4.0, 3.0, 5.0]);
        let found = found.expect("five pairs");
        near(found.r, 0.8, 1e-15);
        let s: f64 = 4.0 / 3.0; // t/√3
        let below =
            0.5 + (groundtruth::math::atan2(s, 1.0) + s / (1.0 + s * s)) / std::f64::consts::PI;
        assert!((found.p - 2.0 * (1.0 - below)).abs() < 1e-12, "{}", found.p);
        let line = pearson(&[1.0, 2.0, 3.0], &[5.0, 3.0, 1.0]).expect("three pairs");
        assert_eq!((line.r, line.p), (-1.0, 0.0));
    }

    /// Oracle: with a million pairs, t is normal: two-sided 5.733e-7 at 5 σ.
    #[test]
    fn the_probability_is_right_for_a_million_pairs() {
        let student = StudentsT::new(0.0, 1.0, 999_998.0).expect("it is one");
        near(2.0 * student.sf(5.0) / 5.733_031_4e-7, 1.0, 1e-3);
        near(2.0 * student.sf(1.0) / 0.317_310_507_9, 1.0, 1e-5);
    }

    #[test]
    fn it_passes_the_truth_and_finds_a_correlation_just_above_its_power() {
        let n = 10_000;
        let smallest = 7.2 / (n as f64).sqrt();
        for seed in 0..8 {
            let [xs, ys] = correlated(n, 0.0, seed);
            passes(pearson(&xs, &ys).expect("many pairs").p);
            let [xs, ys] = correlated(n, -1.1 * smallest, seed);
            let found = pearson(&xs, &ys).expect("many pairs");
            assert!(found.p < LEVEL && found.r < 0.0, "{found:?}");
        }
    }

    /// Law: translation does not change the correlation. Oracle: the same pairs, a million spreads away,
    /// where the sum of squares less the square of the sum would lose all but four digits.
    #[test]
    fn a_far_mean_does_not_matter() {
        let [xs, ys] = correlated(1000, 0.3, 1);
        let small = pearson(&xs, &ys).expect("many pairs").r;
        let far: Vec<f64> = xs.iter().map(|x| x + 1e6).collect();
        near(pearson(&far, &ys).expect("many pairs").r, small, 1e-8);
    }

    #[test]
    fn there_is_none_of_too_few_or_of_constants() {
        assert_eq!(pearson(&[1.0, 2.0], &[1.0, 2.0]), None);
        assert_eq!(pearson(&[0.1; 10], &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]), None);
        assert_eq!(pearson(&[1.0, 2.0, f64::NAN], &[1.0, 2.0, 3.0]), None);
    }
}
