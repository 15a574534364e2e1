//! Known mistakes: the picture that a program with one mistake would render, for each entry of a file ([`known`]).
//!
//! A picture that disagrees with ours may agree with that of a mistake, which is then named. No mistake is a switch
//! of the tracer. Many change the values of the terms that a recorder hears ([`How::Term`] to [`How::Ray`]), so that one
//! pass with the same random numbers renders the pictures of all of them. The others change the scene: by edits that the file
//! says ([`How::Edits`]), or by code ([`How::Scene`], [`How::World`]), which wraps a light, camera or material.
//! People make one mistake in several forms ([`Mistake::form`]); and a mistake of a scene may be in one material alone
//! ([`local`]).

mod beside;
mod called;
mod changes;
mod edit;
mod glass_terms;
pub mod known;
mod light_terms;
pub mod local;
mod mistaken;
mod observed;
mod page;
mod path_terms;
mod places;
mod probed;
mod recorder;
mod shown;
mod surface_terms;
pub mod table;

use std::path::Path;
use std::sync::LazyLock;

use groundtruth::lobes::Fresnel;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use serde_json::json;
use text::shell::quoted;

use edit::Edit;
use known::KnownMistake;
use observed::{ObservedRay, ObservedSurface, ObservedTerm};

pub use beside::Beside;
pub use mistaken::Mistaken;
pub use page::page;
pub use probed::{IsOver, Probed, pixel, probed, replica, replicas};
pub use recorder::Reweighing;
pub use shown::{
    Cover, HEADING, MistakeInScene, TABLE, fewest_scenes, is_wrong_on_purpose, not_shown_by,
    others, pairs, scenes_that_show, shown_by,
};

/// A mistake of a ray tracer in the style of the book: the name of its entry, and its picture.
#[derive(Clone, Copy, Debug)]
pub struct Mistake {
    /// The name of its entry in the file.
    pub name: &'static str,
    /// How its picture is made.
    pub how: How,
    /// In which other form people make it: a half sentence that follows the words. Only forms without one are in the
    /// table of scenes.
    pub form: Option<&'static str>,
}

/// How the picture of a mistake is made.
#[derive(Clone, Copy, Debug)]
pub enum How {
    /// Each term has another value; `None` if it is that of ours.
    Term(Value),
    /// Each term is this many times as large; `None` if it is as ours.
    Factor(fn(&ObservedTerm<'_>) -> Option<f64>),
    /// Smooth transparent surfaces have these shares instead of Fresnel's, of the cosine and the index; total internal
    /// reflection stays as it is.
    Fresnel(fn(f64, f64) -> Fresnel),
    /// The radiance that arrives along each ray is another.
    Ray(fn(&ObservedRay<'_>) -> Rgb),
    /// The scene is another, by these edits.
    Edits(&'static [Edit]),
    /// The scene is another; `None` if the mistake does not apply to it. The files that the scene names are in the
    /// folder.
    Scene(fn(&Scene, &Path) -> Option<Scene>),
    /// The scene's world is another.
    World(Rebuild),
    /// The scene's world is another, and in its picture terms have another value, as in [`How::Term`].
    Both(Rebuild, Value),
}

/// Changes the world of a scene, of which named files are in the folder; `None` if the mistake does not apply to it.
type Rebuild = fn(&mut World, &Scene, &Path) -> Option<()>;

/// The value of a term, if it is not that of ours.
type Value = fn(&ObservedTerm<'_>) -> Option<Rgb>;

impl Mistake {
    const fn new(name: &'static str, how: How) -> Self {
        Self { name, how, form: None }
    }

    const fn term(name: &'static str, value: Value) -> Self {
        Self::new(name, How::Term(value))
    }

    const fn factor(name: &'static str, factor: fn(&ObservedTerm<'_>) -> Option<f64>) -> Self {
        Self::new(name, How::Factor(factor))
    }

    const fn fresnel(name: &'static str, shares: fn(f64, f64) -> Fresnel) -> Self {
        Self::new(name, How::Fresnel(shares))
    }

    const fn ray(name: &'static str, arriving: fn(&ObservedRay<'_>) -> Rgb) -> Self {
        Self::new(name, How::Ray(arriving))
    }

    const fn scene(name: &'static str, change: fn(&Scene, &Path) -> Option<Scene>) -> Self {
        Self::new(name, How::Scene(change))
    }

    const fn world(name: &'static str, change: Rebuild) -> Self {
        Self::new(name, How::World(change))
    }

    const fn both(name: &'static str, change: Rebuild, value: Value) -> Self {
        Self::new(name, How::Both(change, value))
    }

    /// In another form than the mistake of this name that has none.
    const fn in_form(self, form: &'static str) -> Self {
        Self { form: Some(form), ..self }
    }

    /// Its entry in the file.
    pub fn known(&self) -> &'static KnownMistake {
        known::find(self.name).unwrap_or_else(|| panic!("{} is not in mistakes.toml", self.name))
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
        let other = match self.how {
            How::Term(value) | How::Both(_, value) => value(term),
            How::Factor(factor) => factor(term).map(|factor| term.times(factor)),
            How::Fresnel(shares) => glass_terms::with_fresnel(term, shares),
            How::Ray(_) | How::Edits(_) | How::Scene(_) | How::World(_) => None,
        };
        other.unwrap_or_else(|| term.value())
    }

    /// What arrives along a ray in the program with the mistake.
    fn arriving(&self, ray: &ObservedRay<'_>) -> Rgb {
        match self.how {
            How::Ray(arriving) => arriving(ray),
            _ => ray.arriving(),
        }
    }

    /// Whether its picture is made of the terms of ours.
    pub fn is_reweighed(&self) -> bool {
        matches!(self.how, How::Term(_) | How::Factor(_) | How::Fresnel(_) | How::Ray(_))
    }
}

/// What the file says of it: its chapter, words.
impl std::ops::Deref for Mistake {
    type Target = KnownMistake;

    fn deref(&self) -> &KnownMistake {
        self.known()
    }
}

/// Two mistakes are the same if their names and forms are.
impl PartialEq for Mistake {
    fn eq(&self, other: &Self) -> bool {
        (self.name, self.form) == (other.name, other.form)
    }
}

impl Eq for Mistake {}

/// All mistakes in all forms, in the order of the file.
static FORMS: LazyLock<Vec<Mistake>> = LazyLock::new(|| {
    let terms = [surface_terms::ALL, glass_terms::ALL, light_terms::ALL, path_terms::ALL];
    let coded: Vec<Mistake> = terms.into_iter().chain(changes::ALL).flatten().copied().collect();
    coded.iter().for_each(|it| assert!(known::find(it.name).is_some(), "{} has no entry", it.name));
    let made = |known: &'static KnownMistake| {
        let of_edits = |change, form| Mistake { name: known.name, how: How::Edits(change), form };
        let mut all: Vec<Mistake> =
            coded.iter().filter(|it| it.name == known.name).copied().collect();
        if all.is_empty() {
            all.push(of_edits(&known.change, None));
        }
        all.extend(known.forms.iter().map(|form| of_edits(&form.change, Some(form.words))));
        all
    };
    known::pictures().iter().flat_map(made).collect()
});

/// All mistakes, by chapter, each in the form of the table.
pub fn all() -> Vec<&'static Mistake> {
    FORMS.iter().filter(|mistake| mistake.form.is_none()).collect()
}

/// All mistakes in all forms, by chapter.
pub fn forms() -> Vec<&'static Mistake> {
    FORMS.iter().collect()
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

/// The scene with these edits; `None` if they change nothing, or if the scene cannot be written to a file.
fn edited(scene: &Scene, edits: &[Edit]) -> Option<Scene> {
    let mut data = json!({"scene": serde_json::to_value(scene).ok()?});
    edit::apply(edits, &mut data)?;
    serde_json::from_value(data["scene"].take()).ok()
}
