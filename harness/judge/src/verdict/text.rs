//! What is said of a picture, as text: the verdict in a sentence, why, where, and then numbers.

use std::fmt;

use text::brief::count;

use super::place::ALL;
use super::{
    Cause, Causes, DecidedBy, Decision, DifferingRegion, Explanation, Means, Nearest, Place,
    Relative, Verdict,
};
use pictures::compare::article;
use text::digits::{short, three};
use text::percent;

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.sentence())?;
        f.write_str(&self.details())
    }
}

/// Of an object of which a smaller part differs pixel by pixel, its mean says more.
const FEW: f64 = 0.05;

/// What explains less is no part of it that is worth a line.
const PART: f64 = 0.5;

impl Verdict {
    /// The verdict in one sentence.
    pub fn sentence(&self) -> String {
        let Self { as_far, replicas, pictures, .. } = self;
        match (self.decision, self.equal_to_seed) {
            (_, Some(seed)) => format!("agrees: it is our picture with --seed {seed}, bit for bit"),
            (Decision::Agrees, _) if self.loss.is_some() => format!(
                "agrees, as far as a JPEG can tell: no block of 16 × 16 pixels is off by more than {:.1} of 255 on \
                 average; a PNG tells more",
                self.loss.unwrap_or_default()
            ),
            (Decision::Agrees, _) if self.fixed => {
                "agrees: no value differs by more than rounding".to_owned()
            }
            (Decision::Agrees, _) if *pictures > 1 => {
                format!("agrees: no object and no large tile of {pictures} pictures differs")
            }
            (Decision::Agrees, _) => {
                "agrees: the difference from ours is no more than noise".to_owned()
            }
            (Decision::Undecided, _) => format!(
                "interrupted: so far, {as_far} of {replicas} pictures of ours with other seeds differ as much"
            ),
            (Decision::Differs, _) => format!("differs: {}{}", self.how(), self.why()),
        }
    }

    /// What differs, in which direction, by how much.
    fn how(&self) -> String {
        if let Some(Explanation { what, agrees: true, .. }) = &self.explained {
            return format!("{what}; it agrees but for that");
        }
        let mean_of = |name: &str| self.means.iter().find(|means| means.name == name);
        match (&self.decided_by, &self.affected) {
            (Some(DecidedBy::Mean(name)), _) => self.mean_in_words(name, mean_of(name)),
            (Some(DecidedBy::Negative), _) => {
                "radiance is never negative, and that of theirs is".to_owned()
            }
            (None, Some(affected)) if affected.share() < FEW && !self.fixed => {
                self.mean_in_words(&affected.object, mean_of(&affected.object))
            }
            (None, Some(affected)) => affected.words(),
            (None, None) => "by more than noise".to_owned(),
        }
    }

    /// An area whose mean differs.
    fn mean_in_words(&self, name: &str, means: Option<&Means>) -> String {
        let object = article(name);
        let Some(relative) = means.and_then(|means| means.relative) else {
            return format!("{object} differs");
        };
        if !means.is_some_and(Means::is_outside) {
            return format!("{object} differs in some places, not on average");
        }
        let direction = if relative < 0.0 { "too dark" } else { "too bright" };
        let by = percent::of_pixels(relative.abs());
        format!("{object} is {direction}, by {by} on average")
    }

    /// The known mistake that explains it.
    fn why(&self) -> String {
        let Causes { explained_by, tried, otherwise, is_unfinished, .. } = &self.causes;
        if let (Some(cause), [first, ..]) = (explained_by.first(), &**otherwise) {
            let (encoding, [other, so]) = (self.encoding(), [&first.0, &first.1.to_string()]);
            return format!(
                "; nothing says how its values encode radiance: read as {encoding}, the known mistake is that {cause}; as \
                 {other}, that {so}"
            );
        }
        if let Some((cause, others)) = explained_by.split_first() {
            let names: Vec<&str> = others.iter().filter_map(|other| other.name).collect();
            let or =
                if names.is_empty() { "" } else { ", or, which this picture cannot tell apart, " };
            return format!("; known mistake: {cause}{or}{}", names.join(", "));
        }
        if let Some(Explanation { what, agrees: false, .. }) = &self.explained {
            return format!("; {what} explains a part of it");
        }
        let guess = || format!("; it is read as {}, which is a guess", self.encoding());
        let guess = if self.is_guessed { guess() } else { String::new() };
        match (is_unfinished, tried) {
            (true, _) => format!("; the search for a cause was ended{guess}"),
            (false, 0) => guess,
            (false, _) => format!("; no known mistake explains it{guess}"),
        }
    }

    /// How its values are taken to encode radiance.
    fn encoding(&self) -> &str {
        self.assumed.split(',').next().unwrap_or_default()
    }

    /// What the sentence rests on, in lines: causes first, then places, then numbers.
    pub fn details(&self) -> String {
        let is_ours = self.equal_to_seed.is_some();
        let mut lines = Vec::new();
        if !is_ours {
            self.why_in_lines(&mut lines);
            if !self.regions.is_empty() {
                lines.push("where:".to_owned());
            }
            lines.extend(self.regions.iter().map(|region| format!("  {region}")));
            if let Some((margin, answer)) = self.margin {
                lines.push(format!("margin of {}: {}", percent::short(margin), answer.words()));
                let beyond = self.means.iter().filter(|it| it.is_beyond(margin));
                lines.extend(beyond.map(|it| format!("  {}{}", it.name, and_differences(it))));
            }
            lines.extend(self.rank());
            if let Some(whole) = self.means.first() {
                let [theirs, ours] = [whole.theirs, whole.ours].map(three);
                lines.push(format!("mean: {theirs}, ours {ours}{}", and_differences(whole)));
            }
        }
        self.about_values(&mut lines);
        if !is_ours {
            self.power(&mut lines);
        }
        lines.into_iter().map(|line| line + "\n").collect()
    }

    fn rank(&self) -> Option<String> {
        let Self { as_far, replicas, pictures, .. } = self;
        let is_by_rank = self.decided_by.is_none();
        match self.decision {
            _ if self.fixed => None,
            Decision::Agrees if *pictures == 1 && is_by_rank => Some(format!(
                "rank: {as_far} of {replicas} pictures of ours with other seeds differ as much from the rest"
            )),
            Decision::Differs if *pictures > 1 => Some(format!(
                "rank: the means of {pictures} pictures are too far from ours for their noise"
            )),
            Decision::Differs if is_by_rank => Some(format!(
                "rank: it differs more than any of {replicas} pictures of ours with other seeds does from the rest"
            )),
            _ => None,
        }
    }

    /// The noise, and how values are stored.
    fn about_values(&self, lines: &mut Vec<String>) {
        let is_ours = self.equal_to_seed.is_some();
        if !self.fixed && !is_ours {
            let about = match (self.independent, self.coarse) {
                (false, false) => "",
                (true, false) => "; ours have independent samples, as theirs seems to have",
                (_, true) => "; it is unlike ours, so areas below 4 × 4 pixels do not count",
            };
            lines.push(format!("noise: {:.2} of that of our pictures{about}", self.noise));
        }
        lines.extend(self.reference.map(|pictures| {
            format!(
                "reference: all pictures are held against the mean of {pictures} others of ours"
            )
        }));
        if self.set_apart > 0 && !is_ours {
            let pixels = count(self.set_apart, "pixel");
            lines.push(format!(
                "not counted: {pixels}, in which all pictures of ours agree but a correct picture may have another value"
            ));
        }
        lines.extend(self.negative.map(|negative| negative.to_string()));
        lines.push(format!("assumed: {}", self.assumed));
    }

    /// What explains the difference, or most of it.
    fn why_in_lines(&self, lines: &mut Vec<String>) {
        if let Some(Explanation { what, agrees, is_gain }) = &self.explained {
            let rest = if *agrees { "it agrees but for that" } else { "it differs beyond that" };
            lines.push(format!("explained: {what}; {rest}"));
            lines.extend(is_gain.then(|| {
                "  a program that has the same samples in every pixel moves all pixels together: judge three pictures with \
                 other seeds"
                    .to_owned()
            }));
        }
        let Causes { explained_by, nearest, place, tried, otherwise, is_unfinished } = &self.causes;
        for (index, cause) in explained_by.iter().enumerate() {
            let or = match index {
                0 => "cause: the picture agrees with ours if",
                _ => "  or, which this scene cannot tell apart, if",
            };
            lines.push(format!("{or} {cause}"));
        }
        if explained_by.is_empty() && *tried > 0 {
            lines.push(format!(
                "cause: none of the {tried} known mistakes that change this picture"
            ));
        }
        lines.extend(
            otherwise.iter().map(|(encoding, cause)| {
                format!("  or, if its values are {encoding}, that {cause}")
            }),
        );
        if let Some(Nearest { cause, share, interval: [low, high] }) = nearest
            && *share >= PART
        {
            let [share, low, high] = [*share, low.max(0.0), *high].map(|it| 100.0 * it);
            lines.push(format!(
                "a part of it: that {cause} explains {share:.0} % ({low:.0} … {high:.0} %) of the difference"
            ));
        }
        lines.extend(place.as_ref().map(Place::words));
        if self.is_guessed {
            let line = "encoding: nothing says how its values encode radiance; --encoding does";
            lines.push(line.to_owned());
        }
        if *is_unfinished {
            let line = "the search for causes was ended; --search gives it more seconds";
            lines.push(line.to_owned());
        }
    }

    fn power(&self, lines: &mut Vec<String>) {
        for (found, title) in [(true, "would have been seen"), (false, "would not have been seen")]
        {
            let plants = self.plants.iter().filter(|plant| plant.found == found);
            let names: Vec<&str> = plants.map(|plant| plant.what.as_str()).collect();
            if !names.is_empty() {
                let (replicas, names) = (self.replicas, names.join("; "));
                lines.push(format!("{title}, with {replicas} pictures: {names}"));
            }
        }
        let gain = |(side, gain): &(usize, Option<f64>)| {
            Some(format!("{side}×{side}: {}", percent::short((*gain)?)))
        };
        let gains: Vec<String> = self.gains.iter().filter_map(gain).collect();
        if !gains.is_empty() {
            let gains = gains.join(", ");
            lines.push(format!("the smallest gain in a tile that stands out: {gains}"));
        }
    }
}

impl fmt::Display for DifferingRegion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, bounds: [x, y, w, h], z, ours, theirs, worst: [wx, wy] } = self;
        let z = z.map_or(String::new(), |z| {
            format!("{}{} standard deviations, ", if z < 0.0 { "−" } else { "+" }, short(z.abs()))
        });
        let [theirs, ours] = [*theirs, *ours].map(three);
        write!(f, "{name} in {x},{y},{w}x{h}: {z}{theirs}, ours {ours}, the worst at {wx},{wy}")
    }
}

/// Its words, and in brackets where to read more.
impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.words)?;
        if let (Some(name), Some(chapter)) = (self.name, self.chapter) {
            write!(f, " ({name}, ch. {chapter})")?;
        }
        self.also.as_ref().map_or(Ok(()), |also| write!(f, ", and {also}"))
    }
}

impl Place {
    /// Where it is, and how much of the difference.
    fn words(&self) -> String {
        let how_much = if self.share >= ALL { "only" } else { "mostly" };
        let (objects, share) = (self.objects.join(", "), 100.0 * self.share);
        let of = self
            .material
            .as_ref()
            .map_or(String::new(), |material| format!(", of material {material} ({})", self.about));
        format!("{how_much} in {objects}{of}: {share:.0} % of the difference")
    }
}

/// Relative differences and their intervals: one, or one of each channel if they differ.
pub fn differences(means: &Means) -> String {
    let words = |relative: f64, half: f64| {
        format!("{} ± {}", percent::signed(relative, 2), percent::percent(half, 2))
    };
    if !means.is_coloured() {
        return means.relative.map_or(String::new(), |relative| words(relative, means.half));
    }
    let of = |Relative { relative, half }: Relative| {
        relative.map_or("ours is black".to_owned(), |relative| words(relative, half))
    };
    let [red, green, blue] = means.channels.map(of);
    format!("red {red}, green {green}, blue {blue}")
}

/// The same after a comma, if there is anything to say.
fn and_differences(means: &Means) -> String {
    let words = differences(means);
    if words.is_empty() { words } else { format!(", {words}") }
}
