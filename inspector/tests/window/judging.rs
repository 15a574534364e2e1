//! The verdict on another program's picture.

use std::path::Path;

use eframe::egui::Key;
use egui_kittest::kittest::{NodeT, Queryable};
use groundtruth::film::{self, Film, Tone};
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::world::{DEFAULT_SEED, World};
use inspector::action::Shows;
use inspector::comparison::theirs::Theirs;
use judge::verdict::{Case, Decision, Strictness, Verdict};
use pictures::compare::Picture;

use crate::support::*;

/// A scene with noise, in so few pixels that a verdict takes a moment.
fn noisy() -> Scene {
    small("ch18/rectangle", [16, 16], 4)
}

/// Column, row, columns and rows of the brighter patch, on the ground; a tile of the verdict.
const PATCH: [u32; 4] = [4, 10, 2, 2];

/// Our picture of another seed, much brighter in the patch.
fn brighter() -> Film {
    let world = World::build_seeded(&noisy(), Path::new(""), 77).expect("the scene is valid");
    let mut film = render::render(&world);
    let [x, y, w, h] = PATCH;
    for at in (y..y + h).flat_map(|row| (x..x + w).map(move |column| [column, row])) {
        film.set(at, film.get(at) + Rgb::grey(30.0));
    }
    film
}

/// Writes a picture and reads it, as the program does; it is also returned as the command reads it.
fn written(film: &Film) -> (Theirs, Picture) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("theirs.exr");
    film::write(film, &Tone::PLAIN, &path).expect("written");
    let picture = Picture::read(&path, None).expect("it is a picture");
    (Theirs::read(&path, None).expect("it is a picture"), picture)
}

/// A window on a scene that is compared with this picture.
fn held_against(scene: Scene, theirs: Theirs) -> Window {
    let mut window = begin(scene, [1280.0, 800.0]);
    window.state_mut().others.add_picture(theirs);
    window
}

/// The verdict of the command with its defaults.
fn of_command(picture: &Picture) -> Verdict {
    let (scene, mut world) = (noisy(), built(&noisy()));
    let strictness = Strictness { level: 0.01, first: 8 };
    let case = Case { strictness, ..Case::new(&scene, Path::new(""), DEFAULT_SEED) };
    let renders = &mut |world: &World, canvas: &render::Canvas| {
        canvas.render(world);
        true
    };
    case.verdict(&mut world, std::slice::from_ref(picture), renders).expect("nobody interrupts")
}

/// Judges the brighter picture.
fn judged() -> Window {
    let mut window = held_against(noisy(), written(&brighter()).0);
    settle(&mut window);
    push(&mut window, "Judge");
    window
}

/// Law: nothing is judged before the button is pressed; then the bar says the command's verdict, and the map of z is
/// the command's in the page's greys. Oracle: the verdict of the command's defaults and seed; the formula of the greys.
#[test]
fn the_verdict_is_that_of_the_command() {
    let (theirs_now, picture) = written(&brighter());
    let mut window = held_against(noisy(), theirs_now);
    settle(&mut window);
    assert!(theirs(&window).judgement.verdict().is_none());
    assert!(window.get_by_label("Map of z").accesskit_node().is_disabled());
    push(&mut window, "Judge");

    let expected = of_command(&picture);
    assert_eq!(expected.decision, Decision::Differs);
    let z = expected.regions[0].z.expect("the scene has noise");
    assert!(text_with(&window, "differs: ").ends_with(&format!(", z = {z:+.1}")));
    let verdict = theirs(&window).judgement.verdict().expect("it is judged");
    assert_eq!(verdict.to_string(), expected.to_string());
    assert_eq!(verdict.shown.z, expected.shown.z);

    push(&mut window, "Map of z");
    // not under a frame or a number
    let free: Vec<[u32; 2]> = [[5, 11], [5, 10], [2, 12], [12, 4], [14, 14], [8, 9]].into();
    let corners: Vec<[usize; 2]> =
        expected.regions.iter().map(|region| [region.bounds[0], region.bounds[1]]).collect();
    let mut seen = std::collections::BTreeSet::new();
    for at in free {
        let [x, y] = at.map(|along| along as usize);
        assert!(!corners.contains(&[x, y]), "{at:?} is under a number");
        let grey = 0.5 + 0.5 * (expected.shown.z[16 * y + x] / 6.0).clamp(-1.0, 1.0);
        let byte = (255.0 * grey).round() as u8;
        assert_eq!(shown(&mut window, at), [byte; 3], "{at:?}");
        seen.insert(byte);
    }
    assert!(seen.len() > 2, "{seen:?}");
}

/// Law: a brighter patch gets a region whose box has all of it and nothing more; a click on the number over
/// the picture explains its worst pixel. Oracle: where the patch was planted.
#[test]
fn a_click_on_a_region_explains_its_worst_pixel() {
    let mut window = judged();
    let [x, y, w, h] = PATCH.map(|along| along as usize);
    let regions = theirs(&window).judgement.verdict().expect("it is judged").regions.clone();
    let found = regions.iter().position(|region| region.bounds == [x, y, w, h]);
    let found = found.expect("a region of the patch");
    let worst = regions[found].worst.map(|along| along as u32);
    let inside = |at: u32, from: u32, length: u32| (from..from + length).contains(&at);
    assert!(inside(worst[0], PATCH[0], PATCH[2]) && inside(worst[1], PATCH[1], PATCH[3]));

    let tag = window.get_by_label(&format!("region {}", found + 1)).rect();
    let patch = window.state().picture.placement([16, 16]).part([PATCH[0], PATCH[1]], [2, 2]);
    assert_eq!(tag.right_top(), patch.right_top());
    // the frame: orange at the middle of the right side
    let [r, g, b] = color_at(&mut window, patch.right_center());
    assert!(r > 200 && (80..180).contains(&g) && b < 80, "({r}, {g}, {b})");
    click_at(&mut window, tag.center());
    assert_eq!(window.state().selection.pixel, Some(worst));
    assert!(window.query_by_label(&format!("Pixel ({}, {})", worst[0], worst[1])).is_some());
}

/// Law: another picture of ours drops the verdict and its map. Oracle: the state before the judgement.
#[test]
fn another_picture_drops_the_verdict() {
    let mut window = judged();
    press(&mut window, Key::Z);
    assert_eq!(theirs(&window).shows, Shows::Map);
    type_number(&mut window, "Samples", "9");
    assert!(theirs(&window).judgement.verdict().is_none());
    assert_eq!(theirs(&window).shows, Shows::Ours);
    assert!(window.get_by_label("Map of z").accesskit_node().is_disabled());
    assert!(window.query_by_label_contains("differs: ").is_none());
    press(&mut window, Key::Z);
    assert_eq!(theirs(&window).shows, Shows::Ours, "there is no map");
}

/// Law: a judgement that is stopped says so. (It takes far longer than the frames between both clicks.)
#[test]
fn a_stopped_judgement_says_so() {
    let mut scene = noisy();
    scene.image.resize(32, 32);
    scene.image.samples = 256;
    let mut window = held_against(scene, written(&Film::new(32, 32)).0);
    settle(&mut window);
    window.get_by_label("Judge").click();
    window.run_steps(2);
    // 1 of 100 could be farther out by chance
    text_with(&window, " of at most 99 pictures of ours");
    window.get_by_label("Stop").click();
    window.run_steps(3);
    wait_until(&mut window, "it is stopped", |window| !theirs(window).judgement.is_busy());
    window.run_steps(2);
    text_with(&window, "interrupted");
}

/// Law: what the command refuses is refused with its reason. Oracle: the pixel that was made none.
#[test]
fn a_picture_with_a_value_that_is_no_number_is_refused() {
    let mut film = brighter();
    film.set([7, 3], Rgb::new(0.5, f64::NAN, 0.5));
    let mut window = held_against(noisy(), written(&film).0);
    settle(&mut window);
    push(&mut window, "Judge");
    text_with(&window, "pixel 7, 3 is [0.5, NaN, 0.5]; radiance is finite");
}
