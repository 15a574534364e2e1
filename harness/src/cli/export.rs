//! `groundtruth export`.

use std::error::Error;
use std::path::{Path, PathBuf};

use clap::Args;
use groundtruth::{film, scene};

use super::output;
use super::scene::SceneArguments;
use super::{Exit, Outcome, print};

#[derive(Args)]
pub struct Export {
    #[command(flatten)]
    scene: SceneArguments,
    /// The scene file to write; file names in it are relative to its folder. If left out, or -, the scene
    /// goes to the standard output, with absolute file names
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Replace the output if it exists
    #[arg(long, requires = "output")]
    replace: bool,
}

impl Export {
    pub fn run(&self) -> Outcome {
        if self.scene.has_seed() {
            return Err("a scene file keeps no seed; give --seed where it is rendered".into());
        }
        let (mut scene, _) = self.scene.load()?;
        if let Some(folder) = self.scene.folder() {
            let folder = self.relative_to_output(folder)?;
            scene = scene.files_from(&folder)?;
        }
        let text = scene::to_toml(&scene)?;
        let Some(output) = self.file() else { return print(&text) };
        if output.is_dir() {
            return Err(unwritable(output, "it is a folder"));
        }
        if output.exists() && !self.replace {
            // it may have been edited since it was exported
            let problem = "exists already; write to another file, or replace it with --replace";
            return Err(format!("{}: {problem}", output.display()).into());
        }
        film::replace(output, text.as_bytes()).map_err(|e| unwritable(output, e))?;
        Ok(Exit::Yes)
    }

    /// The file to write, if it is not the standard output.
    fn file(&self) -> Option<&Path> {
        self.output.as_deref().filter(|path| !output::is_standard(path))
    }

    /// The folder of the scene, relative to the folder of the output; absolute without an output.
    fn relative_to_output(&self, folder: &Path) -> Result<PathBuf, Box<dyn Error>> {
        // resolves symbolic links, so that `..` is the parent folder
        let folder = folder.canonicalize()?;
        let Some(output) = self.file() else { return Ok(folder) };
        let from = film::folder_of(output).canonicalize().map_err(|e| unwritable(output, e))?;
        // on Windows there is no relative path from one drive to another
        Ok(pathdiff::diff_paths(&folder, from).unwrap_or(folder))
    }
}

fn unwritable(path: &Path, reason: impl std::fmt::Display) -> Box<dyn Error> {
    format!("{}: cannot be written: {reason}", path.display()).into()
}
