//! What is said of a picture, as data.

use groundtruth::explain::count;
use serde::Serialize;

use pictures::compare::{Affected, Picture};

use super::pictures_shown::{Shown, ShownPictures};
use super::reason::Reason;

use super::{
    Answer, Area, Areas, Causes, Decision, DifferingArea, Evaluation, Map, Means, Negative,
    PlantedDefect, Pool, Ranking, Stored, Strictness, WelchTest,
};

/// What is said of a picture.
#[derive(Clone, Debug, Serialize)]
pub struct Verdict {
    /// `agrees`, `differs` or `undecided`.
    pub decision: Decision,
    /// What decided, if it was nothing else that `differs`.
    pub decided_by: Option<DecidedBy>,
    /// The negative values of theirs.
    pub negative: Option<Negative>,
    /// What was assumed of how the picture stores its values.
    pub assumed: String,
    /// The same as data.
    #[serde(skip)]
    pub stored: Stored,
    /// The number of pictures that were judged.
    pub pictures: usize,
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
    /// The number of our pictures in the mean that it was held against, if that was rendered before.
    pub reference: Option<u64>,
    /// The level at which it was decided.
    pub level: f64,
    /// Whether the scene has no random numbers that show.
    pub fixed: bool,
    /// The number of pixels that were set apart: all of ours agree there, and a correct picture need not.
    pub set_apart: usize,
    /// A relative margin for the means, and whether they are within it.
    pub margin: Option<(f64, Answer)>,
    /// The object that differs most, if the picture does.
    pub affected: Option<Affected>,
    /// Where it differs.
    pub regions: Vec<DifferingRegion>,
    /// The change that explains the difference.
    pub explained: Option<Explanation>,
    /// The known mistakes that explain the difference.
    pub causes: Causes,
    /// Whether nothing says how the picture encodes radiance, so that it is read as it fits best.
    pub is_guessed: bool,
    /// Of a JPEG that agrees no further, by how many steps of 1/255 the means of its blocks may be off.
    pub loss: Option<f64>,
    /// Defects that would have been found or not.
    pub plants: Vec<PlantedDefect>,
    /// For tiles of each side, the gain that would stand out.
    pub gains: Vec<(usize, Option<f64>)>,
    /// The pictures.
    #[serde(skip)]
    pub shown: ShownPictures,
}

/// What alone decided that a picture differs.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum DecidedBy {
    /// The mean of this area, outside the interval that noise and rounding leave.
    Mean(String),
    /// A negative value.
    Negative,
}

/// A simple change that explains a difference.
#[derive(Clone, Debug, Serialize)]
pub struct Explanation {
    /// What is different about the picture.
    pub what: String,
    /// Whether it agrees but for that.
    pub agrees: bool,
    /// Whether it is a factor of all radiance.
    pub is_gain: bool,
}

/// A region in which a picture differs.
#[derive(Clone, Debug, Serialize)]
pub struct DifferingRegion {
    /// Where: a tile, an object, or pixels.
    pub name: String,
    /// Left column, top row, columns and rows of the box around it.
    pub bounds: [usize; 4],
    /// In standard deviations; `None` where all our pictures agree.
    pub z: Option<f64>,
    /// The mean of our pictures: red, green, blue.
    pub ours: [f64; 3],
    /// The mean of theirs.
    pub theirs: [f64; 3],
    /// The pixel that is farthest out: x right and y down, from 0.
    pub worst: [usize; 2],
}

impl Verdict {
    /// That of a judgement; `slack` is that of our values ([`Stored::slack`]).
    pub fn of(
        judged: &Evaluation,
        areas: &Areas,
        strictness: Strictness,
        shown: Shown<'_>,
        slack: &[f64],
    ) -> Self {
        let noise = judged.ranking.noise[judged.pool.count() - 1];
        let confidence = 1.0 - strictness.level;
        let means = Means::of((&judged.pool, shown.values), areas, (noise, slack), confidence);
        Self::new(judged, areas, strictness, shown, means).weighed(&judged.pool, areas)
    }

    /// That of a judgement with these means; nothing else is known yet.
    fn new(
        judged: &Evaluation,
        areas: &Areas,
        strictness: Strictness,
        shown: Shown<'_>,
        means: Vec<Means>,
    ) -> Self {
        let theirs = judged.pool.count() - 1;
        let noise = judged.ranking.noise[theirs];
        let pictures = ShownPictures::of(&judged.pool, areas, noise, shown);
        let differs = judged.decision == Decision::Differs;
        Self {
            affected: if differs { pictures.affected(areas) } else { None },
            decision: judged.decision,
            decided_by: None,
            negative: None,
            assumed: judged.pool.stored.to_string(),
            stored: judged.pool.stored,
            pictures: 1,
            equal_to_seed: None,
            means,
            noise,
            coarse: judged.is_coarse,
            independent: false,
            replicas: theirs,
            as_far: judged.ranking.as_far_as(theirs),
            reference: judged.pool.reference().map(|mean| mean.pictures as u64),
            level: strictness.level,
            fixed: judged.is_fixed,
            set_apart: shown.excluded.len(),
            margin: None,
            regions: Vec::new(),
            explained: None,
            causes: Causes::default(),
            is_guessed: false,
            loss: None,
            plants: Vec::new(),
            gains: Vec::new(),
            shown: pictures,
        }
    }

    /// Says also whether the means of the picture and of its objects are within a relative margin of ours.
    pub fn hold_to(&mut self, margin: f64) {
        // a picture with the same bits is within any margin; intervals allow for rounding and may be wider
        let answer = match self.equal_to_seed {
            Some(_) => Answer::Agrees,
            None => Means::within(&self.means, margin),
        };
        self.margin = Some((margin, answer));
        let printed = self.means.iter().filter(|it| it.is_beyond(margin));
        let outside = printed.filter(|it| it.is_outside()).map(|it| it.name.clone()).next();
        if let Some(name) = outside.filter(|_| self.decision == Decision::Agrees) {
            self.decide(DecidedBy::Mean(name));
        }
    }

    /// Says why the picture differs.
    pub(super) fn explain(&mut self, reason: Reason) {
        let Reason { explained, causes, is_guessed, way: _ } = reason;
        (self.explained, self.causes) = (explained, causes);
        let agrees = self.explained.as_ref().is_some_and(|it| it.agrees);
        // a complete explanation replaces a partial one
        if agrees {
            (self.causes.nearest, self.causes.place) = (None, None);
        } else if !self.causes.explained_by.is_empty() {
            self.explained = None;
        }
        self.is_guessed = is_guessed && !agrees && self.causes.explained_by.is_empty();
    }

    /// That of a picture with the bits of our picture of this seed.
    #[must_use]
    pub fn equal(self, seed: u64) -> Self {
        let (decision, equal_to_seed) = (Decision::Agrees, Some(seed));
        Self {
            decision,
            equal_to_seed,
            decided_by: None,
            affected: None,
            regions: Vec::new(),
            ..self
        }
    }

    fn decide(&mut self, by: DecidedBy) {
        (self.decision, self.decided_by) = (Decision::Differs, Some(by));
    }

    /// With its means weighed: no picture agrees while a mean lies outside its interval. Where there is noise, that is
    /// the mean of the whole picture, so that the intervals of many objects add no false alarms.
    fn weighed(mut self, pool: &Pool, areas: &Areas) -> Self {
        let count = if self.fixed { self.means.len() } else { 1 };
        let outside = self.means[..count].iter().position(Means::is_outside);
        if let Some(outside) = outside.filter(|_| self.decision == Decision::Agrees) {
            self.decide(DecidedBy::Mean(self.means[outside].name.clone()));
            let whole = || (0..areas.object_of.len()).collect();
            let object = |object| areas.pixels(Area::Object(object));
            let pixels = outside.checked_sub(1).map_or_else(whole, object);
            let shown = self.shown.theirs.values.as_flattened();
            self.regions.push(DifferingRegion::of_pixels(pool, areas, &pixels, shown));
        }
        self
    }

    /// With the negative values of theirs weighed: radiance is never negative.
    pub fn weigh_negative(&mut self, theirs: &[Picture], pool: &Pool, areas: &Areas) {
        let mean = self.means.first().map_or(0.0, |whole| whole.ours.iter().sum::<f64>() / 3.0);
        let ours = (0..pool.count() - 1).flat_map(|picture| pool.picture(picture));
        let lowest = ours.fold(0.0, |lowest: f32, value| lowest.min(*value));
        self.negative = Negative::of(theirs, (lowest, mean));
        let Some(Negative { counts: true, at: [x, y], .. }) = self.negative else { return };
        if self.decision != Decision::Differs {
            self.decide(DecidedBy::Negative);
            let pixel = y * areas.size[0] + x;
            let shown = self.shown.theirs.values.as_flattened();
            self.regions.push(DifferingRegion::of_pixels(pool, areas, &[pixel], shown));
        }
    }
}

impl Verdict {
    /// That of several pictures by Welch's tests; `pictures` are so many of ours, and then theirs.
    pub fn of_several(
        (stored, areas, strictness): (Stored, &Areas, Strictness),
        (pictures, ours): (&[Vec<f32>], usize),
        theirs_as_read: &[Picture],
        tests: &[WelchTest],
        slack: &[f64],
    ) -> Self {
        let is_off = |test: &WelchTest| test.probability <= strictness.level;
        let theirs = pictures.len() - ours;
        let mean = (0..pictures[0].len()).map(|at| {
            let sum: f64 = pictures[ours..].iter().map(|picture| f64::from(picture[at])).sum();
            (sum / theirs as f64) as f32
        });
        let with_mean = pictures[..ours].iter().cloned().chain([mean.collect()]).collect();
        let pool = Pool::new(areas.size, stored, with_mean);
        let ranking = Ranking::of(&pool, areas, 0);
        let decision = match tests.iter().any(is_off) {
            true => Decision::Differs,
            false => Decision::Agrees,
        };
        let judged = Evaluation { pool, ranking, decision, is_fixed: false, is_coarse: false };
        let pool = &judged.pool;
        let shown = Shown { values: pool.picture(ours), excluded: &[] };
        let mut regions: Vec<DifferingRegion> = Vec::new();
        let mut taken = vec![false; areas.object_of.len()];
        for test in tests.iter().filter(|test| is_off(test)) {
            let pixels = areas.pixels(test.area);
            if regions.len() < REGIONS && !pixels.iter().any(|pixel| taken[*pixel]) {
                pixels.iter().for_each(|pixel| taken[*pixel] = true);
                regions.push(DifferingRegion::of_pixels(pool, areas, &pixels, shown.values));
            }
        }
        let both = [&pictures[ours..], &pictures[..ours]];
        let means = Means::of_several(both, (pool, slack), areas, 1.0 - strictness.level);
        let known = Self::new(&judged, areas, strictness, shown, means);
        let verdict = Self { pictures: theirs, as_far: 0, regions, ..known };
        let mut verdict = verdict.weighed(pool, areas);
        verdict.weigh_negative(theirs_as_read, pool, areas);
        verdict
    }
}

/// Regions that are listed at most.
pub(super) const REGIONS: usize = 8;

impl DifferingRegion {
    /// An area, with its pixel that is farthest out; `shown` is the picture as it is in the file.
    pub fn of_area(
        pool: &Pool,
        areas: &Areas,
        map: &Map,
        (difference, shown): (DifferingArea, &[f32]),
    ) -> Self {
        let pixels = areas.pixels(difference.area);
        let z = map.pixels();
        let worst = pixels.iter().max_by(|a, b| z[**a].abs().total_cmp(&z[**b].abs()));
        let name = match difference.area {
            Area::Object(object) => areas.objects[object].0.to_string(),
            Area::Structure(object) => format!("the fine structure of {}", areas.objects[object].0),
            Area::Tile { .. } => shown_by(areas, &pixels),
        };
        let worst = *worst.expect("an area has pixels");
        Self { z: Some(difference.z), ..Self::new(pool, &pixels, name, worst, shown) }
    }

    /// Pixels in which all our pictures agree against it; `shown` is the picture as it is in the file.
    pub fn of_pixels(pool: &Pool, areas: &Areas, pixels: &[usize], shown: &[f32]) -> Self {
        let theirs = pool.count() - 1;
        let apart = |pixel: usize| {
            let values = (3 * pixel..3 * pixel + 3)
                .map(|at| f64::from(pool.picture(theirs)[at]) - pool.mean_of_others(theirs, at));
            values.map(f64::abs).fold(0.0, f64::max)
        };
        let worst = pixels.iter().max_by(|a, b| apart(**a).total_cmp(&apart(**b)));
        let worst = *worst.expect("there are pixels");
        let name = format!("{} of {}", count(pixels.len(), "pixel"), shown_by(areas, pixels));
        Self::new(pool, pixels, name, worst, shown)
    }

    fn new(pool: &Pool, pixels: &[usize], name: String, worst: usize, shown: &[f32]) -> Self {
        let (theirs, width, count) = (pool.count() - 1, pool.size[0], pixels.len() as f64);
        let mean = |value: &dyn Fn(usize) -> f64, channel: usize| {
            pixels.iter().map(|pixel| value(3 * pixel + channel)).sum::<f64>() / count
        };
        let of_ours = |at| pool.mean_of_others(theirs, at);
        let of_theirs = |at: usize| f64::from(shown[at]);
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
