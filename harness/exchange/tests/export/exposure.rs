//! The exposure of a picture of integers.

use exchange::export::exposure;
use groundtruth::film::Film;
use groundtruth::rgb::Rgb;

/// Law: the exposure is a power of two that brings the brightest channel above a quarter and to at most a half, and 1
/// where nothing is bright or something is infinite. Oracle: these inequalities, for values at and beside powers of
/// two.
#[test]
fn an_exposure_brings_the_brightest_between_a_quarter_and_a_half() {
    for exponent in -40..40 {
        for beside in [1.0 - f64::EPSILON, 1.0, 1.0 + f64::EPSILON, 1.5] {
            let brightest = beside * groundtruth::math::power_of_two(exponent);
            for channel in 0..3 {
                let mut film = Film::new(3, 2);
                let mut color = [0.25 * brightest; 3];
                color[channel] = brightest;
                film.set([2, 1], Rgb::from(color));
                let found = exposure(&film);
                let shown = found * brightest;
                let fits = shown > 0.25 && shown <= 0.5;
                assert!(fits, "the exposure {found} makes {brightest} {shown}, not 0.25 to 0.5");
                let fraction = found.to_bits() & ((1 << 52) - 1);
                assert_eq!(fraction, 0, "the bits behind the first 1 of the exposure {found}");
            }
        }
    }
    for odd in [0.0, f64::INFINITY] {
        let mut film = Film::new(2, 1);
        film.set([1, 0], Rgb::grey(odd));
        assert_eq!(exposure(&film), 1.0, "the exposure of a picture with {odd}");
    }
}
