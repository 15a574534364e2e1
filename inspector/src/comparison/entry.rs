//! One of the pictures that ours can be compared with, and how it is made.

use std::path::Path;

use crate::comparison::recipe::Recipe;
use crate::comparison::theirs::Theirs;

/// The rendering of ours beside which a picture is made, and the pixel for which its program is run.
pub type MadeBeside = (u64, Option<[u32; 2]>);

/// A picture, or how it is made.
pub struct Entry {
    /// Its number.
    pub number: u32,
    /// How it is made; nothing for a file.
    pub recipe: Option<Recipe>,
    /// Beside what it was made.
    pub made_beside: Option<MadeBeside>,
    /// The picture, once it is made.
    pub theirs: Option<Theirs>,
}

impl Entry {
    /// The file, if it is made from a log of rays.
    pub fn log(&self) -> Option<&Path> {
        let Some(Recipe::Scene(source)) = &self.recipe else { return None };
        source.rays()
    }

    /// Whether a program is run for it.
    pub fn is_run(&self) -> bool {
        matches!(self.recipe, Some(Recipe::Run(_)))
    }

    /// What is other, in a few words; of a file, its name.
    pub fn name(&self) -> String {
        let of_recipe = self.recipe.as_ref().map(Recipe::name);
        of_recipe.or(self.theirs.as_ref().map(|it| it.name.clone())).unwrap_or_default()
    }
}
