//! Files that are replaced whole or not at all.

use std::path::Path;

use formats::pictures::base64;
use formats::replace::{replace, replace_all};

/// Law: a temporary file that a killed run left is removed by the next file written into that folder;
/// one whose process is at work stays, and so do files and folders of other names. Oracle: a lock that
/// the test holds.
#[test]
fn what_a_killed_run_left_is_removed_by_the_next() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let names = [".groundtruth-left", ".groundtruth-held", "groundtruth-mine"].map(at);
    names.iter().for_each(|path| std::fs::write(path, "half").expect("written"));
    std::fs::create_dir(at(".groundtruth-folder")).expect("made");
    let held = std::fs::File::open(&names[1]).expect("it is there");
    held.lock().expect("nobody else has it");
    replace(&at("new"), b"whole").expect("written");
    assert_eq!(names.each_ref().map(|path| path.exists()), [false, true, true]);
    assert!(at(".groundtruth-folder").exists());
    drop(held);
    replace(&at("new"), b"whole").expect("written");
    assert!(!names[1].exists());
    assert_eq!(std::fs::read_dir(folder.path()).expect("there").count(), 3);
}

/// Law: many writers of one folder do not remove each other's files. Oracle: none of them fails.
#[test]
fn writers_at_work_leave_each_other_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    std::thread::scope(|scope| {
        for name in ["a", "b", "c", "d"] {
            let path = folder.path().join(name);
            scope.spawn(move || (0..200).for_each(|_| replace(&path, b"x").expect("written")));
        }
    });
    assert_eq!(std::fs::read_dir(folder.path()).expect("there").count(), 4);
}

/// Law: of files that belong together none is replaced unless all can be. Oracle: the old bytes.
#[test]
fn files_that_belong_together_are_replaced_together() {
    let folder = tempfile::tempdir().expect("a folder");
    let [data, page] = ["data", "missing/page"].map(|name| folder.path().join(name));
    std::fs::write(&data, "old").expect("written");
    let files: [(&Path, &[u8]); 2] = [(&data, b"new"), (&page, b"new")];
    assert_eq!(replace_all(&files).expect_err("there is no such folder").0, 1);
    assert_eq!(std::fs::read(&data).expect("there"), b"old");
    std::fs::create_dir(folder.path().join("missing")).expect("made");
    replace_all(&files).expect("written");
    assert_eq!(std::fs::read(&data).expect("there"), b"new");
}

/// Law: three bytes are four letters of base 64, padded. Oracle: the examples of RFC 4648.
#[test]
fn base64_has_the_rfcs_examples() {
    for (bytes, text) in [
        ("", ""),
        ("f", "Zg=="),
        ("fo", "Zm8="),
        ("foo", "Zm9v"),
        ("foob", "Zm9vYg=="),
        ("fooba", "Zm9vYmE="),
        ("foobar", "Zm9vYmFy"),
    ] {
        assert_eq!(base64(bytes.as_bytes()), text);
    }
}

#[cfg(unix)]
mod on_unix {
    use std::os::unix::fs::{PermissionsExt, symlink};

    use formats::replace::replaceable;

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

    /// Law: a named pipe that nobody reads is refused at once, before and after there is something to write. Oracle: a
    /// pipe of `mkfifo`; the test would wait for ever.
    #[test]
    fn a_named_pipe_is_refused_and_not_waited_for() {
        let folder = tempfile::tempdir().expect("a folder");
        let pipe = folder.path().join("pipe.sums");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status().expect("it starts");
        assert!(made.success());
        for refused in [replaceable(&pipe), replace(&pipe, b"x")] {
            assert!(refused.expect_err("nobody reads").to_string().contains("named pipe"));
        }
        assert!(!std::fs::metadata(&pipe).expect("it stays").is_file());
    }
}
