//! A picture file that is opened in the window, to be held against ours.

use std::path::{Path, PathBuf};

use eframe::egui::Context;
use pictures::compare;

use crate::comparison::mistake::WithMistake;
use crate::comparison::theirs::Theirs;
use crate::picture::session::Session;
use crate::picture::worker::Background;

/// The ends of the names of pictures that can be read.
pub const FORMATS: [&str; 8] = ["png", "jpg", "jpeg", "ppm", "pnm", "hdr", "exr", "pfm"];

/// Whether a file is a picture, by its name.
pub fn is_picture(path: &Path) -> bool {
    let end = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    FORMATS.contains(&end.as_str())
}

/// The file that is being read.
#[derive(Default)]
pub struct Opening {
    reading: Background<Result<Theirs, String>>,
}

impl Opening {
    /// Starts to read a file.
    pub fn start(&mut self, ctx: &Context, path: PathBuf) {
        self.reading.start(ctx, move || Theirs::read(&path, None));
    }

    /// Whether a file is being read.
    pub fn is_busy(&self) -> bool {
        self.reading.is_busy()
    }

    /// Once the file is read, holds its picture against ours, which is rendered at its size. Returns what the user must
    /// know, and whether that is an error.
    pub fn refresh(
        &mut self,
        ctx: &Context,
        session: &mut Session,
        mistake: &mut WithMistake,
        theirs: &mut Option<Theirs>,
    ) -> Option<(String, bool)> {
        let read = self.reading.poll()?.unwrap_or_else(|lost| Err(lost.to_string()));
        let picture = match read {
            Ok(picture) if session.waiting.is_none() => picture,
            Ok(_) => {
                return Some(("there is no picture of ours to compare with yet".to_owned(), true));
            }
            Err(error) => return Some((error, true)),
        };
        let mut scene = session.wanted.clone();
        let is_alike = match compare::fit(&mut scene, picture.size()) {
            Ok(is_alike) => is_alike,
            Err(error) => return Some((format!("{}: {error}", picture.name), true)),
        };
        let mut notes = picture.notes().to_vec();
        if !is_alike {
            notes
                .push(format!("{} has another shape; the width of our view is kept", picture.name));
        }
        if session.rendering.size() != picture.size() {
            session.wanted = scene;
            session.rebuild(ctx);
        }
        // the mistake's picture goes first: it would take this one with it
        mistake.choose(None);
        mistake.refresh(ctx, &session.rendering, theirs);
        *theirs = Some(picture);
        (!notes.is_empty()).then(|| (notes.join("; "), false))
    }
}
