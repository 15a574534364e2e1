//! Picture files that are opened in the window, to be held against ours.

use std::path::{Path, PathBuf};

use eframe::egui::Context;
use pictures::compare;

use crate::action::{Action, With};
use crate::comparison::theirs::Theirs;
use crate::picture::session::Session;
use crate::platform::FORMATS;
use crate::scene::source::Source;

/// Whether a file is a picture, by its name.
pub fn is_picture(path: &Path) -> bool {
    let end = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    FORMATS.contains(&end.as_str())
}

/// What opens a file: a picture is held against ours, another file is a scene.
pub fn named(path: PathBuf) -> Action {
    if is_picture(&path) {
        Action::Compare(With::Picture(path))
    } else {
        Action::Open(Source::of_file(path))
    }
}

/// Renders ours at the size of a file's picture. Returns what the user must know.
///
/// # Errors
/// A size that no picture of ours has.
pub fn fit(
    ctx: &Context,
    session: &mut Session,
    picture: &Theirs,
) -> Result<Option<String>, String> {
    let mut scene = session.wanted.clone();
    let is_alike = compare::fit(&mut scene, picture.pixels.size())
        .map_err(|error| format!("{}: {error}", picture.name))?;
    if session.rendering.size() != picture.pixels.size() {
        session.wanted = scene;
        session.rebuild(ctx);
    }
    let note = format!("{} has another shape; the width of our view is kept", picture.name);
    Ok((!is_alike).then_some(note))
}
