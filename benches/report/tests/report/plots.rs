//! Plots: what is printed at the axes says where the points are; how the rest looks is kept as text (`snapshots`).

use groundtruth::math::{Pcg32, ln, power};
use report::plot::*;
use statistics::slope::PowerLaw;

/// Places are whole pixels.
const PIXEL: f64 = 1.01;
/// Where the axes are: their ends in pixels.
const X: [f64; 2] = [76.0, 615.0];
const Y: [f64; 2] = [387.0, 8.0];

fn attribute<'a>(line: &'a str, name: &str) -> &'a str {
    let rest = line.split_once(&format!(" {name}=\""));
    rest.and_then(|(_, rest)| rest.split('"').next()).unwrap_or_default()
}

fn number(line: &str, name: &str) -> f64 {
    attribute(line, name).parse().unwrap_or_else(|_| panic!("{name} of {line}"))
}

fn places(line: &str) -> Vec<[f64; 2]> {
    let pairs = attribute(line, "points").split_whitespace().filter_map(|it| it.split_once(','));
    pairs.map(|(x, y)| [x, y].map(|it| it.parse().expect("a place"))).collect()
}

fn middle(outline: &[[f64; 2]]) -> [f64; 2] {
    let ends = |axis: usize| {
        let values = || outline.iter().map(|at| at[axis]);
        0.5 * (values().fold(f64::INFINITY, f64::min) + values().fold(0.0, f64::max))
    };
    [ends(0), ends(1)]
}

/// A plot as SVG, a line for each element and text.
struct Drawn(String);

impl Drawn {
    fn of(series: Vec<Series>, limit: Option<f64>) -> Self {
        let limit = limit.map(|y| Limit { y, label: "the limit" });
        Self(Plot { x: "across", y: "up", series, limit }.figure("words below").html())
    }

    /// The elements with this name, each with the text after it.
    fn elements(&self, name: &str) -> Vec<(&str, &str)> {
        let lines: Vec<&str> = self.0.lines().collect();
        let pairs = lines.windows(2).map(|pair| (pair[0], pair[1]));
        pairs.filter(|(line, _)| line.starts_with(&format!("<{name}"))).collect()
    }

    /// The places of these texts.
    fn words(&self, is_meant: impl Fn(&str) -> bool) -> Vec<[f64; 2]> {
        let texts = self.elements("text").into_iter().filter(|(_, text)| is_meant(text));
        texts.map(|(line, _)| [number(line, "x"), number(line, "y")]).collect()
    }

    /// The texts at an axis, and where they are.
    fn ticks(&self, axis: usize) -> Vec<(&str, f64)> {
        let is_own = |line: &str| match axis {
            0 => attribute(line, "text-anchor") == "middle" && number(line, "y") == 398.0,
            _ => attribute(line, "text-anchor") == "end" && number(line, "x") == 66.0,
        };
        let texts = self.elements("text").into_iter().filter(|(line, _)| is_own(line));
        texts.map(|(line, text)| (text, number(line, ["x", "y"][axis]))).collect()
    }

    /// Where a value is, by the outermost ticks of an axis, in pixels.
    fn place(&self, axis: usize, value: f64) -> f64 {
        let ticks: Vec<(f64, f64)> =
            self.ticks(axis).into_iter().map(|(text, at)| (read(text), at)).collect();
        let [first, .., last] = ticks[..] else { panic!("ticks: {ticks:?}") };
        first.1 + ln(value / first.0) / ln(last.0 / first.0) * (last.1 - first.1)
    }

    /// The middles of the markers before the legend.
    fn markers(&self) -> Vec<[f64; 2]> {
        let plot = Self(self.0.split("<rect").next().unwrap_or_default().to_owned());
        plot.elements("polygon").iter().map(|(line, _)| middle(&places(line))).collect()
    }
}

/// A number as an axis shows it: `0.01`, `20`, `2·10⁷`.
fn read(text: &str) -> f64 {
    let digit = |c: char| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|it| it == c);
    let raised = text.chars().position(|c| c == '⁻' || digit(c).is_some());
    let Some(start) = raised else { return text.parse().expect("a number") };
    let exponent: String = text
        .chars()
        .skip(start)
        .map(|c| digit(c).map_or("-".to_owned(), |n| n.to_string()))
        .collect();
    let factor: String = text.chars().take(start).collect();
    let factor = factor.trim_end_matches("10").trim_end_matches('·');
    let factor = if factor.is_empty() { "1" } else { factor };
    format!("{factor}e{exponent}").parse().expect("a number")
}

fn near(found: f64, expected: f64, tolerance: f64, what: &str) {
    let off = (found - expected).abs();
    assert!(off <= tolerance, "{what}: found {found}, expected {expected}, {off} apart");
}

fn random(random: &mut Pcg32, decades: [f64; 2]) -> f64 {
    power(10.0, decades[0] + (decades[1] - decades[0]) * random.uniform())
}

fn points(points: Vec<(f64, f64)>, labels: &[&str]) -> Series {
    let labels = labels.iter().map(|&it| it.to_owned()).collect();
    Series { name: "s".to_owned(), points, labels, ..Series::default() }
}

/// Law: markers, lines, fits and the limit are where the printed numbers of logarithmic axes say; the outermost values have 6 % of
/// the range, which is at least one of e, beyond them. Oracle: the ticks, read back.
#[test]
fn points_are_where_the_ticks_say() {
    let mut numbers = Pcg32::new(1, 9);
    for decades in [[-1.0, 1.5], [0.0, 5.0], [-9.0, -2.0], [1.9, 3.4], [-3.0, 9.0]] {
        for other in [[0.0, 2.0], [-7.0, 3.0]] {
            let draw = |_| (random(&mut numbers, decades), random(&mut numbers, other));
            let mut all: Vec<(f64, f64)> = (0..6).map(draw).collect();
            all.sort_by(|a, b| a.0.total_cmp(&b.0));
            // so wide that each axis has ticks
            [all[0].0, all[5].0] = decades.map(|it| power(10.0, it));
            [all[2].1, all[3].1] = other.map(|it| power(10.0, it));
            let limit = random(&mut numbers, other);
            // the power law through the outermost points
            let ends = [all[0].0, all[5].0];
            let exponent = ln(all[5].1 / all[0].1) / ln(ends[1] / ends[0]);
            let factor = all[0].1 / power(ends[0], exponent);
            let fit = Some(Fit { law: PowerLaw { factor, exponent, interval: [0.0, 1.0] }, ends });
            let fitted = Series { fit, points: all[..1].to_vec(), ..Series::joined("fit", []) };
            let drawn = Drawn::of(vec![Series::joined("joined", all.clone()), fitted], Some(limit));
            let same = |found: &[[f64; 2]], expected: &[(f64, f64)], what: &str| {
                assert_eq!(found.len(), expected.len(), "{what}");
                for (found, (x, y)) in found.iter().zip(expected) {
                    // two ticks are rounded, and the point
                    near(found[0], drawn.place(0, *x), 4.0 * PIXEL, what);
                    near(found[1], drawn.place(1, *y), 4.0 * PIXEL, what);
                }
            };
            same(&drawn.markers(), &[&all[..], &all[..1]].concat(), "markers");
            let thin = drawn.elements("polyline");
            let thin = thin.iter().filter(|it| attribute(it.0, "stroke-width") == "1");
            let joined = thin.clone().find(|it| places(it.0).len() == 6).expect("a line of six");
            same(&places(joined.0), &all, "corners of the line");
            let fit = thin.clone().find(|it| attribute(it.0, "stroke") == "#C44E00");
            same(&places(fit.expect("a fit").0), &[all[0], all[5]], "ends of the fit");
            let label = drawn.words(|text| text == "the limit")[0];
            near(label[1] + 16.0, drawn.place(1, limit), 4.0 * PIXEL, "the label of the limit");
            let is_limit = |at: &[[f64; 2]]| {
                at.len() == 2 && at[0][1] == label[1] + 16.0 && at[1][1] == at[0][1]
            };
            assert!(thin.filter(|it| is_limit(&places(it.0))).count() > 20, "dashes of the limit");
            let ys = all.iter().map(|it| it.1).chain([limit]);
            let ys = ys.fold([f64::INFINITY, 0.0_f64], |[l, h], v| [l.min(v), h.max(v)]);
            for (axis, [low, high], [begin, end]) in [(0, ends, X), (1, ys, Y)] {
                let wide = ln(high / low);
                let margin = 0.06 * wide.max(1.0);
                for (value, share) in [(low, margin), (high, margin + wide)] {
                    let expected = begin + share / (wide + 2.0 * margin) * (end - begin);
                    near(drawn.place(axis, value), expected, 4.0 * PIXEL, "the margin");
                }
            }
        }
    }
}

/// Law: ticks rise and are 1, 2 or 5 times powers of ten where the axis is not narrow; of narrow and wide axes they are those
/// that were looked at. Oracle: the numbers, read back; the snapshot.
#[test]
fn ticks_are_round_numbers() {
    let narrow =
        [(110.0, 190.0), (0.0110, 0.0119), (21.0, 22.0), (0.31, 0.32), (6.1e6, 6.3e6), (7.0, 7.0)];
    let wide = (-12..12).flat_map(|low| {
        let low = f64::from(low) + 0.3;
        [0.4, 1.0, 2.9, 3.4, 3.95, 5.0, 8.0].map(|more| (power(10.0, low), power(10.0, low + more)))
    });
    let mut all = String::new();
    for (index, (low, high)) in narrow.into_iter().chain(wide).enumerate() {
        let drawn = Drawn::of(vec![Series::joined("one", [(low, low), (high, high)])], None);
        for axis in [0, 1] {
            let ticks = drawn.ticks(axis);
            let values: Vec<f64> = ticks.iter().map(|it| read(it.0)).collect();
            assert!(values.len() >= 2, "ticks from {low} to {high}: {values:?}");
            assert!(values.windows(2).all(|it| it[0] < it[1]), "they rise: {values:?}");
            let is_round =
                |value: &f64| "125".contains(format!("{value:e}").split('e').next().unwrap_or("x"));
            assert!(index < narrow.len() || values.iter().all(is_round), "{values:?}");
        }
        if index < narrow.len() || index % 5 == 0 {
            let texts = drawn.ticks(1).iter().map(|it| it.0).collect::<Vec<_>>().join(" ");
            all += &format!("{low:.4e} to {high:.4e}: {texts}\n");
        }
    }
    insta::assert_snapshot!(all);
}

/// Law: five series differ in shape, fill and colour, with their names in the legend; only points with positive, finite
/// coordinates are drawn; a plot without any has axes from 1 to 10. Oracle: the pictures that were looked at.
#[test]
fn what_has_a_logarithm_is_drawn() {
    let odd = [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    let odd = odd.iter().flat_map(|it| [(*it, 3.0), (2.0, *it)]);
    let one = Series::joined("a", odd.chain([(1.0, 1.0), (9.0, 9.0)]));
    let others = ["b", "c", "d", "e"].map(|name| Series::joined(name, [(1.0, 2.0), (9.0, 5.0)]));
    let drawn = Drawn::of([vec![one], others.to_vec()].concat(), Some(3.0));
    assert_eq!(drawn.markers().len(), 10, "markers");
    insta::assert_snapshot!("five_series", drawn.0);
    insta::assert_snapshot!("nothing", Drawn::of(vec![Series::joined("none", [])], None).0);
}

/// Law: labels stand beside their points, and do not overlap, however many there are at one place or near to each other; far
/// from each other, all stand above to the right. Oracle: distances of the printed places.
#[test]
fn labels_stand_beside_their_points() {
    const LABELS: [&str; 20] = ["label"; 20];
    let frame = points(vec![(1.0, 1.0), (100.0, 100.0)], &[]);
    let mut numbers = Pcg32::new(7, 9);
    let mut near_by = || (10.0 + 1.5 * numbers.uniform(), 10.0 + 2.0 * numbers.uniform());
    let together = [5, 20].map(|count| vec![(10.0, 10.0); count]);
    let random = (0..200).map(|_| [0; 3].map(|_| near_by()).to_vec());
    for (case, at) in together.into_iter().chain(random).enumerate() {
        let count = at.len();
        let drawn = Drawn::of(vec![points(at, &LABELS[..count]), frame.clone()], None);
        let found = drawn.words(|text| text == "label");
        assert_eq!(found.len(), count, "labels");
        for (k, a) in found.iter().enumerate() {
            let way = [0, 1].map(|axis| (a[axis] - drawn.markers()[k][axis]).abs());
            assert!(count > 5 || (way[0] <= 17.0 && way[1] <= 31.0), "{way:?} from its point");
            // points are rounded to pixels, unless they are one
            let slack = if case < 2 { 0.0 } else { 2.0 * PIXEL };
            let is_apart = |b: &[f64; 2]| {
                (a[0] - b[0]).abs() > 12.0 - slack || (a[1] - b[1]).abs() > 10.0 - slack
            };
            assert!(found[..k].iter().all(is_apart), "labels at {found:?}");
        }
    }
    let apart = (0..5).map(|k| [k, k % 3].map(|it| power(10.0, f64::from(it))));
    let apart: Vec<(f64, f64)> = apart.map(|[x, y]| (x, y)).chain([(10.0, 20.0)]).collect();
    let drawn = Drawn::of(vec![points(apart, &LABELS[..6]), frame], None);
    for (label, marker) in drawn.words(|text| text == "label").iter().zip(drawn.markers()) {
        assert_eq!([label[0] - marker[0], label[1] - marker[1]], [6.0, -12.0]);
    }
}

/// Law: the legend stands in the corner with the fewest points: in 35 % of the width, and 5 % and 6 % for each line of the height.
/// Oracle: points in all corners but one.
#[test]
fn the_legend_stands_where_the_fewest_points_are() {
    let corners = [[0.1, 2.9], [2.9, 2.9], [2.9, 0.1], [0.1, 0.1]];
    for (empty, [x, y]) in corners.into_iter().enumerate() {
        for count in 1..4 {
            let others = corners.iter().filter(|it| **it != [x, y]).chain([&[1.5, 1.5]]);
            let all: Vec<(f64, f64)> =
                others.map(|it| (power(10.0, it[0]), power(10.0, it[1]))).collect();
            let drawn = Drawn::of(vec![points(all, &[]); count], None);
            let legend = drawn.elements("rect")[0].0;
            let at = |start: &str, size: &str| number(legend, start) + 0.5 * number(legend, size);
            let found =
                [at("x", "width") > 0.5 * (X[0] + X[1]), at("y", "height") < 0.5 * (Y[0] + Y[1])];
            assert_eq!(found, [x > 1.5, y > 1.5], "right and upper, corner {empty} without points");
        }
    }
}
