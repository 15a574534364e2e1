//! How the space of a log lies in that of its objects: other axes, another unit of length.

use std::collections::BTreeSet;
use std::fmt;

use groundtruth::math::{Point, Vector};
use serde_json::{Map, Value};

use crate::log::Log;

/// The line for the head that undoes it has the axes that stand for x, y and z, and a factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placing {
    /// For each axis that of the log, and its sign.
    axes: [(usize, f64); 3],
    /// What lengths are multiplied by.
    pub scale: f64,
}

/// What the axes of a head should be.
const AXES: &str =
    "`axes` are x, y and z in any order, each perhaps with a sign, as [\"x\", \"z\", \"-y\"]";
const NAMES: [&str; 3] = ["x", "y", "z"];
/// The units of length that programs and scenes have.
const SCALES: [f64; 6] = [0.001, 0.01, 0.1, 10.0, 100.0, 1000.0];

impl Default for Placing {
    fn default() -> Self {
        Self { axes: [(0, 1.0), (1, 1.0), (2, 1.0)], scale: 1.0 }
    }
}

impl Placing {
    /// Those that are usual mistakes: one axis mirrored, y and z exchanged, another unit.
    pub fn others() -> impl Iterator<Item = Self> {
        let mirrored = (0..3).map(|axis| {
            let mut it = Self::default();
            it.axes[axis].1 = -1.0;
            it
        });
        let signs = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0]];
        let exchanged = signs.map(|[y, z]| Self { axes: [(0, 1.0), (2, y), (1, z)], scale: 1.0 });
        let scaled = SCALES.map(|scale| Self { scale, ..Self::default() });
        mirrored.chain(exchanged).chain(scaled)
    }

    /// What the fields of a head say of it: `"axes": ["x", "z", "-y"]`, `"scale": 0.01`.
    ///
    /// # Errors
    /// What they should be.
    pub fn of(fields: &Map<String, Value>) -> Result<Self, &'static str> {
        let axis = |word: &Value| {
            let word = word.as_str()?;
            let (sign, name) = word.strip_prefix('-').map_or((1.0, word), |name| (-1.0, name));
            Some((NAMES.iter().position(|it| *it == name)?, sign))
        };
        let axes = |it: &Value| -> Option<[(usize, f64); 3]> {
            let axes: Vec<_> = it.as_array()?.iter().map(axis).collect::<Option<_>>()?;
            let each: BTreeSet<usize> = axes.iter().map(|it| it.0).collect();
            axes.try_into().ok().filter(|_| each.len() == 3)
        };
        let length = |it: &Value| it.as_f64().filter(|it| *it > 0.0 && it.is_normal());
        let mut it = Self::default();
        if let Some(value) = fields.get("axes") {
            it.axes = axes(value).ok_or(AXES)?;
        }
        if let Some(value) = fields.get("scale") {
            it.scale = length(value).ok_or("`scale` is a positive number")?;
        }
        Ok(it)
    }

    pub fn is_mirrored(&self) -> bool {
        self.axes.iter().enumerate().all(|(at, (from, _))| at == *from)
    }

    pub fn vector(&self, v: Vector) -> Vector {
        Vector::from(self.axes.map(|(axis, sign)| sign * v.along(axis)))
    }

    pub fn point(&self, p: Point) -> Point {
        Point::from((self.scale * self.vector(p.to_vector())).to_array())
    }

    /// Moves all rays and lamps of a log.
    pub fn apply(&self, log: &mut Log) {
        for ray in &mut log.rays {
            ray.origin = self.point(ray.origin);
            ray.direction = self.vector(ray.direction);
            ray.point = ray.point.map(|point| self.point(point));
            for normal in [&mut ray.normal, &mut ray.shading_normal].into_iter().flatten() {
                *normal = self.vector(*normal);
            }
            for length in [&mut ray.t, &mut ray.end].into_iter().flatten() {
                *length *= self.scale;
            }
        }
    }
}

impl fmt::Display for Placing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.scale != 1.0 {
            return write!(f, "{{\"rays\": 1, \"scale\": {}}} in the first line", self.scale);
        }
        let [x, y, z] = self.axes.map(|(axis, sign)| {
            format!("\"{}{}\"", if sign < 0.0 { "-" } else { "" }, NAMES[axis])
        });
        write!(f, "{{\"rays\": 1, \"axes\": [{x}, {y}, {z}]}} in the first line")
    }
}
