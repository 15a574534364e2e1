//! The simple changes of a picture: orientation, a shift, channel order, exposure, transfer function.

use super::{Decoded, Picture, Transfer};

/// A change of a whole picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    /// None.
    Same,
    /// Its rows are in the opposite order.
    UpsideDown,
    /// Its columns are in the opposite order.
    Mirrored,
    /// Both are.
    Turned,
    /// Rows and columns are exchanged; the picture is square.
    Transposed,
    /// Each pixel is taken from so many columns to the right and rows below.
    Shifted([i64; 2]),
    /// Red, green and blue are these channels.
    Channels([usize; 3]),
    /// Its stored values have another transfer function.
    Decoded(Transfer),
    /// Its radiance is multiplied by this.
    Scaled(f64),
}

impl Change {
    /// The orientations, shifts by a pixel and channel orders that a picture of this size may have.
    pub fn of_pixels([width, height]: [u32; 2]) -> Vec<Self> {
        let mut changes = vec![Self::UpsideDown, Self::Mirrored, Self::Turned];
        if width == height {
            changes.push(Self::Transposed);
        }
        let steps = [-1, 0, 1].into_iter().flat_map(|x| [-1, 0, 1].map(|y| [x, y]));
        changes.extend(steps.filter(|step| *step != [0, 0]).map(Self::Shifted));
        let orders = [[2, 1, 0], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1]];
        changes.extend(orders.map(Self::Channels));
        changes
    }

    /// The radiance of the changed picture at a pixel; `None` where the change takes it from outside.
    pub fn at(self, of: &Decoded<'_>, pixel: [i64; 2]) -> Option<[f64; 3]> {
        let [x, y] = self.source(pixel, of.picture.size)?;
        let index = of.picture.index([x, y]);
        Some(match self {
            Self::Channels(order) => order.map(|channel| of.at(index)[channel]),
            Self::Scaled(factor) => {
                // integers hold no more than 1
                let most = if of.picture.step.is_some() { 1.0 } else { f64::INFINITY };
                of.at(index).map(|value| (factor * value).min(most))
            }
            Self::Decoded(transfer) => {
                of.picture.values[index].map(|value| transfer.decoded(f64::from(value)))
            }
            _ => of.at(index),
        })
    }

    /// Whether it is a factor that has a name.
    pub fn is_known_factor(self) -> bool {
        matches!(self, Self::Scaled(factor) if known(factor).is_some())
    }

    /// The factor with a name that it is if integers were rounded otherwise, by which a median of ratios is off by a few
    /// hundredths.
    pub fn near_known_factor(self) -> Option<Self> {
        let Self::Scaled(factor) = self else { return None };
        nearest(factor, 0.04).map(|(value, _)| Self::Scaled(*value))
    }

    /// The part of a picture of this size that the change takes from inside.
    pub fn overlap(self, size: [u32; 2]) -> f64 {
        let Self::Shifted(step) = self else { return 1.0 };
        let along = |i: usize| 1.0 - step[i].unsigned_abs() as f64 / f64::from(size[i]);
        along(0) * along(1)
    }

    /// The pixel from which the change takes this one.
    fn source(self, [x, y]: [i64; 2], size: [u32; 2]) -> Option<[u32; 2]> {
        let [width, height] = size.map(i64::from);
        let [x, y] = match self {
            Self::UpsideDown => [x, height - 1 - y],
            Self::Mirrored => [width - 1 - x, y],
            Self::Turned => [width - 1 - x, height - 1 - y],
            Self::Transposed => [y, x],
            Self::Shifted([dx, dy]) => [x + dx, y + dy],
            _ => [x, y],
        };
        let is_inside = (0..width).contains(&x) && (0..height).contains(&y);
        is_inside.then_some([x as u32, y as u32])
    }

    /// The changed picture, with its values stored as before; NaN where the change takes them from outside.
    pub fn applied(self, picture: &Picture) -> Picture {
        let [width, height] = picture.size.map(i64::from);
        let value = |pixel: [i64; 2]| {
            let Some(source) = self.source(pixel, picture.size) else { return [f32::NAN; 3] };
            let stored = picture.values[picture.index(source)];
            match self {
                Self::Channels(order) => order.map(|channel| stored[channel]),
                Self::Scaled(factor) => stored.map(|value| self.scaled(picture, factor, value)),
                Self::Decoded(transfer) if picture.step.is_none() => {
                    stored.map(|value| transfer.decoded(f64::from(value)) as f32)
                }
                _ => stored,
            }
        };
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
        let transfer = match self {
            Self::Decoded(transfer) if picture.step.is_some() => transfer,
            _ => picture.transfer,
        };
        Picture { values: pixels.map(value).collect(), transfer, ..picture.clone() }
    }

    /// A stored value whose radiance is multiplied by a factor.
    fn scaled(self, picture: &Picture, factor: f64, value: f32) -> f32 {
        let transfer = picture.transfer;
        transfer.encoded(factor * transfer.decoded(f64::from(value))) as f32
    }

    /// What is different about picture B because of it.
    pub fn words(self, [a, b]: [&str; 2], before: Transfer) -> String {
        match self {
            Self::Same => format!("{b} is unchanged"),
            Self::UpsideDown => format!("the rows of {b} are upside down"),
            Self::Mirrored => format!(
                "left and right of {b} are exchanged (if its axes are left-handed: negate z in the scene)"
            ),
            Self::Turned => format!("{b} is turned by 180°"),
            Self::Transposed => format!("rows and columns of {b} are exchanged"),
            Self::Shifted([dx, dy]) => {
                let name = |along: i64, [less, more]: [&str; 2]| match along {
                    0 => None,
                    -1 => Some(format!("one pixel too far {less}")),
                    _ => Some(format!("one pixel too far {more}")),
                };
                let parts = [name(dx, ["left", "right"]), name(dy, ["up", "down"])];
                let parts = parts.into_iter().flatten().collect::<Vec<_>>().join(" and ");
                format!("{b} is {parts}")
            }
            Self::Channels(order) => {
                let mut names = [""; 3];
                order.iter().zip(["red", "green", "blue"]).for_each(|(at, name)| names[*at] = name);
                format!("the channels of {b} are in the order {}", names.join(", "))
            }
            Self::Decoded(transfer) => format!("{b} is encoded as {transfer}, not as {before}"),
            Self::Scaled(factor) => format!("{b} is {a} divided by {}", named(factor)),
        }
    }
}

/// Factors that have a name.
const KNOWN: [(f64, &str); 5] = {
    use std::f64::consts::PI;
    [(PI, "π"), (1.0 / PI, "1/π"), (0.5, "1/2"), (2.0, "2"), (4.0 * PI, "4π")]
};

/// The one that is within a hundredth of this.
fn known(factor: f64) -> Option<&'static (f64, &'static str)> {
    nearest(factor, 0.01)
}

/// The one that is within this part of a factor.
fn nearest(factor: f64, part: f64) -> Option<&'static (f64, &'static str)> {
    KNOWN.iter().find(|(value, _)| (value / factor - 1.0).abs() < part)
}

/// The factor, or the known one that it nearly is: integers tell it no better.
pub(super) fn known_factor(factor: f64) -> f64 {
    known(factor).map_or(factor, |(value, _)| *value)
}

/// A factor, by its name if it has one.
fn named(factor: f64) -> String {
    let number = || match factor.abs() {
        usual if (1e-3..1e4).contains(&usual) => format!("{factor:.4}"),
        _ => format!("{factor:.2e}"),
    };
    known(factor).map_or_else(number, |(_, name)| (*name).to_owned())
}
