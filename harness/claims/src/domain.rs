//! The domains of maps, each laid on the sphere with its areas in proportion: so cells of directions serve all.

use std::f64::consts::{PI, TAU};

use groundtruth::math::{Vector, atan2, cos, sin};
use serde::Deserialize;

/// What a map from the unit square covers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Domain {
    /// `[0, 1]²`, by two coordinates.
    Square,
    /// The unit disk, by two coordinates.
    Disk,
    /// Barycentric coordinates `β, γ ≥ 0`, `β + γ ≤ 1`: half of a square.
    Triangle,
    /// Unit directions with `z ≥ 0`.
    Hemisphere,
    /// Unit directions.
    Sphere,
}

impl Domain {
    /// How many coordinates a point has.
    pub fn coordinates(self) -> usize {
        if self.is_curved() { 3 } else { 2 }
    }

    /// Whether its points are directions.
    pub fn is_curved(self) -> bool {
        matches!(self, Self::Hemisphere | Self::Sphere)
    }

    /// Its area, or solid angle, over that of the directions on which it is laid.
    pub fn scale(self) -> f64 {
        match self {
            Self::Square => 1.0 / TAU,
            Self::Disk => PI / TAU,
            Self::Triangle => 0.5 / TAU,
            Self::Hemisphere | Self::Sphere => 1.0,
        }
    }

    /// How far a point is outside; 0 inside.
    pub fn outside(self, x: Vector) -> f64 {
        let [a, b, c] = x.to_array();
        let off = match self {
            Self::Square => (-a).max(-b).max(a - 1.0).max(b - 1.0),
            Self::Disk => x.length() - 1.0,
            Self::Triangle => (-a).max(-b).max(a + b - 1.0),
            Self::Hemisphere => (x.length() - 1.0).abs().max(-c),
            Self::Sphere => (x.length() - 1.0).abs(),
        };
        if x.is_finite() { off.max(0.0) } else { f64::INFINITY }
    }

    /// The direction on which a point is laid.
    pub fn direction(self, x: Vector) -> Vector {
        let [a, b, _] = x.to_array();
        let at = |s: f64, phi: f64| {
            let s = s.clamp(0.0, 1.0);
            let sine = (s * (2.0 - s)).sqrt();
            Vector::new(sine * cos(phi), sine * sin(phi), 1.0 - s)
        };
        match self {
            Self::Square => at(a, TAU * b),
            Self::Disk => at(a * a + b * b, atan2(b, a)),
            Self::Triangle => {
                let sum = a + b;
                at(sum * sum, if sum > 0.0 { TAU * b / sum } else { 0.0 })
            }
            // rounding puts points of the rim below it
            Self::Hemisphere => Vector::new(a, b, x.z().abs()),
            Self::Sphere => x,
        }
    }

    /// The point that is laid on a direction; of all but the sphere, on the upper side.
    pub fn point(self, w: Vector) -> Vector {
        // not 1 − z, which loses its digits near the pole
        let s = ((w.x() * w.x() + w.y() * w.y()) / (1.0 + w.z().abs())).min(1.0);
        let turn = atan2(w.y(), w.x()) / TAU;
        let turn = if turn < 0.0 { turn + 1.0 } else { turn };
        let (r, phi) = (s.sqrt(), TAU * turn);
        match self {
            Self::Square => Vector::new(s, turn, 0.0),
            Self::Disk => Vector::new(r * cos(phi), r * sin(phi), 0.0),
            Self::Triangle => Vector::new(r * (1.0 - turn), r * turn, 0.0),
            Self::Hemisphere | Self::Sphere => w,
        }
    }
}
