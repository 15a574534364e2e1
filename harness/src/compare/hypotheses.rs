//! Simple changes that explain a difference: orientation, a shift, channel order, exposure, transfer function.

use std::f64::consts::PI;

use serde::Serialize;

use super::{Decoded, Transfer};

/// A change of one picture that makes it nearly the other.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Hypothesis {
    /// What is different about a picture, in words.
    pub what: String,
    /// The mean difference that is left, as a part of what it was.
    pub left: f64,
}

/// A change explains a difference of which it leaves at most this part.
pub(super) const EXPLAINED: f64 = 0.1;

/// At most about so many pixels are tried: a change is one of all pixels.
const PIXELS: usize = 1 << 16;

/// The radiance of a picture, or of what a change makes of it, at a pixel; `None` if the change takes it from
/// outside.
type Radiance<'a> = Box<dyn Fn([i64; 2]) -> Option<[f64; 3]> + 'a>;

/// A change in words, and the changed picture.
type Change<'a> = (String, Radiance<'a>);

/// The changes that leave little of the difference of two pictures, the best first. The first one is only
/// decoded in other ways; all others are of the second.
pub fn explaining(a: &Decoded<'_>, b: &Decoded<'_>) -> Vec<Hypothesis> {
    let pixels = evenly_spread(a.picture.size, PIXELS);
    let (as_a, as_b) = (moved(a, |pixel| pixel), moved(b, |pixel| pixel));
    let before = distance(&pixels, &as_a, &as_b);
    let of_b = changes(b).into_iter().chain(exposure(&pixels, &as_a, b));
    let of_b = of_b.map(|(what, changed)| (what, distance(&pixels, &as_a, &changed)));
    let of_a = decodings("A", a).into_iter();
    let of_a = of_a.map(|(what, changed)| (what, distance(&pixels, &changed, &as_b)));
    let mut found: Vec<Hypothesis> = of_b
        .chain(of_a)
        .map(|(what, after)| Hypothesis { what, left: after / before })
        .filter(|hypothesis| hypothesis.left <= EXPLAINED)
        .collect();
    found.sort_by(|a, b| a.left.total_cmp(&b.left));
    found
}

/// All pixels, or about `most` evenly spread ones.
pub(super) fn evenly_spread([width, height]: [u32; 2], most: usize) -> Vec<[i64; 2]> {
    let count = width as usize * height as usize;
    // an odd step, so that not only few columns are tried
    let step = (count / most) | 1;
    let pixel = |at: usize| [(at % width as usize) as i64, (at / width as usize) as i64];
    (0..count).step_by(step).map(pixel).collect()
}

/// Both radiances of each pixel at which both are finite.
fn finite<'a>(
    pixels: &'a [[i64; 2]],
    a: &'a Radiance<'_>,
    b: &'a Radiance<'_>,
) -> impl Iterator<Item = [[f64; 3]; 2]> + 'a {
    let both = pixels.iter().filter_map(|&pixel| Some([a(pixel)?, b(pixel)?]));
    both.filter(|colors| colors.as_flattened().iter().all(|value| value.is_finite()))
}

/// The mean relative difference `|x − y|/(|x| + |y|)` of channels, over pixels in which both are finite; black
/// counts as a thousandth of the mean.
fn distance(pixels: &[[i64; 2]], a: &Radiance<'_>, b: &Radiance<'_>) -> f64 {
    let colors: Vec<_> = finite(pixels, a, b).collect();
    let total: f64 = colors.as_flattened().as_flattened().iter().map(|value| value.abs()).sum();
    let count = (6 * colors.len()).max(1) as f64;
    let floor = 1e-3 * total / count + f64::MIN_POSITIVE;
    let of = |(x, y): (f64, f64)| (x - y).abs() / (x.abs() + y.abs() + floor);
    let sum: f64 = colors.into_iter().map(|[x, y]| x.into_iter().zip(y).map(of).sum::<f64>()).sum();
    sum / (0.5 * count)
}

/// The changes that are tried, each with what it makes of `b`.
fn changes<'a>(b: &'a Decoded<'_>) -> Vec<Change<'a>> {
    let [width, height] = b.picture.size.map(i64::from);
    let mut changes = vec![
        ("the rows of B are upside down".to_owned(), moved(b, move |[x, y]| [x, height - 1 - y])),
        (
            "left and right of B are exchanged".to_owned(),
            moved(b, move |[x, y]| [width - 1 - x, y]),
        ),
        ("B is turned by 180°".to_owned(), moved(b, move |[x, y]| [width - 1 - x, height - 1 - y])),
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
        changes.push((format!("B is {what}"), moved(b, move |[x, y]| [x + dx, y + dy])));
    }
    for (order, name) in [
        ([2, 1, 0], "blue, green, red"),
        ([0, 2, 1], "red, blue, green"),
        ([1, 0, 2], "green, red, blue"),
        ([1, 2, 0], "green, blue, red"),
        ([2, 0, 1], "blue, red, green"),
    ] {
        let as_b = moved(b, |pixel| pixel);
        let reordered = move |pixel| as_b(pixel).map(|color| order.map(|channel| color[channel]));
        changes.push((format!("the channels of B are in the order {name}"), Box::new(reordered)));
    }
    changes.extend(decodings("B", b));
    changes
}

/// The picture, if its values are for display, with each other transfer function.
fn decodings<'a>(name: &str, of: &'a Decoded<'_>) -> Vec<Change<'a>> {
    let picture = of.picture;
    let transfers = [Transfer::Linear, Transfer::Srgb, Transfer::Gamma(1.8), Transfer::Gamma(2.2)];
    let is_other = |it: &Transfer| picture.step.is_some() && *it != picture.transfer;
    let decoded = |transfer: Transfer| -> Change<'a> {
        let what = format!("{name} is encoded as {transfer}, not as {}", picture.transfer);
        let linear = move |value: f32| transfer.decoded(f64::from(value));
        let at = move |[x, y]: [i64; 2]| {
            Some(picture.values[picture.index([x as u32, y as u32])].map(linear))
        };
        (what, Box::new(at))
    };
    transfers.into_iter().filter(is_other).map(decoded).collect()
}

/// The picture with the pixel at each position taken from another.
fn moved<'a>(of: &'a Decoded<'_>, from: impl Fn([i64; 2]) -> [i64; 2] + 'a) -> Radiance<'a> {
    let [width, height] = of.picture.size.map(i64::from);
    Box::new(move |pixel| {
        let [x, y] = from(pixel);
        let is_inside = (0..width).contains(&x) && (0..height).contains(&y);
        let at = || of.at(of.picture.index([x as u32, y as u32]));
        is_inside.then(at)
    })
}

/// `b` times the factor that brings it nearest to `a`: the median of their ratios.
fn exposure<'a>(pixels: &[[i64; 2]], a: &Radiance<'_>, b: &'a Decoded<'_>) -> Option<Change<'a>> {
    let as_b = moved(b, |pixel| pixel);
    let ratio = |[x, y]: [[f64; 3]; 2]| x.iter().sum::<f64>() / y.iter().sum::<f64>();
    let mut ratios: Vec<f64> = finite(pixels, a, &as_b)
        .map(ratio)
        .filter(|ratio| ratio.is_finite() && *ratio > 0.0)
        .collect();
    ratios.sort_by(f64::total_cmp);
    let factor = *ratios.get(ratios.len() / 2)?;
    if (factor - 1.0).abs() < 1e-3 {
        return None;
    }
    let known = [(PI, "π"), (1.0 / PI, "1/π"), (0.5, "1/2"), (2.0, "2"), (4.0 * PI, "4π")];
    let name = known.iter().find(|(value, _)| (value / factor - 1.0).abs() < 0.01);
    let name = name.map_or_else(|| format!("{factor:.4}"), |(_, name)| (*name).to_owned());
    let scaled = move |pixel| as_b(pixel).map(|color| color.map(|value| factor * value));
    Some((format!("B is A divided by {name}"), Box::new(scaled)))
}
