//! Drawings as SVG: sizes, places, lines, colours and words, read back from the picture.

use groundtruth::math::Pcg32;
use space::{Drawing, Label, Role, Stroke, arrowhead, ink};

use super::borders::near;

/// Places are printed to a tenth.
const PRINTED: f64 = 0.051;
/// The size of the letters, and the height of a line of words.
const LETTER: f64 = 25.0;
const LINE: f64 = 1.15 * LETTER;

pub const ROLES: [Role; 10] = [
    Role::Incoming,
    Role::Reflected,
    Role::Transmitted,
    Role::Shadow,
    Role::Blocked,
    Role::Dark,
    Role::Normal,
    Role::Outline,
    Role::Surroundings,
    Role::Arc,
];

fn value<'a>(line: &'a str, name: &str) -> Option<&'a str> {
    line.split_once(&format!(" {name}=\""))?.1.split('"').next()
}

fn number(line: &str, name: &str) -> f64 {
    let found = value(line, name).unwrap_or_else(|| panic!("no {name} in {line}"));
    found.parse().unwrap_or_else(|_| panic!("{name} is no number in {line}"))
}

fn points(line: &str) -> Vec<[f64; 2]> {
    let pairs = value(line, "points").unwrap_or_else(|| panic!("no points in {line}")).split(' ');
    pairs
        .map(|pair| {
            let (x, y) = pair.split_once(',').unwrap_or_else(|| panic!("{pair}"));
            [x, y].map(|it| it.parse().unwrap_or_else(|_| panic!("{it} in {line}")))
        })
        .collect()
}

/// The lines of an SVG that begin with this element.
fn elements<'a>(svg: &'a str, name: &'a str) -> Vec<&'a str> {
    svg.lines().filter(|line| line.starts_with(&format!("<{name} "))).collect()
}

/// The width and the height of the picture.
fn size(svg: &str) -> [f64; 2] {
    let text = value(svg, "viewBox").expect("a box");
    let numbers: Vec<f64> = text.split(' ').map(|it| it.parse().expect("a number")).collect();
    assert_eq!(numbers[..2], [0.0, 0.0], "the corner of the picture");
    [numbers[2], numbers[3]]
}

fn random_point(random: &mut Pcg32, scale: [f64; 2]) -> [f64; 2] {
    scale.map(|scale| scale * (2.0 * random.uniform() - 1.0))
}

/// Law: an arrowhead is an isosceles triangle of the given length along the longest piece of a line, its tip ahead, its middle
/// in that of the piece, 0.36 of its length wide on each side; a piece that is shorter has none, one just as long has one.
/// Oracle: products with the direction of the piece and with the perpendicular.
#[test]
fn an_arrowhead_lies_along_the_middle_of_the_longest_piece() {
    const ROUNDING: f64 = 1e-12;
    let mut random = Pcg32::new(2, 9);
    for _ in 0..200 {
        let from = random_point(&mut random, [3.0, 30.0]);
        let way = random_point(&mut random, [2.0, 2.0]);
        let long = (way[0] * way[0] + way[1] * way[1]).sqrt();
        let to = [from[0] + way[0], from[1] + way[1]];
        // a shorter piece before it, and one behind it
        let before = [from[0] + 0.5 * way[1], from[1] - 0.5 * way[0]];
        let behind = [to[0] - 0.3 * way[1], to[1] + 0.6 * way[0]];
        let line = [before, from, to, behind];
        let length = (0.01 + 0.98 * random.uniform()) * long;
        let head = arrowhead(&line, length).expect("there is room");
        let part = head.map(|[x, y]| {
            let at = [x - 0.5 * (from[0] + to[0]), y - 0.5 * (from[1] + to[1])];
            let along = (at[0] * way[0] + at[1] * way[1]) / long;
            let aside = (way[0] * at[1] - way[1] * at[0]) / long;
            [along / length, aside / length]
        });
        let expected = [[0.5, 0.0], [-0.5, 0.36], [-0.5, -0.36]];
        for (found, expected) in part.iter().zip(expected) {
            for axis in [0, 1] {
                near(
                    found[axis],
                    expected[axis],
                    ROUNDING * 30.0 / length,
                    "corner, in lengths of the head",
                );
            }
        }
        assert_eq!(arrowhead(&line, 1.01 * long), None, "the head of a piece that is shorter");
    }
    let straight = [[1.0, 2.0], [1.0, 6.0]];
    assert!(arrowhead(&straight, 4.0).is_some(), "a piece just as long has a head");
    assert_eq!(arrowhead(&straight, 4.5), None, "the head of a piece that is shorter");
    assert_eq!(arrowhead(&straight[..1], 0.0), None, "the head of a dot");
}

/// Law: colours are written as `#rrggbb`; no two roles have the same, but for the ray that arrives and the outline; all but the
/// surroundings, which recede, stand out from white by a contrast of 3. Oracle: the contrast of WCAG 2.
#[test]
fn colours_of_roles_differ_and_stand_out() {
    let mut seen: Vec<(&str, Role)> = Vec::new();
    for role in ROLES {
        let color = ink(role);
        let digits = color.strip_prefix('#').unwrap_or_else(|| panic!("{color} of {role:?}"));
        assert_eq!(digits.len(), 6, "digits of the colour of {role:?}");
        let channel = |k: usize| {
            let value = u8::from_str_radix(&digits[2 * k..2 * k + 2], 16).expect("two digits");
            let value = f64::from(value) / 255.0;
            match value <= 0.04045 {
                true => value / 12.92,
                false => groundtruth::math::power((value + 0.055) / 1.055, 2.4),
            }
        };
        let luminance = 0.2126 * channel(0) + 0.7152 * channel(1) + 0.0722 * channel(2);
        let contrast = 1.05 / (luminance + 0.05);
        let recedes = contrast < 3.0;
        assert_eq!(recedes, role == Role::Surroundings, "contrast {contrast} of {role:?}");
        let same = seen.iter().find(|(other, _)| *other == color).map(|(_, role)| *role);
        let expected = (role == Role::Outline).then_some(Role::Incoming);
        assert_eq!(same, expected, "a role before {role:?} with the same colour");
        seen.push((color, role));
    }
}

/// The box of the words of a label from its lines: left, right, top, bottom.
fn words(lines: &[&str], text: &str) -> [f64; 4] {
    let letters = text.lines().map(|line| line.chars().count()).max().unwrap_or(0);
    let wide = 0.56 * LETTER * letters as f64;
    let left = number(lines[0], "x")
        - match value(lines[0], "text-anchor") {
            Some("end") => wide,
            Some("middle") => 0.5 * wide,
            Some("start") => 0.0,
            other => panic!("anchor {other:?}"),
        };
    let top = number(lines[0], "y") + 0.3 * LETTER - LINE;
    let bottom = number(lines[lines.len() - 1], "y") + 0.3 * LETTER;
    [left, left + wide, top, bottom]
}

/// Law: one scale for both axes, y up; what is drawn, words and lines, is in the middle from left to right, 24 below the upper
/// side, and 24 above the lower one or the notes; it is as large as 800 × 640 allow. Words of several lines are one block,
/// 8 beside their point or in the middle of it. Oracle: the box around all printed places.
#[test]
fn a_drawing_is_as_large_as_there_is_room() {
    let mut random = Pcg32::new(6, 2);
    let mut full = [0; 2];
    for case in 0..80_usize {
        let scale = [[1.0, 1.0], [1e-3, 2e-3], [500.0, 100.0], [1.0, 30.0]][case % 4];
        let mut drawing = Drawing::default();
        for _ in 0..3 {
            drawing.strokes.push(Stroke::new(Role::Arc, vec![random_point(&mut random, scale)]));
        }
        for index in 0..case % 5 {
            let text =
                ["n", "two\nlines", "a longer word", "3\nlines,\nunequal"][(index + case) % 4];
            let side = [(index % 3) as i8 - 1, ((index + case) % 3) as i8 - 1];
            let at = random_point(&mut random, scale);
            drawing.labels.push(Label { at, text: text.to_owned(), role: Role::Normal, side });
        }
        let notes = (case / 5) % 3;
        drawing.notes.extend((0..notes).map(|k| format!("note {k}")));
        let svg = drawing.svg();
        let [width, height] = size(&svg);
        assert_eq!(width, 800.0, "the width of the picture");
        let below = 1.4 * LETTER * notes as f64 + 12.0;
        let drawn = height - below;
        let texts = elements(&svg, "text");
        let (mut texts, last) = texts.split_at(texts.len() - notes);
        for (k, note) in last.iter().enumerate() {
            near(number(note, "x"), 24.0, 0.0, "the left side of a note");
            // the height of the picture is printed in whole units
            let y = drawn + 1.4 * LETTER * (k + 1) as f64 - 0.4 * LETTER;
            near(number(note, "y"), y, 0.5 + PRINTED, "the base line of a note");
        }
        let dots: Vec<[f64; 2]> =
            elements(&svg, "circle").iter().map(|it| ["cx", "cy"].map(|c| number(it, c))).collect();
        let dot = |k: usize| drawing.strokes[k].points[0];
        let factor = |k: usize, axis: usize| {
            [1.0, -1.0][axis] * (dots[k][axis] - dots[0][axis]) / (dot(k)[axis] - dot(0)[axis])
        };
        // the axis along which the dots are farthest apart on the picture says most
        let apart = |k: usize, axis: usize| (dots[k][axis] - dots[0][axis]).abs();
        let best = [(1, 0), (1, 1), (2, 0), (2, 1)]
            .into_iter()
            .max_by(|a, b| apart(a.0, a.1).total_cmp(&apart(b.0, b.1)))
            .expect("four");
        let of_all = factor(best.0, best.1);
        let off = 2.0 * PRINTED / apart(best.0, best.1);
        let place = |[x, y]: [f64; 2]| {
            [dots[0][0] + of_all * (x - dot(0)[0]), dots[0][1] - of_all * (y - dot(0)[1])]
        };
        let close = |found: f64, expected: f64, what: &str| {
            near(found, expected, 2.0 * PRINTED + 800.0 * off, what);
        };
        for (k, found) in dots.iter().enumerate() {
            let expected = place(dot(k));
            (0..2).for_each(|axis| close(found[axis], expected[axis], "place of a dot"));
        }
        let mut box_ = [f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY];
        let mut grow = |[left, right, top, bottom]: [f64; 4]| {
            box_ = [box_[0].min(left), box_[1].max(right), box_[2].min(top), box_[3].max(bottom)];
        };
        dots.iter().for_each(|[x, y]| grow([*x, *x, *y, *y]));
        for label in &drawing.labels {
            let count = label.text.lines().count();
            let (own, rest) = texts.split_at(count);
            texts = rest;
            for (k, line) in own.iter().enumerate() {
                let y = number(own[0], "y") + LINE * k as f64;
                near(number(line, "y"), y, 2.0 * PRINTED, "base line of words");
                assert_eq!(value(line, "fill"), Some(ink(label.role)), "the colour of words");
            }
            let block = words(own, &label.text);
            let at = place(label.at);
            for axis in [0, 1] {
                let [low, high] = [block[2 * axis], block[2 * axis + 1]];
                // y goes down
                match label.side[axis] * [1, -1][axis] {
                    0 => close(0.5 * (low + high), at[axis], "the middle of words"),
                    1 => close(low, at[axis] + 8.0, "the near side of words"),
                    _ => close(high, at[axis] - 8.0, "the near side of words"),
                }
            }
            grow(block);
            grow([at[0], at[0], at[1], at[1]]);
        }
        let [left, right, top, bottom] = box_;
        close(left, 800.0 - right, "the space to the left, beside that to the right");
        close(top, 24.0, "the space above");
        near(bottom, drawn - 24.0, 0.5 + 3.0 * PRINTED + 800.0 * off, "the lowest of all");
        let used = [(right - left) / 752.0, (bottom - top) / 592.0];
        let most = used[0].max(used[1]);
        near(most, 1.0, 1e-3 + 2.0 * off, "the part of the room that is used");
        full[usize::from(used[1] > used[0])] += 1;
    }
    assert!(full.iter().all(|n| *n > 5), "drawings as wide, and as high, as allowed: {full:?}");
}

/// Law: where words have no room at any scale, lines still have 25 units, the size of a letter. Oracle: the printed line.
#[test]
fn lines_are_seen_where_words_have_no_room() {
    for (way, axis) in [([1.0, 0.5], 0), ([0.01, 0.02], 1)] {
        let mut drawing = Drawing::default();
        drawing.strokes.push(Stroke::new(Role::Arc, vec![[0.0; 2], way]));
        let text = "a word ".repeat(20).trim_end().to_owned();
        drawing.labels.push(Label { at: way, text, role: Role::Arc, side: [1, 1] });
        let svg = drawing.svg();
        let ends = points(elements(&svg, "polyline")[0]);
        near((ends[1][axis] - ends[0][axis]).abs(), LETTER, 2.0 * PRINTED, "the longer side");
    }
}
