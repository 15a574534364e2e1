//! Two pictures of one size on an HTML page: side by side, flip, difference in three scales, swipe, and
//! the worst pixel of each region.

use std::fmt::Write;

use groundtruth::explain::count;
use groundtruth::film::{Film, Tone, data_uri};
use groundtruth::rgb::Rgb;

use super::differences::{Differences, NOT_A_NUMBER};
use super::{Comparison, Picture, Region};
use crate::digits::{short, three};
use crate::html::{FLIP, escaped};

/// The rules for a pair and for a map with frames, for the style of their page.
pub const STYLE: &str = "\
img { display: block; image-rendering: pixelated; }
.row { display: grid; grid-template-columns: repeat(auto-fit, minmax(calc(var(--zoom, 1) * min(20em, 100%)), 1fr)); \
gap: 1em; margin: 1em 0; overflow-x: auto; }
.row figure { margin: 0; max-width: calc(var(--zoom, 1) * 40em); min-width: 0; }
.row img { width: 100%; box-sizing: border-box; border: 1px solid var(--edge); }
figcaption { color: var(--quiet); font-size: 90%; }
.flip, .swipe { display: block; position: relative; }
.flip { cursor: pointer; }
.flip input { position: absolute; top: 0.4em; left: 0.4em; z-index: 1; margin: 0; }
.flip img + img { position: absolute; top: 0; left: 0; opacity: 0; }
.flip :checked ~ img + img { opacity: 1; }
@media (hover: hover) {
  .flip:hover img + img { opacity: 1; }
  .flip:hover :checked ~ img + img { opacity: 0; }
}
.flip:focus-within { outline: 3px solid var(--mark); outline-offset: -3px; }
.swipe img { width: min(40em, 100vw - 2em); max-width: none; }
.swipe { overflow: hidden; width: min(40em, 100vw - 2em); border: 1px solid var(--edge); }
.swipe div { position: absolute; top: 0; left: 0; width: 50%; height: 100%; overflow: hidden; \
resize: horizontal; border-right: 2px solid var(--mark); }
.scale { display: grid; grid-template-columns: 1fr 1fr 1fr; margin-top: 0.3em; }
.scale span:nth-child(3) { text-align: center; }
.scale span:nth-child(4) { text-align: right; }
.ramp { grid-column: 1 / 4; height: 0.8em; border: 1px solid var(--edge); \
background: linear-gradient(to right, #000, #fff); }
.row.zoom { display: flex; flex-wrap: wrap; }
.row.zoom figure { position: relative; flex: 0 1 16em; height: max-content; }
.row.zoom img { border: 0; }
.row.zoom p { flex: 1 1 min(20em, 100%); margin: 0; }
.zoom i, .map i { position: absolute; box-sizing: border-box; border: 2px solid #f80; }
.map { position: relative; width: max-content; max-width: calc(var(--zoom, 1) * 100%); }
.map img { width: calc(var(--zoom, 1) * 40em); max-width: 100%; box-sizing: border-box; border: 1px solid var(--edge); }
@media print { .flip input, .swipe, .swiped { display: none; } }
";

/// The legend of a grey picture: a ramp from black to white, and the values at its ends and in its middle.
pub fn scale(values: [&str; 3]) -> String {
    let values = values.map(|value| format!("<span>{}</span>", escaped(value))).concat();
    format!("<div class=\"scale\"><span class=\"ramp\"></span>{values}</div>")
}

/// The shares of differing channels that the three scales of the difference show unclipped: one bright lamp must
/// not hide the rest.
const SCALES: [f64; 3] = [0.5, 0.9, 1.0];

/// Pixels around a region that are shown with it.
const MARGIN: u32 = 4;

/// Pixels to either side of a region's worst pixel that are shown at most.
const REACH: u32 = 16;

/// Two pictures of one size, compared.
pub struct ComparedPictures<'a> {
    /// What the pictures are called: "A" and "B".
    pub names: [&'a str; 2],
    /// The pictures.
    pub pictures: [&'a Picture; 2],
    /// The pictures for eyes, to be shown with `tone`.
    pub shown: [Film; 2],
    /// How `shown` becomes colours of the screen.
    pub tone: Tone,
    /// How the pictures compare.
    pub comparison: &'a Comparison,
    /// The commands that explain a pixel.
    pub commands: &'a dyn Fn([u32; 2]) -> Vec<String>,
}

/// Two pictures of radiance, one over the other, and their differences; nothing if their sizes differ.
pub fn views(names: [&str; 2], pictures: [&Picture; 2]) -> String {
    let Ok(comparison) = Comparison::of(pictures[0], pictures[1], 0.0) else {
        return String::new();
    };
    let (shown, commands) = (pictures.map(Picture::radiance), &|_| Vec::new());
    ComparedPictures {
        names,
        pictures,
        shown,
        tone: Tone::SCREEN,
        comparison: &comparison,
        commands,
    }
    .views()
}

impl ComparedPictures<'_> {
    /// The part of the page.
    pub fn html(&self) -> String {
        let mut html = self.views();
        if !self.comparison.is_same() {
            html.push_str("<h2>Regions</h2>\n<p>Each with its worst pixel framed.</p>\n");
            self.comparison.listed().for_each(|region| self.region(&mut html, region));
        }
        html
    }

    /// Both pictures side by side, the first of which flips to the second by pointer, by tap and by key; a swipe; and
    /// their differences.
    pub fn views(&self) -> String {
        let [a, b] = self.names.map(escaped);
        let [shown_a, shown_b] = [0, 1].map(|i| self.image(i, &with_marked(&self.shown[i])));
        let mut html = format!(
            "<div class=\"row\">\n<figure><label class=\"{FLIP}\"><input type=\"checkbox\" \
             aria-label=\"show {b} in place of {a}\">{shown_a}{shown_b}</label>\
             <figcaption>{a}; {b} under the pointer, by a tap, or by F (or Tab and space); +\u{a0}and\u{a0}−\u{a0}zoom</figcaption></figure>\n\
             <figure>{shown_b}<figcaption>{b}. Magenta is not a number.</figcaption></figure>\n</div>\n"
        );
        if !self.comparison.is_same() {
            self.differences(&mut html);
            let _ = write!(
                html,
                "<h2 class=\"swiped\">Swipe</h2>\n<p class=\"swiped\">{a} at the left, {b} at the right; pull the \
                 corner of the line.</p>\n<div class=\"swipe\">{shown_b}<div>{shown_a}</div></div>\n"
            );
        }
        html
    }

    fn image(&self, index: usize, film: &Film) -> String {
        let (name, data) = (escaped(self.names[index]), data_uri(film, &self.tone));
        format!("<img alt=\"{name}\" src=\"{data}\">")
    }

    fn differences(&self, html: &mut String) {
        let [a, b] = self.names.map(escaped);
        let _ = writeln!(
            html,
            "<h2>{b} − {a}</h2>\n<p>Grey: equal; brighter: {b} is larger. Three scales, because one bright lamp must not \
             hide the rest.</p>\n<div class=\"row\">"
        );
        let differences =
            Differences::of(self.pictures[0], self.pictures[1], self.comparison.tolerance);
        for share in SCALES {
            let largest = differences.within(share);
            let data = data_uri(&differences.film(largest), &Tone::PLAIN);
            let (percent, end) = (100.0 * share, short(largest));
            let legend = scale([&format!("−{end}"), "0", &format!("+{end}")]);
            let _ = writeln!(
                html,
                "<figure><img alt=\"difference\" src=\"{data}\"><figcaption>{legend}{percent} % of the differences are \
                 within the scale</figcaption></figure>"
            );
        }
        html.push_str("</div>\n");
    }

    fn region(&self, html: &mut String, region: &Region) {
        let Region { pixels, bounds: [x, y, w, h], worst, values: [a, b], difference } = region;
        let [left, top, right, bottom] = self.window(region);
        let percent = |part: u32, of: u32| 100.0 * f64::from(part) / f64::from(of);
        let (across, down) = (right - left, bottom - top);
        let mark = format!(
            "<i style=\"left:{}%;top:{}%;width:{}%;height:{}%\"></i>",
            percent(worst[0] - left, across),
            percent(worst[1] - top, down),
            percent(1, across),
            percent(1, down)
        );
        html.push_str("<div class=\"row zoom\">");
        for index in [0, 1] {
            let part = part(&self.shown[index], [left, top, right, bottom]);
            let _ = write!(html, "<figure>{}{mark}</figure>", self.image(index, &part));
        }
        let [wx, wy] = worst;
        let pixels = count(*pixels as usize, "pixel");
        let _ = write!(
            html,
            "<p>{pixels} in {x},{y},{w}x{h}<br>the worst at ({wx}, {wy}), by {}<br>{}: {}<br>{}: {}",
            short(*difference),
            escaped(self.names[0]),
            three(*a),
            escaped(self.names[1]),
            three(*b)
        );
        for command in (self.commands)(*worst) {
            let _ = write!(html, "<br><code>{}</code>", escaped(&command));
        }
        html.push_str("</p></div>\n");
    }

    /// The pixels that are shown of a region: left, top, and the ends at right and bottom.
    fn window(&self, region: &Region) -> [u32; 4] {
        let [x, y, width, height] = region.bounds;
        let [size_x, size_y] = self.comparison.size;
        let side = |start: u32, length: u32, worst: u32, size: u32| {
            let first = start.saturating_sub(MARGIN).max(worst.saturating_sub(REACH));
            let end = (start + length + MARGIN).min(worst + REACH + 1).min(size);
            [first, end]
        };
        let [left, right] = side(x, width, region.worst[0], size_x);
        let [top, bottom] = side(y, height, region.worst[1], size_y);
        [left, top, right, bottom]
    }
}

/// The part of a picture with these first and last columns and rows.
fn part(film: &Film, [left, top, right, bottom]: [u32; 4]) -> Film {
    let mut part = Film::new(right - left, bottom - top);
    for row in top..bottom {
        for column in left..right {
            part.set([column - left, row - top], marked(film.get([column, row])));
        }
    }
    part
}

/// The picture with what is not a number in magenta.
fn with_marked(film: &Film) -> Film {
    part(film, [0, 0, film.width(), film.height()])
}

fn marked(color: Rgb) -> Rgb {
    if color.to_array().iter().any(|channel| channel.is_nan()) { NOT_A_NUMBER } else { color }
}
