//! Quantiles of measured values: median, 99.9th percentile.

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
