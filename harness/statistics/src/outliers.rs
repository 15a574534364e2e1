//! Outliers among values that are otherwise normal.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// The indices of the outliers among these values, the farthest first: at most `most` of them, by the generalised extreme
/// Studentised deviate test at this level. It is meant for 25 values and more; fewer than three have no outlier.
///
/// Source: B. Rosner, "Percentage points for a generalized ESD many-outlier procedure", Technometrics 25(2), 1983.
pub fn outliers(values: &[f64], most: usize, level: f64) -> Vec<usize> {
    let mut left: Vec<usize> = (0..values.len()).collect();
    let (mut removed, mut found) = (Vec::new(), 0);
    for step in 1..=most.min(values.len().saturating_sub(2)) {
        let n = left.len() as f64;
        let mean = left.iter().map(|&index| values[index]).sum::<f64>() / n;
        let square = |index: &usize| (values[*index] - mean) * (values[*index] - mean);
        let deviation = (left.iter().map(square).sum::<f64>() / (n - 1.0)).sqrt();
        let by_distance = |a: &usize, b: &usize| square(a).total_cmp(&square(b));
        let Some(farthest) = left.iter().copied().max_by(by_distance) else { break };
        if deviation.is_nan() || deviation == 0.0 {
            break;
        }
        removed.push(farthest);
        if (values[farthest] - mean).abs() / deviation > critical(n, level) {
            // all that were removed before it are outliers, too
            found = step;
        }
        left.retain(|&index| index != farthest);
    }
    removed.truncate(found);
    removed
}

/// The largest Studentised deviation among n normal values, at this level.
fn critical(n: f64, level: f64) -> f64 {
    let freedom = n - 2.0;
    let t = StudentsT::new(0.0, 1.0, freedom).expect("at least three values");
    let t = t.inverse_cdf(1.0 - level / (2.0 * n));
    (n - 1.0) * t / ((freedom + t * t) * n).sqrt()
}
