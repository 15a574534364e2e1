//! Image files: any bytes are an image of finite, not negative colours or an error, with memory in
//! proportion to what is allowed.

use groundtruth::images::{Encoding, decode};

/// More texels than this are refused.
const MAX: u64 = 1 << 12;

/// Reads a file of any format, as it is by default and as linear numbers.
pub fn run(data: &[u8]) {
    let [default, linear] = [None, Some(Encoding::Linear)].map(|e| decode(data, e, MAX));
    let (Ok(default), Ok(linear)) = (&default, &linear) else {
        assert_eq!(default.is_ok(), linear.is_ok(), "the encoding decides whether it is an image");
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
