//! A comparison as text.

use std::fmt;

use super::{Comparison, Region, Unusual};
use groundtruth::explain::{brief, count};

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [width, height] = self.size;
        writeln!(f, "size: {width} × {height}")?;
        for (name, Unusual { nan, infinite, negative }) in ["A", "B"].into_iter().zip(self.unusual)
        {
            if nan + infinite + negative > 0 {
                writeln!(f, "{name}: {nan} NaN, {infinite} infinite, {negative} negative values")?;
            }
        }
        for (channel, name) in ["red", "green", "blue"].into_iter().enumerate() {
            let [a, b] = self.means.map(|mean| mean[channel]);
            let percent = match a {
                0.0 => String::new(),
                a => format!(", {:+.3} %", 100.0 * (b - a) / a),
            };
            writeln!(f, "mean {name}: {} and {}{percent}", brief(a), brief(b))?;
        }
        writeln!(f, "root mean square of the differences: {}", brief(self.root_mean_square))?;
        if self.is_same() {
            return writeln!(f, "no pixel differs");
        }
        let share = 100.0 * self.differing as f64 / (f64::from(width) * f64::from(height));
        writeln!(f, "pixels that differ: {} ({share:.3} %)", self.differing)?;
        if let Some(Region { worst: [x, y], values: [a, b], difference, .. }) = &self.worst {
            let difference = brief(*difference);
            writeln!(f, "largest difference: {difference} at ({x}, {y}): {a:?} and {b:?}")?;
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
