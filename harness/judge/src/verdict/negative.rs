//! Negative values, which no correct picture has: radiance is none.

use std::fmt;

use serde::Serialize;
use text::brief::{brief, count};

use pictures::compare::Picture;

/// Values down to this part of the mean of ours below 0 are rounding.
const ROUNDING: f64 = 1e-5;

/// The negative values of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Negative {
    /// How many there are.
    pub values: u64,
    /// The lowest.
    pub lowest: f32,
    /// The pixel that has it: x right and y down, from 0.
    pub at: [usize; 2],
    /// Whether the lowest says something: it is more than rounding, and ours have none, as filters with negative lobes make.
    pub counts: bool,
}

impl Negative {
    /// Those of some pictures; `None` without any. Of ours, the lowest value and the mean.
    pub fn of(theirs: &[Picture], (lowest_of_ours, mean): (f32, f64)) -> Option<Self> {
        let mut found: Option<Self> = None;
        for picture in theirs {
            let width = picture.size[0] as usize;
            for (index, value) in picture.values.as_flattened().iter().enumerate() {
                if *value >= 0.0 || value.is_nan() {
                    continue;
                }
                let at = [index / 3 % width, index / 3 / width];
                let first = Self { values: 0, lowest: *value, at, counts: false };
                let found = found.get_or_insert(first);
                found.values += 1;
                if *value < found.lowest {
                    (found.lowest, found.at) = (*value, at);
                }
            }
        }
        let counts = |lowest: f32| f64::from(-lowest) > ROUNDING * mean;
        found.map(|it| Self { counts: counts(it.lowest) && !counts(lowest_of_ours), ..it })
    }
}

impl fmt::Display for Negative {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { values, lowest, at: [x, y], counts } = self;
        let (values, lowest) = (count(*values as usize, "value"), brief(f64::from(*lowest)));
        let rounding = if *counts { "" } else { "; they are rounding, or ours have such, too" };
        write!(f, "negative: {values}, the lowest {lowest} at {x},{y}{rounding}")
    }
}
