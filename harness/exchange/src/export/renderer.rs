//! The other renderers themselves, as programs that render a scene.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use pictures::compare::{Picture, Transfer};
use pictures::running::{last_lines, run};

use super::{Exported, Target};

/// What renders a scene of Mitsuba.
const SCRIPT: &str = include_str!("mitsuba/render.py");

/// A program that renders scenes of a target.
#[derive(Clone, Debug)]
pub struct Renderer {
    target: Target,
    file: PathBuf,
}

impl Renderer {
    /// The program of this file, or on the path: `povray`, or a `python3` that has the module `mitsuba`.
    ///
    /// # Errors
    /// There is none; the message says what to install or write.
    pub fn find(target: Target, given: Option<PathBuf>) -> Result<Self, String> {
        let name = match target {
            Target::Pov => "povray",
            Target::Mitsuba => "python3",
        };
        let it = Self { target, file: file(name, given)? };
        if target == Target::Mitsuba && it.said_version()?.is_none() {
            return Err(format!(
                "{}: it has no module `mitsuba`: `pip install mitsuba`, or run scripts/witnesses.sh, which installs it in \
                 target/mitsuba; then give that Python with --program",
                it.file.display()
            ));
        }
        Ok(it)
    }

    /// Name and version, in words.
    pub fn version(&self) -> String {
        self.said_version().ok().flatten().unwrap_or_else(|| self.target.name().to_owned())
    }

    fn said_version(&self) -> Result<Option<String>, String> {
        const LIMIT: Duration = Duration::from_secs(60);
        let mut command = Command::new(&self.file);
        match self.target {
            Target::Pov => command.arg("--version"),
            Target::Mitsuba => {
                command.args(["-c", "import mitsuba; print('Mitsuba', mitsuba.__version__)"])
            }
        };
        let said = run(&mut command, LIMIT).map_err(|e| format!("{}: {e}", self.file.display()))?;
        let text = String::from_utf8_lossy(&said.messages).into_owned();
        let line = text.lines().find(|line| line.starts_with(self.target.name()));
        Ok(line.map(|line| line.trim().to_owned()))
    }

    /// Renders a scene of this size in a folder: POV-Ray writes in its working folder only.
    ///
    /// POV-Ray sends one ray through the centre of each pixel (`-A`: no more where neighbours differ) and writes linear values
    /// (`File_Gamma=1`) of 16 bits (`+FN16`).
    ///
    /// # Errors
    /// It cannot be started, takes longer than the limit, or fails.
    pub fn render(
        &self,
        said: &Exported,
        [width, height]: [u32; 2],
        folder: &Path,
        limit: Duration,
    ) -> Result<Picture, String> {
        let problem = |what: &str| format!("{}: {what}", self.file.display());
        let write = |name: &str, bytes: &[u8]| {
            std::fs::write(folder.join(name), bytes).map_err(|e| problem(&e.to_string()))
        };
        let [scene, picture] = match self.target {
            Target::Pov => ["scene.pov", "scene.png"],
            Target::Mitsuba => ["scene.xml", "scene.exr"],
        };
        write(scene, said.text.as_bytes())?;
        write("render.py", SCRIPT.as_bytes())?;
        said.files.iter().try_for_each(|(name, bytes)| write(name, bytes))?;
        let mut command = Command::new(&self.file);
        command.current_dir(folder);
        match self.target {
            Target::Pov => {
                command.args([format!("+I{scene}"), format!("+O{picture}")]);
                command.args(["-A", "-D", "+FN16", "File_Gamma=1.0"]);
                command.args([format!("+W{width}"), format!("+H{height}")])
            }
            Target::Mitsuba => command.args(["render.py", scene, picture]),
        };
        let picture = folder.join(picture);
        let run = run(&mut command, limit).map_err(|e| problem(&e))?;
        if !(run.status.success() && picture.is_file()) {
            let last = last_lines(&run.messages);
            return Err(problem(&format!("no picture ({}):\n  {last}", run.status)));
        }
        Picture::read(&picture, Some(Transfer::Linear)).map_err(|e| problem(&e.to_string()))
    }
}

/// The program of this name: `given`, or the first of the folders in `PATH` that has it.
fn file(name: &str, given: Option<PathBuf>) -> Result<PathBuf, String> {
    // it is started in another folder
    let absolute = |file: PathBuf| std::path::absolute(&file).unwrap_or(file);
    if let Some(given) = given {
        return match given.is_file() {
            true => Ok(absolute(given)),
            false => Err(format!("--program {}: there is no such file", given.display())),
        };
    }
    let folders = std::env::var_os("PATH").unwrap_or_default();
    let found = std::env::split_paths(&folders).map(|it| it.join(name)).find(|it| it.is_file());
    found.map(absolute).ok_or_else(|| {
        format!(
            "there is no program `{name}` on the path; install it (Debian: `apt-get install {name}`), or give its \
             file with --program"
        )
    })
}
