//! A comparison as text.

use std::fmt;

use super::{Comparison, Region, Unusual};
use crate::percent;
use groundtruth::explain::{brief, count};

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [width, height] = self.size;
        writeln!(f, "size: {width} × {height}")?;
        for (name, Unusual { nan, infinite, negative }) in self.names.iter().zip(self.unusual) {
            if nan + infinite + negative > 0 {
                writeln!(f, "{name}: {nan} NaN, {infinite} infinite, {negative} negative values")?;
            }
        }
        for (channel, name) in ["red", "green", "blue"].into_iter().enumerate() {
            let [a, b] = self.means.map(|mean| mean[channel]);
            let percent = match a {
                0.0 => String::new(),
                a => format!(", {}", percent::signed((b - a) / a, 3)),
            };
            let [name_a, name_b] = &self.names;
            writeln!(f, "mean {name}: {name_b} {}, {name_a} {}{percent}", brief(b), brief(a))?;
        }
        writeln!(f, "root mean square of the differences: {}", brief(self.root_mean_square))?;
        if self.is_same() {
            return writeln!(f, "no pixel differs");
        }
        let share = 100.0 * self.differing as f64 / (f64::from(width) * f64::from(height));
        writeln!(f, "pixels that differ: {} ({share:.3} %)", self.differing)?;
        if let Some(Region { worst: [x, y], values: [a, b], difference, .. }) = &self.worst {
            let difference = brief(*difference);
            let [name_a, name_b] = &self.names;
            writeln!(
                f,
                "largest difference: {difference} at ({x}, {y}): {name_b} {b:?}, {name_a} {a:?}"
            )?;
        }
        writeln!(f, "largest regions:")?;
        for Region { pixels, bounds: [x, y, w, h], worst, .. } in self.listed() {
            let pixels = count(*pixels as usize, "pixel");
            let [wx, wy] = worst;
            writeln!(f, "  {pixels} in {x},{y},{w}x{h}, the worst at ({wx}, {wy})")?;
        }
        for hypothesis in &self.explained_by {
            let left = 100.0 * hypothesis.left;
            writeln!(f, "explained: {} ({left:.1} % of the difference is left)", hypothesis.what)?;
        }
        for note in &self.notes {
            writeln!(f, "note: {note}")?;
        }
        Ok(())
    }
}
