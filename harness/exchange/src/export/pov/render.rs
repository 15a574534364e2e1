//! POV-Ray itself, as a program that renders a scene.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use pictures::running::{last_lines, run};

/// The program.
#[derive(Clone, Debug)]
pub struct PovRay {
    file: PathBuf,
}

impl PovRay {
    /// The program of this file, or `povray` on the path.
    ///
    /// # Errors
    /// There is none.
    pub fn find(given: Option<PathBuf>) -> Result<Self, String> {
        super::super::program("povray", given, "povray").map(|file| Self { file })
    }

    /// The version, as it says it.
    pub fn version(&self) -> Option<String> {
        const LIMIT: Duration = Duration::from_secs(10);
        let said = run(Command::new(&self.file).arg("--version"), LIMIT).ok()?;
        let text = String::from_utf8_lossy(&said.messages).into_owned();
        text.lines().find(|line| line.starts_with("POV-Ray")).map(|line| line.trim().to_owned())
    }

    /// Renders the text of a scene in a folder, where it writes the picture: it writes in its working folder only.
    ///
    /// One ray through the centre of each pixel (`-A`: no more where neighbours differ), linear values (`File_Gamma=1`)
    /// of 16 bits (`+FN16`).
    ///
    /// # Errors
    /// It cannot be started, takes longer than the limit, or fails.
    pub fn render(
        &self,
        text: &str,
        size: [u32; 2],
        folder: &Path,
        limit: Duration,
    ) -> Result<PathBuf, String> {
        let problem = |what: &str| format!("{}: {what}", self.file.display());
        std::fs::write(folder.join("scene.pov"), text).map_err(|e| problem(&e.to_string()))?;
        let [width, height] = size;
        let mut command = Command::new(&self.file);
        command.current_dir(folder);
        command.args(["+Iscene.pov", "+Oscene.png", "-A", "-D", "+FN16", "File_Gamma=1.0"]);
        command.args([format!("+W{width}"), format!("+H{height}")]);
        let run = run(&mut command, limit).map_err(|e| problem(&e))?;
        let picture = folder.join("scene.png");
        if run.status.success() && picture.is_file() {
            return Ok(picture);
        }
        Err(problem(&format!("no picture ({}):\n  {}", run.status, last_lines(&run.messages))))
    }
}
