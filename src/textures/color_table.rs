//! Tables of colours (Suffern, ch. 31): the book's ramps, images of one row in which a number finds its
//! colour.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Rule;
use crate::invalid::Invalid;
use crate::math::floor;
use crate::rgb::Rgb;

/// More columns than anyone can tell apart.
const MOST_COLUMNS: u32 = 1 << 16;

/// A row of colours for the numbers from 0 to 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ColorTable {
    /// The colours, from that of 0 to that of 1; at least one.
    pub colors: Vec<Rgb>,
    /// How many columns there are, the colours at even distances and mixed between them; from 1 to
    /// 65536. If left out, a column for each colour.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub columns: Option<u32>,
    /// Which numbers a column is for.
    #[serde(default)]
    pub rule: Rule,
}

impl ColorTable {
    /// These colours, mixed in 256 columns.
    pub fn mixed(colors: impl Into<Vec<Rgb>>) -> Self {
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
            Some(columns) if (1..=MOST_COLUMNS).contains(&columns) => {
                let last = f64::from((columns - 1).max(1));
                (0..columns).map(|column| self.mixture(f64::from(column) / last)).collect()
            }
            Some(columns) => {
                let problem = format!("found {columns}, but 1 to {MOST_COLUMNS} fit");
                return Err(here(Invalid::field("columns", problem)));
            }
        };
        Ok(Columns { colors, rule: self.rule })
    }

    /// The mixture of the two colours beside this share of the table.
    fn mixture(&self, share: f64) -> Rgb {
        let last = self.colors.len() - 1;
        let column = share * last as f64;
        let left = (floor(column) as usize).min(last);
        let t = column - left as f64;
        (1.0 - t) * self.colors[left] + t * self.colors[(left + 1).min(last)]
    }
}

/// A table ready to be asked.
#[derive(Debug)]
pub(super) struct Columns {
    colors: Vec<Rgb>,
    rule: Rule,
}

impl Columns {
    /// The colour of `u` from 0 to 1.
    ///
    /// The book's rule is column `trunc(u (hres − 1))`; `u hres − 1`, as one listing has it, would be
    /// −1 for 0 (errata, I).
    pub fn color(&self, u: f64) -> Rgb {
        let last = self.colors.len() - 1;
        let covered = if self.rule == Rule::Even { last + 1 } else { last };
        let column = (u * covered as f64) as usize;
        self.colors[column.min(last)]
    }
}
