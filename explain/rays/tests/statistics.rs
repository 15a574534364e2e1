use std::f64::consts::PI;

use super::laws::traced;
use super::light::broken_by as broken;
use groundtruth::math::{Pcg32, cos, sin};
use rays::Traced;

/// Diffuse rays from points of a floor whose cosines are a function of a random number, and that claim the cosine's density.
fn drawn(cosine: impl Fn(f64) -> f64, seed: impl Fn(usize) -> u64) -> Traced {
    let mut lines = Vec::new();
    let mut random = Pcg32::new(seed(0), 1);
    for pixel in 0..400 {
        if seed(pixel) != 1 {
            random = Pcg32::new(seed(pixel), 1);
        }
        let (up, turn) = (cosine(random.uniform()), 2.0 * PI * random.uniform());
        let side = (1.0 - up * up).sqrt();
        let x = 0.1 * pixel as f64;
        let at = format!("\"pixel\": [{}, {}]", pixel % 20, pixel / 20);
        lines.push(format!("{{{at}, \"ray\": 0, \"kind\": \"path-start\", \"origin\": [{x}, 2, 0], \"direction\": [0, -1, 0], \"t\": 2, \"normal\": [0, 1, 0]}}"));
        lines.push(format!(
            "{{{at}, \"ray\": 1, \"parent\": 0, \"kind\": \"diffuse\", \"origin\": [{x}, 0, 0], \"direction\": [{}, {up}, {}], \"pdf\": {}}}",
            side * cos(turn), side * sin(turn), up / PI
        ));
    }
    traced(&lines)
}

/// Law: directions drawn as claimed are let through, others are not, and what was drawn is named (level 1e-3 for the log).
/// Oracle: the inverse distribution functions.
#[test]
fn densities_are_told_apart() {
    assert_eq!(broken(drawn(f64::sqrt, |_| 1)), []);
    let [(law, cause)] = broken(drawn(|u| u, |_| 1))[..] else { panic!("one law") };
    assert_eq!(law, "drawn-as-claimed");
    assert!(cause.is_some_and(|cause| cause.starts_with("directions are uniform")), "{cause:?}");
    let [(_, cause)] = broken(drawn(|u| cos(0.5 * PI * u), |_| 1))[..] else { panic!("one law") };
    assert!(cause.is_some_and(|cause| cause.contains("clustered")), "{cause:?}");
}

/// Law: the same random numbers in each pixel are seen. Oracle: a generator that is seeded anew.
#[test]
fn a_generator_that_is_seeded_anew_is_seen() {
    let found = broken(drawn(f64::sqrt, |_| 7));
    let cause =
        found.iter().find(|(law, _)| *law == "samples-differ").and_then(|(_, cause)| *cause);
    assert!(cause.is_some_and(|cause| cause.contains("seeded anew")), "{found:?}");
}

/// Law: an honest pinhole camera passes; a film whose pixels are no squares does not, nor one ray elsewhere. Oracle: the film.
#[test]
fn one_film_is_seen() {
    let film = |aspect: f64, odd: f64| {
        let line = |pixel: u32| {
            let (x, y) = (pixel % 20, pixel / 20);
            let shift = if pixel == 105 { odd } else { 0.0 };
            format!(
                "{{\"pixel\": [{x}, {y}], \"kind\": \"camera\", \"origin\": [0, 1, 5], \"direction\": [{}, {}, -1]}}",
                0.05 * (f64::from(x) + 0.5 + shift - 10.0),
                -0.05 * aspect * (f64::from(y) + 0.5 - 10.0)
            )
        };
        traced(&(0..400).map(line).collect::<Vec<_>>())
    };
    assert_eq!(broken(film(1.0, 0.0)), []);
    assert!(broken(film(0.5, 0.0))[0].1.is_some_and(|cause| cause.contains("aspect")));
    assert_eq!(broken(film(1.0, 8.0))[0].0, "one-camera");
}
