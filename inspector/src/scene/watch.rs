//! Files on the disk: a scene file that is changed in an editor is read again.

use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use eframe::egui::Context;
use groundtruth::scene::Scene;
use web_time::Instant;

/// The interval at which the files are checked.
pub const INTERVAL: Duration = Duration::from_millis(500);

/// The time of a file's last change, and its length; `None` if it does not exist.
type Stamp = Option<(SystemTime, u64)>;

/// Files, and their stamps when they were read.
#[derive(Debug, Default)]
pub struct Watch {
    files: Vec<(PathBuf, Stamp)>,
    checked: Option<Instant>,
}

impl Watch {
    /// Also watches this file from now on.
    pub fn add(&mut self, file: PathBuf) {
        let stamp = stamp(&file);
        self.files.push((file, stamp));
    }

    /// Also watches the mesh files that a scene names, relative to this folder.
    pub fn add_meshes(&mut self, scene: &Scene, folder: &Path) {
        scenefile::files(scene).into_iter().for_each(|file| self.add(folder.join(file)));
    }

    /// As [`Self::changed`], in each frame of a window, which is drawn again when the next check is due.
    pub fn follow(&mut self, ctx: &Context) -> bool {
        if !self.files.is_empty() {
            ctx.request_repaint_after(INTERVAL);
        }
        self.changed()
    }

    /// Whether a file was changed since the last call; checked at most twice a second.
    pub fn changed(&mut self) -> bool {
        if self.checked.is_some_and(|at| at.elapsed() < INTERVAL) {
            return false;
        }
        self.checked = Some(Instant::now());
        let mut changed = false;
        for (file, old) in &mut self.files {
            let now = stamp(file);
            changed |= now != *old;
            *old = now;
        }
        changed
    }
}

fn stamp(file: &Path) -> Stamp {
    let data = file.metadata().ok()?;
    Some((data.modified().ok()?, data.len()))
}
