//! The checkers of a sphere (Suffern, ch. 30), for colours, textures or materials.

use std::f64::consts::PI;

use super::cells::{self, Cell};
use super::mapping::{azimuth, polar_angle};
use crate::invalid::Invalid;
use crate::math::Point;

/// A sphere about the origin, divided into columns by the azimuth φ and into rows by the polar
/// angle θ.
#[derive(Clone, Copy, Debug)]
pub struct SphereCells {
    /// The numbers of columns and of rows.
    counts: [f64; 2],
}

impl SphereCells {
    /// Checks the fields `num_horizontal` and `num_vertical`.
    pub(crate) fn new(num_horizontal: u32, num_vertical: u32) -> Result<Self, Invalid> {
        let fields = [("num_horizontal", num_horizontal), ("num_vertical", num_vertical)];
        Ok(Self { counts: cells::counts(fields)? })
    }

    pub(crate) fn count(&self) -> u64 {
        self.counts.map(|count| count as u64).iter().product()
    }

    /// The column `φ/(2π/n_h)` and the row `θ/(π/n_v)` of the direction of a point.
    pub(super) fn division([x, y, z]: [f64; 3], [columns, rows]: [f64; 2]) -> [Cell; 2] {
        let theta = polar_angle(x, z, y) / PI;
        [Cell::of_range(azimuth(x, z), columns), Cell::of_range(theta, rows)]
    }

    /// The column and the row of the direction of a point.
    pub(super) fn cell(&self, local: Point) -> [Cell; 2] {
        Self::division(local.to_array(), self.counts)
    }

    /// The index of the checker in the direction of a point: row by row from the north pole, each
    /// row from φ = 0.
    pub(crate) fn index(&self, local: Point) -> u64 {
        let [column, row] = self.cell(local);
        row.index as u64 * self.counts[0] as u64 + column.index as u64
    }

    /// Checks the length of a list: from 1 to the number of checkers.
    pub(crate) fn check_list(&self, field: &str, length: usize) -> Result<(), Invalid> {
        let max = self.count();
        if length == 0 || length as u64 > max {
            let problem = format!("found {length}, but from 1 to {max} fit, one for each checker");
            return Err(Invalid::field(field, problem));
        }
        Ok(())
    }
}
