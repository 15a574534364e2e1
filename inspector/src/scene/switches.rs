//! Switches for lights and objects.

use eframe::egui::{Align, Layout, TextWrapMode, Ui, vec2};
use groundtruth::scene::Scene;

/// Shows the switches; returns whether the scene was changed, and notes the index of the object that is pointed at.
pub fn show(ui: &mut Ui, scene: &mut Scene, pointed: &mut Option<u32>) -> bool {
    let lights = scene.lights.iter_mut().map(|light| (light.name.as_str(), &mut light.enabled));
    let changed = list(ui, "Lights", "light", lights.collect(), &mut None);
    ui.add_space(8.0);
    let objects =
        scene.objects.iter_mut().map(|object| (object.name.as_str(), &mut object.enabled));
    changed | list(ui, "Objects", "object", objects.collect(), pointed)
}

fn list(
    ui: &mut Ui,
    title: &str,
    thing: &str,
    mut things: Vec<(&str, &mut bool)>,
    pointed: &mut Option<u32>,
) -> bool {
    let mut changed = false;
    ui.horizontal(|ui| {
        ui.strong(title);
        let some_off = things.iter().any(|(_, on)| !**on);
        if some_off && ui.small_button("all on").clicked() {
            things.iter_mut().for_each(|(_, on)| **on = true);
            changed = true;
        }
    });
    let mut only = None;
    for (index, (name, on)) in things.iter_mut().enumerate() {
        ui.push_id((thing, index), |ui| {
            // not wider than what is visible, if the panel above is
            let width = ui.available_width().min(ui.clip_rect().width());
            let row = vec2(width, ui.spacing().interact_size.y);
            ui.allocate_ui_with_layout(row, Layout::right_to_left(Align::Center), |ui| {
                let hint = format!("Switch every other {thing} off");
                if ui.small_button("only").on_hover_text(hint).clicked() {
                    only = Some(index);
                }
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    ui.style_mut().wrap_mode = Some(TextWrapMode::Truncate);
                    let unnamed = format!("{thing} {index}");
                    let label = if name.is_empty() { &unnamed } else { *name };
                    let switch = ui.checkbox(on, label).on_hover_text(label);
                    changed |= switch.changed();
                    if switch.hovered() {
                        *pointed = Some(index as u32);
                    }
                });
            });
        });
    }
    if let Some(only) = only {
        things.iter_mut().enumerate().for_each(|(index, (_, on))| **on = index == only);
        changed = true;
    }
    if things.is_empty() {
        ui.weak("none");
    }
    changed
}
