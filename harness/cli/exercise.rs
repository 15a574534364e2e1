//! `groundtruth exercise`.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use groundtruth::film::{self, Format};
use groundtruth::world::World;
use judge::exercise::{self, Difficulty, Task};

use super::numbers::whole;
use super::program::fresh_seed;
use super::{Outcome, mistakes, output, print, progress};

#[derive(Args)]
pub struct Exercise {
    /// The chapter whose mistakes are to be found, such as ch28
    chapter: String,
    /// A new folder; in it, `class` is for the class and `teacher` for you
    #[arg(short, long, value_name = "FOLDER")]
    output: PathBuf,
    /// So many pictures, or as many as the chapter has mistakes
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = whole::<usize>(1..=100))]
    count: usize,
    /// Which mistakes, in which order; a new choice each time if left out, which the key repeats
    #[arg(long, value_name = "N", value_parser = whole::<u64>(0..=u64::MAX))]
    seed: Option<u64>,
    /// How hard the mistakes are to find
    #[arg(long, value_enum, default_value_t = DifficultyName::Medium)]
    level: DifficultyName,
    /// The width of the pictures in pixels
    #[arg(long, value_name = "N", default_value_t = 300, value_parser = whole::<u32>(16..=2000))]
    width: u32,
}

/// The levels by name.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum DifficultyName {
    /// Most of each picture is wrong, and the sheet lists the mistakes among which they are
    Easy,
    /// A part of each picture is wrong, and the sheet lists mistakes
    Medium,
    /// A few pixels of each picture are wrong, and the sheet lists no mistakes
    Hard,
}

/// A file and what is in it.
type File = (PathBuf, Vec<u8>);

impl Exercise {
    pub fn run(&self) -> Outcome {
        let chapter = mistakes::chapter_named(&self.chapter)?;
        self.check_new()?;
        let level = match self.level {
            DifficultyName::Easy => Difficulty::Easy,
            DifficultyName::Medium => Difficulty::Medium,
            DifficultyName::Hard => Difficulty::Hard,
        };
        let seed = self.seed.unwrap_or_else(fresh_seed);
        let bar = progress::bar(self.count as u64, "{bar:30} {pos} of {len} pictures");
        let size = (self.count, self.width);
        let tasks = exercise::tasks(chapter, level, size, seed, &mut || bar.inc(1))?;
        bar.finish_and_clear();
        if tasks.is_empty() {
            return Err(mistakes::none_of_chapter(chapter).into());
        }
        let level_name = self.level.to_possible_value().expect("no level is hidden");
        let (count, name, width) = (self.count, level_name.get_name(), self.width);
        let options = format!("--count {count} --seed {seed} --level {name} --width {width}");
        let command = format!("groundtruth exercise {} -o FOLDER {options}", self.chapter);
        let sheet = exercise::sheet(chapter, level, &tasks).into_bytes();
        let key = exercise::key(chapter, &command, &tasks)?.into_bytes();
        let mut files: Vec<File> =
            vec![("class/sheet.html".into(), sheet), ("teacher/key.html".into(), key)];
        for (number, task) in (1..).zip(&tasks) {
            files.extend(of_task(number, task)?);
        }
        self.write(&files)?;
        let folder = self.output.display();
        let fewer = match tasks.len() < self.count {
            true => format!(" (chapter {chapter} has no more mistakes that can be seen)"),
            false => String::new(),
        };
        print(&format!(
            "{folder}/class: sheet.html, {} pictures and their scenes{fewer}\n\
             {folder}/teacher: key.html, the mistakes with their reasons\n",
            tasks.len()
        ))
    }

    /// Fails if the folder holds something.
    fn check_new(&self) -> Result<(), String> {
        let folder = self.output.display();
        if !self.output.exists() {
            return Ok(());
        }
        match fs::read_dir(&self.output).map(|mut entries| entries.next()) {
            Err(error) => Err(format!("{folder}: {error}")),
            Ok(None) => Ok(()),
            Ok(Some(_)) => Err(format!("{folder}: the folder is not empty; name a new one")),
        }
    }

    /// Writes all files or none.
    fn write(&self, files: &[File]) -> Result<(), Box<dyn Error>> {
        let is_new = !self.output.exists();
        let made = self.write_in_folders(files);
        if made.is_err() {
            // those that are empty, from the inside out
            let folders = ["class/scenes", "class", "teacher", ""];
            for folder in &folders[..if is_new { 4 } else { 3 }] {
                let _ = fs::remove_dir(self.output.join(folder));
            }
        }
        made.map_err(|error| output::unwritable(&self.output, error))
    }

    fn write_in_folders(&self, files: &[File]) -> std::io::Result<()> {
        for folder in ["class/scenes", "teacher"] {
            fs::create_dir_all(self.output.join(folder))?;
        }
        let paths: Vec<PathBuf> = files.iter().map(|(name, _)| self.output.join(name)).collect();
        let bytes = files.iter().map(|(_, bytes)| &bytes[..]);
        let all: Vec<(&Path, &[u8])> = paths.iter().map(PathBuf::as_path).zip(bytes).collect();
        film::replace_all(&all).map_err(|(_, error)| error)
    }
}

/// The wrong picture of a task, which does not say of which mistake it is, and its scene.
fn of_task(number: usize, task: &Task) -> Result<[File; 2], Box<dyn Error>> {
    let scene = &task.scene;
    let world = World::build(scene)?;
    let made =
        pictures::provenance((gallery::find(task.name), scene), (scene, &world), Path::new(""))?;
    let picture = film::encode(&task.pictures.wrong, &scene.image.tone(), Format::Png, &made)?;
    let text = scenefile::to_toml(scene)?.into_bytes();
    Ok([
        (format!("class/{number}.png").into(), picture),
        (format!("class/scenes/{number}.toml").into(), text),
    ])
}
