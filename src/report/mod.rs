//! The report: evidence for choices. One HTML page and its data, measured on this machine.
//!
//! A [`Page`] answers one question. It measures and returns [`Findings`]: data that can be written as
//! JSON, and a drawing of that data alone. A new page is a folder here and a line in [`PAGES`].
//! Everything except the times is determined by the seed.

mod acceleration;
mod clock;
mod document;
mod html;
mod intersections;
mod light;
mod picture;
mod plot;
mod provenance;
mod samplers;
mod textures;
mod watch;

use serde_json::{Value, json};

pub use document::{check_folder, write};
pub use provenance::Provenance;
pub use watch::{Interrupted, Watch};

/// A part of the report: one question, measured.
pub trait Page: Sync {
    /// Its name for `--only`.
    fn name(&self) -> &'static str;

    /// Its heading.
    fn title(&self) -> &'static str;

    /// The question that it answers, in words for the reader.
    fn question(&self) -> &'static str;

    /// The number of steps of the watch that [`Page::run`] takes.
    fn steps(&self, settings: &Settings) -> u64;

    /// Measures. Anything that takes long takes steps of the watch in between.
    ///
    /// # Errors
    /// [`Interrupted`], as soon as the watch says so.
    fn run(&self, settings: &Settings, watch: &Watch) -> Result<Box<dyn Findings>, Interrupted>;
}

/// The results of a page.
pub trait Findings: Send {
    /// For `report.json`.
    ///
    /// # Errors
    /// If something in it is no JSON.
    fn data(&self) -> serde_json::Result<Value>;

    /// For `index.html`: the content of a section, below its heading and question. It describes what is
    /// compared, how to read it, and what to choose.
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
    /// Intersections: rays for each shape and family.
    pub cases: usize,
    /// Acceleration: the most objects.
    pub objects: u32,
    /// Acceleration: pixels along each side of the picture.
    pub side: u32,
    /// Samplers, light and textures: the most samples for each pixel; light takes 1024 at most, textures
    /// 256, and 16 times as many for their references.
    pub samples: u32,
    /// Samplers: pixels, each with a function of its own.
    pub pixels: u32,
    /// Samplers, light and textures: seeds.
    pub seeds: u32,
    /// Light and textures: pixels across the pictures.
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
    /// A few seconds, to see what the report looks like; its numbers mean little.
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
    watch: &Watch,
) -> Result<Report, Interrupted> {
    watch.begin(pages.iter().map(|page| page.steps(settings)).sum());
    let mut chapters = Vec::new();
    for &page in pages {
        chapters.push((page, page.run(settings, watch)?));
    }
    Ok(Report { provenance: Provenance::here(), settings: settings.clone(), chapters })
}

impl Report {
    /// Where, of what, and with which seed everything was measured; then the data of each page under
    /// its name.
    ///
    /// # Errors
    /// If something in it is no JSON.
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

    /// The page to read or print; it needs nothing beside it.
    pub fn html(&self) -> String {
        document::html(self)
    }
}
