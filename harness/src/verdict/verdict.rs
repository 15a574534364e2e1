//! What is said of a picture, as data and as text.

use std::fmt;

use groundtruth::explain::count;
use serde::Serialize;

use super::{
    Area, Areas, Cause, Causes, Decision, Difference, Factor, Judged, Map, Means, Plant, Pool,
    Stored, Strictness,
};

/// What is said of a picture.
#[derive(Clone, Debug, Serialize)]
pub struct Verdict {
    /// `agrees`, `differs` or `undecided`.
    pub decision: Decision,
    /// What was assumed of how the picture stores its values.
    pub assumed: String,
    /// The seed of the replica that has the same bits.
    pub equal_to_seed: Option<u64>,
    /// The means of the picture and of its objects.
    pub means: Vec<Means>,
    /// The noise of its pixels, relative to ours.
    pub noise: f64,
    /// Whether single pixels and pairs of them were left out, because the noise is unlike ours.
    pub coarse: bool,
    /// Whether ours are made of independent samples, because the noise is nearer to that of these.
    pub independent: bool,
    /// The number of our pictures that it was held against.
    pub replicas: usize,
    /// The number of these that are at least as far out.
    pub as_far: usize,
    /// The level at which it was decided.
    pub level: f64,
    /// Whether the scene has no random numbers that show.
    pub fixed: bool,
    /// Pixels on edges that were set apart.
    pub edges: usize,
    /// Where it differs.
    pub regions: Vec<Region>,
    /// The change that explains the difference, and whether the picture agrees after it.
    pub explained: Option<(String, bool)>,
    /// The terms of which the picture holds another multiple, if these explain it.
    pub factors: Vec<Factor>,
    /// The known mistakes that explain the difference.
    pub causes: Causes,
    /// Defects that would have been found or not.
    pub plants: Vec<Plant>,
    /// For tiles of each side, the gain that would stand out.
    pub gains: Vec<(usize, Option<f64>)>,
}

/// A region in which a picture differs.
#[derive(Clone, Debug, Serialize)]
pub struct Region {
    /// Where: a tile, an object, or pixels.
    pub name: String,
    /// Left column, top row, columns and rows of the box around it.
    pub bounds: [usize; 4],
    /// In standard deviations; `None` where all our pictures agree.
    pub z: Option<f64>,
    /// The mean of our pictures: red, green, blue, as stored.
    pub ours: [f64; 3],
    /// The mean of theirs.
    pub theirs: [f64; 3],
    /// The pixel that is farthest out: x right and y down, from 0.
    pub worst: [usize; 2],
}

impl Verdict {
    /// That of a judgement.
    pub fn of(
        stored: Stored,
        judged: &Judged,
        areas: &Areas,
        strictness: Strictness,
        edges: usize,
    ) -> Self {
        let theirs = judged.pool.len() - 1;
        let noise = judged.ranking.noise[theirs];
        Self {
            decision: judged.decision,
            assumed: stored.to_string(),
            equal_to_seed: None,
            means: Means::of(&judged.pool, areas, noise, 1.0 - strictness.level),
            noise,
            coarse: judged.is_coarse,
            independent: false,
            replicas: theirs,
            as_far: judged.ranking.as_far_as(theirs),
            level: strictness.level,
            fixed: judged.is_fixed,
            edges,
            regions: Vec::new(),
            explained: None,
            factors: Vec::new(),
            causes: Causes::default(),
            plants: Vec::new(),
            gains: Vec::new(),
        }
    }

    /// That of a picture with the bits of one of ours.
    pub fn equal(stored: Stored, seed: u64, judged: &Judged, areas: &Areas) -> Self {
        let strictness = Strictness { level: 0.01, first: judged.pool.len() };
        let verdict = Self::of(stored, judged, areas, strictness, 0);
        Self { decision: Decision::Agrees, equal_to_seed: Some(seed), ..verdict }
    }
}

impl Region {
    /// An area, with its pixel that is farthest out.
    pub fn of_area(pool: &Pool, areas: &Areas, map: &Map, difference: Difference) -> Self {
        let pixels = areas.pixels(difference.area);
        let z = map.pixels();
        let worst = pixels.iter().max_by(|a, b| z[**a].abs().total_cmp(&z[**b].abs()));
        let name = match difference.area {
            Area::Object(object) => areas.objects[object].0.to_string(),
            Area::Tile { .. } => shown_by(areas, &pixels),
        };
        let worst = *worst.expect("an area has pixels");
        Self { z: Some(difference.z), ..Self::new(pool, areas, &pixels, name, worst) }
    }

    /// Pixels in which all our pictures agree against it.
    pub fn of_pixels(pool: &Pool, areas: &Areas, pixels: &[usize]) -> Self {
        let theirs = pool.len() - 1;
        let apart = |pixel: usize| {
            let values = (3 * pixel..3 * pixel + 3)
                .map(|at| f64::from(pool.picture(theirs)[at]) - pool.mean_of_others(theirs, at));
            values.map(f64::abs).fold(0.0, f64::max)
        };
        let worst = pixels.iter().max_by(|a, b| apart(**a).total_cmp(&apart(**b)));
        let worst = *worst.expect("there are pixels");
        let name = format!("{} of {}", count(pixels.len(), "pixel"), shown_by(areas, pixels));
        Self::new(pool, areas, pixels, name, worst)
    }

    fn new(pool: &Pool, areas: &Areas, pixels: &[usize], name: String, worst: usize) -> Self {
        let (theirs, width, count) = (pool.len() - 1, areas.size[0], pixels.len() as f64);
        let mean = |value: &dyn Fn(usize) -> f64, channel: usize| {
            pixels.iter().map(|pixel| value(3 * pixel + channel)).sum::<f64>() / count
        };
        let of_ours = |at| pool.mean_of_others(theirs, at);
        let of_theirs = |at: usize| f64::from(pool.picture(theirs)[at]);
        let along = |of: fn(usize, usize) -> usize| {
            let all = || pixels.iter().map(|pixel| of(*pixel, width));
            let [least, most] =
                [all().min(), all().max()].map(|end| end.expect("there are pixels"));
            [least, most - least + 1]
        };
        let [[x, w], [y, h]] = [along(|at, width| at % width), along(|at, width| at / width)];
        Self {
            name,
            bounds: [x, y, w, h],
            z: None,
            ours: [0, 1, 2].map(|channel| mean(&of_ours, channel)),
            theirs: [0, 1, 2].map(|channel| mean(&of_theirs, channel)),
            worst: [worst % width, worst / width],
        }
    }
}

/// The object that most of these pixels show.
fn shown_by(areas: &Areas, pixels: &[usize]) -> String {
    let mut counts = vec![0_usize; areas.objects.len()];
    pixels.iter().for_each(|pixel| counts[areas.object_of[*pixel] as usize] += 1);
    let most = (0..counts.len()).max_by_key(|object| counts[*object]).unwrap_or_default();
    areas.objects[most].0.to_string()
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "assumed: {}", self.assumed)?;
        if let Some(seed) = self.equal_to_seed {
            return writeln!(f, "agrees: it is our picture with --seed {seed}, bit for bit");
        }
        if let Some(whole) = self.means.first() {
            writeln!(
                f,
                "mean: {}, ours {}{}",
                brief(whole.theirs),
                brief(whole.ours),
                apart(whole)
            )?;
        }
        if !self.fixed {
            let noise = self.noise;
            let note = if self.coarse {
                ": unlike ours, so areas below 4 × 4 pixels were left out"
            } else {
                ""
            };
            writeln!(f, "noise: {noise:.2} of that of our pictures{note}")?;
        }
        if self.edges > 0 {
            let pixels = count(self.edges, "pixel");
            writeln!(f, "set apart: {pixels} on edges, where a rounding error decides")?;
        }
        match self.decision {
            Decision::Agrees if self.fixed => {
                writeln!(f, "agrees: no value differs by more than rounding")?
            }
            Decision::Agrees => writeln!(
                f,
                "agrees: {} of our {} pictures with other seeds are as far out",
                self.as_far, self.replicas
            )?,
            Decision::Undecided => writeln!(
                f,
                "interrupted: {} of {} pictures with other seeds are as far out so far",
                self.as_far, self.replicas
            )?,
            Decision::Differs if self.fixed => writeln!(f, "differs: the scene has no noise")?,
            Decision::Differs => writeln!(
                f,
                "differs: it is farther out than all {} of our pictures with other seeds",
                self.replicas
            )?,
        }
        self.explanation(f)?;
        self.power(f)
    }
}

impl Verdict {
    fn explanation(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((what, agrees)) = &self.explained {
            let rest = if *agrees {
                "the picture agrees but for that"
            } else {
                "but it differs beyond that"
            };
            writeln!(f, "explained: {what}; {rest}")?;
        }
        for factor in &self.factors {
            let meaning = factor.meaning().map_or(String::new(), |name| format!(": {name}"));
            writeln!(
                f,
                "factor: {} count {} ± {} of ours{meaning}",
                factor.terms.join(" and "),
                groundtruth::explain::brief(factor.factor),
                groundtruth::explain::brief(factor.error)
            )?;
        }
        let Causes { explained_by, tried } = &self.causes;
        for (index, Cause { words, chapter, .. }) in explained_by.iter().enumerate() {
            let or = if index == 0 {
                "cause: the picture agrees with ours if"
            } else {
                "  or, which this scene cannot tell apart, if"
            };
            writeln!(f, "{or} {words} (ch. {chapter})")?;
        }
        if explained_by.is_empty() && *tried > 0 {
            writeln!(f, "cause: none of the {tried} known mistakes that change this picture")?;
        }
        if !self.regions.is_empty() {
            writeln!(f, "where:")?;
        }
        for Region { name, bounds: [x, y, w, h], z, ours, theirs, worst: [wx, wy] } in &self.regions
        {
            let z = z.map_or(String::new(), |z| format!("{z:+.1} standard deviations, "));
            writeln!(
                f,
                "  {name} in {x},{y},{w}x{h}: {z}{} and ours {}, the worst at ({wx}, {wy})",
                brief(*theirs),
                brief(*ours)
            )?;
        }
        Ok(())
    }

    fn power(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = |found: bool| {
            let plants = self.plants.iter().filter(|plant| plant.found == found);
            plants.map(|plant| plant.what.as_str()).collect::<Vec<_>>().join("; ")
        };
        for (found, title) in [(true, "would have been seen"), (false, "would not have been seen")]
        {
            let names = names(found);
            if !names.is_empty() {
                writeln!(f, "{title}, with {} pictures: {names}", self.replicas)?;
            }
        }
        let gains: Vec<String> = self
            .gains
            .iter()
            .filter_map(|(side, gain)| Some(format!("{side}×{side}: {}", percent((*gain)?))))
            .collect();
        if !gains.is_empty() {
            writeln!(f, "the smallest gain that stands out in a tile: {}", gains.join(", "))?;
        }
        Ok(())
    }
}

fn percent(part: f64) -> String {
    match 100.0 * part {
        large if large >= 10.0 => format!("{large:.0} %"),
        small => format!("{small:.2} %"),
    }
}

/// A relative difference and its interval.
fn apart(Means { relative, half, .. }: &Means) -> String {
    let percent = |part: f64| format!("{:.2}", 100.0 * part);
    relative.map_or(String::new(), |relative| {
        let sign = if relative < 0.0 { "−" } else { "+" };
        format!(", {sign}{} % ± {} %", percent(relative.abs()), percent(*half))
    })
}

fn brief(color: [f64; 3]) -> String {
    let [r, g, b] = color.map(groundtruth::explain::brief);
    format!("({r}, {g}, {b})")
}
