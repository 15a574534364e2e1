//! The scene beside itself with another value of a field, beside another scene, and beside an earlier state.

use eframe::egui::{Key, Modifiers, accesskit::Role};
use egui_kittest::kittest::Queryable;
use groundtruth::scene::Scene;
use inspector::action::Shows;
use inspector::scene::fields::{self, Change};
use std::path::Path;
use text::brief::short;

use crate::support::*;

/// The small glass sphere with water in place of glass, changed as text.
fn water() -> Scene {
    let text = scenefile::to_toml(&small_glass_sphere()).expect("plain data");
    assert_eq!(text.matches("eta = 1.5\n").count(), 1);
    let text = text.replace("eta = 1.5\n", "eta = 1.33\n");
    scenefile::parse(text, Path::new("")).expect("valid").0
}

/// Opens the menu; its field has the keys.
fn open_menu(window: &mut Window) {
    window.get_by_role_and_label(Role::Button, "Compare with …").click();
    window.run_steps(8);
}

/// Types into the field that has the keys, in place of what is there, and Enter.
fn enter(window: &mut Window, text: &str) {
    press_with(window, Modifiers::COMMAND, Key::A);
    type_text(window, text);
    press(window, Key::Enter);
}

/// Law: a field that is chosen in the menu is put into its line, its value selected; the value that is typed over it gives
/// another picture of the scene, with that value. A click explains the pixel in both: both values and their difference are
/// shown, T flips the trees, and each adds up to its own pixel. Oracle: the scene changed as text, rendered and explained
/// without a window.
#[test]
fn a_field_with_another_value_is_compared() {
    let [ours, with_water] = [small_glass_sphere(), water()].map(|scene| rendered(&scene));
    let mut window = glass_window_at(ON_GLASS);
    open_menu(&mut window);
    type_text(&mut window, "inside.eta");
    window.get_by_role_and_label(Role::Button, &format!("{ETA} = 1.5")).click();
    window.run_steps(4);
    type_text(&mut window, "1.33");
    press(&mut window, Key::Enter);

    assert_eq!((&*theirs(&window).name, theirs(&window).shows), ("eta = 1.33", Shows::Swipe));
    let [a, b] = [&ours, &with_water].map(|film| film.get(ON_GLASS));
    assert_ne!(a, b);
    assert_eq!(theirs(&window).pixels.radiance(ON_GLASS), Some(b));
    let selection = &window.state().selection;
    assert_eq!(selection.explanation().expect("explained").radiance, a);
    assert_eq!(selection.beside.explanation().expect("explained").radiance, b);
    assert!(window.query_by_label(&format!("eta = 1.33: {}", short(b))).is_some());
    assert!(window.query_by_label(&format!("eta = 1.33 − ours: {}", short(b - a))).is_some());
    press(&mut window, Key::T);
    assert!(window.query_by_label_contains("With eta = 1.33 the mean of").is_some());
    let with_water = explain::sample(&water(), &built(&water()), ON_GLASS, 0);
    let line = with_water.ray.expect("it sees").largest_child().expect("glass").line();
    assert!(window.query_all_by_label(&line).next().is_some(), "{line}");
    assert!(window.query_by_label("= the pixel of the picture, bit for bit").is_some());
    assert_eq!(window.state().selection.explanation().expect("explained").radiance, b);
}

/// Law: words that only one field has stand for its path. Oracle: the scene changed as text, rendered without a window.
#[test]
fn words_of_one_field_stand_for_its_path() {
    let mut window = glass_window_at(ON_GLASS);
    open_menu(&mut window);
    enter(&mut window, "eta=1.33");
    text_with(&window, " fields have these words");
    enter(&mut window, "inside.eta=1.33");
    assert_eq!(theirs(&window).pixels.radiance(ON_GLASS), Some(rendered(&water()).get(ON_GLASS)));
}

/// Law: side by side stand the numbers of the selected ray in both, ours first, whichever is shown. Oracle: the angles of
/// refraction that the library explains.
#[test]
fn the_selected_ray_is_shown_side_by_side() {
    let mut window = glass_window_at(ON_GLASS);
    open_menu(&mut window);
    enter(&mut window, &format!("{ETA} = 1.33"));
    push(&mut window, "Side by side");
    let angle = |scene: &Scene| {
        let hit = ray_of(scene, ON_GLASS, 0).hit.expect("glass");
        let angle = hit.optics.and_then(|it| it.angle_of_refraction).expect("it refracts");
        text::digits::shortened(&format!("{angle:?}°"))
    };
    let angles = [angle(&small_glass_sphere()), angle(&water())];
    assert_ne!(angles[0], angles[1]);
    for _ in 0..2 {
        let [ours, theirs] = angles.each_ref().map(|angle| window.get_by_label(angle).rect());
        assert!(ours.right() < theirs.left(), "{ours} {theirs}");
        assert!((ours.center().y - theirs.center().y).abs() < 1.0, "one row");
        press(&mut window, Key::T);
    }
    push_button(&mut window, "×");
    assert!(window.query_by_label("Side by side").is_none());
}

/// Law: side by side names the first ray whose own numbers differ, not those that sum up later rays, and a click selects it.
/// Oracle: the first ray of the library's two trees, from the camera on, with another weight.
#[test]
fn the_first_ray_with_other_numbers_is_one_click_away() {
    let scene = small_glass_sphere();
    let is_kr =
        |it: &Change| it.path.starts_with("materials.red sphere.") && it.path.ends_with(".kr");
    let change = fields::all(&scene).into_iter().find(is_kr).expect("a field");
    let change = Change { value: "0.5".to_owned(), ..change };
    let other = change.applied(&scene).expect("valid");
    let trees = [&scene, &other].map(|scene| ray_of(scene, ON_GLASS, 0));
    let [rays, others] = [trees[0].rays(), trees[1].rays()];
    let pairs = rays.iter().zip(&others);
    let first = pairs.filter(|(a, b)| a.weight != b.weight).map(|(a, _)| a.number).min();
    let first = first.filter(|number| *number > 0).expect("behind the glass");
    let mut window = glass_window_at(ON_GLASS);
    open_menu(&mut window);
    enter(&mut window, &change.to_string());
    push(&mut window, "Side by side");
    push(&mut window, &format!("ray {first} is the first whose own numbers differ"));
    assert_eq!(window.state().selection.tree.ray, first);
}

/// Law: a state that is kept, with what was changed until then, stays as it was while ours is changed further. Oracle: both
/// films.
#[test]
fn a_kept_state_stays() {
    let mut kept = small_glass_sphere();
    kept.lights[2].enabled = false;
    let before = rendered(&kept);
    let mut window = glass_window();
    push(&mut window, "front lamp");
    open_menu(&mut window);
    push_button(&mut window, "This state");
    let comparison = theirs(&window).comparison(&window.state().session.rendering);
    assert_eq!(comparison.map(|it| it.differing), Some(0));
    push(&mut window, "high lamp");
    let mut without = kept;
    without.lights[1].enabled = false;
    assert_eq!(film(&window).pixels(), rendered(&without).pixels());
    for y in 0..48 {
        assert_eq!(theirs(&window).pixels.radiance([24, y]), Some(before.get([24, y])));
    }
    assert_eq!(theirs(&window).name, "state 1");
}

/// Law: another scene is compared at the size of ours; a name that no scene has is an error in the menu, which stays open; a
/// value that a field does not take is a message, and the picture goes again. Oracle: the other scene, resized and rendered.
#[test]
fn another_scene_is_compared() {
    let mut window = glass_window();
    open_menu(&mut window);
    enter(&mut window, "ch28/no-such-scene");
    assert!(window.query_by_label_contains("ch28/no-such-scene").is_some());
    assert_eq!(window.state().others.count(), 0);
    enter(&mut window, "ch03/single-sphere");
    let mut other = (gallery::find("ch03/single-sphere").expect("in the gallery").build)();
    other.image.resize(48, 48);
    let other = rendered(&other);
    assert_eq!(theirs(&window).name, "ch03/single-sphere");
    for y in 0..48 {
        assert_eq!(theirs(&window).pixels.radiance([24, y]), Some(other.get([24, y])));
    }

    open_menu(&mut window);
    enter(&mut window, &format!("{ETA} = -1"));
    let (text, is_error) = window.state().message.clone().expect("a message");
    assert!(is_error && text.contains("eta") && text.contains("-1"), "{text}");
    assert_eq!(window.state().others.count(), 1);
}

/// Law: every field that is listed takes its own value, which changes nothing; a wrong path names what there is. Oracle: the
/// scene as it was, in the words of a scene file.
#[test]
fn every_field_takes_its_own_value() {
    for entry in ["ch28/glass-sphere", "ch19/lost-roots", "ch26/cornell-box"] {
        let scene = (gallery::find(entry).expect("in the gallery").build)();
        let all = fields::all(&scene);
        assert!(all.len() > 20, "{entry}: {}", all.len());
        for change in all {
            let same = change.applied(&scene).unwrap_or_else(|error| panic!("{entry}: {error}"));
            assert_eq!(scenefile::to_toml(&same).ok(), scenefile::to_toml(&scene).ok(), "{change}");
        }
    }
    let scene = small_glass_sphere();
    let changed = |text: &str| Change::parse(text).expect("path = value").applied(&scene);
    let eta = changed(&format!("{ETA} = 2")).expect("a number");
    assert!(scenefile::to_toml(&eta).expect("plain data").contains("eta = 2.0\n"));
    for (wrong, named) in [
        ("materials.glas.recipe = 1", "glass sphere"),
        ("no.such = 1", "materials"),
        ("image.no_such = 1", "no_such"),
        ("image.width = wide", "wide"),
        ("image.width = ", "no value"),
        (" = 1", "a field has a name"),
    ] {
        let error = changed(wrong).expect_err(wrong);
        assert!(error.contains(named), "{wrong}: {error}");
    }
}
