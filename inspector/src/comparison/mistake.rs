//! The list of known mistakes, with which another picture is made.

use eframe::egui::{Button, Key, TextEdit, Ui, WidgetInfo, accesskit::Role};
use judge::mistakes::{self, Mistake};
use text::brief::percent;

use crate::comparison::bar;
use crate::comparison::others::Others;
use crate::picture::worker::Rendering;
use crate::scene::fields::has_words;

/// Shows the list of mistakes that have the typed words: those that the scene of the gallery shows, or all.
pub fn show(ui: &mut Ui, typed: &mut String, others: &mut Others, rendering: &Rendering) {
    let present = others.mistake();
    let name = present.map_or("Mistake …", |mistake| mistake.name);
    let hint = "Another picture, by a program with this mistake; T flips between right and wrong, and explains the one \
                that is shown";
    let mut chosen = None;
    let open = bar::list(ui, name, "With the mistake", hint, |ui| {
        let field = TextEdit::singleline(typed).hint_text("a word").desired_width(f32::INFINITY);
        let field = ui.add(field);
        let is_entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if typed.is_empty() {
            field.request_focus();
        }
        let offered = offered(rendering, typed);
        if is_entered {
            chosen = offered.first().map(|(mistake, _)| Some(*mistake));
        }
        if ui.selectable_label(present.is_none(), "none").clicked() {
            chosen = Some(None);
        }
        for (mistake, share) in offered {
            let (name, words) = (mistake.name, mistake.words);
            let share = share.map(percent);
            let entry = Button::selectable(present == Some(mistake), name);
            let entry = ui.add(entry.right_text(share.clone().unwrap_or_default()));
            entry.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
            let changes = share.map_or(String::new(), |it| format!("; changes {it} of the pixels"));
            let entry = entry.on_hover_text(format!("ch. {}: {words}{changes}", mistake.chapter));
            if entry.clicked() {
                chosen = Some(Some(mistake));
            }
        }
        if chosen.is_some() {
            ui.close();
        }
    });
    if open.is_none() {
        typed.clear();
    }
    if let Some(chosen) = chosen.filter(|chosen| *chosen != present) {
        others.set_mistake(chosen);
    }
}

/// The mistakes that have these words and that a scene of the gallery shows, each with the share of the pixels that it changes
/// there, the largest first; for other scenes, which were not measured, all that have the words.
fn offered(rendering: &Rendering, typed: &str) -> Vec<(&'static Mistake, Option<f64>)> {
    let mut offered: Vec<_> = match rendering.source.entry() {
        Some(entry) => {
            let shown = mistakes::shown_by(entry.name).into_iter();
            shown.map(|pair| (pair.mistake, Some(pair.effect.share))).collect()
        }
        None => mistakes::all().into_iter().map(|mistake| (mistake, None)).collect(),
    };
    offered.retain(|(it, _)| has_words(&format!("{} {}", it.name, it.words), typed));
    offered.sort_by(|(_, a), (_, b)| b.unwrap_or(0.0).total_cmp(&a.unwrap_or(0.0)));
    offered
}
