//! A verdict as one HTML page.

use groundtruth::film::{Film, Tone};
use groundtruth::rgb::Rgb;

use super::{DifferingRegion, Means, ShownPictures, Verdict, text};
use ::text::digits::short;
use ::text::document::*;
use ::text::html;
use ::text::told::Told;
use pictures::compare::pair;

/// Rules for maps, after those of a pair.
pub const STYLE: &str = "\
.legend { max-width: 40em; }
.map svg { position: absolute; top: 0; left: 0; width: 100%; height: 100%; }
";

/// Differences of so many standard deviations are black or white in the map.
const FARTHEST: f64 = 6.0;

/// The page of a verdict on a picture with this name, of which this is told.
pub fn page(verdict: &Verdict, name: &str, told: &Told) -> String {
    let ShownPictures { ours, theirs, .. } = &verdict.shown;
    let body = several()
        .with(pair::views(["the mean of ours", "theirs"], [ours, theirs]))
        .with(map(verdict))
        .with(excluded(&verdict.shown))
        .with(means(verdict));
    told.page(name, &[html::LINES, html::NUMBERS, pair::STYLE, STYLE], &body.html())
}

/// Their picture with hatching over the pixels that are set apart, if there are any.
fn excluded(shown: &ShownPictures) -> Element {
    if shown.excluded.is_empty() {
        return several();
    }
    const WORDS: &str = "Theirs. Hatched pixels do not count: all pictures of ours agree there, and a correct picture may \
         have another value.";
    let film = shown.theirs.radiance();
    let theirs = image(&film, &Tone::SCREEN, "theirs, hatched where it does not count");
    several()
        .with(heading(2, "Not counted"))
        .with(paragraph(WORDS))
        .with(group("map").with(theirs).with(hatching(&shown.excluded, shown.theirs.size)))
}

/// Diagonal lines over these pixels, to be laid over a picture of this size.
fn hatching(pixels: &[usize], [width, height]: [u32; 2]) -> Element {
    let line =
        |pixel: &usize| format!("M{} {}l1 1", pixel % width as usize, pixel / width as usize);
    let lines: String = pixels.iter().map(line).collect();
    // light and dark, so that one shows on any picture
    let strokes = [("#fff", "0.4"), ("#06f", "0.2")].map(|(color, thickness)| {
        element("path")
            .attribute("d", &lines)
            .attribute("stroke", color)
            .attribute("stroke-width", thickness)
    });
    element("svg")
        .attribute("viewBox", format!("0 0 {width} {height}"))
        .attribute("preserveAspectRatio", "none")
        .with_all(strokes)
}

/// The map of z in values for display: 0.5 where z is 0, brighter where theirs is larger, 0 and 1 from six standard
/// deviations on.
pub fn map_film(z: &[f64], [width, height]: [u32; 2]) -> Film {
    let mut film = Film::new(width, height);
    for (index, z) in z.iter().enumerate() {
        let grey = 0.5 + 0.5 * (z / FARTHEST).clamp(-1.0, 1.0);
        film.set([index as u32 % width, index as u32 / width], Rgb::grey(grey));
    }
    film
}

/// A map under its heading, with what is laid over it, and its legend.
pub fn map_with_legend(
    (title, words): (&str, &str),
    (film, alt): (&Film, &str),
    over: impl IntoIterator<Item = Element>,
) -> Element {
    let end = short(FARTHEST);
    let legend = pair::legend([&format!("−{end} and less"), "0", &format!("+{end} and more")]);
    several()
        .with(heading(2, title))
        .with(paragraph(words))
        .with(group("map").with(image(film, &Tone::PLAIN, alt)).with_all(over))
        .with(group("legend").with(legend))
}

/// The map of z, with the regions framed.
fn map(verdict: &Verdict) -> Element {
    const WORDS: &str = "Brighter where theirs is larger. Regions that differ are framed; pixels that do not count are \
         hatched.";
    let (size, excluded) = (verdict.shown.theirs.size, &verdict.shown.excluded);
    let framed = |region: &DifferingRegion| {
        pair::frame(&region.name, region.bounds.map(|it| it as u32), size)
    };
    let hatching = (!excluded.is_empty()).then(|| hatching(excluded, size));
    map_with_legend(
        ("Difference in standard deviations of the noise (z)", WORDS),
        (&map_film(&verdict.shown.z, size), "map of z"),
        hatching.into_iter().chain(verdict.regions.iter().map(framed)),
    )
}

fn means(verdict: &Verdict) -> Element {
    let is_black = |means: &&Means| means.ours == [0.0; 3] && means.theirs == [0.0; 3];
    let mean = |color: [f64; 3]| color.map(short).join(", ");
    let relative = |means: &&Means| match text::differences(means) {
        none if none.is_empty() => "ours is black".to_owned(),
        relative => relative,
    };
    let table = table(verdict.means.iter().filter(|means| !is_black(means)))
        .column("area", |means| &*means.name)
        .column("pixels", |means| means.pixels.to_string())
        .column("ours", |means| mean(means.ours))
        .column("theirs", |means| mean(means.theirs))
        .column("relative difference", relative);
    several().with(heading(2, "Means")).with(table.element())
}
