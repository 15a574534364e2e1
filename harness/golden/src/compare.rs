//! Two pictures compared: to the last bit, or up to drift.

use groundtruth::film::Film;

use super::GoldenStatus;

/// The largest relative difference of a channel that is still drift: about eight times the
/// distance between neighbouring numbers of single precision.
pub const DRIFT: f64 = 1e-6;

/// Compares two pictures as files store them, in single precision: the same, drift or changed.
pub fn verdict(expected: &Film, got: &Film) -> GoldenStatus {
    if !same_size(expected, got) {
        return GoldenStatus::Changed;
    }
    let channels = || expected.to_f32().zip(got.to_f32()).flat_map(|(a, b)| a.into_iter().zip(b));
    if channels().all(|(a, b)| a.to_bits() == b.to_bits()) {
        GoldenStatus::Same
    } else if channels().all(|(a, b)| a.to_bits() == b.to_bits() || within_drift(a, b)) {
        GoldenStatus::Drift
    } else {
        GoldenStatus::Changed
    }
}

fn same_size(a: &Film, b: &Film) -> bool {
    (a.width(), a.height()) == (b.width(), b.height())
}

/// `|a − b| ≤ DRIFT · max(|a|, |b|)`; false for NaN.
fn within_drift(a: f32, b: f32) -> bool {
    let (a, b) = (f64::from(a), f64::from(b));
    (a - b).abs() <= DRIFT * a.abs().max(b.abs())
}

/// A pixel in which two pictures differ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DifferingPixel {
    /// x right and y down, from 0.
    pub pixel: [u32; 2],
    /// The expected colour.
    pub expected: [f32; 3],
    /// The actual colour.
    pub got: [f32; 3],
    /// The largest absolute difference of a channel; infinite if it is NaN.
    pub size: f64,
}

/// The pixels whose bits differ, the largest difference first. Both pictures have the same size.
pub fn differences(expected: &Film, got: &Film) -> Vec<DifferingPixel> {
    let mut all = Vec::new();
    for (i, (a, b)) in expected.to_f32().zip(got.to_f32()).enumerate() {
        if a.map(f32::to_bits) != b.map(f32::to_bits) {
            let channel = |c: usize| (f64::from(a[c]) - f64::from(b[c])).abs();
            let channels = [channel(0), channel(1), channel(2)];
            let not_a_number = channels.iter().any(|c| c.is_nan());
            let size = channels.into_iter().fold(0.0, f64::max);
            let i = i as u32;
            all.push(DifferingPixel {
                pixel: [i % expected.width(), i / expected.width()],
                expected: a,
                got: b,
                size: if not_a_number { f64::INFINITY } else { size },
            });
        }
    }
    all.sort_by(|a, b| b.size.total_cmp(&a.size));
    all
}
