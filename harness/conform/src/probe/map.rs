//! The maps of samples, and their inverses.

use serde::{Deserialize, Serialize};

use super::numbers::{HALF_OPEN, in_square, unit};
use groundtruth::invalid::Invalid;
use groundtruth::math::{UNIT_ROUNDOFF, Vector, maps};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MapQuestion {
    to: Domain,
    u: Option<[f64; 2]>,
    point: Option<Vec<f64>>,
}

/// Where the square is mapped to.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
enum Domain {
    Disk {},
    Hemisphere { exponent: f64 },
    Sphere {},
}

#[derive(Serialize)]
#[serde(untagged)]
pub enum MappedPoints {
    Plane([f64; 2]),
    Space([f64; 3]),
}

impl super::Question for MapQuestion {
    type Answer = MappedPoints;

    fn answer(&self) -> Result<MappedPoints, Invalid> {
        if let Domain::Hemisphere { exponent } = self.to
            && exponent < 0.0
        {
            let problem = format!("found {exponent}, but 0 or more fits");
            return Err(Invalid::field("exponent", problem).inside("hemisphere").inside("to"));
        }
        match (self.u, &self.point) {
            (Some(u), None) => Ok(self.to.map(in_square("u", u, HALF_OPEN)?)),
            (None, Some(point)) => Ok(MappedPoints::Plane(self.to.inverse(point)?)),
            _ => Err(Invalid::new("needs either `u` or `point`")),
        }
    }
}

impl Domain {
    fn map(self, u: [f64; 2]) -> MappedPoints {
        match self {
            Self::Disk {} => MappedPoints::Plane(maps::disk(u)),
            Self::Hemisphere { exponent } => {
                MappedPoints::Space(maps::hemisphere(u, exponent).to_array())
            }
            Self::Sphere {} => MappedPoints::Space(maps::sphere(u).to_array()),
        }
    }

    fn inverse(self, point: &[f64]) -> Result<[f64; 2], Invalid> {
        let unfit = |what: &str| {
            Err(Invalid::field("point", format!("found {point:?}, but {what} is needed")))
        };
        match (self, point) {
            // as for unit vectors, rounding may put it a little outside
            (Self::Disk {}, &[x, y]) if x * x + y * y <= 1.0 + 8.0 * UNIT_ROUNDOFF => {
                Ok(maps::disk_inverse([x, y]))
            }
            (Self::Disk {}, _) => unfit("a point [x, y] of the unit disk"),
            (Self::Hemisphere { exponent }, &[x, y, z]) if z >= 0.0 => {
                let direction = unit("point", Vector::new(x, y, z))?;
                Ok(maps::hemisphere_inverse(direction, exponent))
            }
            (Self::Hemisphere { .. }, _) => unfit("a direction [x, y, z] with z of at least 0"),
            (Self::Sphere {}, &[x, y, z]) => {
                Ok(maps::sphere_inverse(unit("point", Vector::new(x, y, z))?))
            }
            (Self::Sphere {}, _) => unfit("a direction [x, y, z]"),
        }
    }
}
