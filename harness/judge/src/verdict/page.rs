//! A verdict as one HTML page.

use std::fmt::Write;

use groundtruth::film::{Film, Tone, data_uri};
use groundtruth::rgb::Rgb;

use super::pictures_shown::ShownPictures;
use super::text;
use super::verdict::{DifferingRegion, Verdict};
use pictures::compare::pair;
use pictures::digits::short;
use pictures::html::{self, escaped};
use pictures::told::Told;

/// Rules for maps, after those of a pair.
pub const STYLE: &str = "\
.legend { max-width: 40em; }
.map svg { position: absolute; top: 0; left: 0; width: 100%; height: 100%; }
";

/// Differences of so many standard deviations are black or white in the map.
pub const FARTHEST: f64 = 6.0;

/// The page of a verdict on a picture with this name, of which this is told.
pub fn page(verdict: &Verdict, name: &str, told: &Told) -> String {
    let ShownPictures { ours, theirs, .. } = &verdict.shown;
    let body = pair::views(["the mean of ours", "theirs"], [ours, theirs])
        + &map(verdict)
        + &excluded(&verdict.shown)
        + &table(verdict);
    told.page(name, &[html::LINES, html::NUMBERS, pair::STYLE, STYLE], &body)
}

/// Their picture with hatching over the pixels that are set apart, if there are any.
fn excluded(shown: &ShownPictures) -> String {
    if shown.excluded.is_empty() {
        return String::new();
    }
    format!(
        "<h2>Not counted</h2>\n<p>Theirs. Hatched pixels do not count: all pictures of ours agree there, and a correct picture \
         may have another value.</p>\n<div class=\"map\"><img alt=\"theirs, hatched where it does not count\" src=\"{}\">{}</div>\n",
        data_uri(&shown.theirs.radiance(), &Tone::SCREEN),
        hatching(&shown.excluded, shown.theirs.size)
    )
}

/// Diagonal lines over these pixels, to be laid over a picture of this size.
fn hatching(pixels: &[usize], [width, height]: [u32; 2]) -> String {
    let line =
        |pixel: &usize| format!("M{} {}l1 1", pixel % width as usize, pixel / width as usize);
    let lines: String = pixels.iter().map(line).collect();
    // light and dark, so that one shows on any picture
    let strokes = [("#fff", 0.4), ("#06f", 0.2)].map(|(color, thickness)| {
        format!("<path d=\"{lines}\" stroke=\"{color}\" stroke-width=\"{thickness}\"/>")
    });
    format!(
        "<svg viewBox=\"0 0 {width} {height}\" preserveAspectRatio=\"none\">{}</svg>",
        strokes.concat()
    )
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

/// The legend of that map.
pub fn map_scale() -> String {
    let end = short(FARTHEST);
    let scale = pair::scale([&format!("−{end} and less"), "0", &format!("+{end} and more")]);
    format!("<div class=\"legend\">{scale}</div>\n")
}

/// The map of z, with the regions framed.
fn map(verdict: &Verdict) -> String {
    let (size, excluded) = (verdict.shown.theirs.size, &verdict.shown.excluded);
    let film = map_film(&verdict.shown.z, size);
    let framed = |region: &DifferingRegion| frame(&region.name, region.bounds, size);
    let frames: String = verdict.regions.iter().map(framed).collect();
    let hatching = if excluded.is_empty() { String::new() } else { hatching(excluded, size) };
    format!(
        "<h2>Difference in standard deviations of the noise (z)</h2>\n<p>Brighter where theirs is larger. Regions that differ \
         are framed; pixels that do not count are hatched.</p>\n\
         <div class=\"map\"><img alt=\"map of z\" src=\"{}\">{hatching}{frames}</div>\n{}",
        data_uri(&film, &Tone::PLAIN),
        map_scale()
    )
}

/// A frame over a picture of this size, around the pixels from this left column and top row on, so many columns and rows.
pub fn frame(name: &str, [x, y, w, h]: [usize; 4], [width, height]: [u32; 2]) -> String {
    let percent = |part: usize, of: u32| 100.0 * part as f64 / f64::from(of);
    format!(
        "<i title=\"{}\" style=\"left:{:.3}%;top:{:.3}%;width:{:.3}%;height:{:.3}%\"></i>",
        escaped(name),
        percent(x, width),
        percent(y, height),
        percent(w, width),
        percent(h, height)
    )
}

/// The means of the picture and of its objects.
fn table(verdict: &Verdict) -> String {
    let mut html = "<h2>Means</h2>\n<div class=\"wide\"><table>\n<tr><th>area<th>pixels<th>ours<th>theirs<th>relative difference</tr>\n".to_owned();
    for means in &verdict.means {
        let mean = |color: [f64; 3]| color.map(short).join(", ");
        if means.ours == [0.0; 3] && means.theirs == [0.0; 3] {
            continue;
        }
        let relative = match text::differences(means) {
            none if none.is_empty() => "ours is black".to_owned(),
            relative => relative,
        };
        let _ = writeln!(
            html,
            "<tr><td>{}<td>{}<td>{}<td>{}<td>{relative}</tr>",
            escaped(&means.name),
            means.pixels,
            mean(means.ours),
            mean(means.theirs)
        );
    }
    html + "</table></div>\n"
}
