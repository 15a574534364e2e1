//! The global shortcuts of the window, and the list of all keys.

use eframe::egui::{Align2, Context, Grid, Key, Modifiers, PointerButton, RichText, Window};

use crate::action::{Action, Shows, With};

/// The keys and what they do.
const KEYS: [(&str, &str); 24] = [
    ("click", "explain this pixel"),
    ("right click", "on an object: why does the selected ray not hit it?"),
    ("arrows", "explain the next pixel, the same ray (Shift: ten pixels on)"),
    (
        "Alt-Left, Alt-Right",
        "back and forward through the selected pixels (or the mouse's buttons)",
    ),
    ("P", "pin the pixel: another one is compared with it, ray by ray; again: let it go"),
    ("L", "follow the light: the next ray on the path of the largest share"),
    ("wheel, pinch", "zoom in and out under the mouse"),
    ("drag", "move the picture; a bar between two parts: resize them"),
    ("double click", "on a bar: its default place"),
    ("T", "with another picture (Compare with …, a mistake): flip between ours and theirs"),
    ("W", "with another picture: ours at the left of a line, theirs at its right; drag the line"),
    ("D", "with another picture: theirs less ours"),
    ("Z", "with another picture, once it is judged: the map of z"),
    ("N", "the worst pixel of the next region of difference; with a log, the next broken ray"),
    ("O", "with several other pictures: compare with the next of them"),
    ("S", "the picture, the picture and its rays in space, or space alone"),
    ("1 2 3, C, F, A, R", "in space: front, side, top; scene's camera; fit rays, all; along ray"),
    ("Ctrl-O", "type the name of a scene file"),
    ("Ctrl-S", "save the picture"),
    ("Ctrl-Z, Ctrl-Y", "undo a change of the scene in the panel at the left, or do it again"),
    ("Ctrl-+, Ctrl-−, Ctrl-0", "everything larger, smaller, or as at first"),
    ("B", "a dark ground, or a light one for projectors"),
    ("?, F1", "show or hide these keys"),
    ("Esc", "close what is in front"),
];

/// The action of the pressed shortcut. `?` and letters are shortcuts only if no text is being typed (`is_text`).
pub fn pressed(ctx: &Context, is_text: bool) -> Option<Action> {
    let flip = |shows| Action::Compare(With::Flip(shows));
    let always = [
        (Modifiers::COMMAND, Key::O, Action::NameScene),
        (Modifiers::COMMAND, Key::S, Action::Save),
        (Modifiers::NONE, Key::F1, Action::ToggleKeys),
    ];
    let unless_typing = [
        (Modifiers::NONE, Key::Questionmark, Action::ToggleKeys),
        (Modifiers::ALT, Key::ArrowLeft, Action::Go(-1)),
        (Modifiers::ALT, Key::ArrowRight, Action::Go(1)),
        (Modifiers::COMMAND, Key::Z, Action::Undo),
        (Modifiers::COMMAND, Key::Y, Action::Redo),
        (Modifiers::NONE, Key::T, flip(Shows::Theirs)),
        (Modifiers::NONE, Key::W, flip(Shows::Swipe)),
        (Modifiers::NONE, Key::D, flip(Shows::Difference)),
        (Modifiers::NONE, Key::Z, flip(Shows::Map)),
        (Modifiers::NONE, Key::N, Action::NextRegion),
        (Modifiers::NONE, Key::O, Action::Compare(With::Next)),
        (Modifiers::NONE, Key::S, Action::NextView),
        (Modifiers::NONE, Key::B, Action::ChangeGround),
        (Modifiers::NONE, Key::P, Action::Pin),
    ];
    let buttons = [(PointerButton::Extra1, -1), (PointerButton::Extra2, 1)];
    ctx.input_mut(|input| {
        let mut keys = always.into_iter().chain(unless_typing.into_iter().filter(|_| !is_text));
        let pressed = keys.find(|(held, key, _)| input.consume_key(*held, *key));
        let mut buttons = buttons.into_iter().filter(|_| !is_text);
        let gone = buttons.find(|(button, _)| input.pointer.button_pressed(*button));
        pressed.map(|(.., action)| action).or(gone.map(|(_, by)| Action::Go(by)))
    })
}

/// Shows the list of keys in a separate window while it is open.
pub fn list(ctx: &Context, open: &mut bool) {
    if *open && ctx.input(|input| input.key_pressed(Key::Escape)) {
        *open = false;
    }
    let window = Window::new("Keys").open(open).collapsible(false).resizable(false);
    window.anchor(Align2::CENTER_CENTER, [0.0, 0.0]).show(ctx, |ui| {
        Grid::new("keys").num_columns(2).spacing([16.0, 4.0]).show(ui, |ui| {
            for (key, effect) in KEYS {
                ui.label(RichText::new(key).strong());
                ui.label(effect);
                ui.end_row();
            }
        });
    });
}
