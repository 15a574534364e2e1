//! `groundtruth export`.

use std::error::Error;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use exchange::export::{Exported, Target, Term};
use groundtruth::film;

use super::scene::SceneArguments;
use super::witness::{self, By};
use super::{Exit, Outcome, output, print};

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// A scene file
    Toml,
    /// The scene language of POV-Ray 3.7
    Pov,
    /// The XML of Mitsuba 3. Meshes are files beside it, whose names begin as its own
    Mitsuba,
}

impl Format {
    /// The other renderer whose language it is.
    fn target(self) -> Option<Target> {
        match self {
            Self::Toml => None,
            Self::Pov => Some(By::Pov.target()),
            Self::Mitsuba => Some(By::Mitsuba.target()),
        }
    }
}

#[derive(Args)]
pub struct Export {
    #[command(flatten)]
    scene: SceneArguments,
    /// What to write. In another language than ours, all that it cannot say is listed, and nothing is written;
    /// docs/renderers.md has the table
    #[arg(long, value_enum, default_value_t = Format::Toml)]
    format: Format,
    /// Terms to leave out of the scene, with commas: phong (the highlights), ambient, background (where it lights
    /// nothing), absorption (of media), scaling (the 1/η² of refracted radiance), smooth (interpolated normals), or
    /// unshadowed (light that passes through objects: they block it)
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
        if self.scene.chosen_seed().is_some() {
            return Err("a scene file keeps no seed; give --seed where it is rendered".into());
        }
        let (mut scene, _) = self.scene.load()?;
        let inputs = self.scene.files_of(&scene);
        self.without.iter().for_each(|term| term.remove(&mut scene));
        if let Some(target) = self.format.target() {
            let (name, folder) = (self.scene.name(), self.scene.files_folder());
            // how the names of files beside the output begin
            let stem = self.file().and_then(Path::file_stem).unwrap_or("scene".as_ref());
            let said = witness::said(target, (name, &stem.to_string_lossy()), &scene, folder);
            return said.map_or(Ok(Exit::Unanswered), |said| self.write_all(&said, &inputs));
        }
        if let Some(folder) = self.scene.folder() {
            let folder = match self.file() {
                Some(output) => output::folder_seen_from(folder, output)?,
                None => folder.canonicalize()?,
            };
            scene = scenefile::files_from(&scene, &folder)?;
        }
        let text = scenefile::to_toml(&scene)?;
        output::check_distinct(self.file(), &inputs)?;
        self.write(&text)
    }

    /// Writes a scene in the language of another renderer, and the files beside it.
    fn write_all(&self, said: &Exported, inputs: &[PathBuf]) -> Outcome {
        if !said.files.is_empty() && self.file().is_none() {
            let problem = "this scene becomes several files; write it to one with -o, and the others go beside it";
            return Err(problem.into());
        }
        let folder = film::folder_of(self.file().unwrap_or(Path::new("")));
        let files = said.files.iter().map(|(name, bytes)| (folder.join(name), &bytes[..]));
        let files: Vec<(PathBuf, &[u8])> = files.collect();
        // all or none
        let outputs = || files.iter().map(|(output, _)| &**output).chain(self.file());
        output::check_distinct(outputs(), inputs)?;
        outputs().try_for_each(|output| self.check(output))?;
        files.iter().try_for_each(|(output, bytes)| self.write_to(output, bytes))?;
        self.write(&said.text)
    }

    fn write(&self, text: &str) -> Outcome {
        let Some(output) = self.file() else { return print(text) };
        self.write_to(output, text.as_bytes())?;
        Ok(Exit::Yes)
    }

    /// Whether it may be written.
    fn check(&self, path: &Path) -> Result<(), Box<dyn Error>> {
        if path.is_dir() {
            return Err(output::unwritable(path, "it is a folder"));
        }
        if path.exists() && !self.replace {
            // it may have been edited since it was exported
            let problem = "exists already; write to another file, or replace it with --replace";
            return Err(format!("{}: {problem}", path.display()).into());
        }
        Ok(())
    }

    fn write_to(&self, path: &Path, bytes: &[u8]) -> Result<(), Box<dyn Error>> {
        self.check(path)?;
        output::write(path, bytes)
    }

    /// The file to write, if it is not the standard output.
    fn file(&self) -> Option<&Path> {
        self.output.as_deref().filter(|path| !output::is_standard(path))
    }
}
