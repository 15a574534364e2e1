//! The report: measurements on this machine as a basis for choices, as one HTML page and its data.
//!
//! A [`Page`] answers one question. It measures and returns [`Findings`]: the data for JSON, and
//! the HTML made from these data alone. A new page is a folder here and a line in [`PAGES`].
//! Everything except the times is determined by the seed.

pub mod acceleration;
pub mod clock;
mod document;
pub mod html;
mod intersections;
pub mod light;
mod picture;
mod plot;
mod progress;
mod provenance;
pub mod samplers;
mod textures;

use serde_json::{Value, json};

pub use document::{check_folder, write};
pub use progress::{Interrupted, Progress};
pub use provenance::Provenance;

/// A part of the report that answers one question by measurements.
pub trait Page: Sync {
    /// Its name for `--only`.
    fn name(&self) -> &'static str;

    /// Its heading.
    fn title(&self) -> &'static str;

    /// The question that it answers.
    fn question(&self) -> &'static str;

    /// The number of progress steps of [`Page::run`].
    fn steps(&self, settings: &Settings) -> u64;

    /// Measures, with calls of [`Progress::step`] in between.
    ///
    /// # Errors
    /// [`Interrupted`].
    fn run(
        &self,
        settings: &Settings,
        progress: &Progress,
    ) -> Result<Box<dyn Findings>, Interrupted>;
}

/// The results of a page.
pub trait Findings: Send {
    /// For `report.json`.
    ///
    /// # Errors
    /// If the data cannot be serialised.
    fn data(&self) -> serde_json::Result<Value>;

    /// For `index.html`: the content of a section below its heading and question. It describes what
    /// is compared, how to read the results, and what to choose.
    fn drawing(&self) -> String;
}

/// All pages, in their order.
pub const PAGES: &[&dyn Page] = &[
    &intersections::Intersections,
    &acceleration::Acceleration,
    &samplers::Samplers,
    &light::Light,
    &textures::Textures,
];

/// The page of this name.
pub fn page(name: &str) -> Option<&'static dyn Page> {
    PAGES.iter().copied().find(|page| page.name() == name)
}

/// The extent of the measurements.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The seed of all random choices.
    pub seed: u64,
    /// Intersections: the number of rays for each shape and family.
    pub cases: usize,
    /// Acceleration: the largest number of objects.
    pub objects: u32,
    /// Acceleration: the width and height of the picture in pixels.
    pub side: u32,
    /// Samplers, light and textures: the largest number of samples per pixel; at most 1024 for
    /// light and 256 for textures, and 16 times as many for their references.
    pub samples: u32,
    /// Samplers: the number of pixels, each with its own function.
    pub pixels: u32,
    /// Samplers, light and textures: the number of seeds.
    pub seeds: u32,
    /// Light and textures: the width of the pictures in pixels.
    pub width: u32,
}

impl Settings {
    /// At most two minutes for each page on two cores.
    pub const FULL: Self = Self {
        seed: 1,
        cases: 1000,
        objects: 1_000_000,
        side: 256,
        samples: 4096,
        pixels: 64,
        seeds: 16,
        width: 24,
    };
    /// A few seconds, as a preview of the report; its numbers are not reliable.
    pub const QUICK: Self = Self {
        seed: 1,
        cases: 60,
        objects: 1000,
        side: 32,
        samples: 64,
        pixels: 4,
        seeds: 4,
        width: 12,
    };
}

/// A finished report.
pub struct Report {
    provenance: Provenance,
    settings: Settings,
    chapters: Vec<(&'static dyn Page, Box<dyn Findings>)>,
}

/// Measures these pages.
///
/// # Errors
/// [`Interrupted`].
pub fn run(
    pages: &[&'static dyn Page],
    settings: &Settings,
    progress: &Progress,
) -> Result<Report, Interrupted> {
    progress.begin(pages.iter().map(|page| page.steps(settings)).sum());
    let mut chapters = Vec::new();
    for &page in pages {
        chapters.push((page, page.run(settings, progress)?));
    }
    Ok(Report { provenance: Provenance::current(), settings: settings.clone(), chapters })
}

impl Report {
    /// The provenance and the seed, and the data of each page under its name.
    ///
    /// # Errors
    /// If the data cannot be serialised.
    pub fn json(&self) -> serde_json::Result<String> {
        let mut pages = serde_json::Map::new();
        for (page, findings) in &self.chapters {
            pages.insert(page.name().to_owned(), findings.data()?);
        }
        let whole = json!({
            "provenance": self.provenance,
            "seed": self.settings.seed,
            "pages": pages,
        });
        Ok(serde_json::to_string_pretty(&whole)? + "\n")
    }

    /// The HTML page; it is self-contained.
    pub fn html(&self) -> String {
        document::html(self)
    }
}
