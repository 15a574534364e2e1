//! Simple changes that explain a difference: orientation, a shift, channel order, exposure, transfer function.

use std::f64::consts::PI;

use serde::Serialize;

use super::{Picture, Transfer, finite};

/// A change of one picture that makes it nearly the other.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Hypothesis {
    /// What is different about a picture, in words.
    pub what: String,
    /// The mean difference that is left, as a part of what it was.
    pub left: f64,
}

/// A change explains a difference of which it leaves at most this part.
const EXPLAINED: f64 = 0.1;

/// The changes that leave little of the difference of two pictures, the best first. The first one is only
/// decoded in other ways; all others are of the second.
pub fn explaining(a: &Picture, b: &Picture) -> Vec<Hypothesis> {
    let before = distance(a, b);
    let of_b = changes(a, b).into_iter().map(|(what, changed)| (what, distance(a, &changed)));
    let of_a = decodings("A", a).into_iter().map(|(what, changed)| (what, distance(&changed, b)));
    let mut found: Vec<Hypothesis> = of_b
        .chain(of_a)
        .map(|(what, after)| Hypothesis { what, left: after / before })
        .filter(|hypothesis| hypothesis.left <= EXPLAINED)
        .collect();
    found.sort_by(|a, b| a.left.total_cmp(&b.left));
    found
}

/// The mean relative difference `|x − y|/(|x| + |y|)` of channels, over pixels in which both are finite; black
/// counts as a thousandth of the mean.
fn distance(a: &Picture, b: &Picture) -> f64 {
    let (mut total, mut count) = (0.0, 0.0_f64);
    for [x, y] in finite(a, b) {
        total += x.iter().chain(&y).map(|value| value.abs()).sum::<f64>();
        count += 6.0;
    }
    let floor = 1e-3 * total / count.max(1.0) + f64::MIN_POSITIVE;
    let of = |(x, y): (f64, f64)| (x - y).abs() / (x.abs() + y.abs() + floor);
    let sum: f64 = finite(a, b).map(|[x, y]| x.into_iter().zip(y).map(of).sum::<f64>()).sum();
    sum / (0.5 * count).max(1.0)
}

/// The changes that are tried, each with what it makes of `b`.
fn changes(a: &Picture, b: &Picture) -> Vec<(String, Picture)> {
    let [width, height] = b.size.map(i64::from);
    let mut changes = vec![
        ("the rows of B are upside down".to_owned(), moved(b, |[x, y]| [x, height - 1 - y])),
        ("left and right of B are exchanged".to_owned(), moved(b, |[x, y]| [width - 1 - x, y])),
        ("B is turned by 180°".to_owned(), moved(b, |[x, y]| [width - 1 - x, height - 1 - y])),
    ];
    if width == height {
        changes.push(("rows and columns of B are exchanged".to_owned(), moved(b, |[x, y]| [y, x])));
    }
    let steps = [-1, 0, 1].into_iter().flat_map(|x| [-1, 0, 1].map(|y| [x, y]));
    for [dx, dy] in steps.filter(|step| *step != [0, 0]) {
        let name = |along: i64, [less, more]: [&str; 2]| match along {
            0 => None,
            -1 => Some(format!("one pixel too far {less}")),
            _ => Some(format!("one pixel too far {more}")),
        };
        let parts = [name(dx, ["left", "right"]), name(dy, ["up", "down"])];
        let what = parts.into_iter().flatten().collect::<Vec<_>>().join(" and ");
        changes.push((format!("B is {what}"), moved(b, |[x, y]| [x + dx, y + dy])));
    }
    for (order, name) in [
        ([2, 1, 0], "blue, green, red"),
        ([0, 2, 1], "red, blue, green"),
        ([1, 0, 2], "green, red, blue"),
        ([1, 2, 0], "green, blue, red"),
        ([2, 0, 1], "blue, red, green"),
    ] {
        let values = b.values.iter().map(|color| order.map(|channel| color[channel])).collect();
        let what = format!("the channels of B are in the order {name}");
        changes.push((what, Picture { values, ..b.clone() }));
    }
    changes.extend(decodings("B", b));
    changes.extend(exposure(a, b));
    changes
}

/// The picture, if its values are for display, with each other transfer function.
fn decodings(name: &str, picture: &Picture) -> Vec<(String, Picture)> {
    let transfers = [Transfer::Linear, Transfer::Srgb, Transfer::Gamma(1.8), Transfer::Gamma(2.2)];
    let others =
        transfers.into_iter().filter(|it| picture.step.is_some() && *it != picture.transfer);
    let decoded = |transfer| {
        let what = format!("{name} is encoded as {transfer}, not as {}", picture.transfer);
        (what, Picture { transfer, ..picture.clone() })
    };
    others.map(decoded).collect()
}

/// `b` with the pixel at each position taken from another; black where that is outside.
fn moved(b: &Picture, from: impl Fn([i64; 2]) -> [i64; 2]) -> Picture {
    let [width, height] = b.size.map(i64::from);
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
    let value = |pixel| {
        let [x, y] = from(pixel);
        let is_inside = (0..width).contains(&x) && (0..height).contains(&y);
        if is_inside { b.values[b.index([x as u32, y as u32])] } else { [f32::NAN; 3] }
    };
    Picture { values: pixels.map(value).collect(), ..b.clone() }
}

/// `b` times the factor that brings it nearest to `a`: the median of their ratios.
fn exposure(a: &Picture, b: &Picture) -> Option<(String, Picture)> {
    let ratio = |[x, y]: [[f64; 3]; 2]| x.iter().sum::<f64>() / y.iter().sum::<f64>();
    let mut ratios: Vec<f64> =
        finite(a, b).map(ratio).filter(|ratio| ratio.is_finite() && *ratio > 0.0).collect();
    ratios.sort_by(f64::total_cmp);
    let factor = *ratios.get(ratios.len() / 2)?;
    if (factor - 1.0).abs() < 1e-3 {
        return None;
    }
    let known = [(PI, "π"), (1.0 / PI, "1/π"), (0.5, "1/2"), (2.0, "2"), (4.0 * PI, "4π")];
    let name = known.iter().find(|(value, _)| (value / factor - 1.0).abs() < 0.01);
    let name = name.map_or_else(|| format!("{factor:.4}"), |(_, name)| (*name).to_owned());
    let scaled = |color: &[f32; 3]| b.linear(*color).map(|value| (factor * value) as f32);
    let values = b.values.iter().map(scaled).collect();
    let what = format!("B is A divided by {name}");
    Some((what, Picture { values, step: None, transfer: Transfer::Linear, ..b.clone() }))
}
