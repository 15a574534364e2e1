//! Windows of every size: each part has room, and nothing is out of reach.

use eframe::egui::epaint::text::FontsView;
use eframe::egui::{Color32, Rect, TextStyle, accesskit::Role, pos2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};

use crate::support::*;

/// The sizes of a laptop's window, of half a screen, and the smallest that the program allows.
const SIZES: [[f32; 2]; 3] = [[1400.0, 900.0], [900.0, 600.0], [800.0, 500.0]];

fn window_of([width, height]: [f32; 2]) -> (Window, Rect) {
    let mut window = open_sized(small_glass_sphere(), [width, height]);
    click(&mut window, ON_GLASS);
    (window, Rect::from_min_size(pos2(0.0, 0.0), vec2(width, height)))
}

fn picture(window: &Window) -> Rect {
    window.get_by_role_and_label(Role::Image, "picture").rect()
}

/// Shows the panel of the scene in a narrow window, too.
fn unfold(window: &mut Window) {
    if window.query_by_label("The scene").is_some() {
        push(window, "The scene");
    }
}

/// Law: in a window below 1,000 points the panel of the scene is folded away, which the picture gains, until its button is
/// clicked. Oracle: the places.
#[test]
fn a_narrow_window_folds_the_scene_away() {
    let (mut window, _) = window_of(SIZES[1]);
    let before = picture(&window);
    assert!(window.query_by_label("high lamp").is_none());
    unfold(&mut window);
    assert!(window.query_by_label("high lamp").is_some());
    assert!(before.width() > picture(&window).width() + 50.0);
    push(&mut window, "The scene");
    assert_eq!(picture(&window), before);
    assert!(window_of(SIZES[0]).0.query_by_label("The scene").is_none());
}

/// Law: every field and button of the bars is completely inside the window, and no two of them overlap.
#[test]
fn every_button_of_the_bars_is_whole() {
    let buttons = ["Open", "Save", "Explain", "Reset", "Whole", "1×", "4×", "12×", "?"];
    let fields = ["File", "Picture", "Pixel"];
    for size in SIZES {
        let (window, whole) = window_of(size);
        let mut rects: Vec<(&str, Rect)> = Vec::new();
        for name in buttons {
            rects.push((name, window.get_by_role_and_label(Role::Button, name).rect()));
        }
        for name in fields {
            rects.push((name, window.get_by_role_and_label(Role::TextInput, name).rect()));
        }
        for (i, (name, rect)) in rects.iter().enumerate() {
            assert!(whole.contains_rect(*rect), "{name} at {rect} of {size:?}");
            assert!(rect.width() >= 15.0, "{name} at {rect} of {size:?}");
            for (other, at) in &rects[..i] {
                assert!(!rect.shrink(1.0).intersects(*at), "{name} and {other} of {size:?}");
            }
        }
    }
}

/// Law: the bars beside the picture are wide enough to be hit, and dragging one moves the border
/// with the mouse; a double click moves it back; no drag can make a part vanish.
#[test]
fn the_bars_between_the_parts_can_be_grabbed() {
    let (mut window, whole) = window_of([1000.0, 700.0]);
    let before = picture(&window);
    let bar = |window: &Window| window.get_by_role_and_label(Role::Splitter, "right bar").rect();
    let width = bar(&window).width();
    assert!(width >= 6.0, "the bar is {width} wide");
    let drag_by = |window: &mut Window, by: f32| {
        let at = bar(window).center();
        drag(window, at, at + vec2(by, 0.0));
    };
    drag_by(&mut window, -80.0);
    let moved = before.right() - picture(&window).right();
    assert!((moved - 80.0).abs() < 3.0, "moved by {moved}, not 80");
    let at = bar(&window).center();
    double_click(&mut window, at);
    assert_eq!(picture(&window), before, "moved back");
    for by in [-2000.0, 2000.0] {
        drag_by(&mut window, by);
        let width = picture(&window).width();
        assert!(width > 0.25 * whole.width(), "{width} of {}", whole.width());
        let heading = window.get_by_label("Pixel (17, 19)").rect();
        assert!(heading.left() < 0.8 * whole.width(), "{heading} of {}", whole.width());
    }
}

/// Law: every setting of the scene's panel can be scrolled into view, also in a window that is enlarged by Ctrl-+; a
/// button at the end of a line needs no scrolling to the right.
#[test]
fn every_setting_of_the_scene_can_be_reached() {
    for size in [SIZES[0], SIZES[1], SIZES[2], [550.0, 350.0]] {
        let mut window = open_sized(small_glass_sphere(), size);
        unfold(&mut window);
        let panel = picture(&window).left() - 8.0;
        let first = window.get_all_by_label("only").next().expect("a light has one").rect();
        assert!(first.right() <= panel, "only at {first} of {size:?}");
        for (role, name) in [(Role::ComboBox, "Tracer"), (Role::ComboBox, "Routines")] {
            let of = |window: &Window| window.get_by_role_and_label(role, name).rect();
            window.get_by_role_and_label(role, name).scroll_to_me();
            window.run_steps(20);
            let rect = of(&window);
            assert!(rect.right() <= panel && rect.width() > 20.0, "{name} at {rect} of {size:?}");
        }
    }
}

/// Law: beside the rays of the tree all numbers stand whole, also in narrow windows; of the details no text, least of all a
/// term's factors, reaches over the edge. Oracle: the width of the text on one line; the right end of the window.
#[test]
fn numbers_are_not_cut() {
    for size in [SIZES[0], SIZES[1]] {
        let (window, whole) = window_of(size);
        let left = picture(&window).right();
        let font = TextStyle::Body.resolve(&window.ctx.global_style());
        let natural = |text: &str| {
            let layout = |fonts: &mut FontsView<'_>| {
                fonts.layout_no_wrap(text.to_owned(), font.clone(), Color32::WHITE).size().x
            };
            window.ctx.fonts_mut(layout)
        };
        let beside: Vec<_> = window.query_all_by_label_contains("weight ").collect();
        let beside: Vec<(String, Rect)> = beside
            .iter()
            .map(|node| (text_of(&node.accesskit_node()), node.rect()))
            .filter(|(text, _)| text.starts_with("weight ") || text.starts_with("inside, "))
            .filter(|(text, _)| !text.contains('×'))
            .collect();
        assert!(beside.len() >= 2, "{beside:?}");
        for (text, rect) in beside {
            let wanted = natural(&text);
            assert!(rect.width() > wanted - 1.5, "{text}: {rect} of {wanted}, {size:?}");
        }
        for node in window.query_all_by(|node| node.role() == Role::Label) {
            let (text, rect) = (text_of(&node.accesskit_node()), node.rect());
            let is_inside = rect.left() < left || rect.right() <= whole.right() - 7.0;
            assert!(is_inside, "{text}: {rect} of {size:?}");
        }
    }
}
