//! Plots: what is printed at the axes says where the points are; how the rest looks is kept as text (`snapshots`).

use groundtruth::math::power;
use report::plot::*;
use statistics::slope::PowerLaw;

fn attribute<'a>(line: &'a str, name: &str) -> &'a str {
    let rest = line.split_once(&format!(" {name}=\""));
    rest.and_then(|(_, rest)| rest.split('"').next()).unwrap_or_default()
}

fn number(line: &str, name: &str) -> f64 {
    attribute(line, name).parse().unwrap_or_else(|_| panic!("{name} of {line}"))
}

/// A plot as SVG, a line for each element and text.
struct Drawn(String);

impl Drawn {
    fn of(series: Vec<Series>, limit: Option<f64>) -> Self {
        let limit = limit.map(|y| (y, "the limit"));
        Self(Plot { x: "across", y: "up", series, limit }.figure("words below").html())
    }

    /// The elements with this name, each with the text after it.
    fn elements(&self, name: &str) -> Vec<(&str, &str)> {
        let lines: Vec<&str> = self.0.lines().collect();
        let pairs = lines.windows(2).map(|pair| (pair[0], pair[1]));
        pairs.filter(|(line, _)| line.starts_with(&format!("<{name}"))).collect()
    }

    /// The texts at an axis.
    fn ticks(&self, axis: usize) -> Vec<&str> {
        let is_own = |line: &str| match axis {
            0 => attribute(line, "text-anchor") == "middle" && number(line, "y") == 398.0,
            _ => attribute(line, "text-anchor") == "end" && number(line, "x") == 66.0,
        };
        let texts = self.elements("text").into_iter().filter(|(line, _)| is_own(line));
        texts.map(|(_, text)| text).collect()
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

fn points(points: Vec<(f64, f64)>, labels: &[&str]) -> Series {
    let labels = labels.iter().map(|&it| it.to_owned()).collect();
    Series { name: "s".to_owned(), points, labels, ..Series::default() }
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
            let values: Vec<f64> = ticks.iter().map(|it| read(it)).collect();
            assert!(values.len() >= 2, "ticks from {low} to {high}: {values:?}");
            assert!(values.windows(2).all(|it| it[0] < it[1]), "they rise: {values:?}");
            let is_round =
                |value: &f64| "125".contains(format!("{value:e}").split('e').next().unwrap_or("x"));
            assert!(index < narrow.len() || values.iter().all(is_round), "{values:?}");
        }
        if index < narrow.len() || index % 5 == 0 {
            all += &format!("{low:.4e} to {high:.4e}: {}\n", drawn.ticks(1).join(" "));
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
    insta::assert_snapshot!("five_series", drawn.0);
    insta::assert_snapshot!("nothing", Drawn::of(vec![Series::joined("none", [])], None).0);
}

/// Golden: labels of points at one place, beside each other and far apart, a fit, and the legend in each corner in which no
/// points are.
#[test]
fn labels_fits_and_legends_read_as_before() {
    let at = |all: &[[f64; 2]]| all.iter().map(|it| it.map(|x| power(10.0, x)).into()).collect();
    let crowd =
        [[1.0, 1.0], [1.0, 1.0], [1.0, 1.0], [1.0, 1.0], [1.0, 1.0], [1.05, 1.0], [1.0, 1.04]];
    let mut labelled = points(at(&crowd), &["label"; 7]);
    let apart = points(at(&[[0.0, 0.0], [0.5, 2.0], [2.0, 1.5]]), &["a", "b", "c"]);
    let law = PowerLaw { factor: 2.0, exponent: 0.5, interval: [0.4, 0.6] };
    labelled.fit = Some((law, [1.0, 100.0]));
    let mut all = Drawn::of(vec![labelled, apart], Some(30.0)).0;
    let corners = [[0.1, 2.9], [2.9, 2.9], [2.9, 0.1], [0.1, 0.1]];
    for empty in corners {
        let others: Vec<_> = corners.into_iter().filter(|it| *it != empty).collect();
        let drawn = Drawn::of(vec![points(at(&others), &[])], None);
        all += &format!("no points at {empty:?}: {}\n", drawn.elements("rect")[0].0);
    }
    insta::assert_snapshot!(all);
}
