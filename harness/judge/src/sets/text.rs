//! What is said of two sets of pictures, as text: the verdict in a sentence, what it rests on, and what would have been
//! seen.

use std::fmt;

use text::brief::count;

use super::{AreaDifference, AreaMeans, Method, Noise, Odd, Reason, SetsDecision, SetsVerdict};
use pictures::compare::article;
use text::digits::short;
use text::percent;

/// From so many times on, both values say more than their ratio.
const MANY: f64 = 100.0;

impl SetsVerdict {
    /// The verdict in one sentence.
    pub fn sentence(&self) -> String {
        let [before, after] = self.pictures;
        match (self.decision, &self.method) {
            (SetsDecision::Agree, Method::Rounding) => {
                "agree: before and after have the same values, but for rounding".to_owned()
            }
            (SetsDecision::Agree, _) => format!(
                "agree: the means of {before} before and {after} after do not differ by more than noise"
            ),
            (SetsDecision::CannotTell, Method::Rounding) => {
                "cannot tell: each value is no number in some picture".to_owned()
            }
            (SetsDecision::CannotTell, _) => {
                "cannot tell: the difference may be noise, which one picture a side hardly shows"
                    .to_owned()
            }
            (SetsDecision::Differ, Method::Odd) => {
                let first = self.odd.iter().position(Odd::is_broken).unwrap_or_default();
                let side = if first < before { "after" } else { "before" };
                format!("differ: {}; no picture {side} is so", self.odd_in_words(first))
            }
            (SetsDecision::Differ, _) => match (&self.explained_by, self.areas.first()) {
                (Some(change), _) => format!("differ: {change}"),
                (None, Some(area)) => format!("differ: {}", in_words(area)),
                (None, None) => "differ".to_owned(),
            },
        }
    }

    fn method_in_words(&self) -> String {
        let few = |because: &Reason| match because {
            Reason::Few(least) => format!(
                "so few pictures cannot reach a level of {} by divisions (the best is {least:.2})",
                self.level
            ),
            Reason::Noise => "noise that has changed cannot be exchanged".to_owned(),
        };
        let all = |is_all: bool| if is_all { "all" } else { "at random" };
        let ([before, after], p) = (self.pictures, format!("p = {:.3}", self.probability));
        let by_areas = |because: &Reason| {
            let few = few(because);
            format!("{few}; so a t-test of each area, {p} after correction for their number")
        };
        match &self.method {
            Method::Rounding => "there is no noise: each value counts".to_owned(),
            Method::Odd => "such pictures are on one side only: no test is needed".to_owned(),
            Method::Divisions { count, is_all } => format!(
                "{count} ways to divide {} pictures into {before} and {after} ({}), {p}",
                before + after,
                all(*is_all),
            ),
            Method::Signs { pairs, count, is_all } => format!(
                "{pairs} pairs have equal seeds, so most noise is gone: {count} ways to exchange before and after in them \
                 ({}), {p}",
                all(*is_all),
            ),
            Method::Areas { because } => by_areas(because),
            Method::PairedAreas { pairs, because } => format!(
                "{pairs} pairs have equal seeds, so most noise is gone; {}",
                by_areas(because)
            ),
            Method::OnePicture => {
                format!("the noise is estimated from the finest details of the difference, {p}")
            }
        }
    }

    fn power_in_words(&self) -> Option<String> {
        let power = self.power.as_ref()?;
        let gain = |gain: Option<f64>| gain.map_or("no gain".to_owned(), percent::short);
        let (whole, patch, side) = (gain(power.gain), gain(power.gain_of_patch), power.patch);
        let [x, y] = power.corner;
        let lamp = if power.lamp { "one lamp" } else { "no single lamp" };
        let shift = match power.shift {
            [true, true] => "a shift by half a pixel",
            [true, false] => "a shift by half a pixel along rows (not down columns)",
            [false, true] => "a shift by half a pixel down columns (not along rows)",
            [false, false] => "no shift by half a pixel",
        };
        Some(format!(
            "would have been seen: {whole} everywhere, {patch} in {x},{y},{side}x{side}, {lamp} of twelve that is missing, \
             {shift}"
        ))
    }

    /// What stands out in a picture: `picture 3 after: 3 values no number, left out everywhere`.
    fn odd_in_words(&self, index: usize) -> String {
        let [before, _] = self.pictures;
        let (set, number) = match index < before {
            true => ("before", index + 1),
            false => ("after", index + 1 - before),
        };
        let Odd { not_finite, negative, is_far } = self.odd[index];
        let values = |values, what| format!("{} {what}", count(values, "value"));
        let parts = [
            (not_finite > 0).then(|| values(not_finite, "no number, left out everywhere")),
            is_far.then(|| "far from the others of its set".to_owned()),
            (negative > 0).then(|| values(negative, "negative")),
        ];
        let parts = parts.into_iter().flatten().collect::<Vec<_>>().join("; ");
        format!("picture {number} {set}: {parts}")
    }

    /// What the sentence rests on, in lines.
    pub fn details(&self) -> String {
        let is_odd = |index: &usize| self.odd[*index] != Odd::default();
        let odd = (0..self.odd.len()).filter(is_odd);
        let mut lines: Vec<String> = odd.map(|index| self.odd_in_words(index)).collect();
        lines.extend(self.margin.map(|(margin, answer)| {
            format!("margin of {}: {}", percent::short(margin), answer.words())
        }));
        let further = usize::from(self.explained_by.is_none() && self.method != Method::Odd);
        let areas = self.areas.iter().skip(further);
        lines.extend(areas.map(|area| format!("  {}", in_words(area))));
        lines.extend(self.power_in_words());
        lines.push(format!("method: {}", self.method_in_words()));
        // an area that is black in both says nothing
        let means = self.means.iter().filter(|it| it.before != 0.0 || it.after != 0.0);
        lines.extend(means.map(|means| format!("{}: {}", means.name, means_in_words(means))));
        lines.extend(self.noise.map(|Noise { factor, interval: [low, high], .. }| {
            let is_changed = if low > 1.0 || high < 1.0 { "; it has changed" } else { "" };
            format!("noise: {factor:.2} of that before (99 %: {low:.2} to {high:.2}){is_changed}")
        }));
        lines.into_iter().map(|line| line + "\n").collect()
    }
}

impl fmt::Display for SetsVerdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.sentence())?;
        f.write_str(&self.details())
    }
}

fn in_words(AreaDifference { name, before, after, is_mean, .. }: &AreaDifference) -> String {
    let name = article(name);
    if !is_mean {
        return format!("{name} has changed");
    }
    let relative = (after - before).abs() / before;
    let direction = if after < before { "darker" } else { "brighter" };
    let by = match relative {
        usual if (0.0..MANY).contains(&usual) => {
            format!(", by {} on average", percent::of_pixels(relative))
        }
        _ if *before == 0.0 => ", it was black".to_owned(),
        _ => String::new(),
    };
    format!("{name} is {direction} after{by} (from {} to {})", short(*before), short(*after))
}

/// The means of an area, and their difference.
fn means_in_words(means: &AreaMeans) -> String {
    let [before, after] = [means.before, means.after].map(short);
    let Some([relative, low, high]) = means.relative else {
        return format!("{before} before, {after} after");
    };
    let half = percent::percent(0.5 * (high - low), 2);
    format!("{before} before, {after} after, {} ± {half}", percent::signed(relative, 2))
}
