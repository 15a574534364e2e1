//! A claim on an output: one process at a time adds to a file.

use std::error::Error;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use groundtruth::film;
use xxhash_rust::xxh3::xxh3_64;

/// As long as another process may hold the file only to see whether somebody works.
const PATIENCE: Duration = Duration::from_millis(500);

/// A lock file beside an output, held by this process. The system frees the lock of a killed process, and the next file
/// written into that folder removes what it left.
pub struct Claim {
    path: PathBuf,
    _lock: File,
}

impl Claim {
    /// Claims an output.
    ///
    /// # Errors
    /// Another process has it, or the folder cannot be written to.
    pub fn of(output: &Path) -> Result<Self, Box<dyn Error>> {
        let name = output.display();
        let path = lock_file(output).map_err(|e| format!("{name}: cannot be written: {e}"))?;
        let begun = Instant::now();
        loop {
            let lock = File::options().create(true).truncate(false).write(true).open(&path);
            let lock = lock.map_err(|e| format!("{name}: cannot be written: {e}"))?;
            // one that was removed as left behind, between its making and its lock, is nobody's
            if lock.try_lock().is_ok() && is_at(&lock, &path) {
                return Ok(Self { path, _lock: lock });
            }
            if begun.elapsed() > PATIENCE {
                let problem = "another process is writing to it, and one of both would be lost; write to another file";
                return Err(format!("{name}: {problem}").into());
            }
            std::thread::sleep(Duration::from_millis(10));
        }
    }
}

impl Drop for Claim {
    fn drop(&mut self) {
        // while it is locked, so that nobody else has it; if it stays, the next run removes it
        let _ = std::fs::remove_file(&self.path);
    }
}

/// The lock file of an output, the same by whatever path the output is named.
fn lock_file(output: &Path) -> std::io::Result<PathBuf> {
    let whole = match output.canonicalize() {
        Ok(whole) => whole,
        Err(_) => {
            let folder = film::folder_of(output).canonicalize()?;
            folder.join(output.file_name().unwrap_or_default())
        }
    };
    let name = whole.file_name().unwrap_or_default().as_encoded_bytes();
    let lock = format!("{}lock-{:016x}", film::TEMPORARY, xxh3_64(name));
    Ok(film::folder_of(&whole).join(lock))
}

/// Whether an open file is the one that has this path.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let [open, named] = [file.metadata(), std::fs::metadata(path)];
    matches!((open, named), (Ok(a), Ok(b)) if (a.dev(), a.ino()) == (b.dev(), b.ino()))
}

/// Whether there is a file of this path: an open one cannot be removed here.
#[cfg(not(unix))]
fn is_at(_: &File, path: &Path) -> bool {
    path.exists()
}
