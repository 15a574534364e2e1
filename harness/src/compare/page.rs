//! A comparison as one HTML page that needs nothing beside it, and no script.

use std::fmt::Write;

use super::{Comparison, Decoded, Picture, Region};
use crate::html::escaped;
use crate::verify::quantile;
use groundtruth::film::{Film, OutOfGamut, Tone, data_uri};
use groundtruth::rgb::Rgb;

const STYLE: &str = "\
body { font: 15px/1.4 system-ui, sans-serif; margin: 2em auto; max-width: 80em; padding: 0 1em; }
pre { overflow-x: auto; }
img { display: block; image-rendering: pixelated; }
.flip, .swipe { position: relative; width: max-content; border: 1px solid #999; }
.flip img, .swipe img { width: 40em; }
.flip img + img { position: absolute; top: 0; left: 0; opacity: 0; }
.flip:hover img + img { opacity: 1; }
.swipe div { position: absolute; top: 0; left: 0; width: 50%; height: 100%; overflow: hidden; \
resize: horizontal; border-right: 2px solid #f80; }
.row { display: flex; flex-wrap: wrap; gap: 1em; }
figure { margin: 0; }
.row img { width: 24em; border: 1px solid #999; }
.zoom img { width: 16em; }
";

/// The shares of differing channels that the three scales of the difference show unclipped: one bright lamp must
/// not hide the rest.
const SCALES: [f64; 3] = [0.5, 0.9, 1.0];

/// Pixels around a region that are shown with it.
const MARGIN: u32 = 4;

/// The page of a comparison of pictures with these names.
pub fn page(comparison: &Comparison, names: [&str; 2], pictures: [&Picture; 2]) -> String {
    let [a, b] = pictures.map(film_of);
    let [name_a, name_b] = names.map(escaped);
    let tone = Tone { exposure: 1.0, gamma: 2.2, out_of_gamut: OutOfGamut::MaxToOne };
    let [shown_a, shown_b] = [&a, &b].map(|film| data_uri(film, &tone));
    let mut html = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>{name_a} and {name_b}</title>\n\
         <style>\n{STYLE}</style>\n<h1>{name_a} and {name_b}</h1>\n<pre>{}</pre>\n\
         <h2>Flip</h2>\n<p>A; B under the pointer. Magenta is not a number.</p>\n\
         <div class=\"flip\"><img alt=\"A\" src=\"{shown_a}\"><img alt=\"B\" src=\"{shown_b}\"></div>\n\
         <h2>Swipe</h2>\n<p>A at the left, B at the right; pull the corner of the line.</p>\n\
         <div class=\"swipe\"><img alt=\"B\" src=\"{shown_b}\"><div><img alt=\"A\" src=\"{shown_a}\"></div></div>\n",
        escaped(&comparison.to_string())
    );
    if comparison.is_same() {
        return html + "</html>\n";
    }
    html.push_str(
        "<h2>B − A</h2>\n<p>Grey: equal; brighter: B is larger.</p>\n<div class=\"row\">\n",
    );
    let plain = Tone { exposure: 1.0, gamma: 1.0, out_of_gamut: OutOfGamut::MaxToOne };
    for scale in SCALES {
        let (film, largest) = difference_of(&a, &b, scale);
        let data = data_uri(&film, &plain);
        let percent = 100.0 * scale;
        let _ = writeln!(
            html,
            "<figure><img alt=\"difference\" src=\"{data}\"><figcaption>black and white: ±{largest:.3e}, \
             {percent} % of the differences are within</figcaption></figure>"
        );
    }
    html.push_str("</div>\n<h2>Regions</h2>\n");
    for region in &comparison.regions {
        let Region { pixels, worst: [x, y], values: [va, vb], .. } = region;
        let [crop_a, crop_b] = [&a, &b].map(|film| data_uri(&around(film, region), &tone));
        let _ = writeln!(
            html,
            "<div class=\"row zoom\"><img alt=\"A\" src=\"{crop_a}\"><img alt=\"B\" src=\"{crop_b}\"><p>{pixels} \
             pixels, the worst at ({x}, {y}): {va:?} and {vb:?}</p></div>"
        );
    }
    html + "</html>\n"
}

/// The radiances of a picture; what is no number is magenta.
fn film_of(picture: &Picture) -> Film {
    let mut film = Film::new(picture.size[0], picture.size[1]);
    let decoded = Decoded::new(picture);
    for i in 0..picture.values.len() {
        let color = decoded.at(i);
        let is_number = color.iter().all(|channel| !channel.is_nan());
        let color = if is_number { color.into() } else { Rgb::new(1.0, 0.0, 1.0) };
        film.set([i as u32 % picture.size[0], i as u32 / picture.size[0]], color);
    }
    film
}

/// The difference around a middle grey, and the difference that becomes black or white: the one that this share
/// of all differences is within.
fn difference_of(a: &Film, b: &Film, share: f64) -> (Film, f64) {
    let differences = || a.pixels().iter().zip(b.pixels()).map(|(a, b)| *b - *a);
    let sizes: Vec<f64> = differences()
        .flat_map(|difference| difference.to_array().map(f64::abs))
        .filter(|size| *size > 0.0 && size.is_finite())
        .collect();
    let largest = quantile(&sizes, share).unwrap_or(1.0);
    let mut film = Film::new(a.width(), a.height());
    for (i, difference) in differences().enumerate() {
        let shown = difference.map(|channel| (0.5 + 0.5 * channel / largest).clamp(0.0, 1.0));
        film.set([i as u32 % a.width(), i as u32 / a.width()], shown);
    }
    (film, largest)
}

/// The part of a picture around a region.
fn around(film: &Film, region: &Region) -> Film {
    let [x, y, width, height] = region.bounds;
    let (left, top) = (x.saturating_sub(MARGIN), y.saturating_sub(MARGIN));
    let right = (x + width + MARGIN).min(film.width());
    let bottom = (y + height + MARGIN).min(film.height());
    let mut part = Film::new(right - left, bottom - top);
    for row in top..bottom {
        for column in left..right {
            part.set([column - left, row - top], film.get([column, row]));
        }
    }
    part
}
