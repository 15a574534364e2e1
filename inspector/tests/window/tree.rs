//! The tree of rays: what matters is near the top, and each ray can be reached.

use std::time::{Duration, Instant};

use eframe::egui::{Key, OutputCommand, accesskit::Role};
use egui_kittest::kittest::{NodeT, Queryable};
use explain::{Outline, RecordedRay, Row};
use groundtruth::scene::{Depth, Scene, Tracer, Whitted};
use inspector::explanation::tree::MIN_SHARE;

use crate::support::*;

/// The glass sphere with a tree of hundreds of rays.
fn deep_glass_sphere() -> Scene {
    let mut scene = small_glass_sphere();
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 40 });
    scene
}

fn deep_window() -> (Window, RecordedRay) {
    let mut window = open(deep_glass_sphere());
    click(&mut window, ON_GLASS);
    let root = ray_of(&deep_glass_sphere(), ON_GLASS, 0);
    assert!(root.count() > 100, "only {} rays", root.count());
    (window, root)
}

/// How many times the ray's line is shown: in the tree and above the details.
fn lines(window: &Window, ray: &RecordedRay) -> usize {
    window.query_all_by_label(&ray.line()).count()
}

/// Law: rays with less than a hundredth of the light are folded into one line; a click on it shows them.
/// Oracle: the library's outline.
#[test]
fn small_rays_are_folded_until_they_are_asked_for() {
    let (mut window, root) = deep_window();
    let folded =
        Outline::folding_below(MIN_SHARE).rows(&root).into_iter().find_map(|row| match row {
            Row::Folded { parent, .. } => Some(parent),
            Row::Ray { .. } | Row::Local { .. } => None,
        });
    let parent = folded.expect("a deep tree has small rays");
    let small = root.path_to(parent).last().expect("a ray of the tree").children.clone();
    let small = small.iter().find(|ray| ray.share < MIN_SHARE).expect("it folds something");
    assert_eq!(lines(&window, small), 0);
    let first = window.get_all_by_label_contains("more rays from ").next().expect("a folded line");
    first.click();
    settle(&mut window);
    assert_eq!(lines(&window, small), 1, "{}", small.line());
}

/// Law: L steps down the path that carries the light, and from its end back to the camera's ray.
/// Oracle: the child with the largest share, found by hand.
#[test]
fn one_key_follows_the_light() {
    let (mut window, root) = deep_window();
    let mut ray = &root;
    for _ in 0..3 {
        press(&mut window, Key::L);
        let by_share = |a: &&RecordedRay, b: &&RecordedRay| a.share.total_cmp(&b.share);
        ray = ray.children.iter().max_by(by_share).expect("the path goes on");
        assert_eq!(window.state().selection.tree.ray, ray.number);
        assert_eq!(lines(&window, ray), 2, "in the tree and above the details");
    }
    for _ in 0..20 {
        press(&mut window, Key::L);
        if window.state().selection.tree.ray == 0 {
            return;
        }
    }
    panic!("the path has no end");
}

/// Law: a term names its ray by the ray's number in the tree; a click on it selects that ray. Oracle: the
/// library's explanation.
#[test]
fn the_ray_of_a_term_is_a_click_away() {
    let (mut window, root) = deep_window();
    let number = root.terms.iter().find_map(|term| term.ray).expect("glass sends rays on");
    push(&mut window, &format!("ray {number}"));
    assert_eq!(window.state().selection.tree.ray, number);
    let ray = *root.path_to(number).last().expect("it is in the tree");
    assert_eq!(lines(&window, ray), 2, "in the tree and above the details");
}

/// Law: what is copied reproduces the pixel: the command names scene, pixel, size, samples and seed,
/// and the probe's line is answered with the pixel; the
/// test has the bits of the sample. Oracle: the probe, the explanation.
#[test]
fn what_is_copied_reproduces_the_pixel() {
    let mut window = glass_window_at(ON_GLASS);
    let command = copied(&mut window, "The command for a terminal");
    assert_eq!(
        command,
        "groundtruth explain ch28/glass-sphere 17 19 --size 48x48 --samples 4 --tracer whitted --max-depth 5 --seed 1 --sample 0"
    );
    let line = copied(&mut window, "The probe's line");
    let answer = conform::probe::answer(&line);
    let answer: serde_json::Value = serde_json::from_str(&answer).expect("one line of JSON");
    let mean = answer["answer"]["mean"].as_array().expect("a colour");
    let expected = window.state().selection.explanation().expect("explained").radiance.to_array();
    let mean: Vec<f64> = mean.iter().filter_map(serde_json::Value::as_f64).collect();
    assert_eq!(mean, expected);
    let page = copied(&mut window, "A page for a class");
    assert!(page.starts_with("<!DOCTYPE html>") && page.contains("(17, 19)"), "{}", &page[..200]);
    let test = copied(&mut window, "A test in Rust");
    let sample = window.state().selection.explanation().expect("explained").radiances[0];
    let bits = sample.to_array().map(|channel| format!("{:#018x}", channel.to_bits()));
    assert!(test.contains("#[test]") && test.contains(&bits.join(", ")), "{test}");
    set(&mut window, |it| it.selection.sample = 2);
    let page = copied(&mut window, "A page for a class");
    assert!(page.contains("--sample 2") && page.contains("shows sample 2 of 4"), "{page}");
    let numbers = copied(&mut window, "All numbers of the selected ray");
    assert!(numbers.contains("\nt\t") && numbers.contains("\nrelative η\t1.5\n"), "{numbers}");
}

/// What a click on a button puts on the clipboard; the window says so.
pub fn copied(window: &mut Window, button: &str) -> String {
    window.run_steps(3);
    if window.query_by_label(button).is_none() {
        window.get_by_label("Copy").click();
        window.run_steps(3);
    }
    window.get_by_label(button).click();
    let start = Instant::now();
    // a page takes a while
    while start.elapsed() < Duration::from_secs(60) {
        window.step();
        std::thread::sleep(Duration::from_millis(2));
        let commands = &window.output().platform_output.commands;
        let text = commands.iter().find_map(|command| match command {
            OutputCommand::CopyText(text) => Some(text.clone()),
            _ => None,
        });
        if let Some(text) = text {
            window.run_steps(2);
            assert!(window.query_all_by_label("copied").next().is_some());
            return text;
        }
    }
    panic!("{button} copies nothing");
}

/// What assistive programs read of a window, without times: the role of each part, and its text, which is not broken into lines.
fn read_aloud(window: &Window) -> String {
    let mut lines = Vec::new();
    for node in window.query_all_by(|_| true) {
        let node = node.accesskit_node();
        let text = text_of(&node);
        let is_part = node.role() == Role::TextRun || text.starts_with("rendered in ");
        if !text.is_empty() && !is_part {
            lines.push(format!("{:?}: {text}\n", node.role()));
        }
    }
    lines.concat()
}

/// Golden: the texts of a window: of a ray that leaves glass, with all its numbers, its terms in letters and the lights that add
/// nothing; of the sum of a noisy pixel that sees a lamp, by lights and lobes; of an image on a globe and the histogram, under a tracer that leaves
/// out the lights.
#[test]
fn windows_read_as_before() {
    let mut glass = glass_window_at(ON_GLASS);
    let unlit = text_with(&glass, "lights add nothing");
    push(&mut glass, &unlit);
    let root = ray_of(&small_glass_sphere(), ON_GLASS, 0);
    push(&mut glass, &root.largest_child().expect("glass").line());
    push(&mut glass, "The section");
    push(&mut glass, "The ray");
    let mut noisy = open(small("ch26/cornell-box", [24, 24], 16));
    click(&mut noisy, [12, 3]);
    push(&mut noisy, "The sum");
    let mut globe = small("ch29/earth", [48, 48], 1);
    globe.tracer = Tracer::PathTrace(Depth { max_depth: 2 });
    let mut globe = open(globe);
    click(&mut globe, [24, 24]);
    let all = [glass, noisy, globe].each_ref().map(read_aloud);
    insta::assert_snapshot!(all.join("== another window\n"));
}
