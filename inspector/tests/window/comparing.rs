//! Another program's picture compared with ours.

use std::path::Path;

use eframe::egui::{Key, pos2, vec2};
use egui_kittest::kittest::Queryable;
use groundtruth::film::{self, Film, Tone};
use groundtruth::rgb::Rgb;
use inspector::action::Shows;

use crate::support::*;

/// A pixel of our picture's left part and one of its right part, both of the ground.
const LEFT: [u32; 2] = [6, 44];
const RIGHT: [u32; 2] = [40, 44];
/// Pixels that are brighter in their picture: two regions, the larger one first, its worst pixel in the middle.
const BRIGHTER: [([u32; 2], f64); 4] =
    [([39, 44], 0.1), (RIGHT, 0.2), ([41, 44], 0.1), ([6, 44], 0.4)];

/// Our picture, and theirs, which is brighter in some pixels.
fn films() -> [Film; 2] {
    let ours = rendered(&small_glass_sphere());
    let mut theirs = ours.clone();
    for (pixel, more) in BRIGHTER {
        theirs.set(pixel, ours.get(pixel) + Rgb::grey(more));
    }
    [ours, theirs]
}

/// A window on the small glass sphere that is compared with this picture.
fn held_against(film: &Film) -> Window {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut window = glass_window();
    set(&mut window, |it| it.others.add_picture(read(folder.path(), film, "theirs.exr")));
    window
}

/// The colours of both marked pixels on the screen.
fn both(window: &mut Window) -> [[u8; 3]; 2] {
    [LEFT, RIGHT].map(|pixel| shown(window, pixel))
}

/// Law: T shows theirs and ours by turns, W both at the sides of a line, D theirs less ours, white where theirs is
/// larger by the largest shown difference, grey where they are equal. Oracle: `Tone` on both films.
#[test]
fn each_view_shows_its_picture() {
    let [ours, theirs] = films();
    let mut window = held_against(&theirs);
    let tone = window.state().picture.tone;
    let [of_ours, of_theirs] =
        [&ours, &theirs].map(|film| [LEFT, RIGHT].map(|pixel| tone.to_bytes(film.get(pixel))));
    assert_ne!(of_ours, of_theirs);
    assert_eq!(both(&mut window), [of_ours[0], of_theirs[1]], "it starts with the line");
    for (key, expected) in [
        (Key::T, of_theirs),
        (Key::T, of_ours),
        (Key::T, of_theirs),
        (Key::W, [of_ours[0], of_theirs[1]]),
        (Key::W, of_ours),
    ] {
        press(&mut window, key);
        assert_eq!(both(&mut window), expected, "{key:?}");
    }
    press(&mut window, Key::D);
    // 0.2 of 0.4 is half way from grey to white
    assert_eq!(both(&mut window), [[255; 3], [191; 3]]);
    assert_eq!(shown(&mut window, [20, 10]), [128; 3]);
    push(&mut window, "Ours");
    assert_eq!(both(&mut window), of_ours);
}

/// Law: the line follows the mouse, and its drag neither moves the picture nor selects a pixel; it cannot leave the
/// picture's part. Oracle: `Tone` on both films.
#[test]
fn the_line_is_dragged() {
    let [ours, theirs] = films();
    let mut window = held_against(&theirs);
    let tone = window.state().picture.tone;
    let before = window.state().picture.placement([48, 48]).corner;
    let line = window.get_by_label("divider").rect().center();
    let to = on_screen(&window, LEFT) - vec2(30.0, 0.0);
    drag(&mut window, line, pos2(to.x, line.y));
    assert_eq!(both(&mut window), [LEFT, RIGHT].map(|pixel| tone.to_bytes(theirs.get(pixel))));
    let line = window.get_by_label("divider").rect().center();
    assert!((line.x - to.x).abs() < 2.0, "{line} {to}");
    drag(&mut window, line, line + vec2(3000.0, 0.0));
    assert_eq!(both(&mut window), [LEFT, RIGHT].map(|pixel| tone.to_bytes(ours.get(pixel))));
    assert_eq!(window.state().others.shown().map(|theirs| theirs.divider), Some(1.0));
    assert_eq!(window.state().picture.placement([48, 48]).corner, before);
    assert_eq!(window.state().selection.pixel, None);
}

/// Law: N explains the worst pixel of each region of difference, the largest region first, and begins again; beside
/// our sum stands their value. Oracle: the pixels that were changed.
#[test]
fn the_next_region_is_explained_beside_their_value() {
    let [ours, theirs] = films();
    let mut window = held_against(&theirs);
    for pixel in [RIGHT, LEFT, RIGHT] {
        press(&mut window, Key::N);
        assert_eq!(window.state().selection.pixel, Some(pixel));
        let [a, b] = [&ours, &theirs].map(|film| film.get(pixel));
        // the file holds single precision
        let stored = Rgb::from(b.to_array().map(|channel| f64::from(channel as f32)));
        let line = text_with(&window, "theirs: ");
        for channel in stored.to_array() {
            let channel = format!("{:?}", channel as f32);
            assert!(line.contains(&channel), "{line} lacks {channel}");
        }
        let line = text_with(&window, "theirs − ours: ");
        let ours = Rgb::from(a.to_array().map(|channel| f64::from(channel as f32)));
        assert!(line.contains(&text::brief::short(stored - ours)), "{line}");
    }
    click(&mut window, [20, 10]);
    assert!(text_with(&window, "theirs: ").ends_with(": equal"));
    let at = on_screen(&window, RIGHT);
    hover(&mut window, at);
    let [a, b] = [ours.get(RIGHT), theirs.get(RIGHT)].map(text::brief::short);
    assert!(window.query_by_label(&format!("(40, 44)  {a}  theirs {b}")).is_some());
}

/// Law: equal pictures have no next region, and the window says so. Oracle: our own picture.
#[test]
fn equal_pictures_have_no_regions() {
    let mut window = held_against(&films()[0]);
    assert!(window.query_by_label("no pixel differs").is_some());
    press(&mut window, Key::N);
    assert_eq!(window.state().selection.pixel, None);
    assert_eq!(window.state().message, Some(("no pixel differs".to_owned(), false)));
}

/// Law: while our picture has another size, it is shown alone and both sizes are named; back at theirs, the pictures
/// are compared again. Oracle: `Tone` on our film.
#[test]
fn another_size_is_not_compared() {
    let [_, theirs] = films();
    let mut window = held_against(&theirs);
    type_number(&mut window, "Width", "50");
    assert!(text_with(&window, "has 48 × 48 pixels").ends_with("our picture 50 × 48"));
    let film = film(&window);
    let tone = window.state().picture.tone;
    assert_eq!(shown(&mut window, RIGHT), tone.to_bytes(film.get(RIGHT)));
    type_number(&mut window, "Width", "48");
    assert!(text_with(&window, "pixels (").contains("4 pixels (0.17 %) differ"));
}

/// A file that is dropped on the window.
#[derive(Debug)]
struct Dropped(std::path::PathBuf);

impl eframe::egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|error| error.to_string())
    }
}

/// Law: of several pictures, opened by drop, by *Open* and from the start, each stays; the list and O choose which one is
/// compared, in the same view, and ours gets its size; × lets one go. Oracle: the names and sizes of the files.
#[test]
fn several_pictures_are_kept() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let paths = [[48, 48], [24, 24], [30, 30]].map(|[width, height]: [u32; 2]| {
        let path = folder.path().join(format!("{width}.exr"));
        film::write(&Film::new(width, height), &Tone::PLAIN, &path).expect("written");
        path
    });
    let mut window = glass_window();
    for path in &paths[..2] {
        let file = std::sync::Arc::new(Dropped(path.clone()));
        window.input_mut().dropped_files.push(file);
    }
    settle(&mut window);
    type_into(&mut window, "File", paths[2].to_str().expect("UTF-8"));
    assert_eq!(window.state().others.count(), 3);
    let sizes = |window: &Window| {
        let theirs = window.state().others.shown().expect("one is chosen");
        (theirs.pixels.size()[0], window.state().session.rendering.size()[0], theirs.shows)
    };
    assert_eq!(sizes(&window), (30, 30, Shows::Swipe));
    press(&mut window, Key::T);
    for side in [48, 24, 30] {
        press(&mut window, Key::O);
        assert_eq!(sizes(&window), (side, side, Shows::Theirs));
    }
    choose(&mut window, "With", "24.exr");
    assert_eq!(sizes(&window), (24, 24, Shows::Theirs));
    push_button(&mut window, "×");
    assert_eq!((window.state().others.count(), sizes(&window).0), (2, 30));
}

/// Law: a layer of the scene that is chosen is seen in place of the difference. Oracle: the layer of the library.
#[test]
fn a_layer_is_seen_in_place_of_the_difference() {
    let mut window = held_against(&films()[1]);
    press(&mut window, Key::D);
    assert_eq!(both(&mut window), [[255; 3], [191; 3]]);
    let world = built(&small_glass_sphere());
    let layer = layers::Layer::named("object", &world).expect("a layer");
    choose(&mut window, "Layer", "object");
    let colors = layers::Colors::of(&layer, std::iter::empty(), &world, Tone::PLAIN);
    // the legend is over the left one
    assert_eq!(both(&mut window)[1], colors.color(layer.value(&world, RIGHT)));
    assert_eq!(theirs(&window).shows, Shows::Ours);
}
