//! The gallery: the book's scenes with the book's numbers, as functions that return a [`Scene`].
//!
//! Each chapter's file holds its scenes and their list; [`scenes`] is all of them in order.

mod ch03;
mod ch04;
mod ch05;
mod ch06;
mod ch08;
mod ch09;
mod ch10;
mod ch11;
mod ch12;
mod ch14;
mod ch15;
mod ch16;
mod ch17;
mod ch18;
mod ch19;
mod ch20;
mod ch21;
mod ch22;
mod ch23;
mod ch24;
mod ch24_curved;
mod ch25;
mod ch26;
mod ch27;
mod ch28;
mod ch29;
mod ch30;
mod ch31;

// shared by the chapters
mod search;
mod sets;
mod shaded_sets;

pub use search::{about, ranked, search};

use std::path::Path;

use groundtruth::film;
use groundtruth::scene::Scene;
use groundtruth::similar::did_you_mean;

/// A scene by its name, `chNN/some-scene`.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The name on the command line.
    pub name: &'static str,
    /// Builds the scene.
    pub build: fn() -> Scene,
}

/// Every scene, by chapter.
pub fn scenes() -> impl Iterator<Item = Entry> {
    [
        ch03::SCENES,
        ch04::SCENES,
        ch05::SCENES,
        ch06::SCENES,
        ch08::SCENES,
        ch09::SCENES,
        ch10::SCENES,
        ch11::SCENES,
        ch12::SCENES,
        ch14::SCENES,
        ch15::SCENES,
        ch16::SCENES,
        ch17::SCENES,
        ch18::SCENES,
        ch19::SCENES,
        ch20::SCENES,
        ch21::SCENES,
        ch22::SCENES,
        ch23::SCENES,
        ch24::SCENES,
        ch24_curved::SCENES,
        ch25::SCENES,
        ch26::SCENES,
        ch27::SCENES,
        ch28::SCENES,
        ch29::SCENES,
        ch30::SCENES,
        ch31::SCENES,
    ]
    .into_iter()
    .flatten()
    .map(|&(name, build)| Entry { name, build })
}

/// The scene of this name.
pub fn find(name: &str) -> Option<Entry> {
    scenes().find(|entry| entry.name == name)
}

/// The error message for a name that is neither a scene nor a file.
pub fn unknown(name: &str) -> String {
    let problem = format!(
        "no scene `{name}`: neither a gallery name (`groundtruth list` shows them) nor a file"
    );
    let beside =
        std::fs::read_dir(film::folder_of(Path::new(name))).into_iter().flatten().flatten();
    let beside = beside.map(|file| Path::new(name).with_file_name(file.file_name()));
    let beside = beside.filter(|file| file.extension().is_some_and(|it| it == "toml"));
    let names = scenes().map(|entry| entry.name.to_owned());
    let names: Vec<String> = names.chain(beside.map(|file| file.display().to_string())).collect();
    problem + &did_you_mean(name, &names.iter().map(String::as_str).collect::<Vec<_>>())
}

/// The scenes of a chapter: names and build functions.
type List = &'static [(&'static str, fn() -> Scene)];
