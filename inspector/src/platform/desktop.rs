//! A desktop: threads, files on the disk, and the desktop's chooser.

use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};
use std::pin::Pin;
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::thread::{Builder, JoinHandle};
use std::time::Duration;

use eframe::egui::{Context, DroppedFileHandle};
use groundtruth::film;
pub use groundtruth::render::watched;
use pictures::compare::{Picture, Transfer};
use rayon::ThreadPoolBuilder;
use rays::{Log, LogError};
use rfd::{AsyncFileDialog, FileHandle};
pub use scenefile::open as open_scene;

use super::{FORMATS, LOGS, Purpose, Slice};

/// What is said when no file is chosen.
pub const NO_FILE: &str = "no file chosen (the chooser is that of the desktop's portal, or zenity); the path can be typed, too";

/// Rays of depth 128 are traced on the stack; unoptimised builds need more than the usual 2 MB.
const STACK: usize = 16 << 20;

/// Work beside the window.
#[derive(Debug)]
pub struct Task(Option<JoinHandle<()>>);

impl Task {
    /// Starts it: `work` is called until it is whole, which it says by `true`.
    pub fn start(ctx: &Context, mut work: impl FnMut(&Slice) -> bool + Send + 'static) -> Self {
        let ctx = ctx.clone();
        let whole = move || {
            while !work(&Slice::ENDLESS) {}
            ctx.request_repaint();
        };
        // without a thread, it has ended without a result
        Self(Builder::new().stack_size(STACK).spawn(whole).ok())
    }

    /// Whether it has ended.
    pub fn is_ended(&self) -> bool {
        self.0.as_ref().is_none_or(JoinHandle::is_finished)
    }
}

/// What work sends within this time.
///
/// # Errors
/// As [`Receiver::recv_timeout`].
pub fn wait<T>(receiver: &Receiver<T>, timeout: Duration) -> Result<T, RecvTimeoutError> {
    receiver.recv_timeout(timeout)
}

/// Reads a picture.
///
/// # Errors
/// As [`Picture::read`].
pub fn read_picture(path: &Path, said: Option<Transfer>) -> Result<Picture, String> {
    Picture::read(path, said).map_err(|error| error.to_string())
}

/// Work on threads of its own, so that a picture that is being rendered does not hold it up.
pub fn at_once<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    match ThreadPoolBuilder::new().build() {
        Ok(pool) => pool.install(work),
        Err(_) => work(),
    }
}

/// Reads a log of rays.
///
/// # Errors
/// As [`rays::read`].
pub fn read_log(path: &Path) -> Result<Log, LogError> {
    rays::read(File::open(path)?)
}

/// Writes a file, or replaces it. Returns its path with its folder, which a relative name hides.
///
/// # Errors
/// What the file system says.
pub fn save(path: &Path, bytes: &[u8]) -> io::Result<PathBuf> {
    film::replace(path, bytes)?;
    Ok(std::path::absolute(path).unwrap_or(path.to_owned()))
}

/// The files that were dropped on the window.
pub fn dropped(ctx: &Context) -> Vec<PathBuf> {
    let path = |file: &DroppedFileHandle| file.path().to_owned();
    ctx.input(|input| input.raw.dropped_files.iter().map(path).collect())
}

/// The address of the page; a window has none.
pub fn address() -> Option<String> {
    None
}

/// Whether a file would be replaced.
pub fn exists(path: &Path) -> bool {
    path.exists()
}

/// Shows the desktop's chooser, and gives its answer to `chosen` on another thread; no file if the user closed it, and if
/// the desktop has none to show.
pub fn choose(purpose: Purpose, chosen: impl FnOnce(Option<PathBuf>) + Send + 'static) {
    // made on this thread: macOS shows it from no other
    let dialog = AsyncFileDialog::new();
    let answer: Pin<Box<dyn Future<Output = Option<FileHandle>> + Send>> = match purpose {
        Purpose::Scene | Purpose::OtherScene => {
            Box::pin(dialog.add_filter("scenes", &["toml", LOGS]).pick_file())
        }
        Purpose::Theirs => Box::pin(dialog.add_filter("pictures", &FORMATS).pick_file()),
        Purpose::Picture => {
            let formats = ["png", "ppm", "exr", "pfm"];
            Box::pin(dialog.add_filter("pictures", &formats).save_file())
        }
    };
    // without a thread, `chosen` is dropped
    let _ = Builder::new()
        .spawn(move || chosen(pollster::block_on(answer).map(|file| file.path().into())));
}
