//! The list of scenes, and the settings of the picture.

use std::time::{Duration, Instant};

use eframe::egui::{Key, accesskit::Role};
use egui_kittest::kittest::Queryable;
use groundtruth::explain::count;
use groundtruth::scene::{Depth, Intersect, Tracer};
use groundtruth::world::{MAX_SAMPLES, World};
use inspector::picture::view::View;
use inspector::window::picker::found;
use inspector::window::thumbnails;

use crate::support::*;

/// Clicks the button of the list of scenes and waits for it to be in place.
fn open_list(window: &mut Window) {
    window.get_by_label("Scene").click();
    window.run_steps(12);
}

/// Law: the list opens with the present scene in view. Thumbnails appear beside the names, and frames
/// do not wait for them.
#[test]
fn the_list_opens_at_the_present_scene_with_small_pictures() {
    let mut window = glass_window();
    open_list(&mut window);
    let row = window.get_by_role_and_label(Role::Button, "glass-sphere").rect();
    assert!(row.top() > 40.0 && row.bottom() < 790.0, "{row}");
    let start = Instant::now();
    let mut slowest = Duration::ZERO;
    while window.state().picker.thumbnails() < 3 {
        assert!(start.elapsed() < Duration::from_secs(60), "no small pictures");
        std::thread::sleep(Duration::from_millis(20));
        let frame = Instant::now();
        window.step();
        slowest = slowest.max(frame.elapsed());
    }
    // a frame takes a few milliseconds; a busy machine is given time
    assert!(slowest < Duration::from_secs(2), "{slowest:?}");
}

/// Law: below the name of a scene stands its description, in words of its own line. Oracle: the ink in the lower half of
/// each row in view, and none of it right of the list.
#[test]
fn a_row_of_the_list_has_the_description() {
    let mut window = glass_window();
    open_list(&mut window);
    let image = window.render().expect("drawn");
    let mut drawn = 0;
    for entry in gallery::scenes().filter(|entry| entry.name.starts_with("ch28/")) {
        let name = entry.name.trim_start_matches("ch28/");
        let Some(row) = window.query_by_role_and_label(Role::Button, name).map(|it| it.rect())
        else {
            continue;
        };
        let left = row.left() as u32 + thumbnails::SIZE[0] + 10;
        let lower = row.center().y as u32..row.bottom() as u32 - 3;
        let is_ink = |x: u32| lower.clone().any(|y| image.get_pixel(x, y).0[0] > 90);
        let inked = (left..row.right() as u32).filter(|&x| is_ink(x)).count();
        assert!(inked > 120, "{name}: ink in {inked} columns below its name");
        assert!(row.width() < 460.0, "{name}: {row}");
        drawn += 1;
    }
    assert!(drawn > 3, "{drawn} rows");
}

/// Law: the list keeps the scenes of a chapter, or those whose names or descriptions contain all typed words, a number
/// not inside another. First are names that begin with them, the shortest first, last those with the letters inside a
/// word; Enter opens the first. Oracle: names and descriptions of all scenes.
#[test]
fn typing_searches_the_list() {
    let ranked = |typed: &str| found(typed).iter().map(|entry| entry.name).collect::<Vec<_>>();
    let [refr, cornell] = ["refr", "cornell"].map(ranked);
    let first_inside = refr.iter().position(|name| name.contains("wireframe")).expect("found");
    assert!(refr.len() > first_inside && first_inside > 0, "{refr:?}");
    assert!(refr[first_inside..].iter().all(|name| name.contains("wireframe")), "{refr:?}");
    assert_eq!(cornell[0], "ch26/cornell-box");
    let names = |typed: &str| {
        let mut names = ranked(typed);
        names.sort_by_key(|name| gallery::scenes().position(|entry| entry.name == *name));
        names
    };
    let all: Vec<(&str, String)> =
        gallery::scenes().map(|entry| (entry.name, (entry.build)().about)).collect();
    let expected = |fits: &dyn Fn(&str, &str) -> bool| {
        let fitting = all.iter().filter(|(name, about)| fits(name, about));
        let fitting: Vec<&str> = fitting.map(|(name, _)| *name).collect();
        assert!(!fitting.is_empty() && fitting.len() < all.len());
        fitting
    };
    let lower = |about: &str, word: &str| about.to_lowercase().contains(word);
    let mirror = expected(&|name, about| name.contains("mirror") || lower(about, "mirror"));
    assert_eq!(names("Mirror"), mirror);
    let fresnel = expected(&|_, about| lower(about, "fresnel"));
    assert_eq!(names(" fresnel "), fresnel);
    let both = expected(&|name, about| name.starts_with("ch28/") && lower(about, "fresnel"));
    assert_eq!(names("28 fresnel"), both);
    assert_eq!(names("28"), expected(&|name, _| name.starts_with("ch28/")));
    let three_and_four =
        expected(&|name, _| name.starts_with("ch03/") || name.starts_with("ch04/"));
    assert_eq!(names("ch04 3"), three_and_four);
    assert_eq!(names("26.12"), ["ch26/cornell-box-global-trace", "ch26/cornell-box"]);
    assert_eq!(names("figure 16.10"), ["ch16/two-spheres"]);
    assert!(!names("6.10").contains(&"ch16/two-spheres"));
    assert_eq!(names("").len(), all.len());
    let mut window = glass_window();
    open_list(&mut window);
    let focused = window.get_all_by(|node| node.is_focused()).next().expect("it has the keys");
    focused.type_text("three-objects");
    window.step();
    press(&mut window, Key::Enter);
    assert_eq!(window.state().session.rendering.source.name(), "ch03/three-objects");
}

/// Law: the arrow keys move a choice that is in view, from the present scene; Enter opens it. Oracle: the order of the
/// scenes.
#[test]
fn arrow_keys_choose_a_scene_of_the_list() {
    let all: Vec<&str> = gallery::scenes().map(|entry| entry.name).collect();
    let at = all.iter().position(|name| *name == "ch28/glass-sphere").expect("in the gallery");
    let mut window = glass_window();
    open_list(&mut window);
    // far enough up to leave the visible part
    for _ in 0..30 {
        window.key_press(Key::ArrowUp);
    }
    window.run_steps(10);
    window.key_press(Key::ArrowDown);
    window.run_steps(10);
    let (_, name) = all[at - 29].split_once('/').expect("a chapter");
    let row = window.get_all_by_role_and_label(Role::Button, name).next().expect("in view").rect();
    assert!(row.top() > 40.0 && row.bottom() < 790.0, "{row}");
    window.key_press(Key::Enter);
    let name = |window: &Window| window.state().session.rendering.source.name();
    wait_until(&mut window, "it is opened", |window| name(window) == all[at - 29]);
}

/// Law: after words that no scene has, the list has its height again. Oracle: the rows in view before.
#[test]
fn the_list_has_its_height_again_after_a_search_in_vain() {
    let mut window = glass_window();
    open_list(&mut window);
    let type_text = |window: &mut Window, text: &str| {
        let focused = window.get_all_by(|node| node.is_focused()).next().expect("it has the keys");
        focused.type_text(text);
        window.run_steps(10);
    };
    type_text(&mut window, "ch28");
    // only rows that are in view are drawn
    let rows = |window: &Window| {
        let names = found("ch28").into_iter().filter_map(|entry| entry.name.split_once('/'));
        let is_drawn = |name: &str| window.query_by_role_and_label(Role::Button, name).is_some();
        names.filter(|(_, name)| is_drawn(name)).count()
    };
    let before = rows(&window);
    assert!(before > 3, "{before}");
    type_text(&mut window, "zz");
    assert!(window.query_by_label("no scene has this in its name and description").is_some());
    for _ in 0..2 {
        window.key_press(Key::Backspace);
    }
    window.run_steps(10);
    assert_eq!(rows(&window), before);
}

/// Law: a thumbnail has the proportions of its picture and is no larger than the space for it.
#[test]
fn thumbnails_fit_their_space() {
    let [max_width, max_height] = thumbnails::SIZE;
    for size in [[400, 400], [600, 100], [1, 5000], [3, 2]] {
        let [width, height] = thumbnails::fitting(size);
        let fits = (1..=max_width).contains(&width) && (1..=max_height).contains(&height);
        assert!(fits, "{size:?} is shown as {width} × {height}");
        assert!(width == max_width || height == max_height, "{size:?}");
    }
}

/// Law: 16 384 samples can be typed. Oracle: the library refuses only counts above its limit, which is
/// larger.
#[test]
fn many_samples_can_be_typed() {
    let mut scene = small_glass_sphere();
    scene.image.resize(1, 1);
    scene.image.samples = MAX_SAMPLES + 1;
    assert!(World::build(&scene).is_err());
    scene.image.samples = 1;
    let mut window = open(scene);
    type_number(&mut window, "Samples", "16384");
    assert_eq!(window.state().session.rendering.scene.image.samples, 16384);
    let status = text_with(&window, "16384 samples");
    assert_eq!(status, "1 × 1, 16384 samples");
}

/// Law: a width that is too large is refused with the number that was typed, and the picture stays. Oracle: that number.
#[test]
fn a_width_that_is_too_large_is_refused_as_typed() {
    let mut window = glass_window();
    type_number(&mut window, "Width", "4000000000");
    let (message, is_error) = window.state().message.clone().expect("a message");
    assert!(is_error && message.contains("4000000000"), "{message}");
    assert_eq!(window.state().session.rendering.size(), [48, 48]);
}

/// Law: the picture follows size, depth and seed; a seed is not rounded, and an invalid seed changes
/// nothing. Oracle: the library's rendering with the same settings.
#[test]
fn size_depth_and_seed_are_followed() {
    let mut window = glass_window();
    type_number(&mut window, "Width", "30");
    type_number(&mut window, "Height", "20");
    type_number(&mut window, "Max depth", "2");
    // the smallest positive integer that an `f64` cannot represent
    let seed = (1_u64 << 53) + 1;
    type_into(&mut window, "Seed", &seed.to_string());
    let mut scene = small_glass_sphere();
    scene.image.resize(30, 48);
    scene.image.resize(30, 20);
    if let groundtruth::scene::Tracer::Whitted(whitted) = &mut scene.tracer {
        whitted.max_depth = 2;
    }
    let world = World::build_seeded(&scene, "".as_ref(), seed).expect("the scene is valid");
    let film = film(&window);
    assert_eq!(window.state().session.rendering.size(), [30, 20]);
    assert_eq!(film.pixels(), groundtruth::render::render(&world).pixels());
    type_into(&mut window, "Seed", "seven");
    assert_eq!(window.state().session.rendering.world.seed, seed);
}

/// Law: one control switches between the library's and the book's intersection routines. Oracle: the
/// library's rendering of the scene with all objects intersected that way.
#[test]
fn intersections_are_switched() {
    let mut scene = small("ch19/lost-roots", [32, 32], 1);
    let mut window = open(scene.clone());
    let mut shown = Vec::new();
    for intersect in [Intersect::Robust, Intersect::Textbook] {
        window.get_by_label("Routines").click();
        window.run_steps(3);
        push(&mut window, intersect.name());
        scene.set_intersections(intersect);
        let film = film(&window);
        assert_eq!(film.pixels(), groundtruth::render::render(&built(&scene)).pixels());
        shown.push(film.pixels().to_vec());
    }
    assert_ne!(shown[0], shown[1], "the textbook's roots are lost");
}

/// Law: the whole picture fills its area along one side; a scale of at least two points per pixel is
/// rounded down to a whole number.
#[test]
fn the_whole_picture_fills_its_area() {
    let area = eframe::egui::Rect::from_min_max([200.0, 90.0].into(), [880.0, 790.0].into());
    for (size, scale) in [([400, 400], 1.7), ([300, 300], 2.0), ([12, 12], 56.0), ([1360, 9], 0.5)]
    {
        let placement = View::WHOLE.place(area, size);
        assert!((placement.scale - scale).abs() < 1e-6, "{} of {size:?}", placement.scale);
    }
}

/// Law: a count of one has the singular.
#[test]
fn a_count_of_one_has_the_singular() {
    let words = [1, 0, 2].map(|n| count(n, "ray"));
    assert_eq!(words, ["1 ray", "0 rays", "2 rays"]);
    let mut scene = small_glass_sphere();
    scene.image.samples = 1;
    let window = open(scene);
    assert!(window.query_by_label("48 × 48, 1 sample").is_some());
}

/// Law: the window says which lights the tracer leaves out, without a click on the black picture. Oracle: the
/// scene's own lights, of which `path_trace` can meet none.
#[test]
fn lights_that_the_tracer_leaves_out_are_named() {
    let mut scene = small_glass_sphere();
    assert!(!scene.lights.is_empty());
    scene.tracer = Tracer::PathTrace(Depth { max_depth: 2 });
    let names: Vec<String> = scene.lights.iter().map(|light| light.name.clone()).collect();
    let window = open(scene);
    for name in names {
        text_with(&window, &format!("path_trace leaves out the light \"{name}\""));
    }
}
