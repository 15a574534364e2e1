//! The picture of a program with a known mistake, chosen in a list.

use std::path::Path;

use eframe::egui::{Key, accesskit::Role};
use egui_kittest::kittest::Queryable;
use groundtruth::film::Film;
use groundtruth::render;
use groundtruth::world::DEFAULT_SEED;
use inspector::action::Shows;
use judge::mistakes::{self, Mistaken};

use crate::support::*;

const NAME: &str = "no-cosine";
const LIST: &str = "With the mistake";

/// The picture of the small glass sphere by the program with the mistake.
fn wrong() -> Film {
    let mistake = mistakes::find(NAME).expect("it is known");
    let program = Mistaken::new(mistake, &small_glass_sphere(), Path::new(""), DEFAULT_SEED);
    render::render(&program.expect("valid").expect("it applies"))
}

/// Law: a mistake that is chosen in the list gives another picture; T flips between right and wrong, and what is shown is
/// explained: the wrong program's tree adds up to its own pixel. Without the mistake there is one picture again. Oracle:
/// the program with the mistake, rendered without a window.
#[test]
fn right_and_wrong_are_flipped_and_explained() {
    let mut window = glass_window();
    let ours = film(&window);
    let wrong = wrong();
    let pixels = (0..48).flat_map(|y| (0..48).map(move |x| [x, y]));
    let change = |at: &[u32; 2]| (wrong.get(*at) - ours.get(*at)).max();
    let pixel = pixels.max_by(|a, b| change(a).total_cmp(&change(b))).expect("there are pixels");
    assert!(change(&pixel) > 0.05);
    window.get_by_role_and_label(Role::ComboBox, LIST).click();
    window.run_steps(6);
    // it may be below the first entries
    type_text(&mut window, NAME);
    push_button(&mut window, NAME);
    assert_eq!((&*theirs(&window).name, theirs(&window).shows), (NAME, Shows::Swipe));
    press(&mut window, Key::T);
    let tone = window.state().picture.tone;
    assert_eq!(shown(&mut window, pixel), tone.to_bytes(wrong.get(pixel)));
    click(&mut window, pixel);
    for (film, subject) in [(&wrong, "With no-cosine the mean"), (&ours, "The mean of")] {
        let explanation = window.state().selection.explanation().expect("it is explained");
        assert_eq!(explanation.radiance, film.get(pixel));
        let [x, y] = pixel;
        assert!(window.query_by_label(&format!("Pixel ({x}, {y})")).is_some());
        assert!(window.query_by_label_contains(subject).is_some());
        let equal = "= the pixel of the picture, bit for bit";
        assert!(window.query_by_label_contains(equal).is_some());
        press(&mut window, Key::T);
    }
    choose(&mut window, LIST, "none");
    assert!(window.state().others.shown().is_none());
}

/// Law: the wrong picture follows the scene: with another size it is rendered again, in the same view. Oracle: its size.
#[test]
fn the_wrong_picture_follows_the_scene() {
    let mut window = glass_window();
    set(&mut window, |it| it.others.set_mistake(mistakes::find(NAME)));
    press(&mut window, Key::T);
    type_number(&mut window, "Width", "50");
    assert_eq!((theirs(&window).pixels.size(), theirs(&window).shows), ([50, 48], Shows::Theirs));
}

/// Law: of a mistake that changes nothing of the scene the window says so, and shows ours. Oracle: a scene without a lens.
#[test]
fn what_changes_nothing_is_said() {
    let mut window = glass_window();
    set(&mut window, |it| it.others.set_mistake(mistakes::find("not-focused")));
    assert!(window.state().others.shown().is_none());
    let message = window.state().message.clone().expect("a message");
    assert!(
        message.0.starts_with("the scene has nothing that not-focused changes"),
        "{}",
        message.0
    );
}
