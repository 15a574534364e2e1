//! Mitsuba itself, as a module of Python that renders a scene.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

use crate::export::{Exported, program};
use pictures::compare::{Picture, Transfer};
use pictures::running::{last_lines, run};

/// What renders the scene.
const SCRIPT: &str = include_str!("render.py");

/// A Python that has the module.
#[derive(Clone, Debug)]
pub struct Mitsuba {
    file: PathBuf,
    /// Its version, in words.
    pub version: String,
}

impl Mitsuba {
    /// The Python of this file, or `python3` on the path.
    ///
    /// # Errors
    /// There is none, or it has no module `mitsuba`.
    pub fn find(given: Option<PathBuf>) -> Result<Self, String> {
        let file = program("python3", given, "python3")?;
        let version = "import mitsuba; print('Mitsuba', mitsuba.__version__)";
        let run = Command::new(&file).args(["-c", version]).stdin(Stdio::null()).output();
        let run = run.map_err(|e| format!("{}: cannot be started: {e}", file.display()))?;
        if !run.status.success() {
            return Err(format!(
                "{}: it has no module `mitsuba`: `pip install mitsuba`, or run scripts/witnesses.sh, which installs it in \
                 target/mitsuba; then give that Python with --program",
                file.display()
            ));
        }
        let version = String::from_utf8_lossy(&run.stdout).trim().to_owned();
        Ok(Self { file, version })
    }

    /// Renders a scene in a folder.
    ///
    /// # Errors
    /// It cannot be started, takes longer than the limit, or fails.
    pub fn render(
        &self,
        said: &Exported,
        folder: &Path,
        limit: Duration,
    ) -> Result<Picture, String> {
        let problem = |what: &str| format!("{}: {what}", self.file.display());
        let write = |name: &str, bytes: &[u8]| {
            std::fs::write(folder.join(name), bytes).map_err(|e| problem(&e.to_string()))
        };
        write("render.py", SCRIPT.as_bytes())?;
        said.files.iter().try_for_each(|(name, bytes)| write(name, bytes))?;
        let mut command = Command::new(&self.file);
        command.current_dir(folder).args(["render.py", "scene.xml", "scene.exr"]);
        write("scene.xml", said.text.as_bytes())?;
        let run = run(&mut command, limit).map_err(|e| problem(&e))?;
        if !run.status.success() {
            let last = last_lines(&run.messages);
            return Err(problem(&format!("no picture ({}):\n  {last}", run.status)));
        }
        let picture = Picture::read(&folder.join("scene.exr"), Some(Transfer::Linear));
        picture.map_err(|e| problem(&e.to_string()))
    }
}
