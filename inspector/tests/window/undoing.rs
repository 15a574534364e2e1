//! Pixels and changes of the scene that one goes back to, compares and drags; files that are read or have an error.

use eframe::egui::{Key, Modifiers, accesskit::Role, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use inspector::action::With;
use inspector::explanation::beside;
use text::brief::short;

use crate::support::*;

/// Law: a pinned pixel stands beside the one that is selected next: its value, a tab with the numbers of both, and the first
/// rays that end elsewhere, which a click selects; P lets it go. Oracle: the library's two trees.
#[test]
fn two_pixels_are_compared() {
    let other = [6, 6];
    let mut window = glass_window_at(ON_GLASS);
    push_button(&mut window, "Pin");
    click(&mut window, other);
    let pinned = rendered(&small_glass_sphere()).get(ON_GLASS);
    assert!(window.query_by_label(&format!("pinned (17, 19): {}", short(pinned))).is_some());
    push(&mut window, "Side by side");
    for name in ["(6, 6)", "(17, 19)"] {
        assert!(window.query_by_label(name).is_some(), "{name}");
    }
    let [this, that] = [other, ON_GLASS].map(|pixel| ray_of(&small_glass_sphere(), pixel, 0));
    let [here, _] = beside::parting(&this, &that).expect("glass and ground");
    push(&mut window, &format!("ray {} is the first that ends elsewhere", here.number));
    assert_eq!(window.state().selection.tree.ray, here.number);
    press(&mut window, Key::P);
    assert!(window.query_by_label("Side by side").is_none());
    assert_eq!(window.state().selection.pixel, Some(other));
}

/// Law: back and forward go through the pixels that were selected; of steps by arrow keys the last one is kept; a pixel that
/// is selected after going back ends the way forward. Oracle: a browser.
#[test]
fn one_goes_back_and_forward_through_pixels() {
    let [a, b, c] = [[10, 10], [20, 20], [30, 30]];
    let mut window = glass_window_at(a);
    click(&mut window, b);
    for _ in 0..3 {
        press(&mut window, Key::ArrowRight);
    }
    let at = |window: &Window| window.state().selection.pixel.expect("one is selected");
    assert_eq!(at(&window), [23, 20]);
    for (key, pixel) in [
        (Key::ArrowLeft, b),
        (Key::ArrowLeft, a),
        (Key::ArrowLeft, a),
        (Key::ArrowRight, b),
        (Key::ArrowRight, [23, 20]),
        (Key::ArrowRight, [23, 20]),
    ] {
        press_with(&mut window, Modifiers::ALT, key);
        assert_eq!(at(&window), pixel);
    }
    push_button(&mut window, "‹");
    assert_eq!(at(&window), b);
    click(&mut window, c);
    press_with(&mut window, Modifiers::ALT, Key::ArrowRight);
    assert_eq!(at(&window), c);
    push_button(&mut window, "‹");
    assert_eq!(at(&window), b);
}

/// Law: Ctrl-Z undoes the last change of the scene, Ctrl-Y does it again; a change after that ends the way forward, and one
/// that could not be built is none. Oracle: the library's pictures.
#[test]
fn changes_of_the_scene_are_undone() {
    let mut window = glass_window();
    let sized = |width: u32, samples: u32| {
        let mut scene = small_glass_sphere();
        scene.image.resize(width, 48);
        scene.image.samples = samples;
        rendered(&scene)
    };
    type_number(&mut window, "Width", "50");
    type_number(&mut window, "Samples", "9");
    type_number(&mut window, "Width", "4000000000");
    assert!(window.state().message.is_some(), "too wide");
    window.key_press(Key::Escape);
    let steps = [
        (Key::Z, [50, 4]),
        (Key::Z, [48, 4]),
        (Key::Z, [48, 4]),
        (Key::Y, [50, 4]),
        (Key::Y, [50, 9]),
    ];
    for (key, [width, samples]) in steps {
        press_with(&mut window, Modifiers::COMMAND, key);
        assert!(film(&window) == sized(width, samples), "{width} × 48, {samples} samples");
    }
    push(&mut window, "Undo");
    assert!(film(&window) == sized(50, 4));
    type_number(&mut window, "Samples", "16");
    press_with(&mut window, Modifiers::COMMAND, Key::Y);
    assert!(film(&window) == sized(50, 16), "nothing to do again");
}

/// Law: a number of the scene that is dragged in the panel changes the explained pixel while the mouse is down, and the whole
/// drag is undone at once. Oracle: the scene with the value that is shown, explained by the library.
#[test]
fn a_number_is_dragged_and_the_pixel_follows() {
    let mut window = glass_window_at(ON_GLASS);
    push(&mut window, "Numbers");
    let field = window
        .get_all_by_role(Role::TextInput)
        .find(|node| node.accesskit_node().placeholder() == Some("words of a path"))
        .expect("a search")
        .rect()
        .center();
    point_and_press(&mut window, field);
    window.step();
    type_text(&mut window, "inside.eta");
    let label = window.get_by_label(ETA).rect();
    let numbers = window.get_all_by_role(Role::SpinButton).map(|node| node.rect());
    let below =
        numbers.filter(|it| it.top() > label.top()).min_by(|a, b| a.top().total_cmp(&b.top()));
    let at = below.expect("its number").center();
    let value = |window: &Window| {
        explain::pixel(
            &window.state().session.rendering.scene,
            &*window.state().session.rendering.world,
            ON_GLASS,
            None,
        )
        .expect("few rays")
        .radiance
    };
    let before = value(&window);
    window.hover_at(at);
    window.drag_at(at);
    window.step();
    for step in 1..=12 {
        window.hover_at(at - vec2(4.0 * step as f32, 0.0));
        window.step();
    }
    let is_other = |window: &Window| {
        let explained = window.state().selection.explanation().map(|answer| answer.radiance);
        value(window) != before && explained == Some(value(window))
    };
    wait_until(&mut window, "the pixel follows", is_other);
    window.drop_at(at - vec2(48.0, 0.0));
    settle(&mut window);
    let eta_now = scenefile::to_toml(&window.state().session.rendering.scene).expect("plain data");
    assert!(!eta_now.contains("eta = 1.5\n"), "{eta_now}");
    push(&mut window, "Undo");
    assert_eq!(value(&window), before);
}

/// Law: while a file is read, the window says which. Oracle: a large file, which ends too early.
#[test]
fn what_is_read_is_said() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("large.ppm");
    std::fs::write(&path, format!("P3 2000 2000 255\n{}", "1 ".repeat(11_000_000)))
        .expect("written");
    let mut window = glass_window();
    let ctx = window.ctx.clone();
    let inspector = window.state_mut();
    inspector.others.perform(&ctx, &mut inspector.session, With::Picture(path.clone()));
    window.step();
    let said = format!("reading {}", path.display());
    assert!(window.query_by_label(&said).is_some());
    settle(&mut window);
    assert!(window.query_by_label(&said).is_none());
    assert!(window.state().message.is_some(), "it ends too early");
}
