//! A comparison as text: the verdict in a sentence, and what it rests on.

use std::fmt;
use std::sync::Arc;

use super::{Affected, Comparison, Decoded, Picture, Region, Unusual, is_equal};
use text::brief::count;
use text::digits::{short, three};
use text::percent;

impl Comparison {
    /// The verdict in one sentence.
    pub fn sentence(&self) -> String {
        if self.is_same() {
            return match self.tolerance {
                0.0 => "same: no pixel differs".to_owned(),
                most => format!("same: no channel differs by more than {}", percent::short(most)),
            };
        }
        if let Some(loss) = self.loss {
            return format!(
                "same, as far as a JPEG can tell: no block of 16 × 16 pixels is off by more than {loss:.1} of 255 on \
                 average; a PNG tells more"
            );
        }
        if let Some(change) = self.explained_by.first() {
            let left = match change.left {
                0.0 => "nothing else differs".to_owned(),
                left => format!("{} of the difference is left", percent::of_pixels(left)),
            };
            return format!("differs: {}; {left}", change.what);
        }
        let what = match &self.affected {
            Some(affected) if self.are_objects_known => format!("differs: {}", affected.words()),
            Some(affected) => {
                let [a, b] = &self.names;
                let how = affected.direction.words_beside(a);
                format!(
                    "differs: {b} {how}, {} of its pixels",
                    percent::of_pixels(affected.share())
                )
            }
            None => "differs".to_owned(),
        };
        let known = self.known_mistakes.first().map(|words| format!("; known mistake: {words}"));
        what + &known.unwrap_or_default()
    }

    /// Says in which of the objects (name, number of pixels) of a scene it differs most; `object_of` has the index of that
    /// which each pixel shows.
    pub fn find_object(
        &mut self,
        (objects, object_of): (&[(Arc<str>, u32)], &[u32]),
        pictures: [&Picture; 2],
    ) {
        let decoded = pictures.map(Decoded::new);
        self.affected = affected(&decoded, self.tolerance, (objects, object_of));
        self.are_objects_known = true;
    }
}

/// The object that differs most: by the sum of the differences.
pub(super) fn affected(
    [a, b]: &[Decoded<'_>; 2],
    tolerance: f64,
    (objects, object_of): (&[(Arc<str>, u32)], &[u32]),
) -> Option<Affected> {
    Affected::of(objects, object_of, |pixel| {
        let [x, y] = [a.at(pixel), b.at(pixel)];
        let stored = a.picture.values[pixel].into_iter().zip(b.picture.values[pixel]);
        let differs = stored.into_iter().any(|(x, y)| !is_equal(a, b, (x, y), tolerance));
        let difference = [0, 1, 2].map(|channel| y[channel] - x[channel]);
        let weight = difference.iter().map(|channel| channel.abs()).sum();
        differs.then_some((weight, difference))
    })
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.sentence())?;
        f.write_str(&self.details())
    }
}

impl Comparison {
    /// What the sentence rests on, in lines.
    pub fn details(&self) -> String {
        let [width, height] = self.size;
        let [name_a, name_b] = &self.names;
        let mut lines = Vec::new();
        for words in self.known_mistakes.iter().skip(1) {
            lines.push(format!("or, which this scene cannot tell apart: {words}"));
        }
        if !self.is_same() {
            let share = self.differing as f64 / (f64::from(width) * f64::from(height));
            let (pixels, share) = (self.differing, percent::of_pixels(share));
            lines.push(format!("pixels that differ: {pixels} of {width} × {height} ({share})"));
            if let Some(Region { worst: [x, y], values: [a, b], difference, .. }) = &self.worst {
                let difference = short(*difference);
                let [a, b] = [a, b].map(|it| three(*it));
                lines.push(format!(
                    "largest difference: {difference} at ({x}, {y}): {name_b} {b}, {name_a} {a}"
                ));
            }
            lines.push("largest regions:".to_owned());
            for Region { pixels, bounds: [x, y, w, h], worst: [wx, wy], .. } in self.listed() {
                let pixels = count(*pixels as usize, "pixel");
                lines.push(format!("  {pixels} in {x},{y},{w}x{h}, the worst at ({wx}, {wy})"));
            }
            for hypothesis in &self.explained_by {
                let left = percent::of_pixels(hypothesis.left);
                lines.push(format!(
                    "explained: {} ({left} of the difference is left)",
                    hypothesis.what
                ));
            }
            lines.extend(self.means_in_words());
            let rms = short(self.root_mean_square);
            lines.push(format!("root mean square of the differences: {rms}"));
        } else {
            lines.push(format!("size: {width} × {height}"));
        }
        for (name, Unusual { nan, infinite, negative }) in self.names.iter().zip(self.unusual) {
            let counts = [(nan, "NaN"), (infinite, "infinite"), (negative, "negative")];
            let counts = counts.into_iter().filter(|(count, _)| *count > 0);
            let counts: Vec<String> =
                counts.map(|(count, what)| format!("{count} {what}")).collect();
            if !counts.is_empty() {
                lines.push(format!("{name}: {} values", counts.join(", ")));
            }
        }
        lines.extend(self.notes.iter().map(|note| format!("note: {note}")));
        lines.into_iter().map(|line| line + "\n").collect()
    }

    /// The means of the channels.
    fn means_in_words(&self) -> impl Iterator<Item = String> + '_ {
        let [name_a, name_b] = &self.names;
        ["red", "green", "blue"].into_iter().enumerate().filter_map(move |(channel, name)| {
            let [a, b] = self.means.map(|mean| mean[channel]);
            let percent = match a {
                0.0 => String::new(),
                a => format!(", {}", percent::signed((b - a) / a, 2)),
            };
            // a channel that is black in both says nothing
            (a != 0.0 || b != 0.0).then(|| {
                format!("mean {name}: {name_b} {}, {name_a} {}{percent}", short(b), short(a))
            })
        })
    }
}
