//! What is said of a picture, as text: what was assumed, the means, the noise, the decision, and then why.

use std::fmt;

use groundtruth::explain::{brief, count};

use super::verdict::{DecidedBy, Explanation, Region, Verdict};
use super::{Cause, Causes, Decision, Factor, Factors, Means, Nearest, Place, Relative};
use pictures::percent;

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "assumed: {}", self.assumed)?;
        if self.equal_to_seed.is_some() {
            return writeln!(f, "{}", self.decision_in_words());
        }
        if let Some(whole) = self.means.first() {
            let [theirs, ours] = [whole.theirs, whole.ours].map(color);
            writeln!(f, "mean: {theirs}, ours {ours}{}", and_differences(whole))?;
        }
        if !self.fixed {
            writeln!(f, "noise: {:.2} of that of our pictures{}", self.noise, self.about_noise())?;
        }
        if let Some(pictures) = self.reference {
            writeln!(
                f,
                "reference: all pictures are held against the mean of {pictures} others of ours"
            )?;
        }
        if self.set_apart > 0 {
            let pixels = count(self.set_apart, "pixel");
            writeln!(
                f,
                "set apart: {pixels}, where all of ours agree and a correct picture need not"
            )?;
        }
        if let Some(negative) = &self.negative {
            writeln!(f, "{negative}")?;
        }
        writeln!(f, "{}", self.decision_in_words())?;
        self.margin(f)?;
        self.explanation(f)?;
        self.places(f)?;
        self.power(f)
    }
}

impl Verdict {
    fn about_noise(&self) -> &'static str {
        match (self.independent, self.coarse) {
            (false, false) => "",
            (true, false) => "; ours have independent samples, as theirs seems to have",
            (_, true) => "; it is unlike ours, so areas below 4 × 4 pixels do not count",
        }
    }

    /// The decision, and on what it rests, in one line.
    pub fn decision_in_words(&self) -> String {
        let Self { as_far, replicas, pictures, .. } = self;
        if let Some(seed) = self.equal_to_seed {
            return format!("agrees: it is our picture with --seed {seed}, bit for bit");
        }
        match &self.decided_by {
            Some(DecidedBy::Mean(name)) => {
                let means = self.means.iter().find(|means| means.name == *name).map(differences);
                return format!(
                    "differs: the mean of {name} is outside its interval{}",
                    means.unwrap_or_default()
                );
            }
            Some(DecidedBy::Negative) => {
                return "differs: radiance is never negative, and that of theirs is".to_owned();
            }
            None => {}
        }
        match (self.decision, self.fixed, *pictures > 1) {
            (Decision::Agrees, true, _) => {
                "agrees: no value differs by more than rounding".to_owned()
            }
            (Decision::Agrees, _, true) => {
                format!("agrees: no object and no large tile of {pictures} pictures differs")
            }
            (Decision::Agrees, ..) => format!(
                "agrees: {as_far} of {replicas} pictures of ours with other seeds are as far out"
            ),
            (Decision::Differs, true, _) => {
                "differs: by more than rounding, and the scene has no noise".to_owned()
            }
            (Decision::Differs, _, true) => {
                format!(
                    "differs: the means of {pictures} pictures are too far from ours for their noise"
                )
            }
            (Decision::Differs, ..) => format!(
                "differs: it is farther out than all {replicas} pictures of ours with other seeds"
            ),
            (Decision::Undecided, ..) => format!(
                "interrupted: so far, {as_far} of {replicas} pictures of ours with other seeds are as far out"
            ),
        }
    }

    fn margin(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some((margin, answer)) = self.margin else { return Ok(()) };
        writeln!(f, "margin of {}: {}", percent::short(margin), answer.words())?;
        for means in self.means.iter().filter(|it| it.is_beyond(margin)) {
            writeln!(f, "  {}{}", means.name, and_differences(means))?;
        }
        Ok(())
    }

    fn explanation(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(Explanation { what, agrees, is_gain }) = &self.explained {
            let rest = if *agrees { "it agrees but for that" } else { "it differs beyond that" };
            writeln!(f, "explained: {what}; {rest}")?;
            if *is_gain {
                writeln!(
                    f,
                    "  a program that has the same samples in every pixel moves all pixels together: judge three \
                     pictures with other seeds"
                )?;
            }
        }
        self.cause(f)
    }

    /// What explains the difference, or most of it.
    fn cause(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Causes { explained_by, nearest, place, tried } = &self.causes;
        for (index, cause) in explained_by.iter().enumerate() {
            let or = match index {
                0 => "cause: the picture agrees with ours if",
                _ => "  or, which this scene cannot tell apart, if",
            };
            writeln!(f, "{or} {}", because(cause))?;
        }
        if explained_by.is_empty() && *tried > 0 {
            writeln!(f, "cause: none of the {tried} known mistakes that change this picture")?;
        }
        // they explain more than what is nearest
        if let Some(Factors { factors, share }) = &self.factors {
            let share = 100.0 * share;
            writeln!(f, "factors: these explain {share:.0} % of the difference")?;
            factors.iter().try_for_each(|factor| writeln!(f, "  {factor}"))?;
        }
        if let Some(Nearest { cause, share, interval }) = nearest {
            let [share, low, high] =
                [*share, interval[0].max(0.0), interval[1]].map(|it| 100.0 * it);
            writeln!(
                f,
                "nearest: that {} explains {share:.0} % ({low:.0} … {high:.0} %) of the difference",
                because(cause)
            )?;
        }
        if let Some(place) = place {
            write!(f, "{place}")?;
        }
        Ok(())
    }

    fn places(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.regions.is_empty() {
            writeln!(f, "where:")?;
        }
        self.regions.iter().try_for_each(|region| writeln!(f, "  {region}"))
    }

    fn power(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (found, title) in [(true, "would have been seen"), (false, "would not have been seen")]
        {
            let plants = self.plants.iter().filter(|plant| plant.found == found);
            let names: Vec<&str> = plants.map(|plant| plant.what.as_str()).collect();
            if !names.is_empty() {
                writeln!(f, "{title}, with {} pictures: {}", self.replicas, names.join("; "))?;
            }
        }
        let gain = |(side, gain): &(usize, Option<f64>)| {
            Some(format!("{side}×{side}: {}", percent::short((*gain)?)))
        };
        let gains: Vec<String> = self.gains.iter().filter_map(gain).collect();
        if !gains.is_empty() {
            writeln!(f, "the smallest gain in a tile that stands out: {}", gains.join(", "))?;
        }
        Ok(())
    }
}

impl fmt::Display for Region {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, bounds: [x, y, w, h], z, ours, theirs, worst: [wx, wy] } = self;
        let z = z.map_or(String::new(), |z| format!("{z:+.1} standard deviations, "));
        let [theirs, ours] = [*theirs, *ours].map(color);
        write!(f, "{name} in {x},{y},{w}x{h}: {z}{theirs}, ours {ours}, the worst at {wx},{wy}")
    }
}

/// The words of a cause, and in brackets where to read more.
fn because(Cause { name, words, chapter }: &Cause) -> String {
    match (name, chapter) {
        (Some(name), Some(chapter)) => format!("{words} ({name}, ch. {chapter})"),
        _ => words.clone(),
    }
}

impl fmt::Display for Factor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [times, error] = [self.factor, self.error].map(brief);
        let meaning = self.meaning().map_or(String::new(), |name| format!(": {name}"));
        let terms = self.terms.join(" and ");
        write!(f, "{terms} counts {times} ± {error} of ours{meaning}")
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let share = 100.0 * self.share;
        let of = match &self.material {
            Some(material) => format!(", of material {material} ({})", self.about),
            None => String::new(),
        };
        let (how_much, objects) = (self.how_much(), self.objects.join(", "));
        writeln!(f, "{how_much} in {objects}{of}: {share:.0} % of the difference")?;
        let Some(factors) = &self.factors else { return Ok(()) };
        let counts: Vec<String> = factors.iter().map(Factor::to_string).collect();
        writeln!(f, "  there {}", counts.join(", "))
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

fn color(channels: [f64; 3]) -> String {
    format!("({})", channels.map(brief).join(", "))
}
