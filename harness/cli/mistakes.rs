//! `groundtruth mistakes`.

use std::error::Error;
use std::path::{Path, PathBuf};

use clap::Args;
use groundtruth::{film, printable, similar};
use judge::mistakes::{self, Cover, Mistake, table};

use super::{Outcome, mistake, print, progress};

#[derive(Args)]
pub struct Mistakes {
    /// A mistake: what is done wrong, where the book has it right, and how it looks; a scene of the gallery, or a scene
    /// file: the mistakes that it shows, and those that it does not; or a chapter, such as ch28: few scenes that show all its
    /// mistakes. All mistakes if left out
    #[arg(value_name = "MISTAKE|SCENE|CHAPTER")]
    name: Option<String>,
    /// Of a mistake: write the picture of a scene that shows it, the right one on the left, the wrong one on the right
    #[arg(short, long, value_name = "FILE", requires = "name")]
    output: Option<PathBuf>,
    /// Print everything as one page of Markdown: docs/mistakes.md
    #[arg(long, conflicts_with_all = ["name", "table"])]
    page: bool,
    /// Measure which scenes show which mistakes, and print the table
    #[arg(long, conflicts_with = "name")]
    table: bool,
}

impl Mistakes {
    pub fn run(&self) -> Outcome {
        if self.page {
            return print(&mistakes::page());
        }
        if self.table {
            return measured();
        }
        match &self.name {
            None => print(&listed(&mistakes::all())),
            Some(name) => match (mistakes::find(name), chapter(name)) {
                (Some(mistake), _) => mistake::told(mistake, self.output.as_deref()),
                (None, _) if self.output.is_some() => {
                    Err(format!("-o: a picture is of one mistake, and {name} is none").into())
                }
                (None, Some(_)) => print(&of_chapter(name)?),
                (None, None) => print(&of_scene(name)?),
            },
        }
    }
}

/// The number of `ch28`.
fn chapter(name: &str) -> Option<u32> {
    name.strip_prefix("ch").filter(|digits| digits.len() == 2)?.parse().ok()
}

fn listed(all: &[&Mistake]) -> String {
    let widest = all.iter().map(|mistake| mistake.name.len()).max().unwrap_or(0);
    let line = |it: &&Mistake| format!("ch. {:2}  {:widest$}  {}\n", it.chapter, it.name, it.words);
    all.iter().map(line).collect()
}

/// The number of a chapter that is written as `ch28`.
pub fn chapter_named(name: &str) -> Result<u32, String> {
    chapter(name).ok_or_else(|| format!("{name}: a chapter is written as ch28"))
}

/// What is said of a chapter without known mistakes.
pub fn none_of_chapter(chapter: u32) -> String {
    format!("no known mistakes of chapter {chapter}; `groundtruth mistakes` lists all")
}

/// Few scenes that show all mistakes of a chapter such as `ch28`.
pub fn of_chapter(name: &str) -> Result<String, String> {
    let chapter = chapter_named(name)?;
    let Cover { scenes, never_shown } = mistakes::fewest_scenes(chapter);
    if scenes.is_empty() && never_shown.is_empty() {
        return Err(none_of_chapter(chapter));
    }
    let names = |all: &[&Mistake]| {
        let names: Vec<&str> = all.iter().map(|mistake| mistake.name).collect();
        names.join(", ")
    };
    let mut text: String =
        scenes.iter().map(|(scene, shown)| format!("{scene}: {}\n", names(shown))).collect();
    if !never_shown.is_empty() {
        text += &format!("no scene shows: {}\n", names(&never_shown));
    }
    Ok(text)
}

fn of_scene(name: &str) -> Result<String, Box<dyn Error>> {
    let shown: Vec<&Mistake> = match gallery::find(name) {
        Some(_) => mistakes::shown_by(name).iter().map(|pair| pair.mistake).collect(),
        None if mistakes::is_file(name) => {
            let (scene, _) = scenefile::open(Path::new(name))?;
            let folder = film::folder_of(Path::new(name));
            let shown = table::shown(&mistakes::all(), &scene, folder)?;
            shown.into_iter().map(|(mistake, _)| mistake).collect()
        }
        None => {
            let scenes = gallery::scenes().map(|entry| entry.name);
            let names: Vec<&str> = scenes.chain(mistakes::all().iter().map(|it| it.name)).collect();
            let similar = similar::did_you_mean(name, &names);
            let scenes = "scene of the gallery (`groundtruth list`)";
            let wrong = "mistake (`groundtruth mistakes`)";
            return Err(format!("no {scenes} and no {wrong} is called `{name}`{similar}").into());
        }
    };
    let hidden = mistakes::others(&shown);
    let name = printable::name(name);
    let mut text = format!("{name} shows {} mistakes:\n{}", shown.len(), listed(&shown));
    text += &format!("\nIt does not show {}:\n", hidden.len());
    for (mistake, best) in hidden {
        let best = best.map_or("no scene shows it".to_owned(), |best| format!("{best} does"));
        text += &format!("{}  {}; {best}\n", mistake.name, mistake.words);
    }
    Ok(text)
}

/// Measures all scenes, with the progress on a terminal.
fn measured() -> Outcome {
    let scenes: Vec<gallery::Entry> = gallery::scenes().collect();
    let style = "{bar:40} {pos} of {len} scenes  {elapsed} elapsed, {eta} to go  {msg}";
    let bar = progress::bar(scenes.len() as u64, style);
    let mut text = mistakes::HEADING.to_owned();
    for entry in &scenes {
        bar.set_message(entry.name);
        text += &table::lines(entry)?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    print(&text)
}
