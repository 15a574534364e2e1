//! The rays of another program, by their log.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Parser;
use eframe::egui::{Key, accesskit::Role};
use egui_kittest::kittest::Queryable;
use groundtruth::rgb::Rgb;
use inspector::action::Shows;
use inspector::explanation::selection::Tab;
use inspector::window::arguments::Arguments;

use crate::support::*;
use crate::tree::copied;

/// A mirror above a floor in two pixels: one ray is mirrored, the other goes on as it came.
const LOG: &str = r#"{"rays": 1, "program": "a tracer", "size": [40, 20]}
{"object": "floor", "plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}}
{"pixel": [10, 10], "ray": 0, "kind": "camera", "origin": [0, 2, 0], "direction": [0.6, -0.8, 0], "t": 2.5, "object": "floor", "normal": [0, 1, 0], "radiance": 0.5}
{"pixel": [10, 10], "ray": 1, "parent": 0, "kind": "reflected", "origin": [1.5, 0, 0], "direction": [0.6, 0.8, 0], "weight": 0.5, "radiance": 1, "values": {"roughness": 0.25}}
{"pixel": [30, 10], "ray": 0, "kind": "camera", "origin": [0, 2, 0], "direction": [0.8, -0.6, 0], "t": 3.3333333333333335, "object": "floor", "normal": [0, 1, 0], "radiance": 0.25}
{"pixel": [30, 10], "ray": 1, "parent": 0, "kind": "reflected", "origin": [2.6666666666666665, 0, 0], "direction": [0.8, -0.6, 0], "weight": 0.25, "radiance": 1}
"#;
const HELD: [u32; 2] = [10, 10];
const BROKEN: [u32; 2] = [30, 10];

fn written(folder: &Path, text: &str) -> PathBuf {
    let path = folder.join("rays.jsonl");
    fs::write(&path, text).expect("written");
    path
}

fn open_log(folder: &Path, text: &str) -> Window {
    let log = written(folder, text);
    started(&Arguments::parse_from(["inspector", "--rays", log.to_str().expect("a name")]))
}

fn selected(window: &Window) -> (Option<[u32; 2]>, usize) {
    let selection = &window.state().selection;
    (selection.pixel, selection.tree.ray)
}

/// Law: a log opens at the first ray that breaks a law: its pixel is explained as the mean of what the log says, the ray is
/// selected and marked, its finding and its own fields are read below; another pixel of the log has no mark. A click beside a
/// logged pixel explains the nearest. Oracle: the log, by hand.
#[test]
fn a_log_opens_at_its_broken_ray() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = open_log(folder.path(), LOG);
    assert_eq!(selected(&window), (Some(BROKEN), 1));
    let answer = window.state().selection.explanation().expect("explained");
    assert_eq!((answer.radiance, answer.samples_per_pixel), (Rgb::grey(0.25), 1));
    let marked: Vec<usize> = window.state().selection.tree.found.keys().copied().collect();
    assert_eq!(marked, [1]);
    assert!(window.query_by_label_contains("line 6 of the log").is_some());
    assert!(window.get_all_by_label_contains("from the mirrored direction").next().is_some());

    click(&mut window, [12, 8]);
    assert_eq!(window.state().selection.pixel, Some(HELD));
    assert!(window.state().selection.tree.found.is_empty());
    let answer = window.state().selection.explanation().expect("explained");
    assert_eq!(answer.radiance, Rgb::grey(0.5));
    set(&mut window, |it| it.selection.go_to(1));
    assert!(window.query_by_label("roughness").is_some(), "a field of one's own");
    assert!(window.query_by_label("0.25").is_some());
}

/// Law: the section of the hit that a broken ray leaves draws where it should go, with its angle, whether the log names its
/// objects or not. Oracle: the mirrored direction, by hand.
#[test]
fn the_section_shows_where_a_ray_should_go() {
    let folder = tempfile::tempdir().expect("a folder");
    let rays = LOG.lines().filter(|line| !line.contains("plane"));
    let without: String = rays.map(|line| line.to_owned() + "\n").collect();
    for log in [LOG, &without] {
        let mut window = open_log(folder.path(), log);
        set(&mut window, |it| it.selection.tab = Tab::Section);
        let drawing = copied(&mut window, "Copy as SVG");
        for words in ["reflected ray 1", "ray 1 should go", "53.13°"] {
            assert!(drawing.contains(words), "{words}: {drawing}");
        }
        click(&mut window, HELD);
        set(&mut window, |it| it.selection.go_to(0));
        assert!(!copied(&mut window, "Copy as SVG").contains("should go"));
    }
}

/// Law: N goes from one broken ray to the next; the tab of checks has each law in one of three lists, and a click on a ray
/// there selects it. Oracle: the log with a third and a fourth pixel, by hand.
#[test]
fn broken_rays_are_found_one_after_the_other() {
    let folder = tempfile::tempdir().expect("a folder");
    let more: String =
        LOG.lines().skip(4).map(|line| line.replace("[30, 10]", "[5, 3]") + "\n").collect();
    let mut window = open_log(folder.path(), &format!("{LOG}{more}"));
    let mut seen = Vec::new();
    for _ in 0..3 {
        press(&mut window, Key::N);
        seen.push(selected(&window));
    }
    assert_eq!(seen, [(Some([5, 3]), 1), (Some(BROKEN), 1), (Some([5, 3]), 1)]);

    set(&mut window, |it| it.selection.tab = Tab::Checks);
    for list in ["Broken", "Held", "Not asked"] {
        assert!(window.query_by_label_contains(list).is_some(), "{list}");
    }
    click(&mut window, HELD);
    window.get_by_role_and_label(Role::Link, "(30, 10), ray 1 (reflected)").click();
    settle(&mut window);
    assert_eq!(selected(&window), (Some(BROKEN), 1));
}

/// Law: a log that names a scene of ours opens it; a pixel is explained from the log and by ours, and both add up to the same
/// numbers if the log is ours. Oracle: the log that our own explanation is written as.
#[test]
fn a_log_stands_beside_our_rays() {
    let entry = gallery::find("ch28/glass-sphere").expect("in the gallery");
    let (mut scene, pixel) = ((entry.build)(), [17, 19]);
    scene.image.resize(48, 48);
    let explained = explain::pixel(&scene, &built(&scene), pixel, None).expect("few rays");
    let folder = tempfile::tempdir().expect("a folder");
    let log = rays::log_of(&explained, (entry.name, [48, 48]), None);
    let mut window = open_log(folder.path(), &log);
    let inspector = window.state();
    assert_eq!(inspector.session.rendering.source.name(), entry.name);
    let logged = inspector.others.log().expect("a log");
    assert!(!logged.verdict.is_broken(), "{}", logged.verdict.text());
    assert_eq!(inspector.others.shown().map(|theirs| theirs.shows), Some(Shows::Theirs));
    let selection = &inspector.selection;
    assert_eq!(selection.pixel, Some(pixel));
    let (yours, ours) = (selection.explanation().expect("theirs"), selection.beside.explanation());
    let ours = ours.expect("ours");
    assert_eq!(ours.radiance, explained.radiance);
    let difference = yours.radiance - ours.radiance;
    assert!(difference.average().abs() <= 1e-12 * ours.radiance.average(), "{difference:?}");
    let of_sample = log.lines().filter(|line| line.contains(r#""sample":0"#)).count();
    assert_eq!(yours.samples[0].ray.as_ref().map(explain::RecordedRay::count), Some(of_sample));
    press(&mut window, Key::T);
    assert_eq!(window.state().others.shown().map(|theirs| theirs.shows), Some(Shows::Ours));
}

/// Law: a log that is written again is read again, its values too, and stays at its pixel; one that is being written, and has no ray yet, is
/// waited for. Oracle: the log with its mistake mended.
#[test]
fn a_log_is_followed() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = open_log(folder.path(), LOG);
    let is_broken =
        |window: &Window| window.state().others.log().map(|log| log.verdict.is_broken());
    assert_eq!(is_broken(&window), Some(true));
    set(&mut window, |it| it.selection.tab = Tab::Samples);
    let has_value = |window: &Window, value: &str| {
        window.query_by_label(&format!("{value}  sample 0, ray 0 (camera)")).is_some()
    };
    assert!(has_value(&window, "0.25"));
    let mended = LOG.replace(
        r#""direction": [0.8, -0.6, 0], "weight""#,
        r#""direction": [0.8, 0.6, 0], "weight""#,
    );
    let mended = mended.replace(": 0.25", ": 0.75");
    for text in ["", &mended] {
        written(folder.path(), text);
        let waited = std::time::Instant::now();
        while waited.elapsed() < std::time::Duration::from_millis(1500) {
            window.step();
            std::thread::sleep(std::time::Duration::from_millis(20));
        }
        settle(&mut window);
        assert!(is_broken(&window).is_some());
    }
    assert_eq!(is_broken(&window), Some(false));
    assert_eq!(window.state().selection.pixel, Some(BROKEN));
    assert!(has_value(&window, "0.75") && !has_value(&window, "0.25"));
}

/// Law: two logs stand beside each other: O changes from one to the other at the same pixel and ray, and the tab has the numbers
/// of both. Oracle: a log and the same with its mistake mended.
#[test]
fn two_logs_stand_beside_each_other() {
    let folder = tempfile::tempdir().expect("a folder");
    let mended =
        LOG.replace("-0.6, 0], \"weight\"", "0.6, 0], \"weight\"").replace("a tracer", "mended");
    let before = written(folder.path(), LOG);
    let after = folder.path().join("after.jsonl");
    fs::write(&after, mended).expect("written");
    let [after, before] = [&after, &before].map(|log| log.to_str().expect("a name"));
    let arguments = Arguments::parse_from(["inspector", "--rays", after, "--rays", before]);
    let mut window = started(&arguments);
    assert_eq!(selected(&window), (Some(BROKEN), 1));
    let name = |window: &Window| {
        let program = window.state().others.shown().and_then(|theirs| theirs.explained().cloned());
        program.map(|program| program.name.clone())
    };
    assert_eq!(name(&window).as_deref(), Some("a tracer"));
    window.key_press(Key::O);
    settle(&mut window);
    assert_eq!(name(&window).as_deref(), Some("mended"));
    assert_eq!(selected(&window), (Some(BROKEN), 1));
    window.state_mut().selection.tab = Tab::Beside;
    settle(&mut window);
    for text in ["mended", "a tracer", "(0.8, 0.6, 0.0)", "(0.8, -0.6, 0.0)"] {
        assert!(window.query_all_by_label(text).next().is_some(), "{text}");
    }
}
