//! Six states of the window, in three sizes and both themes: nothing moves between them, and texts are where they were.

use std::collections::BTreeMap;

use eframe::egui::{Key, Pos2, accesskit::Role};
use egui_kittest::kittest::{NodeT, Queryable};

use crate::support::*;

const SIZES: [[f32; 2]; 3] = [[900.0, 600.0], [1400.0, 900.0], [2560.0, 1440.0]];
/// What can be clicked, typed into or dragged.
const WIDGETS: [Role; 7] = [
    Role::Button,
    Role::ComboBox,
    Role::TextInput,
    Role::SpinButton,
    Role::Slider,
    Role::CheckBox,
    Role::Splitter,
];
const TABS: [&str; 6] = [TREE, "lower bar", "The ray", "The section", "The sum", "The samples"];
/// What stands above the rows of the tree.
const TREE: &str = "Follow the largest (L)";

/// Shows each state in a window of this size. The trees of all pixels have as many rows.
fn each_state(size: [f32; 2], is_light: bool, mut seen: impl FnMut(&str, &Window)) {
    let in_theme = |window: &mut Window| {
        if is_light {
            window.key_press(Key::B);
            window.run_steps(3);
        }
    };
    // hours of work
    let mut window = begin(small("ch28/glass-sphere", [600, 600], 10_000), size);
    window.run_steps(3);
    in_theme(&mut window);
    let at = on_screen(&window, [215, 240]);
    point_and_press(&mut window, at);
    wait_until(&mut window, "it is explained", |it| it.state().selection.explanation().is_some());
    window.run_steps(4);
    seen("begun", &window);
    drop(window);
    let mut window = open_sized(small_glass_sphere(), size);
    in_theme(&mut window);
    click(&mut window, ON_GLASS);
    let number = ray_of(&small_glass_sphere(), ON_GLASS, 0).largest_child().expect("glass").number;
    set(&mut window, |it| it.selection.go_to(number));
    seen("selected", &window);
    push(&mut window, "Copy");
    push(&mut window, "The pixel, all its digits");
    set(&mut window, |it| it.message = Some(("the file\nis broken".to_owned(), true)));
    seen("told", &window);
    set(&mut window, |it| it.message = None);
    push(&mut window, "Pin");
    click(&mut window, [17, 20]);
    seen("pinned", &window);
    push(&mut window, "Pin");
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut other = film(&window);
    other.set([3, 4], other.get([3, 4]) + groundtruth::rgb::Rgb::WHITE);
    let theirs = read(folder.path(), &other, "theirs.exr");
    set(&mut window, |it| it.others.add_picture(theirs));
    push(&mut window, "The section");
    seen("compared", &window);
    push(&mut window, "Judge");
    push(&mut window, "The verdict");
    seen("judged", &window);
}

/// The corners of what can be clicked, typed into or dragged, by its name and, of several of one name, its count; of the tree
/// only of the button above its rows, and without what is below the tabs. Two buttons that close something have no other name.
fn places(window: &Window) -> BTreeMap<(String, usize), Pos2> {
    let tree = window.get_by_label(TREE).rect();
    let mut found = BTreeMap::new();
    for node in window.query_all_by(|node| WIDGETS.contains(&node.role())) {
        let (name, rect) = (text_of(&node.accesskit_node()), node.rect());
        let is_above = rect.left() < tree.left() - 100.0 || rect.bottom() < tree.top();
        if name != "×" && (is_above || TABS.contains(&&*name)) {
            let count = (0..).find(|count| !found.contains_key(&(name.clone(), *count)));
            found.insert((name, count.expect("few")), rect.min);
        }
    }
    found
}

/// The texts of a window with their places, which it shows and the state before did not; without times and progress.
fn news(window: &Window, before: &mut Vec<String>) -> String {
    let mut lines = Vec::new();
    for node in window.query_all_by(|node| node.role() != Role::TextRun) {
        let it = node.accesskit_node();
        let (role, text) = (it.role(), text_of(&it));
        let is_time =
            text.starts_with("rendered in ") || text.ends_with(" s") || text == "many rays";
        if !(text.is_empty() || is_time || role == Role::ProgressIndicator) {
            let (at, size) = (node.rect().min.round(), node.rect().size().round());
            lines.push(format!("{at} {} {} {role:?}: {text}\n", size.x, size.y));
        }
    }
    let new: String = lines.iter().filter(|line| !before.contains(line)).cloned().collect();
    *before = lines;
    new
}

/// Law: a picture that becomes finished, the choice of a ray, a copy, a message, a pinned pixel, a comparison and its verdict
/// move no button, list, field or bar, in windows of every size; in the light theme all is where it is in the dark one. Oracle:
/// the places before. Golden: places and sizes of all texts, of each state those that are new in it.
#[test]
fn nothing_moves_between_states() {
    let mut all = String::new();
    for (size, is_light) in SIZES.map(|size| (size, false)).into_iter().chain([(SIZES[1], true)]) {
        let (mut corners, mut text, mut before) = (BTreeMap::new(), String::new(), Vec::new());
        each_state(size, is_light, |state, window| {
            text += &format!("== {size:?}, {state}\n{}", news(window, &mut before));
            let places = places(window);
            assert!(places.len() > 30, "{} places", places.len());
            // above the first tree many samples can be chosen from
            let is_same = |(name, _): &((String, usize), Pos2)| state != "begun" || name.0 != TREE;
            for (name, place) in places.into_iter().filter(is_same) {
                let was = *corners.entry(name.clone()).or_insert(place);
                assert_eq!(place, was, "{name:?} in {state}, {size:?}");
            }
        });
        match is_light {
            true => assert!(all.contains(&text), "the light theme: {text}"),
            false => all += &text,
        }
    }
    insta::assert_snapshot!(all);
}
