//! What is found of pictures that were held against ours, before anybody asks why.

use pictures::compare::Picture;

use super::reason::Reason;
use super::residuals::mean_of;
use super::{
    Area, Areas, DecidedBy, Decision, DifferingRegion, Evaluation, Map, Means, Negative,
    PlantedDefect, Pool, Ranking, ShownPictures, Stored, Strictness, Verdict, WelchTest,
};

/// Regions that are listed at most.
const REGIONS: usize = 8;

/// One picture of theirs, or several, held against ours.
#[derive(Clone, Debug)]
pub struct Finding {
    /// Its last picture is theirs, or the mean of theirs.
    pub judged: Evaluation,
    /// What follows from all that is here.
    pub decision: Decision,
    /// What decided, if it was nothing else that `differs`.
    pub decided_by: Option<DecidedBy>,
    means: Vec<Means>,
    negative: Option<Negative>,
    /// That picture as it is in the file, three values a pixel, and the pixels that are set apart.
    shown: (Vec<f32>, Vec<usize>),
    /// Of several pictures: their number, and the areas in which they differ.
    several: Option<(usize, Vec<Area>)>,
}

/// What is known of pictures when it is known whether they differ.
#[derive(Default)]
pub(super) struct More {
    pub equal_to_seed: Option<u64>,
    pub loss: Option<f64>,
    pub independent: bool,
    pub reason: Reason,
    pub plants: Vec<PlantedDefect>,
    pub gains: Vec<(usize, Option<f64>)>,
}

impl Finding {
    /// Of a picture that was ranked among ours. It is `shown` as it is read from its file, with the pixels that are set apart;
    /// `slack` is that of our values ([`Stored::slack`]).
    pub fn of(
        judged: Evaluation,
        (areas, strictness): (&Areas, Strictness),
        shown: (Vec<f32>, Vec<usize>),
        slack: &[f64],
        theirs: &Picture,
    ) -> Self {
        let noise = judged.ranking.noise[judged.pool.count() - 1];
        let confidence = 1.0 - strictness.level;
        let means = Means::of((&judged.pool, &shown.0), None, areas, (noise, slack), confidence);
        Self::decided(judged, means, shown, std::slice::from_ref(theirs), None)
    }

    /// Of several pictures and ours, by their stored values and by these tests of them ([`super::several`]).
    pub fn of_several(
        (stored, areas, strictness): (Stored, &Areas, Strictness),
        both @ [theirs, ours]: [&[Vec<f32>]; 2],
        tests: &[WelchTest],
        slack: &[f64],
        read: &[Picture],
    ) -> Self {
        let mean: Vec<f32> = mean_of(theirs).into_iter().map(|value| value as f32).collect();
        let with_mean = ours.iter().cloned().chain([mean.clone()]).collect();
        let pool = Pool::new(areas.size, stored, with_mean);
        let ranking = Ranking::of(&pool, areas, 0);
        let differing = tests.iter().filter(|test| test.probability <= strictness.level);
        let differing: Vec<Area> = differing.map(|test| test.area).collect();
        let decision = if differing.is_empty() { Decision::Agrees } else { Decision::Differs };
        let means =
            Means::of((&pool, &mean), Some(both), areas, (1.0, slack), 1.0 - strictness.level);
        let judged = Evaluation { pool, ranking, decision, is_fixed: false, is_coarse: false };
        let several = Some((theirs.len(), differing));
        Self::decided(judged, means, (mean, Vec::new()), read, several)
    }

    /// With means and negative values weighed. No picture agrees while a mean lies outside its interval: where there is
    /// noise, that is the mean of the whole picture, so that the intervals of many objects add no false alarms. And radiance
    /// is never negative.
    fn decided(
        judged: Evaluation,
        means: Vec<Means>,
        shown: (Vec<f32>, Vec<usize>),
        theirs: &[Picture],
        several: Option<(usize, Vec<Area>)>,
    ) -> Self {
        let count = if judged.is_fixed { means.len() } else { 1 };
        let outside = means[..count].iter().find(|means| means.is_outside());
        let outside = outside.filter(|_| judged.decision == Decision::Agrees);
        let mean = means.first().map_or(0.0, |whole| whole.ours.iter().sum::<f64>() / 3.0);
        let ours = (0..judged.pool.count() - 1).flat_map(|picture| judged.pool.picture(picture));
        let lowest = ours.fold(0.0, |lowest: f32, value| lowest.min(*value));
        let negative = Negative::of(theirs, (lowest, mean));
        let counts = negative.filter(|it| it.counts && judged.decision != Decision::Differs);
        let decided_by = outside
            .map(|means| DecidedBy::Mean(means.name.clone()))
            .or(counts.map(|_| DecidedBy::Negative));
        let decision = if decided_by.is_some() { Decision::Differs } else { judged.decision };
        Self { judged, decision, decided_by, means, negative, shown, several }
    }

    /// The verdict, if nothing more is known.
    pub fn verdict(self, areas: &Areas, strictness: Strictness) -> Verdict {
        self.with(More::default(), areas, strictness)
    }

    pub(super) fn with(self, more: More, areas: &Areas, strictness: Strictness) -> Verdict {
        let judged = &self.judged;
        let theirs = judged.pool.count() - 1;
        let noise = judged.ranking.noise[theirs];
        let shown = (&*self.shown.0, &*self.shown.1);
        let shown = ShownPictures::of(&judged.pool, areas, noise, shown);
        let is_same = more.equal_to_seed.is_some();
        let affected = || shown.affected(areas);
        let agrees = is_same || more.loss.is_some();
        let has_regions = !is_same && (more.loss.is_none() || self.decided_by.is_some());
        Verdict {
            decision: if agrees { Decision::Agrees } else { self.decision },
            affected: (judged.decision == Decision::Differs && !is_same).then(affected).flatten(),
            regions: if has_regions { self.regions(areas) } else { Vec::new() },
            assumed: judged.pool.stored.to_string(),
            stored: judged.pool.stored,
            pictures: self.several.as_ref().map_or(1, |(count, _)| *count),
            equal_to_seed: more.equal_to_seed,
            noise,
            coarse: judged.is_coarse,
            independent: more.independent,
            replicas: theirs,
            as_far: if self.several.is_some() { 0 } else { judged.ranking.as_far_as(theirs) },
            reference: judged.pool.reference.as_ref().map(|mean| mean.pictures as u64),
            level: strictness.level,
            fixed: judged.is_fixed,
            set_apart: self.shown.1.len(),
            margin: None,
            explained: more.reason.explained,
            causes: more.reason.causes,
            is_guessed: more.reason.is_guessed,
            loss: more.loss,
            plants: more.plants,
            gains: more.gains,
            decided_by: self.decided_by.filter(|_| !is_same),
            negative: self.negative,
            means: self.means,
            shown,
        }
    }

    /// Where the picture differs, the farthest out first; no two regions share a pixel.
    fn regions(&self, areas: &Areas) -> Vec<DifferingRegion> {
        let (pool, shown) = (&self.judged.pool, &*self.shown.0);
        let of_pixels = |pixels: &[usize]| DifferingRegion::of_pixels(pool, areas, pixels, shown);
        match (&self.decided_by, self.judged.decision, &self.several) {
            (Some(DecidedBy::Mean(_)), ..) => {
                let outside = self.means.iter().position(Means::is_outside).unwrap_or_default();
                let whole = || (0..areas.object_of.len()).collect();
                let object = |object| areas.pixels(Area::Object(object));
                vec![of_pixels(&outside.checked_sub(1).map_or_else(whole, object))]
            }
            (Some(DecidedBy::Negative), ..) => {
                let at = self.negative.map_or([0, 0], |negative| negative.at);
                vec![of_pixels(&[at[1] * areas.size[0] + at[0]])]
            }
            (None, Decision::Differs, Some((_, differing))) => {
                let apart = areas.apart(differing.iter().map(|area| (*area, ())), REGIONS);
                apart.iter().map(|(_, pixels)| of_pixels(pixels)).collect()
            }
            (None, Decision::Differs, None) => self.ranked_regions(areas),
            _ => Vec::new(),
        }
    }

    /// The same of a picture that is farther out than all of ours.
    fn ranked_regions(&self, areas: &Areas) -> Vec<DifferingRegion> {
        let (judged, shown) = (&self.judged, &*self.shown.0);
        let theirs = judged.pool.count() - 1;
        let map = Map::of(&judged.pool, areas, theirs, judged.ranking.noise[theirs]);
        let outliers: Vec<usize> = map.outliers().collect();
        let of_outliers = || DifferingRegion::of_pixels(&judged.pool, areas, &outliers, shown);
        let mut regions = Vec::new();
        if judged.is_fixed && !outliers.is_empty() {
            regions.push(of_outliers());
        }
        let differences = judged.ranking.differences(&judged.pool, areas, theirs);
        let differences = differences.into_iter().map(|it| (it.area, it));
        for (it, _) in areas.apart(differences, REGIONS - regions.len()) {
            regions.push(DifferingRegion::of_area(&judged.pool, areas, &map, (it, shown)));
        }
        if regions.is_empty() && !outliers.is_empty() {
            regions.push(of_outliers());
        }
        regions
    }
}
