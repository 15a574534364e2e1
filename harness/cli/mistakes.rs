//! `groundtruth mistakes`.

use std::error::Error;
use std::path::Path;

use clap::Args;
use groundtruth::scene::Scene;
use groundtruth::similar;
use judge::mistakes::known::Known;
use judge::mistakes::{self, Cover, Mistake, Mistaken, table};
use pictures::percent;
use pictures::told::NEXT;

use super::scene::SceneArguments;
use super::{Outcome, print, progress};

/// A known mistake with which a picture is rendered or explained.
#[derive(Args)]
pub struct MistakeArgument {
    /// As a program with this known mistake does it (`mistakes` lists them)
    #[arg(long, value_name = "NAME", value_parser = named)]
    mistake: Option<&'static Mistake>,
}

impl MistakeArgument {
    /// The name of the mistake, if there is one.
    pub fn name(&self) -> Option<&'static str> {
        self.mistake.map(|mistake| mistake.name)
    }

    /// The program with the mistake, if there is one, on the scene that was read by these arguments.
    ///
    /// # Errors
    /// The mistake does not apply to the scene.
    pub fn mistaken(
        &self,
        arguments: &SceneArguments,
        scene: &Scene,
    ) -> Result<Option<Mistaken>, Box<dyn Error>> {
        let Some(mistake) = self.mistake else { return Ok(None) };
        let folder = arguments.folder().unwrap_or(Path::new(""));
        let mistaken = Mistaken::new(mistake, scene, folder, arguments.seed())?;
        let refused = || {
            let Mistake { known: Known { name, words, .. }, .. } = mistake;
            format!(
                "the scene has nothing that {name} changes ({words}); `groundtruth mistakes {name}` lists scenes \
                 that show it"
            )
        };
        Ok(Some(mistaken.ok_or_else(refused)?))
    }
}

/// The mistake of this name.
fn named(name: &str) -> Result<&'static Mistake, String> {
    let names: Vec<&str> = mistakes::all().iter().map(|mistake| mistake.name).collect();
    mistakes::find(name).ok_or_else(|| {
        let similar = similar::did_you_mean(name, &names);
        format!("no known mistake has this name (`groundtruth mistakes` lists them){similar}")
    })
}

#[derive(Args)]
pub struct Mistakes {
    /// A scene of the gallery: the mistakes that it shows, and those that it does not; a chapter, such as
    /// ch28: few scenes that show all its mistakes; or a mistake: the scenes that show it. All mistakes if left out
    #[arg(value_name = "SCENE|CHAPTER|MISTAKE")]
    name: Option<String>,
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
            Some(name) => match (chapter(name), mistakes::find(name)) {
                (Some(number), _) => print(&of_chapter(number)?),
                (None, Some(mistake)) => print(&of_mistake(mistake)),
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

/// Few scenes that show all mistakes of a chapter such as `ch28`.
pub fn of_chapter_named(name: &str) -> Outcome {
    let number = chapter(name).ok_or_else(|| format!("{name}: a chapter is written as ch28"))?;
    print(&of_chapter(number)?)
}

fn of_chapter(chapter: u32) -> Result<String, String> {
    let Cover { scenes, never_shown } = mistakes::fewest_scenes(chapter);
    if scenes.is_empty() && never_shown.is_empty() {
        return Err(format!(
            "no known mistakes of chapter {chapter}; `groundtruth mistakes` lists all"
        ));
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

fn of_scene(scene: &str) -> Result<String, String> {
    let hidden = mistakes::not_shown_by(scene).ok_or_else(|| unknown(scene))?;
    let shown: Vec<&Mistake> = mistakes::shown_by(scene).iter().map(|pair| pair.mistake).collect();
    let mut text = format!("{scene} shows {} mistakes:\n{}", shown.len(), listed(&shown));
    text += &format!("\nIt does not show {}:\n", hidden.len());
    for (mistake, best) in hidden {
        let best = best.map_or("no scene shows it".to_owned(), |best| format!("{best} does"));
        text += &format!("{}  {}; {best}\n", mistake.name, mistake.words);
    }
    Ok(text)
}

/// The scenes of a mistake that show it best, and how to look at it there.
fn of_mistake(mistake: &Mistake) -> String {
    let Known { name, chapter, words, place, .. } = mistake.known;
    let mut text = format!("{name}: {words} (ch. {chapter})\nthe right rule: {place}\n");
    let scenes = mistakes::scenes_that_show(mistake);
    let Some(best) = scenes.first() else { return text + "no scene of the gallery shows it\n" };
    text += "seen in, each with the part of the pixels that it changes:\n";
    for pair in scenes.iter().take(SCENES) {
        text += &format!("  {}: {}\n", pair.scene, percent::of_pixels(pair.effect.share));
    }
    text + &format!("{NEXT}groundtruth render {} --mistake {name} -o {name}.png\n", best.scene)
}

/// So many scenes of a mistake are listed.
const SCENES: usize = 8;

/// What is said of a name that the gallery does not have.
fn unknown(scene: &str) -> String {
    let scenes = gallery::scenes().map(|entry| entry.name);
    let names: Vec<&str> = scenes.chain(mistakes::all().iter().map(|it| it.name)).collect();
    let similar = similar::did_you_mean(scene, &names);
    format!(
        "no scene `{scene}` in the gallery (`groundtruth list` shows it), and no mistake{similar}"
    )
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
