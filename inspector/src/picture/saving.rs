//! Saving the picture: on a separate thread, and asking before a file is replaced.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use eframe::egui::{Context, Event, Id, Key, Modal};
use groundtruth::film::{self, Format};
use pictures::provenance;

use crate::picture::display::Picture;
use crate::picture::worker::{Background, Rendering};

/// The state of saving.
#[derive(Debug, Default)]
pub struct Saving {
    working: Background<Result<PathBuf, String>>,
    /// The existing file that the question is about.
    asking: Option<PathBuf>,
}

impl Saving {
    /// Saves the picture, or asks first if the file exists.
    pub fn start(&mut self, ctx: &Context, rendering: &Rendering, picture: &Picture, to: &Path) {
        if to.exists() {
            self.asking = Some(to.to_owned());
        } else {
            self.write(ctx, rendering, picture, to.to_owned());
        }
    }

    fn write(&mut self, ctx: &Context, rendering: &Rendering, picture: &Picture, to: PathBuf) {
        let (canvas, tone, of_scene) =
            (rendering.canvas.clone(), picture.tone, rendering.world.image.tone());
        let is_for_display = Format::of(&to).is_ok_and(Format::is_for_display);
        let (source, read) = (rendering.source.clone(), rendering.read.clone());
        let (scene, world) = (Arc::clone(&rendering.scene), Arc::clone(&rendering.world));
        self.working.start(ctx, move || {
            let made = provenance((source.entry(), &read), (&scene, &world), source.folder());
            let mut made = made.map_err(|error| error.to_string())?;
            made.tone = (is_for_display && tone != of_scene).then(|| tone.to_string());
            let written = film::write_made(&canvas.film(), &tone, &to, &made);
            // with its folder, which a relative name hides
            let whole = std::path::absolute(&to).unwrap_or(to);
            written.map(|()| whole).map_err(|error| error.to_string())
        });
    }

    /// Asks whether to replace the file, until the user answers.
    pub fn ask(&mut self, ctx: &Context, rendering: &Rendering, picture: &Picture) {
        let Some(path) = self.asking.clone() else { return };
        let enter = ctx.input(|input| input.events.iter().any(is_enter));
        let modal = Modal::new(Id::unique("replace")).show(ctx, |ui| {
            ui.set_max_width(420.0);
            ui.label(format!("{} exists. Replace it?", path.display()));
            ui.add_space(8.0);
            ui.horizontal(|ui| {
                let replace = ui.button("Replace (Enter)").clicked();
                if ui.button("Cancel (Esc)").clicked() {
                    ui.close();
                }
                replace
            })
            .inner
        });
        if modal.inner || enter {
            self.asking = None;
            self.write(ctx, rendering, picture, path);
        } else if modal.should_close() {
            self.asking = None;
        }
    }

    /// Whether the question is open; it then gets the keys.
    pub fn is_asking(&self) -> bool {
        self.asking.is_some()
    }

    /// Whether a picture is being written.
    pub fn is_busy(&self) -> bool {
        self.working.is_busy()
    }

    /// The message about a picture that was written, returned once, and whether it is an error.
    pub fn poll(&mut self) -> Option<(String, bool)> {
        Some(match self.working.poll()? {
            Ok(Ok(path)) => (format!("saved {}", path.display()), false),
            Ok(Err(error)) => (error, true),
            Err(lost) => (lost.to_string(), true),
        })
    }
}

/// Whether Enter was pressed. A key that is held down since before the question does not count.
fn is_enter(event: &Event) -> bool {
    matches!(event, Event::Key { key: Key::Enter, pressed: true, repeat: false, .. })
}
