//! Many files changed as one: all of the changes, or none, wherever the machine stops.
//!
//! The new files are written into a folder of their own, each under the path it will have. Renaming
//! that folder to `.accepted` decides: before it, nothing has happened; after it, what is left in
//! the folder is moved to its place, now or when the goldens are opened next.

use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

use groundtruth::film;
use tempfile::TempDir;

/// The folder of files that are decided, and may not be in their places yet.
const ACCEPTED: &str = ".accepted";
/// How the names of folders begin whose files are not decided.
const STAGED: &str = ".accepting-";

/// What a run locks that changes the folder: the folder itself, or a file in it where folders have no locks.
fn lockable(folder: &Path) -> io::Result<File> {
    if cfg!(unix) {
        return File::open(folder);
    }
    File::options().create(true).truncate(false).write(true).open(folder.join(".lock"))
}

/// Waits until no other run changes the folder, and keeps others out while the file is open. The system
/// frees the lock of a process that is killed.
pub fn lock(folder: &Path) -> io::Result<File> {
    let file = lockable(folder)?;
    match file.lock() {
        // a file system without locks
        Err(error) if error.kind() != io::ErrorKind::Unsupported => Err(error),
        _ => Ok(file),
    }
}

/// A folder for new files, gone again unless it is decided.
pub fn stage(folder: &Path) -> io::Result<TempDir> {
    tempfile::Builder::new().prefix(STAGED).tempdir_in(folder).map_err(film::without_path)
}

/// Decides for the staged files. They are on the disk before their folder has its new name.
pub fn decide(folder: &Path, staged: TempDir) -> io::Result<()> {
    for (file, _) in files(staged.path(), folder)? {
        std::fs::OpenOptions::new().append(true).open(file)?.sync_all()?;
    }
    std::fs::rename(staged.path(), folder.join(ACCEPTED))?;
    let _ = staged.keep(); // it has another name now
    Ok(())
}

/// Whether there are decided files.
pub fn waits(folder: &Path) -> bool {
    folder.join(ACCEPTED).is_dir()
}

/// Moves decided files to their places; whether there were any.
pub fn finish(folder: &Path) -> io::Result<bool> {
    let accepted = folder.join(ACCEPTED);
    if !waits(folder) {
        return Ok(false);
    }
    for (from, to) in files(&accepted, folder)? {
        if let Some(folder) = to.parent() {
            std::fs::create_dir_all(folder)?;
        }
        std::fs::rename(from, to)?;
    }
    std::fs::remove_dir_all(accepted)?;
    Ok(true)
}

/// Removes the staged files of earlier runs that were stopped before they decided.
pub fn clear(folder: &Path) -> io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let entry = entry?;
        if entry.file_name().to_string_lossy().starts_with(STAGED) {
            std::fs::remove_dir_all(entry.path())?;
        }
    }
    Ok(())
}

/// The files below `here`, each with its path below `there`.
pub fn files(here: &Path, there: &Path) -> io::Result<Vec<(PathBuf, PathBuf)>> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(here)? {
        let entry = entry?;
        let to = there.join(entry.file_name());
        if entry.file_type()?.is_dir() {
            found.extend(files(&entry.path(), &to)?);
        } else {
            found.push((entry.path(), to));
        }
    }
    Ok(found)
}
