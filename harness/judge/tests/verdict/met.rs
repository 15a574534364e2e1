//! Mistakes as they were met: pictures of a student's program ([`student`]), stored in three ways, nothing said of how.

use std::cell::Cell;
use std::path::Path;

use groundtruth::math::{Pcg32, power};
use groundtruth::scene::{self, Scene};
use image::ImageEncoder;
use judge::verdict::{Decision, Progress, Strictness, Verdict};
use pictures::compare::{Picture, Transfer};

use super::cases::{verdict, watched};
use super::student::{self, MISTAKES, Stage, Student};
use super::writers::{CURVES, QUANTISERS, Step};
use testkit::as_many;

/// The ways to store a picture: floats, and bytes.
const STORAGES: [Step<f64, f64>; 3] = [
    ("PFM", |v| v),
    ("PPM by truncation", |v| (255.999 * v.clamp(0.0, 1.0)).floor() / 255.0),
    ("PNG", |v| (255.0 * power(v.clamp(0.0, 1.0), 1.0 / 2.2)).round() / 255.0),
];

fn scene_of(stage: &Stage) -> Scene {
    scene::parse(stage.scene(), Path::new("stage.toml")).expect("it is valid").0
}

fn stored(colors: &[[f64; 3]], storage: usize) -> Picture {
    let value = |v: f64| STORAGES[storage].1(v) as f32;
    let values: Vec<f32> = colors.iter().flatten().map(|v| value(*v)).collect();
    let picture = Picture::of_radiance(&values, [48, 36]);
    if storage == 0 { picture } else { Picture { step: Some(1.0 / 255.0), ..picture } }
}

fn judged(stage: &Stage, mistake: &str, storage: usize) -> Verdict {
    let picture = stored(&Student { stage, mistake }.picture(40), storage);
    verdict(&scene_of(stage), &[picture], Strictness { level: 0.01, first: 8 })
}

/// What becomes of a name in the first line.
#[derive(Debug, PartialEq)]
enum Named {
    Rightly,
    Wrongly,
    Not,
    Missed,
}

fn named(verdict: &Verdict, names: &[&str]) -> Named {
    let line = verdict.sentence();
    let is_named = ["known mistake:", "it agrees but for that", "explains a part"];
    let is_named = is_named.iter().any(|it| line.contains(it));
    match verdict.decision {
        Decision::Differs if names.iter().any(|name| line.contains(name)) => Named::Rightly,
        Decision::Differs if is_named => Named::Wrongly,
        Decision::Differs => Named::Not,
        _ => Named::Missed,
    }
}

/// Law: the student's program without a mistake has our pictures. Oracle: it shares nothing with ours.
#[test]
fn a_right_picture_of_the_student_agrees() {
    for stage in student::stages() {
        for (storage, (how, _)) in STORAGES.iter().enumerate() {
            let verdict = judged(&stage, "", storage);
            assert_eq!(verdict.decision, Decision::Agrees, "{}, {how}: {verdict}", stage.name);
        }
    }
}

/// The verdicts on pictures with these mistakes: each stored in these ways, of each of these stages.
fn met(stages: &[Stage], mistakes: &[(&str, &[&str])], storages: &[usize]) {
    let (mut rightly, mut missed, mut wrongly, mut count) = (0, 0, Vec::new(), 0);
    for stage in stages {
        for (mistake, names) in mistakes {
            if stage.samples == 1 && *mistake == "the last sample left out" {
                continue;
            }
            for storage in storages {
                let verdict = judged(stage, mistake, *storage);
                let (named, line) = (named(&verdict, names), verdict.sentence());
                println!(
                    "{named:?}: {} | {mistake} | {}: {line}",
                    stage.name, STORAGES[*storage].0
                );
                count += 1;
                match named {
                    Named::Rightly => rightly += 1,
                    Named::Missed => missed += 1,
                    Named::Wrongly => wrongly.push(format!("{mistake}: {line}")),
                    Named::Not => {}
                }
            }
        }
    }
    println!("{rightly} of {count} are named rightly, {missed} agree");
    assert_eq!(wrongly, Vec::<String>::new());
    assert!(4 * rightly >= 3 * count, "{rightly} of {count}");
}

/// Law: mistakes as they were met are named rightly or not at all, three of four rightly, however the picture is stored.
/// Oracle: the mistake that was made.
#[test]
fn mistakes_as_met_are_named_rightly_or_not_at_all() {
    let stages = student::stages();
    met(&stages[..1], &MISTAKES[..8], &[1, 2]);
    met(&stages[1..2], MISTAKES, &[0]);
    // a PNG, which may be rounded or truncated
    let half = MISTAKES.iter().position(|(name, _)| *name == "half of all light").expect("met");
    met(&stages[1..2], &MISTAKES[half..half + 1], &[2]);
    // 3.5 times as bright, which noise does not tell from 4 times, as if ks were left out
    let normalised =
        MISTAKES.iter().position(|(name, _)| *name == "a normalised highlight").expect("met");
    met(&stages[2..], &MISTAKES[normalised..normalised + 1], &[1, 2]);
}

/// Law: the same for all mistakes, stages and ways to store. Oracle: as above.
#[test]
#[ignore = "cost: cargo test --test judge met -- --ignored --nocapture"]
fn all_mistakes_as_met_are_named_rightly_or_not_at_all() {
    met(&student::stages(), MISTAKES, &[0, 1, 2]);
}

/// A way to store a picture: its name, and the picture that it makes of colours.
type Honest = (String, Box<dyn Fn(&[[f64; 3]]) -> Picture>);

/// Forty honest ways to store a picture.
fn honest() -> Vec<Honest> {
    let mut all: Vec<Honest> = Vec::new();
    for (curve, of) in [0, 1, 2, 3, 5].map(|it| CURVES[it]) {
        for (name, to) in QUANTISERS {
            let byte = move |v: f64| to(of(v.clamp(0.0, 1.0))) / 255.0;
            all.push((format!("{curve}, {name}"), Box::new(move |it| integers(it, 255.0, byte))));
        }
    }
    for (curve, of) in [CURVES[0], CURVES[5]] {
        let word = move |v: f64| (65535.0 * of(v.clamp(0.0, 1.0))).round() / 65535.0;
        all.push((format!("{curve}, 16 bits"), Box::new(move |it| integers(it, 65535.0, word))));
    }
    for quality in [50, 75, 90, 95] {
        all.push((format!("JPEG {quality}"), Box::new(move |it| jpeg(it, quality))));
    }
    let float = |it: &[[f64; 3]]| stored(it, 0);
    let png = |it: &[[f64; 3]]| stored(it, 2);
    let ppm = |it: &[[f64; 3]]| stored(it, 1);
    all.push(("PFM".to_owned(), Box::new(float)));
    let half = |it: &[[f64; 3]]| stored(&each(it, |v| f64::from(half(v as f32))), 0);
    all.push(("EXR, half".to_owned(), Box::new(half)));
    let upside_down = |it: &[[f64; 3]]| it.chunks(48).rev().flatten().copied().collect::<Vec<_>>();
    let mirrored = |it: &[[f64; 3]]| {
        it.chunks(48).flat_map(|row| row.iter().rev().copied()).collect::<Vec<_>>()
    };
    let reversed = |it: &[[f64; 3]]| it.iter().map(|[r, g, b]| [*b, *g, *r]).collect::<Vec<_>>();
    all.push(("PNG, flipped".to_owned(), Box::new(move |it| png(&upside_down(it)))));
    all.push(("PPM, flipped".to_owned(), Box::new(move |it| ppm(&upside_down(it)))));
    all.push(("PNG, mirrored".to_owned(), Box::new(move |it| png(&mirrored(it)))));
    all.push(("PPM, mirrored".to_owned(), Box::new(move |it| ppm(&mirrored(it)))));
    all.push(("PNG, BGR".to_owned(), Box::new(move |it| png(&reversed(it)))));
    all.push(("PPM, BGR".to_owned(), Box::new(move |it| ppm(&reversed(it)))));
    let dithered = |it: &[[f64; 3]]| {
        let random = std::cell::RefCell::new(Pcg32::new(5, 5));
        let below = || f64::from(random.borrow_mut().below(1 << 24)) / f64::from(1 << 24);
        integers(it, 255.0, |v| (255.0 * v.clamp(0.0, 1.0) + below()).floor().min(255.0) / 255.0)
    };
    all.push(("dithered".to_owned(), Box::new(dithered)));
    all
}

fn each(colors: &[[f64; 3]], of: impl Fn(f64) -> f64) -> Vec<[f64; 3]> {
    colors.iter().map(|color| color.map(&of)).collect()
}

fn integers(colors: &[[f64; 3]], largest: f64, value: impl Fn(f64) -> f64) -> Picture {
    let picture = stored(&each(colors, value), 0);
    Picture { step: Some(1.0 / largest), ..picture }
}

/// To 11 significant bits.
fn half(value: f32) -> f32 {
    f32::from_bits((value.to_bits() + (1 << 12)) >> 13 << 13)
}

fn jpeg(colors: &[[f64; 3]], quality: u8) -> Picture {
    let of = |v: f64| (255.0 * power(v.clamp(0.0, 1.0), 1.0 / 2.2)).round() as u8;
    let bytes: Vec<u8> = colors.iter().flatten().map(|v| of(*v)).collect();
    let mut file = Vec::new();
    let encoder = image::codecs::jpeg::JpegEncoder::new_with_quality(&mut file, quality);
    encoder.write_image(&bytes, 48, 36, image::ExtendedColorType::Rgb8).expect("it fits");
    Picture::from_bytes(&file, Path::new("a.jpg"), None).expect("it is a picture")
}

/// Law: a right picture agrees, however it is stored, or what was done to it is named. Oracle: the student's program, which
/// has our pictures.
#[test]
fn honest_pictures_agree_or_are_told_what_was_done_to_them() {
    let mut wrong = Vec::new();
    for (index, stage) in [0, 2].map(|it| student::stages().swap_remove(it)).iter().enumerate() {
        let colors = Student { stage, mistake: "" }.picture(40);
        // every second way of each, thoroughly all of both
        let (first, step) = as_many((index, 2), (0, 1));
        for (name, store) in honest().into_iter().skip(first).step_by(step) {
            let verdict =
                verdict(&scene_of(stage), &[store(&colors)], Strictness { level: 0.01, first: 8 });
            let is_told = verdict.explained.as_ref().is_some_and(|it| it.agrees && !it.is_gain);
            if verdict.decision != Decision::Agrees && !is_told {
                wrong.push(format!("{}, {name}: {}", stage.name, verdict.sentence()));
            }
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
}

/// Law: a file that says that it is encoded as sRGB, and is not, is told so, and nothing else is. Oracle: how it was stored.
#[test]
fn a_file_that_lies_about_its_encoding_is_told_so() {
    let stage = student::stages().swap_remove(1);
    let strictness = Strictness { level: 0.01, first: 8 };
    for (storage, name) in [(1, "linear"), (2, "gamma 2.2")] {
        let picture = stored(&Student { stage: &stage, mistake: "" }.picture(40), storage);
        let picture = Picture { transfer: Transfer::Srgb, ..picture };
        let silent = |_: Progress<'_>| {};
        let how = (strictness, Some(Transfer::Srgb));
        let verdict =
            watched(&scene_of(&stage), &[picture], how, usize::MAX, (&Cell::new(0), &silent));
        let line = verdict.expect("nobody interrupts").sentence();
        let expected =
            format!("differs: theirs is encoded as {name}, not as sRGB; it agrees but for that");
        assert!(line.starts_with(&expected), "{line}");
    }
}
