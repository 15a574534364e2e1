//! Output files: replaced whole or not at all, through symbolic links, with the mode they had.

use std::io::{Error, ErrorKind, Result, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use crate::printable;

/// How the names of temporary files begin. What a killed run leaves behind, the next one
/// removes that writes into the same folder.
pub const TEMPORARY: &str = ".groundtruth-";

/// Replaces a file by `bytes`, completely or not at all.
///
/// A symbolic link stays, and what it points to is replaced. An existing file keeps its mode; a new
/// one gets that of the umask. The bytes are on the disk before the file has its name. A device is written to; a named
/// pipe is refused, as nobody may ever read from it.
///
/// # Errors
/// The file cannot be written; nothing was left behind.
pub fn replace(path: &Path, bytes: &[u8]) -> Result<()> {
    Staged::new(path, bytes)?.commit()
}

/// Replaces several files: none of them unless all could be written, then one after the other in this order.
///
/// # Errors
/// The first file that cannot be written, by its index.
pub fn replace_all(files: &[(&Path, &[u8])]) -> std::result::Result<(), (usize, Error)> {
    let mut staged = Vec::new();
    for (index, (path, bytes)) in files.iter().enumerate() {
        staged.push(Staged::new(path, bytes).map_err(|error| (index, error))?);
    }
    for (index, file) in staged.into_iter().enumerate() {
        file.commit().map_err(|error| (index, error))?;
    }
    Ok(())
}

/// A new file that is complete, and not yet in its place. Dropped, it is gone.
#[derive(Debug)]
struct Staged {
    target: PathBuf,
    /// `None` if the target was written to already: a device.
    temporary: Option<NamedTempFile>,
}

impl Staged {
    /// Writes `bytes` beside the file that is to be replaced.
    ///
    /// # Errors
    /// As [`replace()`].
    fn new(path: &Path, bytes: &[u8]) -> Result<Self> {
        let target = target_of(path)?;
        let old = std::fs::metadata(&target).ok();
        old.as_ref().map_or(Ok(()), not_a_pipe)?;
        if old.as_ref().is_some_and(|old| !old.is_file() && !old.is_dir()) {
            std::fs::OpenOptions::new().write(true).open(&target)?.write_all(bytes)?;
            return Ok(Self { target, temporary: None });
        }
        let mut temporary = temporary_beside(&target)?;
        // not through the temporary file, whose errors name it
        temporary.as_file_mut().write_all(bytes)?;
        flush(temporary.as_file())?;
        if let Some(old) = old {
            temporary.as_file().set_permissions(old.permissions())?;
        }
        Ok(Self { target, temporary: Some(temporary) })
    }

    /// Puts the new file into its place.
    ///
    /// # Errors
    /// As [`replace()`].
    fn commit(self) -> Result<()> {
        let Some(temporary) = self.temporary else { return Ok(()) };
        temporary.persist(self.target).map(drop).map_err(|e| e.error)
    }
}

/// Whether [`replace()`] can write there, found out before there is something to write.
///
/// # Errors
/// As [`replace()`].
pub fn replaceable(path: &Path) -> Result<()> {
    let target = target_of(path)?;
    match std::fs::metadata(&target) {
        Ok(old) if old.is_dir() => Err(Error::other("it is a folder")),
        Ok(old) if not_a_pipe(&old).is_err() => not_a_pipe(&old),
        Ok(old) if !old.is_file() => std::fs::OpenOptions::new().write(true).open(target).map(drop),
        _ => temporary_beside(&target).map(drop),
    }
}

/// Brings what was written to the disk: a file that is renamed before may be empty after a loss of power.
fn flush(file: &std::fs::File) -> Result<()> {
    match file.sync_data() {
        // a file system that keeps nothing
        Err(e) if matches!(e.kind(), ErrorKind::InvalidInput | ErrorKind::Unsupported) => Ok(()),
        other => other,
    }
}

/// Fails for a named pipe: to open it waits for a reader, for ever if there is none.
fn not_a_pipe(file: &std::fs::Metadata) -> Result<()> {
    #[cfg(unix)]
    if std::os::unix::fs::FileTypeExt::is_fifo(&file.file_type()) {
        return Err(Error::other(
            "it is a named pipe; write to the standard output (-), or to a file",
        ));
    }
    let _ = file;
    Ok(())
}

/// The folder that a file stands in: `.` for a bare file name.
pub fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// What a chain of symbolic links points to, which need not exist yet.
fn target_of(path: &Path) -> Result<PathBuf> {
    /// As many as Linux follows.
    const MAX_LINKS: u32 = 40;
    let mut path = path.to_owned();
    for _ in 0..MAX_LINKS {
        match std::fs::read_link(&path) {
            Ok(target) => path = folder_of(&path).join(target),
            Err(_) => return Ok(path),
        }
    }
    Err(Error::other("too many symbolic links; they may form a circle"))
}

/// A temporary file in the same folder, deleted unless it is renamed.
fn temporary_beside(path: &Path) -> Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(TEMPORARY);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // less the umask; by default temporary files are readable by their owner only
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    let folder = folder_of(path);
    remove_left(folder);
    loop {
        let file = builder.tempfile_in(folder).map_err(|error| match error.kind() {
            ErrorKind::NotFound => {
                let folder = printable::text(&folder.display().to_string());
                Error::new(error.kind(), format!("there is no folder `{folder}`; make it first"))
            }
            _ => without_path(error),
        })?;
        // the lock says that a process is at work; the system frees that of a killed one. A process that
        // came before the lock may have removed the file as one that was left.
        let is_locked = file.as_file().lock().is_ok();
        if !is_locked || file.path().exists() {
            return Ok(file);
        }
    }
}

/// The error without the name of a temporary file, which the user does not know.
pub fn without_path(error: Error) -> Error {
    let text = error.to_string();
    let reason = text.split_once(" at path ").map_or(text.as_str(), |(reason, _)| reason);
    Error::new(error.kind(), reason)
}

/// Removes the temporary files that killed runs left in a folder: those that nobody holds a lock on.
fn remove_left(folder: &Path) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let is_ours = entry.file_name().to_string_lossy().starts_with(TEMPORARY);
        if !is_ours || !entry.file_type().is_ok_and(|kind| kind.is_file()) {
            continue;
        }
        let Ok(file) = std::fs::File::open(entry.path()) else { continue };
        // held until the file is gone: the process that made it may be about to lock it
        if file.try_lock().is_ok() {
            // what cannot be removed does not stand in the way of the new file
            let _ = std::fs::remove_file(entry.path());
        }
    }
}
