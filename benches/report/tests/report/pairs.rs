//! Biases of pictures in pairs.

use report::light::BiasData;

/// Law: of two series that differ by a constant, pictures of one seed are a pair, and the interval has almost no
/// width; the noise that both have is not in it. Oracle: the constant, relative to the mean.
#[test]
fn the_noise_of_pairs_is_not_in_the_interval() {
    let truth = [1.0, 5.0, 2.0, 8.0];
    let values = truth.map(|value| value + 0.5);
    let bias = BiasData::paired(String::new(), &values, &truth);
    let [value, low, high] = bias.difference.expect("four pairs");
    assert!((value - 0.125).abs() < 1e-12 && high - low < 1e-12, "{value}: {low} to {high}");
    let alone = BiasData::new(String::new(), &values, &truth).difference.expect("four and four");
    assert!(alone[2] - alone[1] > 1.0, "unpaired, the noise is in the interval: {alone:?}");
}
