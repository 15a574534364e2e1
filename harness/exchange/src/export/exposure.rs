//! The exposure at which a picture uses most of the steps of integers from 0 to 1.

use groundtruth::film::Film;

/// The picture is brightened or darkened so that our brightest value is between half of this and this: nothing is
/// clipped, not even if theirs is twice as bright, and most of the 65536 steps are used.
const BRIGHTEST: f64 = 0.5;

/// The power of two by which to multiply every pixel of a picture like ours.
pub fn exposure(ours: &Film) -> f64 {
    let brightest = ours.pixels().iter().map(|color| color.max()).fold(0.0, f64::max);
    let mut exposure = 1.0;
    if brightest > 0.0 && brightest.is_finite() {
        while exposure * brightest > BRIGHTEST {
            exposure /= 2.0;
        }
        while exposure * brightest <= 0.5 * BRIGHTEST {
            exposure *= 2.0;
        }
    }
    exposure
}
