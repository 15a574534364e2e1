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

    /// Whether the fields of a head can say it.
    ///
    /// # Errors
    /// What they should be.
    pub fn check(fields: &Map<String, Value>) -> Result<(), String> {
        let axis = |word: &Value| {
            NAMES
                .iter()
                .position(|it| Some(*it) == word.as_str().map(|it| it.trim_start_matches('-')))
        };
        let axes = |it: &Vec<Value>| it.iter().map(axis).collect::<Option<BTreeSet<_>>>();
        let is_whole = |it: &Value| {
            it.as_array()
                .is_some_and(|it| it.len() == 3 && axes(it).is_some_and(|it| it.len() == 3))
        };
        if fields.get("axes").is_some_and(|it| !is_whole(it)) {
            return Err("`axes` are x, y and z in any order, each perhaps with a sign, as [\"x\", \"z\", \"-y\"]".to_owned());
        }
        let is_length = |it: &Value| it.as_f64().is_some_and(|it| it > 0.0 && it.is_normal());
        match fields.get("scale").is_none_or(is_length) {
            true => Ok(()),
            false => Err("`scale` is a positive number".to_owned()),
        }
    }

    /// What the head says of it: `"axes": ["x", "z", "-y"]`, `"scale": 0.01`.
    pub fn of(log: &Log) -> Option<Self> {
        let fields = &log.head.others;
        let axis = |word: &Value| {
            let word = word.as_str()?;
            let (sign, name) = word.strip_prefix('-').map_or((1.0, word), |name| (-1.0, name));
            Some((NAMES.iter().position(|it| *it == name)?, sign))
        };
        let axes = fields.get("axes").and_then(Value::as_array);
        let axes =
            axes.and_then(|it| it.iter().map(axis).collect::<Option<Vec<_>>>()?.try_into().ok());
        let scale = fields.get("scale").and_then(Value::as_f64);
        (axes.is_some() || scale.is_some()).then(|| Self {
            axes: axes.unwrap_or(Self::default().axes),
            scale: scale.unwrap_or(1.0),
        })
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
