//! The list of known mistakes, with which another picture is made.

use eframe::egui::Ui;
use judge::mistakes::{self, Mistake};

use crate::comparison::bar;
use crate::comparison::others::Others;
use crate::picture::worker::Rendering;

/// Shows the list of mistakes: those that the scene of the gallery shows, or all.
pub fn show(ui: &mut Ui, others: &mut Others, rendering: &Rendering) {
    let mut chosen = others.mistake();
    let name = chosen.map_or("With mistake …", |mistake| mistake.name);
    let hint = "Another picture, by a program with this mistake; T flips between right and wrong, and explains the one \
                that is shown";
    bar::list(ui, name, "With the mistake", hint, |ui| {
        ui.selectable_value(&mut chosen, None, "none");
        for mistake in offered(rendering) {
            let entry = ui.selectable_value(&mut chosen, Some(mistake), mistake.name);
            entry.on_hover_text(format!("ch. {}: {}", mistake.chapter, mistake.words));
        }
    });
    if chosen != others.mistake() {
        others.set_mistake(chosen);
    }
}

/// The mistakes that a scene of the gallery shows; all of them for other scenes.
fn offered(rendering: &Rendering) -> Vec<&'static Mistake> {
    match rendering.source.entry() {
        Some(entry) => mistakes::shown_by(entry.name).iter().map(|pair| pair.mistake).collect(),
        None => mistakes::all(),
    }
}
