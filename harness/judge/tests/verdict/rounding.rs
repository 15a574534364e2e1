//! Correct pictures that rounding or chance sets apart from all of ours.

use groundtruth::film::Film;
use groundtruth::math::Pcg32;
use groundtruth::scene::Scene;
use judge::verdict::{
    Areas, Bright, Decision, Evaluation, PoolContext, Quantiser, Stored, Strictness,
};
use pictures::compare::{Picture, Transfer};
use testkit::as_many;

use super::cases::verdict;
use super::noise::normal;
use super::pictures::{film, films, scene, world};

/// Law: of correct pictures in 8 bits whose noise is a tenth of a step, or nearly half of one, few are called wrong, dark
/// or bright. Oracle: the binomial distribution: of 240 at level 5 %, more than 24 have a probability below 5e-4.
#[test]
fn noise_below_a_step_is_no_difference() {
    const STRICTNESS: Strictness = Strictness { level: 0.05, first: 8 };
    const SIZE: usize = 12;
    let areas = Areas::tiles([SIZE; 2]);
    let random = &mut Pcg32::new(5, 7);
    let (mut alarms, mut lines) = (0, Vec::new());
    for (noise, brightest) in [(0.1, 6.0), (0.1, 250.0), (0.4, 6.0), (0.4, 250.0)] {
        let stored = Stored::Integers {
            step: 1.0 / 255.0,
            transfer: Transfer::Gamma(2.2),
            quantiser: Quantiser::Rounded,
            bright: Bright::Clamped,
        };
        let mut picture = || -> Vec<f32> {
            let of = |at: usize| {
                let unit = normal(random);
                let slope = brightest * (at / 3) as f64 / (SIZE * SIZE) as f64;
                ((slope + noise * unit).round().max(0.0) / 255.0) as f32
            };
            (0..3 * SIZE * SIZE).map(of).map(|value| stored.read(value)).collect()
        };
        let before = alarms;
        for _ in 0..60 {
            let theirs = picture();
            let subject = PoolContext { areas: &areas, stored, reference: None };
            let judged =
                Evaluation::of(&theirs, subject, STRICTNESS, &mut Vec::new(), |_| Some(picture()));
            alarms += u32::from(judged.expect("enough").decision == Decision::Differs);
        }
        lines.push(format!("{noise}, {brightest}: {}", alarms - before));
    }
    assert!(alarms <= 24, "{alarms} of 240: {lines:?}");
}

/// A scene without noise, its picture, and the verdict at level 5 %.
fn without_noise() -> (Scene, Film) {
    let scene = scene("ch14/set", [32; 2], 1);
    let film = film(&scene, 9);
    (scene, film)
}

/// Law: a negative value is counted, located, and decides, if it is more than rounding, and ours have none. Oracle: the values
/// that were planted; a filter with negative lobes, whose own pictures have some.
#[test]
fn negative_values_decide() {
    let (scene, film) = without_noise();
    let strictness = Strictness { level: 0.05, first: 8 };
    let of = |value: f32| {
        let mut theirs = Picture::of_film(&film);
        let at = (0..theirs.values.len()).find(|at| theirs.values[*at][1] == 0.0).unwrap_or(70);
        theirs.values[at][1] = value;
        (at, verdict(&scene, &[theirs], strictness))
    };
    let (at, wrong) = of(-1.0);
    assert_eq!(wrong.decision, Decision::Differs, "{wrong}");
    let negative = wrong.negative.expect("one");
    assert_eq!((negative.values, negative.lowest), (1, -1.0));
    assert_eq!(negative.at, [at % 32, at / 32]);
    assert!(
        wrong.to_string().contains(&format!(
            "negative: 1 value, the lowest -1 at {},{}",
            at % 32,
            at / 32
        )),
        "{wrong}"
    );
    let mut noisy = super::pictures::scene("ch18/rectangle", [32; 2], 4);
    noisy.image.samples = 4;
    let film = super::pictures::film(&noisy, 900);
    let mut theirs = Picture::of_film(&film);
    theirs.values[33][2] = -1.0;
    for pictures in [vec![theirs.clone()], vec![theirs; 3]] {
        let verdict = verdict(&noisy, &pictures, strictness);
        assert_eq!(verdict.decision, Decision::Differs, "{verdict}");
        assert_eq!(verdict.negative.map(|it| (it.lowest, it.at)), Some((-1.0, [1, 1])));
        if pictures.len() == 1 {
            // and no cause is named beside it
            let line = "differs: radiance is never negative, and that of theirs is";
            assert_eq!(verdict.sentence(), line);
        }
    }
    let lobes = super::pictures::scene("ch04/checker-mitchell", [32; 2], 4);
    let theirs = films(&mut world(&lobes, 1), 900..905);
    let theirs: Vec<Picture> = theirs.iter().map(Picture::of_film).collect();
    for pictures in [&theirs[..1], &theirs] {
        let verdict = verdict(&lobes, pictures, Strictness { level: 0.01, first: 8 });
        assert_eq!(verdict.decision, Decision::Agrees, "{} pictures: {verdict}", pictures.len());
        assert!(verdict.negative.is_some_and(|it| !it.counts), "{verdict}");
    }
}

/// Law: no verdict agrees while a mean in it lies outside its interval, in scenes with noise and without, in 8 bits and in
/// radiance, of one picture and of several. Oracle: the intervals that are printed.
#[test]
fn no_verdict_agrees_with_a_mean_outside_its_interval() {
    let noisy = scene("ch18/rectangle", [24; 2], 4);
    let (still, _) = without_noise();
    let strictness = Strictness { level: 0.05, first: 8 };
    let mut outside = 0;
    for scene in [noisy, still] {
        let films = films(&mut world(&scene, 1), 700..703);
        for gain in as_many(&[0.99, 1.04][..], &[0.96, 0.99, 1.0, 1.01, 1.04]) {
            let picture = |film: &Film, bits: bool| {
                let mut picture = Picture::of_film(film);
                for value in picture.values.as_flattened_mut() {
                    let gained = *gain * f64::from(*value);
                    let byte = (255.0 * gained.clamp(0.0, 1.0).sqrt()).round() / 255.0;
                    *value = if bits { byte } else { gained } as f32;
                }
                Picture { step: bits.then_some(1.0 / 255.0), ..picture }
            };
            for bits in [false, true] {
                let all: Vec<Picture> = films.iter().map(|film| picture(film, bits)).collect();
                for theirs in [&all[..1], &all[..]] {
                    let mut verdict = verdict(&scene, theirs, strictness);
                    verdict.hold_to(0.001);
                    let is_outside = verdict.means[0].is_outside();
                    outside += u32::from(is_outside);
                    let agrees = verdict.decision == Decision::Agrees;
                    assert!(
                        verdict.equal_to_seed.is_some() || !(agrees && is_outside),
                        "{verdict}"
                    );
                }
            }
        }
    }
    assert!(outside > as_many(3, 8), "{outside}");
}
