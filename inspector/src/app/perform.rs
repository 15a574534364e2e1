//! What each action does.

use eframe::egui::Context;
use pictures::parse_pixel;
use rays::RayPlace;

use super::Inspector;
use crate::action::Action;
use crate::scene::source::Source;
use crate::window::{panels, saved};

impl Inspector {
    /// Performs an action.
    pub(super) fn perform(&mut self, ctx: &Context, action: Action) {
        let rendering = &self.session.rendering;
        match action {
            Action::Open(source) => {
                self.message = None;
                if let Source::File(path) = &source {
                    self.fields.open = path.display().to_string();
                }
                self.session.open(ctx, source);
            }
            Action::Rebuild => self.session.rebuild(ctx),
            Action::Save => match self.fields.save.trim() {
                "" => self.message = Some(("the picture has no name".to_owned(), true)),
                name => self.perform(ctx, Action::SaveAs(name.into())),
            },
            Action::SaveAs(path) => {
                match saved::content(&self.picture, self.others.shown(), rendering) {
                    Ok(content) => {
                        self.message = None;
                        let shown = (rendering, self.picture.tone);
                        self.saving.start(ctx, shown, content, &path);
                    }
                    Err(why) => self.message = Some((why, true)),
                }
            }
            Action::Compare(with) => {
                self.message = self.others.perform(ctx, &mut self.session, with);
            }
            Action::Choose(purpose) => self.chooser.show(ctx, purpose),
            Action::NameScene => {
                ctx.memory_mut(|memory| memory.request_focus(panels::file_field()))
            }
            Action::Select(pixel) => self.select(pixel),
            Action::RevealTyped(text) => match parse_pixel(&text) {
                Ok(pixel) => self.reveal(pixel),
                Err(error) => self.message = Some((error, true)),
            },
            Action::NextRegion => self.reveal_next_region(),
            Action::Pin => self.selection.pin(),
            Action::Go(by) => self.selection.go(by),
            Action::Undo => self.session.undo(ctx, false),
            Action::Redo => self.session.undo(ctx, true),
            Action::NextView => self.space.mode = self.space.mode.next(),
            Action::ChangeGround => {
                self.settings.ground = self.settings.ground.other();
                self.settings.ground.set(ctx);
            }
            Action::ToggleKeys => self.is_showing_keys ^= true,
        }
    }

    /// Explains a sample of a pixel, if the picture has it.
    pub fn explain(&mut self, pixel: [u32; 2], sample: u32) {
        self.selection.sample = sample;
        self.select(pixel);
    }

    /// Selects a pixel, if the picture has it.
    pub(super) fn select(&mut self, pixel: [u32; 2]) {
        let pixel @ [x, y] = self.others.nearest(pixel).unwrap_or(pixel);
        let selected = self.selection.select(pixel, self.session.rendering.size());
        if selected.is_ok() {
            self.fields.pixel = format!("{x}, {y}");
        }
        self.message = selected.err().map(|problem| (problem, true));
    }

    /// Selects a pixel and moves the picture if it is not in view.
    pub(super) fn reveal(&mut self, pixel: [u32; 2]) {
        self.select(pixel);
        if self.selection.pixel == Some(pixel) {
            self.picture.reveal(self.session.rendering.size(), pixel);
        }
    }

    /// Selects a ray of a log, and moves the picture if its pixel is not in view.
    pub(super) fn seek(&mut self, place: RayPlace) {
        self.reveal(place.pixel);
        self.selection.seek(place);
    }

    /// Reveals the next broken ray of a log, or the worst pixel of the next region of difference.
    fn reveal_next_region(&mut self) {
        let Some(theirs) = self.others.shown_mut() else { return };
        if let Some(place) = theirs.next_broken() {
            return self.seek(place);
        }
        match theirs.next_region(&self.session.rendering) {
            Ok(pixel) => self.reveal(pixel),
            Err(why) => self.message = Some((why.to_owned(), false)),
        }
    }
}
