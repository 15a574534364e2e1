//! `groundtruth export`.

use std::error::Error;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use groundtruth::{film, scene};
use harness::export::{Term, listed, pbrt};

use super::scene::SceneArguments;
use super::{Exit, Outcome, output, print, witness};

/// What is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// A scene file
    Toml,
    /// The scene language of POV-Ray 3.7
    Pov,
    /// A scene file of pbrt-v4
    Pbrt,
}

#[derive(Args)]
pub struct Export {
    #[command(flatten)]
    scene: SceneArguments,
    /// What to write. In another language than ours, all that it cannot say is listed, and nothing is written;
    /// docs/renderers.md has the table
    #[arg(long, value_enum, default_value_t = Format::Toml)]
    format: Format,
    /// Terms to leave out of the scene: phong (the highlights), ambient, background (where it lights nothing) or
    /// shadowless (all cast shadows), with commas
    #[arg(long, value_name = "TERMS", value_delimiter = ',')]
    without: Vec<Term>,
    /// The file to write; file names in it are relative to its folder. If left out, or -, the scene
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
        self.without.iter().for_each(|term| term.remove(&mut scene));
        if self.format == Format::Pov {
            let said = witness::said(self.scene.name(), &scene);
            return said.map_or(Ok(Exit::Unanswered), |text| self.write(&text));
        }
        if self.format == Format::Pbrt {
            let folder = self.scene.folder().unwrap_or(Path::new(""));
            return match pbrt::write(self.scene.name(), &scene, folder)? {
                Ok(text) => self.write(&text),
                Err(all) => {
                    eprintln!("error: {}", listed("pbrt", &all));
                    Ok(Exit::Unanswered)
                }
            };
        }
        if let Some(folder) = self.scene.folder() {
            let folder = self.relative_to_output(folder)?;
            scene = scene.files_from(&folder)?;
        }
        self.write(&scene::to_toml(&scene)?)
    }

    /// Writes the text to the output.
    fn write(&self, text: &str) -> Outcome {
        let Some(output) = self.file() else { return print(text) };
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
