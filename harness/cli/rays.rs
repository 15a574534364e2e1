//! `rays`.

use std::error::Error;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use groundtruth::scene::Scene;
use groundtruth::world::{self, World};
use rays::{RayVerdict, Traced, WriterLanguage};

use super::{Exit, Outcome, print};

#[derive(Args)]
pub struct Rays {
    /// What your program wrote of its rays; docs/rays.md has the format
    #[arg(value_name = "LOG", required_unless_present_any = ["init", "laws"])]
    log: Option<PathBuf>,
    /// Print a file for your program that writes such a log
    #[arg(long, value_name = "LANGUAGE", value_parser = language, exclusive = true)]
    init: Option<WriterLanguage>,
    /// List the laws, what each needs, and its usual causes
    #[arg(long, exclusive = true)]
    laws: bool,
    /// Write the verdict with the tree and drawings as a page (.html)
    #[arg(short, long, value_name = "FILE", conflicts_with = "json")]
    output: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

impl Rays {
    pub fn run(self) -> Outcome {
        if let Some(language) = self.init {
            return print(language.writer());
        }
        if self.laws {
            return print(&rays::laws_text());
        }
        let Some(path) = &self.log else { return Ok(Exit::Unanswered) };
        let traced = read(path)?;
        let verdict = RayVerdict::of(traced);
        if let Some(output) = &self.output {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            super::output::write(output, verdict.page(&name).as_bytes())?;
            print(&(verdict.sentence() + "\n"))?;
            return Ok(exit(&verdict));
        }
        match self.json {
            true => print(&(serde_json::to_string_pretty(&verdict.json())? + "\n"))?,
            false => print(&verdict.text())?,
        };
        Ok(exit(&verdict))
    }
}

fn exit(verdict: &RayVerdict) -> Exit {
    if verdict.is_broken() { Exit::No } else { Exit::Yes }
}

fn read(path: &PathBuf) -> Result<Traced, Box<dyn Error>> {
    let named = |problem: String| format!("{}: {problem}", path.display());
    let file = File::open(path).map_err(|e| named(e.to_string()))?;
    let log = rays::read(file).map_err(|e| named(e.to_string()))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let world = rays::world_of(&log, folder, |name| named_scene(name, folder)).map_err(named)?;
    Ok(Traced::of(log, world.map(|(_, world)| Arc::new(world))))
}

/// A scene of the gallery, or a file beside the log.
fn named_scene(name: &str, folder: &Path) -> Result<(Scene, World), String> {
    if let Some(entry) = gallery::find(name) {
        let scene = (entry.build)();
        let world = World::build(&scene).map_err(|e| e.to_string())?;
        return Ok((scene, world));
    }
    let file = folder.join(name);
    if !file.exists() {
        return Err(gallery::unknown(name));
    }
    world::read(&file).map_err(|e| e.to_string())
}

fn language(name: &str) -> Result<WriterLanguage, String> {
    let named =
        |(known, language, _): &(&str, WriterLanguage, &str)| (*known == name).then_some(*language);
    let known =
        || WriterLanguage::ALL.iter().map(|(name, ..)| *name).collect::<Vec<_>>().join(", ");
    WriterLanguage::ALL
        .iter()
        .find_map(named)
        .ok_or_else(|| format!("the languages are {}", known()))
}
