//! Known mistakes: the picture that a program with one mistake would render, for each of a catalogue ([`known`]).
//!
//! A picture that disagrees with ours may agree with that of a mistake, which is then named. No mistake is a switch
//! of the tracer. Most change the values of the terms that a recorder hears ([`How::Term`], [`How::Ray`]), so that one
//! pass with the same random numbers renders the pictures of all of them. The others change the scene
//! ([`How::Scene`]), where needed by kinds of the harness that wrap a light, camera or material.
//! People make one mistake in several forms ([`Mistake::form`]); and a mistake of a scene may be in one material alone
//! ([`local`]).

mod beside;
mod changes;
pub mod fields;
mod films;
mod glass_terms;
pub mod known;
mod light_terms;
pub mod local;
mod mistaken;
mod observed;
mod page;
mod path_terms;
mod probed;
mod recorder;
mod replicas;
mod shown;
mod surface_terms;
pub mod table;

use std::path::Path;

use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use known::KnownMistake;
use pictures::shell::quoted;

pub use beside::Beside;
pub use films::{Films, films, pixel};
pub use mistaken::Mistaken;
pub use observed::{ObservedRay, ObservedSurface, ObservedTerm};
pub use page::page;
pub use probed::{IsOver, Probed, probed};
pub use recorder::Reweighing;
pub use replicas::{replica, replicas};
pub use shown::{
    Cover, HEADING, MistakeInScene, TABLE, fewest_scenes, is_wrong_on_purpose, not_shown_by,
    others, pairs, scenes_that_show, shown_by,
};

/// A mistake of a ray tracer in the style of the book: its entry in the catalogue, and its picture.
#[derive(Clone, Copy, Debug)]
pub struct Mistake {
    /// Its entry.
    pub known: &'static KnownMistake,
    /// How its picture is made.
    pub how: How,
    /// In which other form people make it: a half sentence that follows the words. Only forms without one are in the
    /// table of scenes.
    pub form: Option<&'static str>,
}

/// How the picture of a mistake is made.
#[derive(Clone, Copy, Debug)]
pub enum How {
    /// Each term has another value.
    Term(fn(&ObservedTerm<'_>) -> Rgb),
    /// The radiance that arrives along each ray is another.
    Ray(fn(&ObservedRay<'_>) -> Rgb),
    /// The scene is another; `None` if the mistake does not apply to it. The files that the scene names are in the
    /// folder.
    Scene(fn(&Scene, &Path) -> Option<Scene>),
    /// The scene is another, and in its picture each term has another value.
    Both(fn(&Scene, &Path) -> Option<Scene>, fn(&ObservedTerm<'_>) -> Rgb),
}

impl Mistake {
    const fn term(known: &'static KnownMistake, value: fn(&ObservedTerm<'_>) -> Rgb) -> Self {
        Self { known, how: How::Term(value), form: None }
    }

    const fn ray(known: &'static KnownMistake, arriving: fn(&ObservedRay<'_>) -> Rgb) -> Self {
        Self { known, how: How::Ray(arriving), form: None }
    }

    const fn scene(
        known: &'static KnownMistake,
        change: fn(&Scene, &Path) -> Option<Scene>,
    ) -> Self {
        Self { known, how: How::Scene(change), form: None }
    }

    /// The same mistake in another form.
    const fn in_form(self, form: &'static str, how: How) -> Self {
        Self { form: Some(form), how, ..self }
    }

    /// Completes the sentence "the picture agrees with ours if …", with its form.
    pub fn sentence(&self) -> String {
        match self.form {
            Some(form) => format!("{}, {form}", self.words),
            None => self.words.to_owned(),
        }
    }

    /// The value of a term in the program with the mistake.
    fn value(&self, term: &ObservedTerm<'_>) -> Rgb {
        match self.how {
            How::Term(value) | How::Both(_, value) => value(term),
            How::Ray(_) | How::Scene(_) => term.value(),
        }
    }

    /// What arrives along a ray in the program with the mistake.
    fn arriving(&self, ray: &ObservedRay<'_>) -> Rgb {
        match self.how {
            How::Ray(arriving) => arriving(ray),
            How::Term(_) | How::Both(..) | How::Scene(_) => ray.arriving(),
        }
    }

    /// Whether its picture is made of the terms of ours.
    pub fn is_reweighed(&self) -> bool {
        matches!(self.how, How::Term(_) | How::Ray(_))
    }
}

/// What the catalogue says of it: its name, chapter, words.
impl std::ops::Deref for Mistake {
    type Target = KnownMistake;

    fn deref(&self) -> &KnownMistake {
        self.known
    }
}

/// Two mistakes are the same if their names and forms are.
impl PartialEq for Mistake {
    fn eq(&self, other: &Self) -> bool {
        (self.name, self.form) == (other.name, other.form)
    }
}

impl Eq for Mistake {}

/// All mistakes, by chapter, each in the form of the table.
pub fn all() -> Vec<&'static Mistake> {
    forms().into_iter().filter(|mistake| mistake.form.is_none()).collect()
}

/// All mistakes in all forms, by chapter.
pub fn forms() -> Vec<&'static Mistake> {
    let terms = [surface_terms::ALL, glass_terms::ALL, light_terms::ALL, path_terms::ALL];
    let mut all: Vec<&Mistake> = terms.into_iter().chain(changes::ALL).flatten().collect();
    all.sort_by_key(|mistake| mistake.chapter);
    all
}

/// The mistake of this name, in the form of the table.
pub fn find(name: &str) -> Option<&'static Mistake> {
    all().into_iter().find(|mistake| mistake.name == name)
}

/// The command that lists the mistakes that a scene of the gallery or of a file shows and those that it does not; all mistakes
/// of another scene.
pub fn command(scene: &str) -> String {
    match gallery::find(scene) {
        Some(entry) => format!("groundtruth mistakes {}", entry.name),
        None if is_file(scene) => format!("groundtruth mistakes {}", quoted(scene)),
        None => "groundtruth mistakes".to_owned(),
    }
}

/// Whether this names a scene file.
pub fn is_file(scene: &str) -> bool {
    Path::new(scene).extension().is_some_and(|it| it == "toml")
}

/// The scene of which the picture of a mistake is made; `None` if the mistake does not apply to it, or
/// is one of terms.
pub fn scene(mistake: &Mistake, scene: &Scene, folder: &Path) -> Option<Scene> {
    match mistake.how {
        How::Scene(change) | How::Both(change, _) => change(scene, folder),
        How::Term(_) | How::Ray(_) => None,
    }
}
