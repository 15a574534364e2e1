//! Two pictures of one size on an HTML page: side by side, flip, difference in three scales, swipe, and
//! the worst pixel of each region.

use groundtruth::film::{Film, Tone};
use groundtruth::rgb::Rgb;
use text::brief::count;

use super::differences::{Differences, NOT_A_NUMBER};
use super::{Comparison, Picture, Region};
use text::digits::{short, three};
use text::document::*;
use text::html::FLIP;

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
pub fn legend(values: [&str; 3]) -> Element {
    group("scale")
        .with(element("span").class("ramp"))
        .with_all(values.map(|value| element("span").with(value)))
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
pub fn views(names: [&str; 2], pictures: [&Picture; 2]) -> Element {
    let Ok(comparison) = Comparison::of(pictures[0], pictures[1], 0.0) else {
        return several();
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
    pub fn element(&self) -> Element {
        let whole = several().with(self.views());
        if self.comparison.is_same() {
            return whole;
        }
        whole
            .with(heading(2, "Regions"))
            .with(paragraph("Each with its worst pixel framed."))
            .with_all(self.comparison.listed().map(|region| self.region(region)))
    }

    /// Both pictures side by side, the first of which flips to the second by pointer, by tap and by key; a swipe; and
    /// their differences.
    pub fn views(&self) -> Element {
        let [a, b] = self.names;
        let shown = |index: usize| self.image(index, &with_marked(&self.shown[index]));
        let box_to_flip = element("input")
            .attribute("type", "checkbox")
            .attribute("aria-label", format!("show {b} in place of {a}"));
        let flip = element("label").class(FLIP).with(box_to_flip).with_all([0, 1].map(shown));
        let how = format!(
            "{a}; {b} under the pointer, by a tap, or by F (or Tab and space); +\u{a0}and\u{a0}−\u{a0}zoom"
        );
        let row = group("row")
            .with(figure(flip, how))
            .with(figure(shown(1), format!("{b}. Magenta is not a number.")));
        if self.comparison.is_same() {
            return row;
        }
        let how = format!("{a} at the left, {b} at the right; pull the corner of the line.");
        several()
            .with(row)
            .with(self.differences())
            .with(heading(2, "Swipe").class("swiped"))
            .with(paragraph(how).class("swiped"))
            .with(group("swipe").with(shown(1)).with(element("div").with(shown(0))))
    }

    fn image(&self, index: usize, film: &Film) -> Element {
        image(film, &self.tone, self.names[index])
    }

    fn differences(&self) -> Element {
        let [a, b] = self.names;
        let differences =
            Differences::of(self.pictures[0], self.pictures[1], self.comparison.tolerance);
        let scaled = |share: f64| {
            let largest = differences.within(share);
            let (percent, end) = (100.0 * share, short(largest));
            let legend = legend([&format!("−{end}"), "0", &format!("+{end}")]);
            let caption = format!("{percent} % of the differences are within the scale");
            let image = image(&differences.film(largest), &Tone::PLAIN, "difference");
            figure(image, several().with(legend).with(caption))
        };
        several()
            .with(heading(2, format!("{b} − {a}")))
            .with(paragraph(format!(
                "Grey: equal; brighter: {b} is larger. Three scales, because one bright lamp must not hide the rest."
            )))
            .with(group("row").with_all(SCALES.map(scaled)))
    }

    fn region(&self, region: &Region) -> Element {
        let Region { pixels, bounds: [x, y, w, h], worst, values, difference } = region;
        let window @ [left, top, right, bottom] = self.window(region);
        let [wx, wy] = *worst;
        let mark = frame("", [wx - left, wy - top, 1, 1], [right - left, bottom - top]);
        let figures = [0, 1].map(|index| {
            let image = self.image(index, &part(&self.shown[index], window));
            element("figure").with(image).with(mark.clone())
        });
        let pixels = count(*pixels as usize, "pixel");
        let mut said = vec![
            format!("{pixels} in {x},{y},{w}x{h}"),
            format!("the worst at ({wx}, {wy}), by {}", short(*difference)),
        ];
        let values = self.names.iter().zip(values);
        said.extend(values.map(|(name, value)| format!("{name}: {}", three(*value))));
        let commands = (self.commands)(*worst).into_iter().map(code).map(Node::from);
        let lines = said.into_iter().map(Node::from).chain(commands);
        let lines = lines.map(|line| several().with(line).with(element("br")));
        group("row zoom").with_all(figures).with(element("p").with_all(lines))
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

/// A frame over a picture of this size, around the pixels from this left column and top row on, so many columns and rows.
pub fn frame(name: &str, [x, y, w, h]: [u32; 4], [width, height]: [u32; 2]) -> Element {
    let percent = |part: u32, of: u32| 100.0 * f64::from(part) / f64::from(of);
    let style = format!(
        "left:{}%;top:{}%;width:{}%;height:{}%",
        percent(x, width),
        percent(y, height),
        percent(w, width),
        percent(h, height)
    );
    let frame = element("i");
    let frame = if name.is_empty() { frame } else { frame.attribute("title", name) };
    frame.attribute("style", style)
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
