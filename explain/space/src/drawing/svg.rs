//! A drawing as SVG.

use std::fmt::Write;

use text::html::escaped;

use super::{Drawing, Label, Role, Stroke, arrowhead};

/// The width of the picture, in its own units.
const WIDTH: f64 = 800.0;
/// The greatest height of what is drawn, without the notes.
const HEIGHT: f64 = 640.0;
/// The space around what is drawn.
const MARGIN: f64 = 24.0;
/// The size of the letters.
const LETTER: f64 = 25.0;
/// The mean width of a letter, as a part of its size.
const LETTER_WIDTH: f64 = 0.56;
/// The height of a line of words.
const LINE: f64 = 1.15 * LETTER;
/// The distance of words from their point.
const GAP: f64 = 8.0;
/// The length of arrowheads.
const HEAD: f64 = 18.0;
/// The most letters on a line of the notes.
const COLUMNS: usize = 60;

/// The colour of what has this role on white paper, as `#rrggbb`.
pub fn ink(role: Role) -> &'static str {
    match role {
        Role::Incoming | Role::Outline => "#1a1a1a",
        Role::Reflected => "#c04a00",
        Role::Transmitted => "#0068b5",
        Role::Shadow => "#a07800",
        Role::Blocked => "#7a5a9a",
        Role::Dark => "#000000",
        Role::Normal => "#1d7d34",
        Role::Surroundings => "#a8a8a8",
        Role::Arc => "#444444",
    }
}

/// The width of a line, in units of the picture.
fn width(role: Role) -> f64 {
    match role {
        Role::Surroundings | Role::Arc => 1.5,
        Role::Normal | Role::Dark => 2.0,
        Role::Outline => 2.5,
        Role::Incoming | Role::Reflected | Role::Transmitted | Role::Shadow | Role::Blocked => 3.5,
    }
}

/// From coordinates of a drawing to those of its picture, whose y goes down.
#[derive(Clone, Copy, Debug)]
struct Fit {
    scale: f64,
    /// Where (0, 0) is.
    origin: [f64; 2],
    /// The height of what is drawn.
    height: f64,
}

impl Drawing {
    /// The drawing with its words and notes as an SVG of 800 units of width, on white.
    pub fn svg(&self) -> String {
        let fit = self.fit();
        let notes: Vec<String> =
            self.notes.iter().flat_map(|note| wrapped(note, COLUMNS)).collect();
        let height = fit.height + 1.4 * LETTER * notes.len() as f64 + 0.5 * MARGIN;
        let title = escaped(&self.title);
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height:.0}\" role=\"img\" \
             font-family=\"system-ui, sans-serif\" font-size=\"{LETTER}\">\n<title>{title}</title>\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
        );
        for stroke in &self.strokes {
            fit.write_stroke(&mut svg, stroke);
        }
        for label in &self.labels {
            fit.write_label(&mut svg, label);
        }
        for (line, note) in (1..).zip(&notes) {
            let y = fit.height + 1.4 * LETTER * f64::from(line) - 0.4 * LETTER;
            let _ = writeln!(svg, "<text x=\"{MARGIN}\" y=\"{y:.1}\">{}</text>", escaped(note));
        }
        svg + "</svg>\n"
    }

    /// The largest scale at which lines and words have room.
    fn fit(&self) -> Fit {
        let [low, high] = self.bounds().unwrap_or([[0.0; 2], [1.0; 2]]);
        let size = |axis: usize| (high[axis] - low[axis]).max(f64::MIN_POSITIVE);
        let room = [WIDTH - 2.0 * MARGIN, HEIGHT - 2.0 * MARGIN];
        // what words need beyond the lines, on both ends of an axis
        let extra = |axis: usize, scale: f64| {
            self.labels.iter().fold([0.0_f64; 2], |[before, after], label| {
                let [down, up] = extent(label)[axis];
                let [to_low, to_high] = [label.at[axis] - low[axis], high[axis] - label.at[axis]];
                [before.max(down - scale * to_low), after.max(up - scale * to_high)]
            })
        };
        let used = |axis: usize, scale: f64| {
            let [before, after] = extra(axis, scale);
            scale * size(axis) + before + after
        };
        let of_lines = |room: [f64; 2]| (room[0] / size(0)).min(room[1] / size(1));
        // lines are seen even if there is no room for the words
        let [mut scale, mut too_large] = [of_lines([LETTER; 2]), of_lines(room)];
        for _ in 0..40 {
            let middle = 0.5 * (scale + too_large);
            let fits = (0..2).all(|axis| used(axis, middle) <= room[axis]);
            *(if fits { &mut scale } else { &mut too_large }) = middle;
        }
        let extra = [0, 1].map(|axis| extra(axis, scale));
        let aside = 0.5 * (WIDTH - used(0, scale)) + extra[0][0];
        Fit {
            scale,
            origin: [aside - scale * low[0], MARGIN + extra[1][1] + scale * high[1]],
            height: used(1, scale) + 2.0 * MARGIN,
        }
    }
}

/// How far words go from their point to the left and right, and down and up.
fn extent(label: &Label) -> [[f64; 2]; 2] {
    let letters = label.text.lines().map(|line| line.chars().count()).max().unwrap_or(0);
    let size = [LETTER_WIDTH * LETTER * letters as f64, LINE * label.text.lines().count() as f64];
    let reach = |axis: usize| match label.side[axis] {
        0 => [0.5 * size[axis]; 2],
        side if side < 0 => [size[axis] + GAP, 0.0],
        _ => [0.0, size[axis] + GAP],
    };
    [reach(0), reach(1)]
}

impl Fit {
    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.origin[0] + self.scale * x, self.origin[1] - self.scale * y]
    }

    fn write_stroke(&self, svg: &mut String, stroke: &Stroke) {
        let points: Vec<[f64; 2]> = stroke.points.iter().map(|&point| self.place(point)).collect();
        let (ink, width) = (ink(stroke.role), width(stroke.role));
        if let [[x, y]] = points[..] {
            let _ = writeln!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"5\" fill=\"{ink}\"/>");
            return;
        }
        let dashes = match stroke.role {
            _ if stroke.dashed => " stroke-dasharray=\"7 6\"",
            Role::Dark => " stroke-dasharray=\"2 6\"",
            _ => "",
        };
        let ray = stroke.ray.map_or(String::new(), |ray| format!(" data-ray=\"{ray}\""));
        let _ = writeln!(
            svg,
            "<polyline{ray} points=\"{}\" fill=\"none\" stroke=\"{ink}\" stroke-width=\"{width}\" \
             stroke-linecap=\"round\" stroke-linejoin=\"round\"{dashes}/>",
            listed(&points)
        );
        if let Some(head) = arrowhead(&points, HEAD).filter(|_| stroke.arrow) {
            let _ = writeln!(svg, "<polygon points=\"{}\" fill=\"{ink}\"/>", listed(&head));
        }
    }

    fn write_label(&self, svg: &mut String, label: &Label) {
        let [x, y] = self.place(label.at);
        let x = x + f64::from(label.side[0]) * GAP;
        let anchor = match label.side[0] {
            0 => "middle",
            side if side < 0 => "end",
            _ => "start",
        };
        let [_, [_, up]] = extent(label);
        let top = if label.side[1] < 0 { y + GAP } else { y - up };
        let ink = ink(label.role);
        for (index, line) in label.text.lines().enumerate() {
            // the base line of letters is about a quarter of their size above the end of their line
            let y = top + LINE * (index as f64 + 1.0) - 0.3 * LETTER;
            let _ = writeln!(
                svg,
                "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" fill=\"{ink}\" stroke=\"#ffffff\" \
                 stroke-width=\"4\" paint-order=\"stroke\">{}</text>",
                escaped(line)
            );
        }
    }
}

fn listed(points: &[[f64; 2]]) -> String {
    let points = points.iter().map(|[x, y]| format!("{x:.1},{y:.1}"));
    points.collect::<Vec<_>>().join(" ")
}

/// The words of each line of a text in lines of at most this many letters; a longer word has a line of its own.
fn wrapped(text: &str, columns: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for line in text.lines() {
        lines.push(String::new());
        for word in line.split_whitespace() {
            let Some(last) = lines.last_mut() else { continue };
            if last.is_empty() {
                word.clone_into(last);
            } else if last.chars().count() + 1 + word.chars().count() <= columns {
                *last += " ";
                *last += word;
            } else {
                lines.push(word.to_owned());
            }
        }
    }
    lines
}
