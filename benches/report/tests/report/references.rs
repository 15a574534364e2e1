//! References that know their own error.

use groundtruth::film::Film;
use groundtruth::rgb::Rgb;
use report::reference::*;

fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() < tolerance, "found {found}, expected {expected}");
}

/// Two pixels, each of one grey.
fn film(left: f64, right: f64) -> Film {
    let mut film = Film::new(2, 1);
    film.set([0, 0], Rgb::grey(left));
    film.set([1, 0], Rgb::grey(right));
    film
}

/// Law: a mean, the variance of one picture, and the standard error of the mean. Oracle: by
/// hand: 1 and 3 have the mean 2, the variance 2, and 2/2 = 1 is that of their mean; 4 and 4
/// have none.
#[test]
fn a_reference_knows_its_own_error() {
    let replicas = [film(1.0, 4.0), film(3.0, 4.0)];
    let reference = Reference::new(&replicas);
    assert_eq!(reference.film, film(2.0, 4.0));
    assert_eq!((reference.mean, brightness(&replicas[0])), (3.0, 2.5));
    let own = reference.own_error();
    near(own[0] * own[0], 0.5 * (1.0 + 0.0), 1e-15);
    // relative to the square of the pixel's 2, and of a tenth of the mean
    let relative = 0.5 * 1.0 / (4.0 + 0.09);
    near(own[1] * own[1], relative, 1e-15);
}

/// Law: the error of a picture is the mean of squares minus that of the reference. Oracle: by
/// hand: 5 and 7 are 3 and 3 off 2 and 4: the squares' mean is 9, and 8.5 without the
/// reference's 0.5.
#[test]
fn errors_are_those_found_by_hand() {
    let reference = [Reference::new(&[film(1.0, 4.0), film(3.0, 4.0)])];
    let [square, relative] = Reference::squared_error(&reference, &[film(5.0, 7.0)]);
    near(square.expect("an error"), 8.5, 1e-14);
    let by_hand = 0.5 * ((9.0 - 1.0) / 4.09 + 9.0 / 16.09);
    near(relative.expect("an error"), by_hand, 1e-14);
    // of several pictures, the mean: 9 and 1 of 5 and 3
    let [square, _] = Reference::squared_error(&reference, &[film(5.0, 7.0), film(3.0, 5.0)]);
    near(square.expect("an error"), 5.0 - 0.5, 1e-14);
    // a difference of ½ of one pixel: 1/8 is less than the reference's own 1/2
    assert_eq!(Reference::squared_error(&reference, &[film(2.5, 4.0)]), [None; 2]);
    // one channel off by 3: a third of the square
    let mut red = film(2.0, 4.0);
    red.set([1, 0], Rgb::new(7.0, 4.0, 4.0));
    let [square, _] = Reference::squared_error(&reference, &[red]);
    near(square.expect("an error"), 0.5 * 9.0 / 3.0 - 0.5, 1e-14);
}

/// Law: the variance does not depend on the bias. Oracle: by hand: 6 and 8 have the variance 2
/// about 7.
#[test]
fn variance_is_blind_to_bias() {
    let reference = [Reference::new(&[film(1.0, 4.0), film(3.0, 4.0)])];
    let variance = Reference::relative_variance(&reference, &[film(6.0, 9.0), film(8.0, 9.0)]);
    near(variance.expect("two pictures"), 0.5 * 2.0 / 4.09, 1e-15);
    assert_eq!(Reference::relative_variance(&reference, &[film(6.0, 9.0)]), None);
}
