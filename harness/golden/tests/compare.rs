//! Pictures compared to the bit, or up to drift.

use golden::GoldenStatus;
use golden::compare::*;
use groundtruth::film::Film;
use groundtruth::rgb::Rgb;

fn grey(value: f64) -> Film {
    let mut film = Film::new(8, 6);
    (0..48).for_each(|i| film.set([i % 8, i / 8], Rgb::grey(value)));
    film
}

#[test]
fn what_is_not_a_number_is_never_drift_and_is_the_worst() {
    let mut film = grey(0.5);
    film.set([1, 2], Rgb::grey(9.0));
    film.set([3, 0], Rgb::new(0.5, f64::NAN, 0.5));
    assert_eq!(verdict(&grey(0.5), &film), GoldenStatus::Changed);
    assert_eq!(verdict(&film, &film), GoldenStatus::Same, "bits are compared, not values");
    let found: Vec<_> = differences(&grey(0.5), &film).iter().map(|d| d.pixel).collect();
    assert_eq!(found, [[3, 0], [1, 2]]);
}

#[test]
fn pictures_of_other_sizes_are_changed() {
    let other = Film::new(6, 8);
    assert_eq!(verdict(&Film::new(8, 6), &other), GoldenStatus::Changed);
}
