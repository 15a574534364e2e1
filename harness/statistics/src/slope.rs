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
