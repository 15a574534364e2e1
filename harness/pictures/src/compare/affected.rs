//! The object in which a picture differs most, and how: what the first line of a verdict says.

use std::sync::Arc;

use groundtruth::printable;
use serde::Serialize;

use text::percent;

/// How the differing pixels of an object differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Direction {
    /// Most of the difference is a lack of light.
    TooDark,
    /// Most of it is too much light.
    TooBright,
    /// Some pixels are too dark, others as much too bright: a pattern or an edge is elsewhere.
    Both,
    /// Channels differ against each other.
    OtherColour,
    /// Some value is NaN or infinite.
    NoNumber,
}

/// The object that differs most.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Affected {
    /// Its name.
    pub object: String,
    /// How it differs.
    pub direction: Direction,
    /// The number of its pixels that differ.
    pub differing: usize,
    /// The number of its pixels.
    pub pixels: usize,
}

/// The differing pixels of an object, added up.
#[derive(Clone, Copy, Default)]
struct Sum {
    weight: f64,
    differing: usize,
    /// Of the means of channels.
    signed: f64,
    /// Of their magnitudes.
    magnitude: f64,
    /// Of the means of the channels' magnitudes.
    channels: f64,
    no_numbers: usize,
}

/// A sum has a direction if it is at least this part of that of the magnitudes.
const CLEAR: f64 = 0.5;

impl Affected {
    /// Of objects (name, number of pixels) and the object of each pixel, the one with the largest sum of weights. `at`
    /// gives the weight of a pixel that differs, and by how much each channel does. `None` if none differs.
    pub fn of(
        objects: &[(Arc<str>, u32)],
        object_of: &[u32],
        at: impl Fn(usize) -> Option<(f64, [f64; 3])>,
    ) -> Option<Self> {
        let mut sums = vec![Sum::default(); objects.len()];
        for (pixel, object) in object_of.iter().enumerate() {
            if let Some((weight, difference)) = at(pixel) {
                sums[*object as usize].add(weight, difference);
            }
        }
        let all = sums.into_iter().zip(objects).filter(|(sum, _)| sum.differing > 0);
        let (sum, (name, pixels)) = all.max_by(|a, b| a.0.weight.total_cmp(&b.0.weight))?;
        Some(Self {
            object: name.to_string(),
            direction: sum.direction(),
            differing: sum.differing,
            pixels: *pixels as usize,
        })
    }

    /// The part of its pixels that differ.
    pub fn share(&self) -> f64 {
        self.differing as f64 / self.pixels as f64
    }

    /// `the glass sphere is too dark, 55.0 % of its pixels`.
    pub fn words(&self) -> String {
        let (object, how) = (article(&self.object), self.direction.words());
        format!("{object} {how}, {} of its pixels", percent::of_pixels(self.share()))
    }
}

/// The name of an object or area in a sentence: `the glass sphere`, `box 1`.
pub fn article(name: &str) -> String {
    let is_label =
        name.starts_with("the ") || name.contains(|c: char| !c.is_lowercase() && c != ' ');
    let name = printable::name(name);
    if is_label { name.to_string() } else { format!("the {name}") }
}

impl Sum {
    fn add(&mut self, weight: f64, difference: [f64; 3]) {
        self.differing += 1;
        if difference.iter().any(|channel| !channel.is_finite()) {
            self.no_numbers += 1;
            self.weight = f64::INFINITY;
            return;
        }
        let mean = difference.iter().sum::<f64>() / 3.0;
        self.weight += weight;
        self.signed += mean;
        self.magnitude += mean.abs();
        self.channels += difference.iter().map(|channel| channel.abs()).sum::<f64>() / 3.0;
    }

    fn direction(&self) -> Direction {
        match self.signed {
            _ if self.no_numbers > 0 => Direction::NoNumber,
            _ if self.magnitude < CLEAR * self.channels => Direction::OtherColour,
            less if less <= -CLEAR * self.magnitude => Direction::TooDark,
            more if more >= CLEAR * self.magnitude => Direction::TooBright,
            _ => Direction::Both,
        }
    }
}

impl Direction {
    /// After the name of the object.
    pub fn words(self) -> &'static str {
        match self {
            Self::TooDark => "is too dark",
            Self::TooBright => "is too bright",
            Self::Both => "is too dark in some places and too bright in others",
            Self::OtherColour => "has another colour",
            Self::NoNumber => "has values that are no numbers (NaN or infinite)",
        }
    }

    /// The same of one of two pictures, neither of which is right: `is darker than a.png`.
    pub fn words_beside(self, other: &str) -> String {
        match self {
            Self::TooDark => format!("is darker than {other}"),
            Self::TooBright => format!("is brighter than {other}"),
            Self::Both => format!("is darker than {other} in some places and brighter in others"),
            Self::OtherColour => format!("has other colours than {other}"),
            Self::NoNumber => self.words().to_owned(),
        }
    }
}
