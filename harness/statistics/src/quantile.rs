//! Quantiles of measured values: median, 99.9th percentile.

/// The value below or at which a share of the values lies (nearest rank): 0.5 for the median. `None`
/// if there are none. With fewer than 1000 values, the 99.9th percentile is the largest.
pub fn quantile(values: &[f64], share: f64) -> Option<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let rank = (share * sorted.len() as f64).ceil() as usize;
    sorted.get(rank.clamp(1, sorted.len().max(1)) - 1).copied()
}
