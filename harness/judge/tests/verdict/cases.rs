//! What is said of whole pictures.

use std::cell::Cell;
use std::path::Path;

use groundtruth::film::Film;
use groundtruth::math::power;
use groundtruth::scene::Scene;
use judge::verdict::{Answer, Case, Decision, Means, Progress, Relative, Strictness, Verdict};
use pictures::compare::{Picture, Transfer};

use super::pictures::{film, films, scene, world};
use super::shared::mapped;

const SIZE: [u32; 2] = [48, 48];

/// The verdict, if nobody interrupts.
pub fn verdict(scene: &Scene, theirs: &[Picture], strictness: Strictness) -> Verdict {
    interrupted(scene, theirs, strictness, usize::MAX).expect("nobody interrupts")
}

/// The verdict, if the user interrupts after so many pictures of ours.
fn interrupted(
    scene: &Scene,
    theirs: &[Picture],
    strictness: Strictness,
    after: usize,
) -> Option<Verdict> {
    watched(scene, theirs, (strictness, None), after, (&Cell::new(0), &|_| {}))
}

/// The number of pictures of ours, and what hears of progress.
pub type Watch<'a> = (&'a Cell<usize>, &'a dyn Fn(Progress<'_>));

/// The same of files that may say their transfer function; the watch counts pictures of ours, and hears what is told.
pub fn watched(
    scene: &Scene,
    theirs: &[Picture],
    (strictness, transfer): (Strictness, Option<Transfer>),
    after: usize,
    (rendered, so_far): Watch<'_>,
) -> Option<Verdict> {
    let mut world = world(scene, 1);
    let case = Case { so_far, strictness, transfer, ..Case::new(scene, Path::new(""), 1) };
    let renders = &mut |world: &_, canvas: &groundtruth::render::Canvas| {
        canvas.render(world);
        rendered.set(rendered.get() + 1);
        rendered.get() <= after
    };
    case.verdict(&mut world, theirs, renders)
}

pub const STRICTNESS: Strictness = Strictness { level: 0.05, first: 8 };

/// A scene with noise, soft shadows and edges.
fn noisy() -> Scene {
    scene("ch18/rectangle", SIZE, 4)
}

fn judged(theirs: &Picture) -> Verdict {
    verdict(&noisy(), std::slice::from_ref(theirs), STRICTNESS)
}

/// The picture with the value at each position taken from another; at the edge it is repeated.
fn moved(film: &Film, from: impl Fn(i64, i64) -> [i64; 2]) -> Picture {
    let last = [film.width(), film.height()].map(|side| i64::from(side) - 1);
    let changed = mapped(film, |[x, y], _| {
        let [x, y] = from(i64::from(x), i64::from(y));
        film.get([x.clamp(0, last[0]) as u32, y.clamp(0, last[1]) as u32])
    });
    Picture::of_film(&changed)
}

fn scaled(film: &Film, factor: f64) -> Picture {
    let mut picture = Picture::of_film(film);
    picture
        .values
        .iter_mut()
        .flatten()
        .for_each(|value| *value = (f64::from(*value) * factor) as f32);
    picture
}

/// Law: each harmless change is named, and the picture agrees but for it. Oracle: the change that was made; for film points at the
/// corners of pixels a picture of our own with one column and row more, whose pixels lie half a pixel off.
#[test]
fn harmless_changes_are_named_before_anything_else() {
    let film = film(&noisy(), 500);
    let last = i64::from(SIZE[0]) - 1;
    let mut larger = noisy();
    [larger.image.width, larger.image.height] = SIZE.map(|side| side + 1);
    let larger = super::pictures::film(&larger, 500);
    let corners = mapped(&film, |[x, y], _| larger.get([x + 1, y + 1]));
    let changes = [
        (moved(&film, |x, y| [x, last - y]), "the rows of theirs are upside down"),
        (
            moved(&film, |x, y| [last - x, y]),
            "left and right of theirs are exchanged (if its axes are left-handed: negate z in the scene)",
        ),
        (moved(&film, |x, y| [y, x]), "rows and columns of theirs are exchanged"),
        (moved(&film, |x, y| [x + 1, y]), "theirs is one pixel too far left"),
        (scaled(&film, std::f64::consts::PI), "theirs is ours divided by 1/π"),
        (
            Picture::of_film(&corners),
            "theirs is half a pixel too far left and half a pixel too far up (corners of pixels taken for centres)",
        ),
    ];
    for (picture, expected) in changes {
        let verdict = judged(&picture);
        assert_eq!(verdict.decision, Decision::Differs, "{expected}");
        let explained = verdict.explained.expect(expected);
        assert_eq!(explained.what, expected);
        assert!(explained.agrees, "{expected}: {explained:?}");
    }
}

/// Law: a picture that is one of ours is said to be that, and a correct one from another seed agrees, with what would
/// have been seen. Oracle: the seeds.
#[test]
fn our_own_pictures_agree() {
    let equal = judged(&Picture::of_film(&film(&noisy(), 3)));
    assert_eq!((equal.decision, equal.equal_to_seed), (Decision::Agrees, Some(3)));
    // at this level few other seeds or samplers would have it called wrong
    let strictness = Strictness { level: 0.005, ..STRICTNESS };
    let theirs = Picture::of_film(&film(&noisy(), 500));
    let honest = verdict(&noisy(), &[theirs], strictness);
    assert_eq!((honest.decision, honest.equal_to_seed), (Decision::Agrees, None), "{honest}");
    assert!(honest.plants.iter().any(|plant| plant.what == "half a pixel off" && plant.found));
    assert!(!honest.fixed);
}

/// Law: in a scene without random numbers, rounding agrees, and a single other pixel differs and is named, also in one of several
/// pictures. Oracle: the pixel that was changed.
#[test]
fn a_scene_without_noise_is_judged_by_rounding() {
    let scene = scene("ch14/set", SIZE, 1);
    let film = film(&scene, 500);
    let rounded = scaled(&film, 1.0 + 1e-6);
    let agrees = verdict(&scene, std::slice::from_ref(&rounded), STRICTNESS);
    assert!(agrees.fixed && agrees.decision == Decision::Agrees, "{agrees}");
    let mut changed = rounded.clone();
    let at = changed.index([20, 30]);
    changed.values[at][1] += 0.01;
    let differs = verdict(&scene, &[changed.clone()], STRICTNESS);
    assert!(differs.fixed && differs.decision == Decision::Differs, "{differs}");
    assert_eq!(differs.regions[0].worst, [20, 30]);
    assert_eq!(differs.set_apart, 0);
    for (other, decision) in [(rounded.clone(), Decision::Agrees), (changed, Decision::Differs)] {
        let found = verdict(&scene, &[rounded.clone(), other], STRICTNESS).decision;
        assert_eq!(found, decision, "two pictures");
    }
}

/// Law: who interrupts is told what is known by then, which is nothing with fewer than three pictures of ours. Oracle:
/// the number of pictures.
#[test]
fn an_interruption_ends_with_what_is_known() {
    let theirs = [scaled(&film(&noisy(), 500), 1.05)];
    let after = |count| interrupted(&noisy(), &theirs, STRICTNESS, count);
    assert!(after(2).is_none());
    let verdict = after(5).expect("five are enough to say something");
    assert_eq!((verdict.decision, verdict.replicas), (Decision::Undecided, 5));
    let text = verdict.to_string();
    assert!(text.contains("interrupted: so far, ") && text.contains(" of 5 pictures"), "{text}");
}

/// Law: of several pictures nothing is assumed of their noise: gains that differ from picture to picture, with the mean
/// 1, agree, where one picture alone differs; a gain of all of them differs. Oracle: the gains.
#[test]
fn several_pictures_may_have_any_noise() {
    let scene = noisy();
    let gains = [0.97, 1.012, 0.985, 1.027, 1.006];
    let with = |common: f64| -> Vec<Picture> {
        let films = films(&mut world(&scene, 1), 500..505);
        films.iter().zip(gains).map(|(film, gain)| scaled(film, gain * common)).collect()
    };
    assert_eq!(judged(&with(1.0)[0]).decision, Decision::Differs);
    let agrees = verdict(&scene, &with(1.0), STRICTNESS);
    assert_eq!(agrees.decision, Decision::Agrees, "{agrees}");
    let differs = verdict(&scene, &with(1.3), STRICTNESS);
    assert_eq!(differs.decision, Decision::Differs, "{differs}");
}

/// Law: a margin has three answers: within it, beyond it, and that the noise is too large; one area is enough for the
/// last two. Oracle: intervals by hand.
#[test]
fn a_margin_has_three_answers() {
    let area = |relative: Option<f64>, half: f64| Means {
        name: "an area".to_owned(),
        pixels: 1,
        ours: [1.0; 3],
        theirs: [1.0; 3],
        relative,
        half,
        channels: [Relative::default(); 3],
    };
    let within = area(Some(-0.004), 0.005);
    for (other, expected) in [
        (area(Some(0.0), 0.0099), Answer::Agrees),
        (area(None, 0.0), Answer::Agrees),
        (area(Some(0.004), 0.007), Answer::CannotTell),
        (area(Some(0.012), 0.005), Answer::CannotTell),
        (area(Some(0.016), 0.005), Answer::DiffersByMore),
        (area(Some(-0.016), 0.005), Answer::DiffersByMore),
    ] {
        let all = [within.clone(), other];
        assert_eq!(Means::within(&all, 0.01), expected, "{:?}", all[1]);
    }
}

/// Law: a file that says that it is encoded as sRGB, and is not, is told so, and nothing else is. Oracle: how it was stored.
#[test]
fn a_file_that_lies_about_its_encoding_is_told_so() {
    let scene = scene("ch14/set", SIZE, 1);
    let film = film(&scene, 500);
    for (gamma, name) in [(1.0, "linear"), (2.2, "gamma 2.2")] {
        let code = |radiance: f64| {
            ((255.0 * power(radiance.clamp(0.0, 1.0), 1.0 / gamma)).round() / 255.0) as f32
        };
        let values = film.pixels().iter().map(|color| color.to_array().map(code)).collect();
        let picture = Picture {
            values,
            transfer: Transfer::Srgb,
            step: Some(1.0 / 255.0),
            ..Picture::of_film(&film)
        };
        let how = (STRICTNESS, Some(Transfer::Srgb));
        let found = watched(&scene, &[picture], how, usize::MAX, (&Cell::new(0), &|_| {}));
        let line = found.expect("nobody interrupts").sentence();
        let expected =
            format!("differs: theirs is encoded as {name}, not as sRGB; it agrees but for that");
        assert!(line.starts_with(&expected), "{line}");
    }
}
