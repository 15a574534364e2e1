//! Ways in which programs store 8 bits, written as a student writes them.

use std::cell::RefCell;
use std::path::Path;

use groundtruth::film::{self, Film, Format};
use groundtruth::math::{Pcg32, power};
use image::codecs::jpeg::JpegEncoder;
use image::{ExtendedColorType, ImageEncoder};
use judge::verdict::{Decision, Quantiser, Stored, Strictness, plausible};
use pictures::compare::{Comparison, Picture, Transfer};
use testkit::as_many;

use super::cases::verdict;
use super::pictures::{film, scene, world};
use super::power::half_a_pixel_off;
use super::shared::{Shared, mapped};
use crate::verbs::equal;

/// A step of a writer, with its name.
type Step<A, B> = (&'static str, fn(A) -> B);

/// From a display value to a byte; the last ones cap what is beyond 255.
const QUANTISERS: [Step<f64, f64>; 5] = [
    ("round(255 v)", |v| (255.0 * v + 0.5).floor()),
    ("int(255 v)", |v| (255.0 * v).floor()),
    ("int(255.99 v)", |v| (255.99 * v).floor()),
    ("int(255.999 v)", |v| (255.999 * v).floor()),
    ("int(256 v), capped", |v| (256.0 * v).floor().min(255.0)),
];

fn srgb(v: f64) -> f64 {
    if v < 0.0031308 { 12.92 * v } else { 1.055 * power(v, 1.0 / 2.4) - 0.055 }
}

const CURVES: [Step<f64, f64>; 7] = [
    ("v", |v| v),
    ("v^(1/1.8)", |v| power(v, 1.0 / 1.8)),
    ("v^(1/2)", f64::sqrt),
    ("v^(1/2.2)", |v| power(v, 1.0 / 2.2)),
    ("v^(1/2.4)", |v| power(v, 1.0 / 2.4)),
    ("sRGB", srgb),
    ("sRGB, 1 at 1", |v| if v >= 1.0 { 1.0 } else { srgb(v) }),
];

fn largest([r, g, b]: [f64; 3]) -> f64 {
    r.max(g).max(b)
}

const GAMUTS: [Step<[f64; 3], [f64; 3]>; 3] = [
    ("clamped", |c| c.map(|v| v.clamp(0.0, 1.0))),
    ("by the largest", |c| if largest(c) > 1.0 { c.map(|v| v / largest(c)) } else { c }),
    ("red", |c| if largest(c) > 1.0 { [1.0, 0.0, 0.0] } else { c }),
];

/// A writer: gamut, curve and quantiser.
type Writer = [usize; 3];

/// Twenty: each quantiser with 2.2 and 1 and two other curves; clamping is the most usual.
fn writers() -> Vec<Writer> {
    let of = |quantiser: usize| {
        let other = [1, 2, 4, 5, 1][quantiser];
        [[0, 3], [quantiser % 3, 0], [1, 5], [2, other]].map(|[g, c]| [g, c, quantiser])
    };
    (0..QUANTISERS.len()).flat_map(of).collect()
}

fn name([gamut, curve, quantiser]: Writer) -> String {
    format!("{}, {}, {}", GAMUTS[gamut].0, CURVES[curve].0, QUANTISERS[quantiser].0)
}

/// The picture that a writer makes of a film.
fn written(film: &Film, [gamut, curve, quantiser]: Writer) -> Picture {
    let byte = |v: f64| (QUANTISERS[quantiser].1(CURVES[curve].1(v)) / 255.0) as f32;
    let pixel = |color: [f64; 3]| GAMUTS[gamut].1(color).map(byte);
    let values = film.pixels().iter().map(|color| pixel(color.to_array())).collect();
    Picture { values, step: Some(1.0 / 255.0), ..Picture::of_film(film) }
}

/// Law: the integers that are assumed of a writer are those that it writes, and each stands for the middle of the values
/// that become it. Oracle: a writer's own line, over a fine grid of values.
#[test]
fn an_integer_stands_for_the_middle_of_its_values() {
    const VALUES: usize = 1 << 20;
    for ((name, writer), assumed) in QUANTISERS.iter().zip(Quantiser::ALL) {
        let (mut sums, mut counts) = ([0.0; 256], [0.0; 256]);
        for v in (0..VALUES).map(|i| (i as f64 + 0.5) / VALUES as f64) {
            let integer = writer(v);
            assert_eq!(assumed.integer(v, 255.0), integer, "{name} of {v}");
            sums[integer as usize] += v;
            counts[integer as usize] += 1.0;
        }
        // black and white stand for what is clamped, too
        for integer in 1..255 {
            let off = sums[integer] / counts[integer] - assumed.middle(integer as f64, 255.0);
            // the ends of an interval may lie anywhere between two values of the grid
            assert!(off.abs() <= 1.0 / VALUES as f64, "{name}: {integer} is off by {off:e}");
        }
    }
}

/// Every quantiser with every curve and every rule for colours beyond 1.
fn all_writers() -> Vec<Writer> {
    let of = |quantiser: usize| {
        let pairs =
            (0..GAMUTS.len()).flat_map(|gamut| (0..CURVES.len()).map(move |curve| [gamut, curve]));
        pairs.map(move |[gamut, curve]| [gamut, curve, quantiser])
    };
    (0..QUANTISERS.len()).flat_map(of).collect()
}

/// Law: of scenes without noise, dark and bright, correct pictures agree, whichever of all quantisers, curves and rules for
/// colours beyond 1 stored them. Oracle: the scene, whose pictures they are.
#[test]
fn every_writer_of_a_right_picture_agrees() {
    let mut wrong = Vec::new();
    for scene_name in ["ch14/out-of-gamut", "ch15/page-one"] {
        let scene = scene(scene_name, [16; 2], 1);
        let (ours, film) = (world(&scene, 1), film(&scene, 50_000));
        let shared = Shared::usual(scene_name, [16, 1, 8]);
        let differs = |writer: &Writer| shared.differs(&ours, &written(&film, *writer), 1);
        let all = all_writers().into_iter().filter(differs);
        wrong.extend(all.map(|writer| format!("{scene_name}: {}", name(writer))));
    }
    equal("correct pictures that are called wrong", wrong, Vec::new());
}

/// Law: in a scene without noise, a gain of 1 % and half a pixel are found whichever program wrote the picture. Oracle: the
/// defect that was planted.
#[test]
fn defects_are_found_whoever_wrote_the_picture() {
    let (name_of_scene, side) = ("ch14/set", 32);
    let scene = scene(name_of_scene, [side; 2], 1);
    let (ours, film) = (world(&scene, 1), film(&scene, 50_000));
    let shared = Shared::usual(name_of_scene, [side, 1, 8]);
    let brighter = mapped(&film, |_, color| 1.01 * color);
    let shifted = half_a_pixel_off(name_of_scene, [side, 1], 50_000);
    for writer in writers().into_iter().step_by(as_many(3, 1)) {
        for (what, theirs) in [("1 %", &brighter), ("half a pixel", &shifted)] {
            let differs = shared.differs(&ours, &written(theirs, writer), 1);
            assert!(differs, "{what} is not found: {}", name(writer));
        }
    }
}

/// Law: the picture of each scene of the gallery, stored in each format that we write, has no difference from ours as its file
/// stores it: colours beyond 1 and below 0 included. Oracle: the file.
#[test]
fn every_scene_has_the_values_of_its_own_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let (mut beyond, mut negative) = (0, 0);
    // one of each chapter, and those whose filters have negative lobes
    let is_tried = |(index, entry): &(usize, gallery::Entry)| {
        index % as_many(4, 1) == 0 || entry.name.contains("mitchell")
    };
    for (_, entry) in gallery::scenes().enumerate().filter(is_tried) {
        let scene = scene(entry.name, [12, 8], 4);
        let film = film(&scene, 1);
        beyond += usize::from(film.pixels().iter().any(|color| color.max() > 1.0));
        negative += usize::from(
            film.pixels().iter().any(|color| color.to_array().iter().any(|x| *x < 0.0)),
        );
        for (_, format) in Format::ALL {
            let file = folder.path().join(format!("a.{format}"));
            film::write(&film, &scene.image.tone(), &file).expect("written");
            let theirs = Picture::read(&file, None).expect("a picture");
            let tone = (scene.image.gamma, scene.image.out_of_gamut);
            let candidates = Stored::candidates(&theirs, theirs.stated, tone);
            let stored = plausible(&candidates, &theirs, std::slice::from_ref(&film))[0];
            let ours = Picture::of_film(&stored.mapped(&film));
            let transfer = stored.transfer().unwrap_or(theirs.transfer);
            let theirs = Picture { transfer, ..theirs };
            let found = Comparison::of(&ours, &theirs, 0.0).expect("one size");
            assert!(found.is_same(), "{}, {format}: {} pixels differ", entry.name, found.differing);
        }
    }
    assert!(
        beyond > as_many(5, 20) && negative > 0,
        "{beyond} scenes with bright colours, {negative} negative"
    );
}

/// The picture with each value made another, in steps if they are integers.
fn each(picture: &Picture, step: Option<f64>, of: impl Fn(f64) -> f64) -> Picture {
    let values = picture.values.iter().map(|color| color.map(|v| of(f64::from(v)) as f32));
    Picture { values: values.collect(), step, ..picture.clone() }
}

fn jpeg(picture: &Picture, quality: u8) -> Picture {
    let of = |v: &f32| (255.0 * power(f64::from(*v).clamp(0.0, 1.0), 1.0 / 2.2)).round() as u8;
    let bytes: Vec<u8> = picture.values.as_flattened().iter().map(of).collect();
    let [width, height] = picture.size;
    let mut file = Vec::new();
    let encoder = JpegEncoder::new_with_quality(&mut file, quality);
    encoder.write_image(&bytes, width, height, ExtendedColorType::Rgb8).expect("it fits");
    Picture::from_bytes(&file, Path::new("a.jpg"), None).expect("it is a picture")
}

fn png(picture: &Picture) -> Picture {
    let byte = |v: f64| (255.0 * power(v.clamp(0.0, 1.0), 1.0 / 2.2)).round() / 255.0;
    each(picture, Some(1.0 / 255.0), byte)
}

/// The name of a way to store a picture, and the picture as stored.
type WayToStore = (&'static str, fn(&Picture) -> Picture);

/// Other ways to store a picture than by one quantiser in each pixel.
const OTHERS: [WayToStore; 7] = [
    ("half precision", |it| {
        // to 11 significant bits
        let half = |v: f32| f32::from_bits((v.to_bits() + (1 << 12)) >> 13 << 13);
        each(it, None, |v| f64::from(half(v as f32)))
    }),
    ("JPEG of quality 50", |it| jpeg(it, 50)),
    ("JPEG of quality 95", |it| jpeg(it, 95)),
    ("16 bits, sRGB", |it| {
        each(it, Some(1.0 / 65535.0), |v| (65535.0 * srgb(v.clamp(0.0, 1.0))).round() / 65535.0)
    }),
    ("blue, green, red", |it| {
        let values = it.values.iter().map(|[r, g, b]| [*b, *g, *r]).collect();
        png(&Picture { values, ..it.clone() })
    }),
    ("upside down", |it| {
        let rows = it.values.chunks(it.size[0] as usize).rev().flatten().copied();
        png(&Picture { values: rows.collect(), ..it.clone() })
    }),
    ("dithered", |it| {
        let random = RefCell::new(Pcg32::new(5, 5));
        let below = || random.borrow_mut().uniform();
        each(it, Some(1.0 / 255.0), |v| {
            (255.0 * v.clamp(0.0, 1.0) + below()).floor().min(255.0) / 255.0
        })
    }),
];

/// Law: a right picture agrees, in whichever other way it is stored, or what was done to it is named, with noise and without.
/// Oracle: the scene, whose picture it is.
#[test]
fn honest_pictures_agree_or_are_told_what_was_done_to_them() {
    let mut wrong = Vec::new();
    for (scene_name, samples) in [("ch14/set", 1), ("ch18/rectangle", 4)] {
        let scene = scene(scene_name, as_many([32, 24], [48, 36]), samples);
        let film = film(&scene, 40);
        let right = Picture::of_film(&film);
        for (way, store) in OTHERS {
            let strictness = Strictness { level: 0.01, first: 8 };
            let found = verdict(&scene, &[store(&right)], strictness);
            let is_told = found.explained.as_ref().is_some_and(|it| it.agrees && !it.is_gain);
            if found.decision != Decision::Agrees && !is_told {
                wrong.push(format!("{scene_name}, {way}: {}", found.sentence()));
            }
        }
    }
    equal("honest pictures that differ", wrong, Vec::new());
}

/// Law: the curve of a picture in 8 bits is named, and for sRGB the quantiser. Oracle: those that it was written with.
#[test]
fn transfer_functions_are_assumed_and_named() {
    let scene = scene("ch18/rectangle", [48; 2], 16);
    let film = film(&scene, 500);
    for (curve, quantiser, expected) in [
        (0, 0, "linear"),
        (1, 0, "gamma 1.8"),
        (3, 0, "gamma 2.2"),
        (5, 0, "sRGB, rounded to 8 bits, channels above 1 clamped"),
        (5, 1, "sRGB, truncated to 8 bits, channels above 1 clamped"),
    ] {
        // at this level few other seeds or samplers would have it called wrong
        let strictness = Strictness { level: 0.005, first: 8 };
        let transfer = if curve == 5 { Transfer::Srgb } else { Transfer::Linear };
        let picture = Picture { transfer, ..written(&film, [0, curve, quantiser]) };
        let verdict = verdict(&scene, &[picture], strictness);
        assert_eq!(verdict.decision, Decision::Agrees, "{verdict}");
        assert!(verdict.assumed.starts_with(expected), "{expected}: {verdict}");
    }
}
