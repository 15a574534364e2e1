//! The report: measurements on this machine as a basis for choices, as one HTML page and its data.
//!
//! A [`Page`] answers one question. It measures, and returns the data for JSON and the HTML made
//! from these data alone. A new page is a folder here and an entry in [`PAGES`]. What pages share:
//! [`words`] and `plot` draw, `pictures` renders, `reference` measures the error of pictures, and
//! `convergence` is error against samples and time. Everything except the times is determined by
//! the seed.

pub mod acceleration;
pub mod clock;
mod convergence;
mod document;
mod intersections;
pub mod light;
mod pictures;
pub mod plot;
mod progress;
mod provenance;
pub mod reference;
pub mod samplers;
mod textures;
pub mod words;

use serde::Serialize;
use serde_json::{Value, json};
use text::document::Element;

pub use document::{check_folder, write};
pub use progress::{Interrupted, ReportProgress};
pub use provenance::Provenance;

/// A part of the report that answers one question by measurements.
#[derive(Clone, Copy)]
pub struct Page {
    /// Its name for `--only`.
    pub name: &'static str,
    /// Its heading.
    pub title: &'static str,
    /// The question that it answers.
    pub question: &'static str,
    /// The number of progress steps of `measure`.
    pub steps: fn(&Settings) -> u64,
    /// Measures, with calls of [`Progress::step`] in between.
    measure: fn(&Settings, &ReportProgress) -> Result<Findings, Interrupted>,
}

/// The results of a page.
struct Findings {
    /// For `report.json`.
    data: Value,
    /// For `index.html`: the content of a section below its heading and question. It describes what
    /// is compared, how to read the results, and what to choose.
    section: Element,
}

impl Findings {
    fn new<T: Serialize>(data: &T, section: fn(&T) -> Element) -> Self {
        let json = serde_json::to_value(data).expect("the keys of all data are texts");
        Self { data: json, section: section(data) }
    }

    /// The findings without the numbers of these names, which the page does not report.
    fn without(mut self, names: &[&str]) -> Self {
        remove(&mut self.data, names);
        self
    }
}

fn remove(data: &mut Value, names: &[&str]) {
    match data {
        Value::Object(map) => {
            map.retain(|name, _| !names.contains(&&**name));
            map.values_mut().for_each(|value| remove(value, names));
        }
        Value::Array(items) => items.iter_mut().for_each(|item| remove(item, names)),
        _ => {}
    }
}

/// All pages, in their order.
pub const PAGES: &[Page] =
    &[intersections::PAGE, acceleration::PAGE, samplers::PAGE, light::PAGE, textures::PAGE];

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
    seed: u64,
    chapters: Vec<(Page, Findings)>,
}

/// Measures these pages.
///
/// # Errors
/// [`Interrupted`].
pub fn run(
    pages: &[Page],
    settings: &Settings,
    progress: &ReportProgress,
) -> Result<Report, Interrupted> {
    progress.begin(pages.iter().map(|page| (page.steps)(settings)).sum());
    let measured = pages.iter().map(|page| Ok((*page, (page.measure)(settings, progress)?)));
    let chapters = measured.collect::<Result<_, _>>()?;
    Ok(Report { provenance: Provenance::current(), seed: settings.seed, chapters })
}

impl Report {
    /// The provenance and the seed, and the data of each page under its name.
    pub fn json(&self) -> String {
        let data = |(page, found): &(Page, Findings)| (page.name.to_owned(), found.data.clone());
        let pages: serde_json::Map<String, Value> = self.chapters.iter().map(data).collect();
        let whole = json!({
            "provenance": self.provenance,
            "seed": self.seed,
            "pages": pages,
        });
        format!("{whole:#}\n")
    }
}
