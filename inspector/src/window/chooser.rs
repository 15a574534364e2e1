//! The desktop's file chooser, for a scene to open, for the file of the picture, and for one to compare with.

use std::path::PathBuf;
use std::pin::Pin;

use eframe::egui::Context;
use rfd::{AsyncFileDialog, FileHandle};

use crate::action::{Action, Purpose, With};
use crate::comparison::opening::{self, FORMATS};
use crate::picture::worker::Background;
use crate::scene::source::Source;
use crate::window::panels::Fields;

/// What is said when no file is chosen.
const NO_FILE: &str = "no file chosen (the chooser is that of the desktop's portal, or zenity); the path can be typed, too";

/// The chooser while it is open.
#[derive(Default)]
pub struct FileChooser {
    answer: Background<(Purpose, Option<PathBuf>)>,
}

impl FileChooser {
    /// Shows the desktop's chooser, unless it is open.
    pub fn show(&mut self, ctx: &Context, purpose: Purpose) {
        if self.is_open() {
            return;
        }
        // made on this thread: macOS shows it from no other
        let dialog = AsyncFileDialog::new();
        let chosen: Pin<Box<dyn Future<Output = Option<FileHandle>> + Send>> = match purpose {
            Purpose::Scene | Purpose::OtherScene => {
                Box::pin(dialog.add_filter("scenes", &["toml"]).pick_file())
            }
            Purpose::Theirs => Box::pin(dialog.add_filter("pictures", &FORMATS).pick_file()),
            Purpose::Picture => {
                let formats = ["png", "ppm", "exr", "pfm"];
                Box::pin(dialog.add_filter("pictures", &formats).save_file())
            }
        };
        self.wait_for(ctx, purpose, || pollster::block_on(chosen).map(|file| file.path().into()));
    }

    /// Waits for a chosen file on a separate thread.
    pub fn wait_for(
        &mut self,
        ctx: &Context,
        purpose: Purpose,
        choose: impl FnOnce() -> Option<PathBuf> + Send + 'static,
    ) {
        self.answer.start(ctx, move || (purpose, choose()));
    }

    /// What the chosen file is for; its name is put in its field. Or why there is none.
    pub fn chosen(&mut self, fields: &mut Fields) -> Option<Result<Action, &'static str>> {
        let Some((purpose, path)) = self.poll()? else { return Some(Err(NO_FILE)) };
        Some(Ok(match purpose {
            Purpose::Scene => opening::named(path),
            Purpose::Theirs => Action::Compare(With::Picture(path)),
            Purpose::OtherScene => Action::Compare(With::Scene(Source::File(path))),
            Purpose::Picture => {
                fields.save = path.display().to_string();
                Action::SaveAs(path)
            }
        }))
    }

    /// Whether it is open.
    pub fn is_open(&self) -> bool {
        self.answer.is_busy()
    }

    /// The file that was chosen, returned once; `None` inside if there is none. That is all that is known when the user
    /// closed the chooser, and when the desktop has none to show.
    pub fn poll(&mut self) -> Option<Option<(Purpose, PathBuf)>> {
        let answer = self.answer.poll()?.ok();
        Some(answer.and_then(|(purpose, file)| Some((purpose, file?))))
    }
}
