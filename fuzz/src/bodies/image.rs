//! Image files: any bytes give an error, or an image with finite and non-negative colours. The memory is in
//! proportion to the allowed number of texels.

use groundtruth::images::{Encoding, decode};

/// More texels than this are refused.
const MAX: u64 = 1 << 12;

/// Decodes a file of any format twice: with its default encoding and as linear values.
pub fn run(data: &[u8]) {
    let [default, linear] = [None, Some(Encoding::Linear)].map(|e| decode(data, e, MAX));
    let (Ok(default), Ok(linear)) = (&default, &linear) else {
        assert_eq!(default.is_ok(), linear.is_ok(), "only one encoding is accepted");
        return;
    };
    assert!(u64::from(linear.width()) * u64::from(linear.height()) <= MAX);
    for row in 0..linear.height() {
        for column in 0..linear.width() {
            for texels in [default, linear] {
                let color = texels.color(column, row).to_array();
                assert!(color.iter().all(|c| c.is_finite() && *c >= 0.0), "{color:?}");
            }
        }
    }
}
