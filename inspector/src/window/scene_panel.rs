//! The panel of the scene: what the scene is, its settings, numbers and switches.

use eframe::egui::{Button, RichText, ScrollArea, Ui};
use groundtruth::printable;
use rays::Logged;
use text::brief::count;

use crate::comparison::others::Others;
use crate::picture::image_settings::ImageSettings;
use crate::picture::session::Session;
use crate::scene::numbers::Numbers;
use crate::scene::switches;

/// The panel's own state.
#[derive(Default)]
pub struct ScenePanel {
    settings: ImageSettings,
    numbers: Numbers,
}

impl ScenePanel {
    /// Shows it. Returns whether the scene was changed, and notes the index of the object that is pointed at.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        session: &mut Session,
        others: &Others,
        pointed: &mut Option<u32>,
    ) -> bool {
        let show = |ui: &mut Ui| {
            if let Some(log) = others.log().filter(|_| session.rendering.source.rays().is_some()) {
                of_log(ui, log, pointed);
                return false;
            }
            self.scene(ui, session, pointed)
        };
        ScrollArea::both().auto_shrink(false).show(ui, show).inner
    }

    /// Shows what the scene is, its settings and switches. Returns whether it was changed.
    fn scene(&mut self, ui: &mut Ui, session: &mut Session, pointed: &mut Option<u32>) -> bool {
        let can_undo = session.can_undo();
        let Session { rendering, wanted, seed, .. } = session;
        if !wanted.about.is_empty() {
            ui.label(RichText::new(&wanted.about).italics());
            ui.add_space(6.0);
        }
        let mut is_undone = false;
        ui.horizontal(|ui| {
            ui.strong("Picture");
            let undo = ui.add_enabled(can_undo, Button::new("Undo").small());
            is_undone =
                undo.on_hover_text("The last change in this panel (Ctrl-Z; Ctrl-Y)").clicked();
        });
        let mut changed = self.settings.show(ui, wanted, seed);
        for note in explain::notes(&rendering.built.scene, &rendering.world) {
            ui.label(RichText::new(note).color(ui.visuals().warn_fg_color));
        }
        changed |= self.numbers.show(ui, (rendering.generation, &rendering.built.scene), wanted);
        ui.add_space(8.0);
        changed |= switches::show(ui, wanted, pointed);
        if is_undone {
            session.undo(ui.ctx(), false);
        }
        changed && !is_undone
    }
}

/// Shows what is known of a program from the log of its rays; notes the index of the object that is pointed at.
fn of_log(ui: &mut Ui, log: &Logged, pointed: &mut Option<u32>) {
    let traced = &log.verdict.traced;
    let program = traced.log.head.program.as_deref().unwrap_or("A log of rays");
    ui.strong(printable::name(program));
    let (rays, pixels) = (traced.log.rays.len(), log.pixels().count());
    let broken = log.pixels().filter(|(_, is_broken)| *is_broken).count();
    ui.label(format!("{} of {}", count(rays, "ray"), count(pixels, "pixel")));
    ui.label(format!("{} with a broken law", count(broken, "pixel")));
    ui.add_space(8.0);
    let conventions = traced.conventions.sentences();
    if !conventions.is_empty() {
        ui.strong("Taken from the log");
        conventions.into_iter().for_each(|it| drop(ui.label(printable::text(&it))));
        ui.add_space(8.0);
    }
    ui.strong("Objects");
    match &traced.world {
        None => {
            drop(ui.weak("none: with shapes, hits and shadows are checked, and space shows them"))
        }
        Some(world) => {
            for object in world.objects() {
                if ui.label(printable::name(&object.name)).hovered() {
                    *pointed = Some(object.index);
                }
            }
        }
    }
}
