//! Colour tables (Suffern, ch. 31): the book's ramps, images of one row that map a number from 0 to
//! 1 to a colour.

use super::Rule;
use crate::invalid::Invalid;
use crate::math::floor;
use crate::rgb::Rgb;

const MAX_COLUMNS: u32 = 1 << 16;

/// A row of colours for the numbers from 0 to 1.
#[kind(PartialEq)]
pub struct ColorTable {
    /// The colours, from that of 0 to that of 1; at least one.
    pub colors: Vec<Rgb>,
    /// The number of columns, from 1 to 65536: the colours are at equal distances, with linear
    /// interpolation between them. If left out, one column for each colour.
    pub columns: Option<u32>,
    /// The numbers that each column covers.
    #[default]
    pub rule: Rule,
}

impl ColorTable {
    /// These colours, interpolated in 256 columns.
    pub fn interpolated(colors: impl Into<Vec<Rgb>>) -> Self {
        Self { colors: colors.into(), columns: Some(256), rule: Rule::Even }
    }

    /// Checks the data and makes the columns.
    pub(super) fn build(&self, field: &str) -> Result<Columns, Invalid> {
        let here = |e: Invalid| e.inside(field);
        for (index, color) in self.colors.iter().enumerate() {
            let at = |e: Invalid| Invalid::new(e.problem).inside(index).inside("colors");
            color.checked("colors").map_err(|e| here(at(e)))?;
        }
        if self.colors.is_empty() {
            return Err(here(Invalid::field("colors", "found none, but at least one is needed")));
        }
        let colors = match self.columns {
            None => self.colors.clone(),
            Some(columns) if (1..=MAX_COLUMNS).contains(&columns) => {
                let last = f64::from((columns - 1).max(1));
                (0..columns).map(|column| self.interpolate(f64::from(column) / last)).collect()
            }
            Some(columns) => {
                let problem = format!("found {columns}, but 1 to {MAX_COLUMNS} fit");
                return Err(here(Invalid::field("columns", problem)));
            }
        };
        Ok(Columns { colors, rule: self.rule })
    }

    /// The colour at position `x` of the table, from 0 to 1.
    fn interpolate(&self, x: f64) -> Rgb {
        let last = self.colors.len() - 1;
        let column = x * last as f64;
        let left = (floor(column) as usize).min(last);
        let t = column - left as f64;
        (1.0 - t) * self.colors[left] + t * self.colors[(left + 1).min(last)]
    }
}

/// A built colour table.
#[derive(Debug)]
pub(super) struct Columns {
    colors: Vec<Rgb>,
    rule: Rule,
}

impl Columns {
    /// The colour of `u` from 0 to 1.
    ///
    /// The book's rule is column `trunc(u (hres − 1))`; one listing has `u hres − 1`, which is −1
    /// for `u = 0` (errata, I).
    pub fn color(&self, u: f64) -> Rgb {
        let last = self.colors.len() - 1;
        let covered = if self.rule == Rule::Even { last + 1 } else { last };
        let column = (u * covered as f64) as usize;
        self.colors[column.min(last)]
    }
}
