//! Every usual way to store integers: a correct picture has no pixel that differs.

use groundtruth::film::Film;
use groundtruth::math::power;
use groundtruth::rgb::Rgb;
use pictures::compare::{Comparison, Picture, Transfer};

use super::encoded::srgb;
use crate::verbs::equal;
use testkit::as_many;

/// A way to an integer, with its name.
type Step = (&'static str, fn(f64, f64) -> f64);

/// From a display value to an integer up to the largest, as programs write it.
const QUANTISERS: [Step; 6] = [
    ("int(N v)", |v, n| (n * v).floor()),
    ("int((N + 0.99) v)", |v, n| ((n + 0.99) * v).floor()),
    ("int((N + 0.999) v)", |v, n| ((n + 0.999) * v).floor()),
    ("int((N + 1) v), capped", |v, n| ((n + 1.0) * v).floor().min(n)),
    ("round(N v)", |v, n| (n * v).round()),
    ("int(N v + 0.5)", |v, n| (n * v + 0.5).floor()),
];

/// A curve, with what it is called.
type Curve = (Transfer, Box<dyn Fn(f64) -> f64>);

fn curves() -> Vec<Curve> {
    let gammas = as_many(&[2.2][..], &[1.8, 2.0, 2.2, 2.4]);
    let of = |gamma: f64| -> Curve {
        (Transfer::Gamma(gamma), Box::new(move |v| power(v, 1.0 / gamma)))
    };
    let mut all: Vec<Curve> = gammas.iter().copied().map(of).collect();
    all.push((Transfer::Linear, Box::new(|v| v)));
    all.push((Transfer::Srgb, Box::new(srgb)));
    all
}

/// The radiances that are stored: evenly spread beyond both ends, each border of an integer, and the numbers beside it.
fn values(decode: &dyn Fn(f64) -> f64) -> Vec<f64> {
    let even = (0..=2_400).map(|i| f64::from(i) / 2_000.0);
    let borders = (0..=255).flat_map(|i| {
        let i = f64::from(i);
        [i / 255.0, i / 255.99, i / 256.0, (i + 0.5) / 255.0].map(decode)
    });
    even.chain(borders.flat_map(|v| [v * (1.0 - 1e-9), v, v * (1.0 + 1e-9)])).collect()
}

/// Law: a picture in integers of 8 or 16 bits that a usual program stored agrees with its radiance at every value: rounded,
/// or truncated after any usual factor, by any usual curve, clamped. Integers that are larger by two differ. Oracle: the
/// programs' own lines.
#[test]
fn a_correct_picture_agrees_whoever_stored_it() {
    for (transfer, encode) in curves() {
        let decode = |v: f64| transfer.decoded(v);
        let values = values(&decode);
        let mut film = Film::new(values.len() as u32, 2);
        for (x, v) in (0..).zip(&values) {
            film.set([x, 0], Rgb::new(*v, 0.5 * v, 0.0));
            film.set([x, 1], Rgb::new(0.0, *v, 1.0));
        }
        let ours = Picture::of_film(&film);
        for largest in [255.0, 65_535.0] {
            for (name, quantise) in QUANTISERS {
                let integer =
                    |v: f32| quantise(encode(f64::from(v).clamp(0.0, 1.0)).min(1.0), largest);
                let written = |more: f64| {
                    let of = |v: f32| ((integer(v) + more).clamp(0.0, largest) / largest) as f32;
                    let values = ours.values.iter().map(|color| color.map(of)).collect();
                    Picture { values, transfer, step: Some(1.0 / largest), ..ours.clone() }
                };
                let what = format!("{name}, {transfer}, N = {largest}");
                for (a, b) in [(&ours, &written(0.0)), (&written(0.0), &ours)] {
                    let found = Comparison::of(a, b, 0.0).expect("one size");
                    equal(format!("{what}: pixels that differ, {found}"), found.differing, 0);
                }
                let off = Comparison::of(&ours, &written(2.0), 0.0).expect("one size");
                let bright = values.iter().filter(|v| integer(**v as f32) + 2.0 <= largest).count();
                assert!(
                    off.differing >= bright as u64,
                    "{what}: two integers off, found {} pixels that differ, expected {bright} or more",
                    off.differing
                );
            }
        }
    }
}
