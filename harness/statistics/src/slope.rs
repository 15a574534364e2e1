//! Straight lines through log–log plots: how fast does an error fall, or a time grow?

use statrs::distribution::{ContinuousCDF, StudentsT};

use libm::{exp, log};

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
/// Points may share their `x`: several measurements of each are better than one, as they tell how
/// they scatter. Measure variances with as many replicas everywhere, so that they scatter alike. The
/// interval is that of the best line; it does not know of a curve, so begin where the law holds.
///
/// Power: an interval's half-width is `t · s / (σ_x √n)`, with s the scatter of `ln y` and `σ_x` the
/// spread of `ln x`; a slope that is wrong by more than twice that is left outside, 98 times in 100
/// or more.
pub fn power_law(points: &[(f64, f64)], confidence: f64) -> Option<PowerLaw> {
    let usable = |&(x, y): &(f64, f64)| x > 0.0 && y > 0.0 && x.is_finite() && y.is_finite();
    let differ = points.iter().any(|p| p.0 != points[0].0);
    if points.len() < 3 || !points.iter().all(usable) || !differ {
        return None;
    }
    let logs: Vec<(f64, f64)> = points.iter().map(|&(x, y)| (log(x), log(y))).collect();
    let n = logs.len() as f64;
    let mean = |f: fn(&(f64, f64)) -> f64| logs.iter().map(f).sum::<f64>() / n;
    let (mean_x, mean_y) = (mean(|p| p.0), mean(|p| p.1));
    let spread: f64 = logs.iter().map(|(x, _)| (x - mean_x) * (x - mean_x)).sum();
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verify::biased_samples::power_of;
    use crate::verify::judge::near;

    /// Law: a power law without noise is found; with noise, its interval has the true slope as often
    /// as it says, and leaves a false one out. Oracle: how the points were made.
    #[test]
    fn a_fitted_slope_is_the_true_one_and_not_another() {
        let exact = power_law(&power_of(0.25, 0.0, 0), 0.95).expect("twelve points");
        near(exact.exponent, 0.25, 1e-12);
        near(exact.factor, 3.0, 1e-11);
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

    /// Oracle: by hand. Logarithms 0, 1, 0 at 0, 1, 2 have the slope 0, squares of 2/3 about the line and
    /// a spread of 2; t of one degree is Cauchy's, with the quantile `tan(π (c/2))`.
    #[test]
    fn the_interval_of_three_points_is_that_found_by_hand() {
        let e = exp(1.0);
        let fit = power_law(&[(1.0, 1.0), (e, e), (e * e, 1.0)], 0.95).expect("three points");
        let half = groundtruth::math::tan(std::f64::consts::PI * 0.475) * (1.0_f64 / 3.0).sqrt();
        near(fit.exponent, 0.0, 1e-14);
        near(fit.interval[1], half, 1e-9);
        near(fit.interval[0], -half, 1e-9);
    }

    #[test]
    fn a_slope_needs_three_positive_points_that_differ() {
        assert_eq!(power_law(&[(1.0, 1.0), (2.0, 4.0)], 0.95), None);
        assert_eq!(power_law(&[(1.0, 1.0), (2.0, 4.0), (3.0, 0.0)], 0.95), None);
        assert_eq!(power_law(&[(1.0, 1.0), (2.0, f64::NAN), (3.0, 1.0)], 0.95), None);
        for x in [2.0, 3.0, 0.1, 1e-9] {
            assert_eq!(power_law(&[(x, 1.0), (x, 4.0), (x, 1.0)], 0.95), None);
        }
    }
}
