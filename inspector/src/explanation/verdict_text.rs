//! The verdict on the picture that ours is compared with, as text.

use eframe::egui::{RichText, Ui};
use judge::verdict::Verdict;

use crate::explanation::copying;

/// Shows a verdict as the command prints it, to be read, selected and copied.
pub fn show(ui: &mut Ui, verdict: &Verdict) {
    let text = verdict.to_string();
    ui.horizontal(|ui| {
        if ui.small_button("Copy the verdict").clicked() {
            ui.ctx().copy_text(text.clone());
            copying::set_copied(ui.ctx());
        }
        copying::show_copied(ui);
    });
    ui.label(RichText::new(text).monospace().size(12.0));
}
