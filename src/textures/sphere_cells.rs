//! The checkers of a sphere (Suffern, ch. 30), for colours, textures or materials.

use std::f64::consts::PI;

use super::cells::{self, Cell};
use super::mapping::{around, from_axis};
use crate::invalid::Invalid;
use crate::math::Point;

/// A sphere about the origin, divided into columns by the azimuth φ and into rows by the polar angle θ.
#[derive(Clone, Copy, Debug)]
pub struct SphereCells {
    columns: f64,
    rows: f64,
}

impl SphereCells {
    /// Checks the fields `num_horizontal` and `num_vertical`.
    pub(crate) fn new(num_horizontal: u32, num_vertical: u32) -> Result<Self, Invalid> {
        let columns = cells::count("num_horizontal", num_horizontal)?;
        Ok(Self { columns, rows: cells::count("num_vertical", num_vertical)? })
    }

    /// How many there are.
    pub(crate) fn number(&self) -> u64 {
        self.columns as u64 * self.rows as u64
    }

    /// The column `φ/(2π/n_h)` and the row `θ/(π/n_v)` of the direction of a point.
    pub(super) fn cell(&self, local: Point) -> [Cell; 2] {
        let [x, y, z] = local.to_array();
        let theta = from_axis(x, z, y) / PI;
        [Cell::of_range(around(x, z), self.columns), Cell::of_range(theta, self.rows)]
    }

    /// The number of the checker in the direction of a point: row by row from the north pole, and in each
    /// row from φ = 0 on.
    pub(crate) fn index(&self, local: Point) -> u64 {
        let [column, row] = self.cell(local);
        row.index as u64 * self.columns as u64 + column.index as u64
    }

    /// Refuses a list of things for the checkers that is empty, or longer than they are many.
    pub(crate) fn check_list(&self, field: &str, length: usize) -> Result<(), Invalid> {
        let most = self.number();
        if length == 0 || length as u64 > most {
            let problem = format!("found {length}, but from 1 to {most} fit, one for each checker");
            return Err(Invalid::field(field, problem));
        }
        Ok(())
    }
}
