//! `rays`.

use std::error::Error;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ask::{JunitCase, JunitResult};
use clap::Args;
use groundtruth::printable;
use groundtruth::scene::Scene;
use groundtruth::world::{DEFAULT_SEED, World};
use judge::mistakes::Mistaken;
use rays::{LawReport, LogError, RayLaw, RayVerdict, Traced, WRITERS};
use serde_json::Value;

use super::{Exit, Outcome, output, print};

#[derive(Args)]
pub struct Rays {
    /// What your program wrote of its rays, one log or several; - is the standard input; docs/rays.md has the format
    #[arg(value_name = "LOG", required_unless_present_any = ["init", "laws"])]
    logs: Vec<PathBuf>,
    /// Print a file for your program that writes such a log
    #[arg(long, value_name = "LANGUAGE", value_parser = writer, exclusive = true)]
    init: Option<&'static str>,
    /// List the laws, what each needs, and its usual causes
    #[arg(long, exclusive = true)]
    laws: bool,
    /// Print a line for each pixel, the worst last
    #[arg(long, conflicts_with_all = ["json", "output"])]
    pixels: bool,
    /// Write the laws of each log for continuous integration (JUnit's XML)
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Write the verdict on one log with the tree and drawings as a page (.html)
    #[arg(short, long, value_name = "FILE", conflicts_with = "json")]
    output: Option<PathBuf>,
    /// Print JSON; of several logs, a list
    #[arg(long)]
    json: bool,
}

impl Rays {
    pub fn run(self) -> Outcome {
        if let Some(writer) = self.init {
            return print(writer);
        }
        if self.laws {
            return print(&rays::laws_text());
        }
        let is_no_page = |it: &&PathBuf| it.extension().is_none_or(|end| end != "html");
        if let Some(file) = self.output.as_ref().filter(is_no_page) {
            return Err(format!("{}: a page ends with .html", file.display()).into());
        }
        if self.output.is_some() && self.logs.len() > 1 {
            return Err("--output: a page has one log".into());
        }
        output::once(&self.logs, "input")?;
        output::once(self.output.iter().chain(&self.junit), "output")?;
        let (mut exit, mut suites, mut told) = (Exit::Yes, Vec::new(), Vec::new());
        for path in &self.logs {
            let verdict = judged(path)?;
            if verdict.is_broken() {
                exit = Exit::No;
            }
            if self.json {
                told.push(verdict.json());
            } else {
                print(&self.text(path, &verdict))?;
            }
            let suite = || (path.display().to_string(), cases(&verdict));
            suites.extend(self.junit.is_some().then(suite));
            if let Some(file) = &self.output {
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                output::write(file, verdict.page(&name).as_bytes())?;
            }
        }
        if self.json {
            let one = told.len() == 1;
            let all = if one { told.swap_remove(0) } else { Value::Array(told) };
            print(&(serde_json::to_string_pretty(&all)? + "\n"))?;
        }
        if let Some(file) = &self.junit {
            output::write(file, ask::junit("rays", suites).as_bytes())?;
        }
        Ok(exit)
    }

    /// What is printed of a log: all of it, or a line if there are several logs or a page.
    fn text(&self, path: &Path, verdict: &RayVerdict) -> String {
        let name =
            if self.logs.len() > 1 { format!("{}: ", path.display()) } else { String::new() };
        match (self.pixels, self.logs.len() > 1 || self.output.is_some()) {
            (true, _) => format!("{name}{}", verdict.pixels_text()),
            (_, true) => printable::text(&format!("{name}{}", verdict.sentence())) + "\n",
            _ => verdict.text(),
        }
    }
}

/// The laws as cases.
fn cases(verdict: &RayVerdict) -> Vec<JunitCase> {
    let case = |(law, asked): &(&'static RayLaw, LawReport)| {
        let result = match asked.outcome() {
            rays::Outcome::Held => JunitResult::Success,
            rays::Outcome::NotAsked => JunitResult::Skipped,
            rays::Outcome::Broken => JunitResult::Failure,
        };
        let found = asked.roots().chain(&asked.findings).next();
        let words = found.map_or(String::new(), |found| {
            let cause = law.cause(asked.roots()).map_or(String::new(), |it| format!(": {it}"));
            format!("{} {}{cause}", verdict.traced.name(found.ray), found.words)
        });
        (law.name.to_owned(), result, words)
    };
    verdict.asked.iter().map(case).collect()
}

fn judged(path: &Path) -> Result<RayVerdict, Box<dyn Error>> {
    let named = |problem: String| format!("{}: {problem}", path.display());
    let log = match output::is_standard(path) {
        true => rays::read(std::io::stdin().lock()),
        false => File::open(path).map_err(LogError::from).and_then(rays::read),
    };
    let log = log.map_err(|e| named(e.to_string()))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let (scene, world) =
        rays::world_of(&log, folder, |name| named_scene(name, folder)).map_err(named)?.unzip();
    let mut verdict = RayVerdict::of(Traced::of(log, world.map(Arc::new)));
    if let Some(scene) = scene {
        verdict.name_mistakes(Mistaken::each(&scene, folder, DEFAULT_SEED));
    }
    Ok(verdict)
}

/// A scene of the gallery, or a file beside the log.
fn named_scene(name: &str, folder: &Path) -> Result<(Scene, World), String> {
    if let Some(entry) = gallery::find(name) {
        let scene = (entry.build)();
        let world = World::build(&scene).map_err(|e| e.to_string())?;
        return Ok((scene, world));
    }
    let file = folder.join(name);
    // a log is somebody else's: it opens nothing but scenes
    if !file.exists() || file.extension().is_none_or(|end| end != "toml") {
        return Err(gallery::unknown(name));
    }
    scenefile::read(&file).map_err(|e| e.to_string())
}

/// The file of a language.
fn writer(language: &str) -> Result<&'static str, String> {
    let found = WRITERS.into_iter().find(|(name, _)| *name == language);
    let known = || WRITERS.map(|(name, _)| name).join(", ");
    found.map(|(_, file)| file).ok_or_else(|| format!("the languages are {}", known()))
}
