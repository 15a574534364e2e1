//! Files that cannot be written to their end.

use std::process::Command;

use super::{GROUNDTRUTH, files_in};

/// Law: where the disk takes no more, the error names the file that was asked for and no temporary one, and nothing is
/// left of a picture. Oracle: a limit on the size of files, which the shell sets.
#[test]
fn no_error_names_a_temporary_file() {
    for (command, error) in [
        (
            "render ch03/three-objects -o a.ppm --size 64x64",
            "error: a.ppm: cannot be written: File too large (os error 27)",
        ),
        (
            "goldens accept ch03/three-objects --folder mine --because seen --size 64x64",
            "error: mine: File too large (os error 27)",
        ),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        let line = format!("trap '' XFSZ; ulimit -f 2; exec '{GROUNDTRUTH}' {command}");
        let mut shell = Command::new("sh");
        let output =
            shell.args(["-c", &line]).current_dir(folder.path()).output().expect("a shell");
        assert_eq!(output.status.code(), Some(2), "{command}");
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(stderr.lines().last(), Some(error), "{command}");
        assert!(!files_in(folder.path()).contains(&"a.ppm".to_owned()), "{command}");
    }
}
