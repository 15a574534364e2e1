//! The other renderers themselves, as programs that render a scene.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use pictures::compare::{Picture, Transfer};
use pictures::running::{last_lines, run};

use super::{Exported, Target};

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
        let it = Self { target, file: file(target.language().program, given)? };
        match target.language().missing {
            Some(missing) if it.said_version()?.is_none() => {
                Err(format!("{}: {missing}", it.file.display()))
            }
            _ => Ok(it),
        }
    }

    /// Name and version, in words.
    pub fn version(&self) -> String {
        self.said_version().ok().flatten().unwrap_or_else(|| self.target.name().to_owned())
    }

    fn said_version(&self) -> Result<Option<String>, String> {
        const LIMIT: Duration = Duration::from_secs(60);
        let mut command = Command::new(&self.file);
        command.args(self.target.language().version);
        let said = run(&mut command, LIMIT).map_err(|e| format!("{}: {e}", self.file.display()))?;
        let text = String::from_utf8_lossy(&said.messages).into_owned();
        let line = text.lines().find(|line| line.starts_with(self.target.name()));
        Ok(line.map(|line| line.trim().to_owned()))
    }

    /// Renders a scene of this size in a folder, which is its working folder: POV-Ray writes only there.
    ///
    /// # Errors
    /// It cannot be started, takes longer than the limit, or fails.
    pub fn render(
        &self,
        said: &Exported,
        size: [u32; 2],
        folder: &Path,
        limit: Duration,
    ) -> Result<Picture, String> {
        let problem = |what: &str| format!("{}: {what}", self.file.display());
        let write = |name: &str, bytes: &[u8]| {
            std::fs::write(folder.join(name), bytes).map_err(|e| problem(&e.to_string()))
        };
        let language = self.target.language();
        let [scene, picture] = language.files;
        write(scene, said.text.as_bytes())?;
        language.script.iter().try_for_each(|[name, text]| write(name, text.as_bytes()))?;
        said.files.iter().try_for_each(|(name, bytes)| write(name, bytes))?;
        let [width, height] = size.map(|side| side.to_string());
        let arguments = language.arguments.replace("{width}", &width).replace("{height}", &height);
        let mut command = Command::new(&self.file);
        command.current_dir(folder).args(arguments.split(' '));
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
