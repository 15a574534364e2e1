//! The desktop's file chooser, for a scene to open, for the file of the picture, and for one to compare with.

use std::path::PathBuf;
use std::pin::Pin;

use eframe::egui::Context;
use rfd::{AsyncFileDialog, FileHandle};

use crate::action::Purpose;
use crate::comparison::opening::FORMATS;
use crate::picture::worker::Background;

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
            Purpose::Scene => Box::pin(dialog.add_filter("scenes", &["toml"]).pick_file()),
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
