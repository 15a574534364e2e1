//! Plots: what is printed at the axes says where the points are.

use groundtruth::math::{Pcg32, ln, power};
use report::plot::*;
use statistics::slope::PowerLaw;

/// Places are whole pixels.
pub const PIXEL: f64 = 1.01;
/// Where the axes are: their ends in pixels.
pub const X: [f64; 2] = [76.0, 615.0];
pub const Y: [f64; 2] = [387.0, 8.0];

pub fn near(found: f64, expected: f64, tolerance: f64, what: &str) {
    let off = (found - expected).abs();
    assert!(off <= tolerance, "{what}: found {found}, expected {expected}, {off} apart");
}

fn attribute<'a>(line: &'a str, name: &str) -> Option<&'a str> {
    line.split_once(&format!(" {name}=\""))?.1.split('"').next()
}

pub fn number(line: &str, name: &str) -> f64 {
    attribute(line, name)
        .and_then(|it| it.parse().ok())
        .unwrap_or_else(|| panic!("{name} of {line}"))
}

pub fn places(line: &str) -> Vec<[f64; 2]> {
    let pairs = attribute(line, "points").unwrap_or_default().split_whitespace();
    pairs
        .filter_map(|pair| {
            let (x, y) = pair.split_once(',')?;
            Some([x.parse().ok()?, y.parse().ok()?])
        })
        .collect()
}

/// A marker: its colour, its middle, its outline around that, and whether it is filled.
pub type Marker = (String, [f64; 2], Vec<[f64; 2]>, bool);

/// A word of a plot: its text, its place and what it belongs to.
pub struct Word {
    pub text: String,
    pub at: [f64; 2],
    anchor: String,
    pub size: f64,
    pub color: String,
}

pub struct Drawn {
    pub svg: String,
    pub words: Vec<Word>,
}

impl Drawn {
    pub fn of(plot: &Plot<'_>) -> Self {
        let svg = plot.figure("words below").html();
        let lines: Vec<&str> = svg.lines().collect();
        let words = lines
            .windows(2)
            .filter(|pair| pair[0].starts_with("<text"))
            .map(|pair| Word {
                text: pair[1].to_owned(),
                at: [number(pair[0], "x"), number(pair[0], "y")],
                anchor: attribute(pair[0], "text-anchor").unwrap_or_default().to_owned(),
                size: number(pair[0], "font-size"),
                color: attribute(pair[0], "fill").unwrap_or_default().to_owned(),
            })
            .collect();
        Self { words, svg }
    }

    /// The values that are printed at an axis, and where.
    fn ticks(&self, axis: usize) -> Vec<(f64, f64)> {
        let own = |it: &&Word| match axis {
            0 => it.anchor == "middle" && it.at[1] == 398.0,
            _ => it.anchor == "end" && it.at[0] == 66.0,
        };
        self.words.iter().filter(own).map(|it| (read(&it.text), it.at[axis])).collect()
    }

    /// Where a value is, by the outermost ticks of an axis, in pixels.
    fn place(&self, axis: usize, value: f64) -> f64 {
        let ticks = self.ticks(axis);
        let [first, .., last] = ticks[..] else { panic!("ticks: {ticks:?}") };
        let share = ln(value / first.0) / ln(last.0 / first.0);
        first.1 + share * (last.1 - first.1)
    }

    /// The markers outside of the legend: colour, middle, outline around it, and whether they are filled.
    pub fn markers(&self) -> Vec<Marker> {
        let end = self.svg.find("<rect").unwrap_or(self.svg.len());
        Self::markers_of(&self.svg[..end])
    }

    fn markers_of(svg: &str) -> Vec<Marker> {
        let lines: Vec<&str> = svg.lines().collect();
        let of = |pair: &[&str]| {
            let outline = places(pair[0]);
            let color = attribute(pair[1], "stroke").unwrap_or_default().to_owned();
            let middle = |axis: usize| {
                let values = || outline.iter().map(|at| at[axis]);
                0.5 * (values().fold(f64::INFINITY, f64::min) + values().fold(0.0, f64::max))
            };
            let at = [middle(0), middle(1)];
            let moved = outline.iter().map(|it| [it[0] - at[0], it[1] - at[1]]).collect();
            let is_filled = attribute(pair[0], "fill") == Some(&*color);
            (color, at, moved, is_filled)
        };
        lines.windows(2).filter(|pair| pair[0].starts_with("<polygon")).map(of).collect()
    }
}

/// A number as an axis shows it.
fn read(text: &str) -> f64 {
    let Some((digit, exponent)) =
        text.split_once("10").filter(|it| it.1.chars().any(|c| "⁻⁰¹²³⁴⁵⁶⁷⁸⁹".contains(c)))
    else {
        return text.parse().unwrap_or_else(|_| panic!("`{text}` is no number"));
    };
    let digit = digit.trim_end_matches('·');
    let digit: f64 = if digit.is_empty() { 1.0 } else { digit.parse().expect("a digit") };
    let exponent: String = exponent
        .chars()
        .map(|c| match "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|it| it == c) {
            Some(k) => char::from_digit(k as u32, 10).expect("a digit"),
            None => '-',
        })
        .collect();
    format!("{digit}e{exponent}").parse().expect("a number")
}

pub fn plot(series: Vec<Series>, limit: Option<f64>) -> Plot<'static> {
    Plot { x: "across", y: "up", series, limit: limit.map(|y| Limit { y, label: "the limit" }) }
}

pub fn random(random: &mut Pcg32, decades: [f64; 2]) -> f64 {
    power(10.0, decades[0] + (decades[1] - decades[0]) * random.uniform())
}

/// Law: markers, lines, fits and the limit are where the printed numbers of logarithmic axes say; the outermost values have 6 % of
/// the range, which is at least one of e, beyond them. Oracle: the ticks, read back.
#[test]
fn points_are_where_the_ticks_say() {
    let mut numbers = Pcg32::new(1, 9);
    for decades in [[-1.0, 1.5], [0.0, 5.0], [-9.0, -2.0], [1.9, 3.4], [-3.0, 9.0]] {
        for other in [[0.0, 2.0], [-7.0, 3.0]] {
            let mut points: Vec<(f64, f64)> = (0..6)
                .map(|_| (random(&mut numbers, decades), random(&mut numbers, other)))
                .collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            // so wide that each axis has ticks
            points[0].0 = power(10.0, decades[0]);
            points[5].0 = power(10.0, decades[1]);
            points[2].1 = power(10.0, other[0]);
            points[3].1 = power(10.0, other[1]);
            let limit = random(&mut numbers, other);
            // the power law through the outermost points
            let ends = [points[0].0, points[5].0];
            let exponent = ln(points[5].1 / points[0].1) / ln(ends[1] / ends[0]);
            let factor = points[0].1 / power(ends[0], exponent);
            let fit = Fit { law: PowerLaw { factor, exponent, interval: [0.0, 1.0] }, ends };
            let fitted = Series {
                fit: Some(fit),
                points: points[..1].to_vec(),
                ..Series::joined("fit", [])
            };
            let all = vec![Series::joined("joined", points.clone()), fitted];
            let drawn = Drawn::of(&plot(all, Some(limit)));
            let at = |(x, y): (f64, f64)| [drawn.place(0, x), drawn.place(1, y)];
            let same = |found: [f64; 2], expected: [f64; 2], what: &str| {
                // two ticks are rounded, and the point
                (0..2).for_each(|axis| near(found[axis], expected[axis], 4.0 * PIXEL, what));
            };
            let markers = drawn.markers();
            assert_eq!(markers.len(), 7, "markers");
            for (marker, point) in markers.iter().zip(&points) {
                same(marker.1, at(*point), "a marker");
            }
            let lines: Vec<Vec<[f64; 2]>> = drawn
                .svg
                .lines()
                .filter(|it| it.contains("stroke-width=\"1\""))
                .map(places)
                .collect();
            let joined = lines.iter().find(|it| it.len() == 6).expect("a line of six");
            for (found, point) in joined.iter().zip(&points) {
                same(*found, at(*point), "a corner of the line");
            }
            let colored = drawn.svg.lines().filter(|it| {
                it.starts_with("<polyline") && it.contains("stroke=\"#C44E00\" stroke-width=\"1\"")
            });
            let fits: Vec<Vec<[f64; 2]>> = colored.map(places).collect();
            assert_eq!(fits.len(), 1, "fitted lines");
            assert_eq!(fits[0].len(), 2, "ends of the fitted line");
            for (found, point) in fits[0].iter().zip([points[0], points[5]]) {
                same(*found, at(point), "an end of the fit");
            }
            let dashes: Vec<[f64; 2]> = lines
                .iter()
                .filter(|it| {
                    it.len() == 2
                        && it[0][1] == it[1][1]
                        && it[0][0] >= X[0]
                        && it[1][0] - it[0][0] < 8.0
                })
                .flatten()
                .copied()
                .collect();
            assert!(dashes.len() > 50, "dashes of the limit: {}", dashes.len() / 2);
            for dash in &dashes {
                near(dash[1], drawn.place(1, limit), 4.0 * PIXEL, "the limit");
            }
            let word = drawn.words.iter().find(|it| it.text == "the limit").expect("a label");
            near(word.at[1], dashes[0][1] - 16.0, PIXEL, "the label of the limit");
            near(word.at[0], X[0] + 4.0, PIXEL, "the label of the limit");
            let xs = [points[0].0, points[5].0];
            let ys = points.iter().map(|it| it.1).chain([limit]);
            let ys = ys.fold([f64::INFINITY, 0.0_f64], |[l, h], v| [l.min(v), h.max(v)]);
            for (axis, [low, high], [begin, end]) in [(0, xs, X), (1, ys, Y)] {
                let wide = ln(high / low);
                let margin = 0.06 * wide.max(1.0);
                for (value, share) in [(low, margin), (high, margin + wide)] {
                    let expected = begin + share / (wide + 2.0 * margin) * (end - begin);
                    near(
                        drawn.place(axis, value),
                        expected,
                        4.0 * PIXEL,
                        "the margin of the outermost",
                    );
                }
            }
        }
    }
}

/// Law: ticks are powers of ten or, where fewer than four of these are in the range, also 2 and 5 times them, and rise; a number is
/// printed in full from 0.001 to 1000, as a power of ten beyond. Oracle: the numbers, read back.
#[test]
fn ticks_are_round_numbers() {
    let mut seen = [0; 3];
    for low in -12..12 {
        for decades in [0.4, 1.0, 2.9, 3.4, 3.95, 5.0, 8.0] {
            let [a, b] = [f64::from(low) + 0.3, f64::from(low) + 0.3 + decades];
            let points = [a, b].map(|it| (power(10.0, it), power(10.0, it)));
            let drawn = Drawn::of(&plot(vec![Series::joined("one", points)], None));
            let margin = 0.06 * decades.max(1.0 / ln(10.0));
            let inside =
                (-40..40).filter(|n| (a - margin..=b + margin).contains(&f64::from(*n))).count();
            for axis in [0, 1] {
                let ticks = drawn.ticks(axis);
                assert!(ticks.len() >= 2, "ticks from {a} to {b}: {ticks:?}");
                let mut has_others = false;
                for pair in ticks.windows(2) {
                    assert!(pair[0].0 < pair[1].0, "ticks rise: {ticks:?}");
                }
                for (value, at) in &ticks {
                    let digits = format!("{value:e}");
                    let digit = digits.split('e').next().unwrap_or_default();
                    assert!(["1", "2", "5"].contains(&digit), "a tick at {value}");
                    has_others |= digit != "1";
                    let place = drawn.place(axis, *value);
                    near(*at, place, 2.0 * PIXEL, "the place of a tick");
                    let log = ln(*value) / ln(10.0);
                    assert!(
                        (a - margin - 1e-9..=b + margin + 1e-9).contains(&log),
                        "{value} is on the axis"
                    );
                }
                assert_eq!(has_others, inside < 4, "2 and 5 among {ticks:?}, {inside} powers");
                seen[usize::from(has_others)] += 1;
            }
            let own = |it: &&Word| it.anchor == "end" && it.at[0] == 66.0;
            for word in drawn.words.iter().filter(own) {
                let value = read(&word.text);
                let is_plain = word.text.chars().all(|c| c.is_ascii_digit() || c == '.');
                let expected = (0.000_99..1001.0).contains(&value);
                assert_eq!(is_plain, expected, "`{}` is printed in full", word.text);
                assert!(
                    !word.text.starts_with("1·"),
                    "a power of ten has no factor: {}",
                    word.text
                );
                seen[2] += usize::from(!expected);
            }
        }
    }
    assert!(
        seen.iter().all(|n| *n > 20),
        "axes of powers, of 1, 2 and 5; powers printed: {seen:?}"
    );
}

/// Law: on an axis with fewer than two such ticks, they are multiples of 1, 2 or 5 times a power of ten, evenly apart, two to
/// eight of them, and printed as people write them. Oracle: the numbers, read back; their differences.
#[test]
fn a_narrow_axis_has_even_ticks() {
    for (low, high) in
        [(110.0, 190.0), (0.0110, 0.0119), (21.0, 22.0), (0.31, 0.32), (6.1e6, 6.3e6), (7.0, 7.0)]
    {
        let points = [(low, low), (high, high)];
        let drawn = Drawn::of(&plot(vec![Series::joined("one", points)], None));
        for axis in [0, 1] {
            let ticks: Vec<f64> = drawn.ticks(axis).iter().map(|it| it.0).collect();
            assert!((2..=8).contains(&ticks.len()), "ticks from {low} to {high}: {ticks:?}");
            let step = ticks[1] - ticks[0];
            let digits = format!("{step:.1e}");
            assert!(["1.0", "2.0", "5.0"].contains(&&digits[..3]), "steps of {step}");
            for pair in ticks.windows(2) {
                near(pair[1] - pair[0], step, 1e-9 * ticks[0], "the step of ticks");
            }
        }
        for word in drawn.words.iter().filter(|it| it.anchor == "end" && it.at[0] == 66.0) {
            assert!(word.text.chars().count() <= 7, "`{}` is short", word.text);
        }
    }
}

/// Law: only points with positive, finite coordinates are drawn; a plot without any has axes from 1 to 10; five series have five
/// pairs of shape and fill, and their names stand in the legend. Oracle: counts.
#[test]
fn what_has_a_logarithm_is_drawn() {
    let odd = [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    let mut points = vec![(2.0, 3.0), (20.0, 30.0)];
    points.extend(odd.map(|x| (x, 3.0)));
    points.extend(odd.map(|y| (2.0, y)));
    let drawn = Drawn::of(&plot(vec![Series::joined("one", points)], None));
    assert_eq!(drawn.markers().len(), 2, "markers");
    let empty = Drawn::of(&plot(vec![Series::joined("none", [])], None));
    assert!(empty.markers().is_empty(), "markers of nothing");
    for axis in [0, 1] {
        let ticks: Vec<f64> = empty.ticks(axis).iter().map(|it| it.0).collect();
        assert_eq!(ticks.first(), Some(&1.0), "ticks of nothing: {ticks:?}");
        assert!(ticks.iter().all(|it| (1.0..=10.0).contains(it)), "ticks of nothing: {ticks:?}");
    }
    let names = ["a", "b", "c", "d", "e"];
    let five = names.map(|name| Series::joined(name, [(1.0, 1.0), (9.0, 9.0)]));
    let drawn = Drawn::of(&plot(five.to_vec(), None));
    let markers = drawn.markers();
    assert_eq!(markers.len(), 10, "markers of five series");
    // in black and white, and by colour
    for by_color in [false, true] {
        let kind = |it: &Marker| {
            if by_color { it.0.clone() } else { format!("{} {:?}", it.3, it.2) }
        };
        let kinds: std::collections::BTreeSet<String> = markers.iter().map(kind).collect();
        assert_eq!(kinds.len(), 5, "kinds of markers, by colour: {by_color}");
    }
    let fills = drawn
        .svg
        .lines()
        .filter(|it| it.starts_with("<polygon") && it.contains("fill=\"#FFFFFF\""));
    // squares, diamonds and rings, twice and in the legend
    assert_eq!(fills.count(), 9, "markers that are not filled");
    let lines: Vec<&str> = drawn.svg.lines().collect();
    let legend = lines.iter().position(|it| it.starts_with("<rect")).expect("a legend");
    let shown = Drawn::markers_of(&lines[legend..].join("\n"));
    assert_eq!(shown.len(), 5, "markers in the legend");
    let left = number(lines[legend], "x");
    for (name, marker) in names.into_iter().zip(shown) {
        let word = drawn.words.iter().find(|it| it.text == name).expect("a name");
        near(
            marker.1[0],
            0.5 * (left + word.at[0]),
            PIXEL,
            "the marker stands between border and name",
        );
        near(marker.1[1], word.at[1] + 5.0, 4.0, "the marker stands on the line of its name");
        let said = lines[legend..].iter().filter(|it| **it == name).count();
        assert_eq!(said, 1, "`{name}` in the legend");
    }
    assert!(drawn.svg.contains("<figcaption>words below</figcaption>"), "the caption");
    for word in ["across", "up"] {
        assert_eq!(lines.iter().filter(|it| **it == word).count(), 1, "`{word}` at its axis");
    }
}
