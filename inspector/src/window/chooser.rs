//! The file chooser, for a scene to open, for the file of the picture, and for one to compare with.

use std::path::PathBuf;

use eframe::egui::Context;

use crate::action::{Action, With};
use crate::comparison::opening;
use crate::picture::worker::Background;
use crate::platform::{self, Purpose};
use crate::scene::source::Source;
use crate::window::panels::Fields;

/// The chooser while it is open.
#[derive(Default)]
pub struct FileChooser {
    answer: Background<(Purpose, Option<PathBuf>)>,
}

impl FileChooser {
    /// Shows the chooser, unless it is open.
    pub fn show(&mut self, ctx: &Context, purpose: Purpose) {
        if self.is_open() {
            return;
        }
        self.wait_for(ctx, purpose, |chosen| platform::choose(purpose, chosen));
    }

    /// Waits until `choose` gives a file to what it is given.
    pub fn wait_for(
        &mut self,
        ctx: &Context,
        purpose: Purpose,
        choose: impl FnOnce(Box<dyn FnOnce(Option<PathBuf>) + Send>),
    ) {
        let answer = self.answer.expect(ctx);
        choose(Box::new(move |path| answer((purpose, path))));
    }

    /// What the chosen file is for; its name is put in its field. Or why there is none.
    pub fn chosen(&mut self, fields: &mut Fields) -> Option<Result<Action, &'static str>> {
        // no file is all that is known when the user closed it, and when a desktop has none to show
        let Ok((purpose, Some(path))) = self.answer.poll()? else {
            return Some(Err(platform::NO_FILE));
        };
        Some(Ok(match purpose {
            Purpose::Scene => opening::named(path),
            Purpose::Theirs => Action::Compare(With::Picture(path)),
            Purpose::OtherScene => Action::Compare(With::Scene(Source::of_file(path))),
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
}
