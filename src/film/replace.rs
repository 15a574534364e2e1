//! Output files: replaced whole or not at all, through symbolic links, with the mode they had.

use std::io::{Error, Result, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

/// How the names of temporary files begin. A run that is killed leaves them behind.
pub const TEMPORARY: &str = ".groundtruth-";

/// Replaces a file by `bytes`, completely or not at all.
///
/// A symbolic link stays, and what it points to is replaced. An existing file keeps its mode; a new
/// one gets that of the umask. What is neither file nor folder, such as a pipe, is written to.
///
/// # Errors
/// The file cannot be written; nothing was left behind.
pub fn replace(path: &Path, bytes: &[u8]) -> Result<()> {
    let target = target_of(path)?;
    let old = std::fs::metadata(&target).ok();
    if old.as_ref().is_some_and(|old| !old.is_file() && !old.is_dir()) {
        return std::fs::OpenOptions::new().write(true).open(target)?.write_all(bytes);
    }
    let mut temporary = temporary_beside(&target)?;
    temporary.write_all(bytes)?;
    if let Some(old) = old {
        temporary.as_file().set_permissions(old.permissions())?;
    }
    temporary.persist(target).map_err(|e| e.error)?;
    Ok(())
}

/// Whether [`replace()`] can write there, found out before there is something to write.
///
/// # Errors
/// As [`replace()`].
pub fn replaceable(path: &Path) -> Result<()> {
    let target = target_of(path)?;
    match std::fs::metadata(&target) {
        Ok(old) if old.is_dir() => Err(Error::other("it is a folder")),
        Ok(old) if !old.is_file() => std::fs::OpenOptions::new().write(true).open(target).map(drop),
        _ => temporary_beside(&target).map(drop),
    }
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
    // without the name of the temporary file, which the user does not know
    builder.tempfile_in(folder_of(path)).map_err(|error| {
        let text = error.to_string();
        let reason = text.split_once(" at path ").map_or(text.as_str(), |(reason, _)| reason);
        Error::new(error.kind(), reason)
    })
}

#[cfg(all(test, unix))]
mod tests {
    use std::os::unix::fs::{PermissionsExt, symlink};

    use super::*;

    fn mode(path: &Path) -> u32 {
        std::fs::metadata(path).expect("it is there").permissions().mode() & 0o7777
    }

    /// Law: a link stays, and the file it points to is replaced, also by way of a second link, and where
    /// there is none yet; no temporary file is left. Oracle: the file system.
    #[test]
    fn a_link_stays_and_its_target_is_replaced() {
        let folder = tempfile::tempdir().expect("a folder");
        let [target, link, second] = ["target", "link", "second"].map(|n| folder.path().join(n));
        symlink("target", &link).expect("linked");
        symlink(&link, &second).expect("linked");
        for (path, bytes) in [(&second, b"new"), (&link, b"old"), (&second, b"end")] {
            replaceable(path).expect("the folder can be written to");
            replace(path, bytes).expect("it can be written");
            assert!(link.is_symlink() && second.is_symlink() && !target.is_symlink());
            assert_eq!(std::fs::read(&target).expect("written"), bytes);
        }
        assert_eq!(std::fs::read_dir(folder.path()).expect("it is there").count(), 3);
        let circle = folder.path().join("circle");
        symlink("circle", &circle).expect("linked");
        replaceable(&circle).expect_err("it ends nowhere");
        replace(&circle, b"").expect_err("it ends nowhere");
    }

    /// Law: an existing file keeps its mode; a new one has the mode of one made by the standard library.
    /// Oracle: the modes of files made so.
    #[test]
    fn an_existing_file_keeps_its_mode_and_a_new_one_has_the_usual_mode() {
        let folder = tempfile::tempdir().expect("a folder");
        let [usual, new] = ["usual", "new"].map(|name| folder.path().join(name));
        std::fs::write(&usual, "").expect("written");
        replace(&new, b"1").expect("written");
        assert_eq!(mode(&new), mode(&usual));
        for kept in [0o600, 0o640, 0o664, 0o755] {
            std::fs::set_permissions(&new, std::fs::Permissions::from_mode(kept)).expect("mine");
            replace(&new, b"2").expect("written");
            assert_eq!(mode(&new), kept);
        }
    }

    /// Law: a device is written to, not replaced. Oracle: it is still one.
    #[test]
    fn a_device_is_written_to() {
        let null = Path::new("/dev/null");
        replaceable(null).expect("everyone can write there");
        replace(null, b"gone").expect("everyone can write there");
        assert!(!std::fs::metadata(null).expect("it is there").is_file());
    }
}
