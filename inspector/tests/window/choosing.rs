//! The list of scenes, and the settings of the picture.

use eframe::egui::{Key, accesskit::Role};
use egui_kittest::kittest::Queryable;
use gallery::ranked as found;
use groundtruth::scene::Intersect;
use groundtruth::world::World;

use crate::support::*;

/// Clicks the button of the list of scenes and waits for it to be in place.
fn open_list(window: &mut Window) {
    window.get_by_label("Scene").click();
    window.run_steps(12);
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
    type_text(&mut window, "three-objects");
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
        assert_eq!(film.pixels(), rendered(&scene).pixels());
        shown.push(film.pixels().to_vec());
    }
    assert_ne!(shown[0], shown[1], "the textbook's roots are lost");
}
