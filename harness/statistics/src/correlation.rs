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
/// With heavy tails use more pairs. No correlation does not mean no dependence: see
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
