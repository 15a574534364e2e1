//! One picture of a scene, from its file to what is said of it.

use std::path::Path;

use groundtruth::film::{Film, OutOfGamut};
use groundtruth::samplers;
use groundtruth::scene::Scene;
use groundtruth::world::World;

use super::planted::brighter;
use super::sampling::Sampling;
use super::verdict::{Explanation, REGIONS, Region, Shown, Verdict};
use super::{
    Area, Areas, Decision, Evaluation, Evidence, Factors, Map, PlantedDefect, RayTolerance,
    Reference, Renders, Replicas, Stored, Strictness, Subject, Suspects, exclude, factors,
    is_alike, is_nearer, noise, planted, plausible, several, smallest_gains, terms,
};
use pictures::compare::{
    Change, Decoded, Picture, Transfer, changes_that_explain, distance_of, half_pixel_directions,
    half_pixel_words,
};

/// A scene, and how strictly its pictures are judged.
pub struct Case<'a> {
    /// The scene's world, at the size of the pictures.
    pub world: &'a mut World,
    /// The scene.
    pub scene: &'a Scene,
    /// Where the files are that it names.
    pub folder: &'a Path,
    /// Whether the user interrupted.
    pub is_interrupted: &'a dyn Fn() -> bool,
    /// Is told what is known so far, before more replicas are rendered.
    pub so_far: &'a dyn Fn(&Evaluation),
    /// How strictly.
    pub strictness: Strictness,
    /// The transfer function of pictures for display, if the user or the file says it.
    pub transfer: Option<Transfer>,
    /// The gamma of the scene's picture, and its rule for colours beyond 1.
    pub tone: (f64, OutOfGamut),
    /// The seed of the first replica.
    pub seed: u64,
    /// A mean of other pictures of ours, if one was rendered before.
    pub reference: Option<&'a Reference>,
    /// How far the rays of the other renderer may be from ours.
    pub tolerance: RayTolerance,
}

/// The gain that is planted everywhere, and the one in an object.
const PLANTED: [f64; 2] = [1.02, 1.05];

/// Objects in which a defect is planted have at least so many pixels.
const SEEN: u32 = 100;

/// A plant makes the picture at least this many times as bright.
const LEAST_GAIN: f64 = 1.0001;

/// Pictures with samples alike in all pixels are tried if ours with such are at most so far from theirs, as a part of the
/// distance of our usual ones: a wrong picture is nearer to some of them by chance.
const ALIKE: f64 = 0.9;

/// Terms are the mean of so many replicas.
const TERM_REPLICAS: u64 = 4;

impl Case<'_> {
    /// What is to be said of a picture; `None` if the user interrupted before anything could be.
    pub fn verdict(&mut self, theirs: &Picture, renders: Renders<'_>) -> Option<Verdict> {
        let areas = Areas::of(self.world);
        let (strictness, seed) = (self.strictness, self.seed);
        let (transfer, tone) = (self.transfer, self.tone);
        let mut replicas = Replicas::new(self.world, seed, renders);
        replicas.fill(strictness.first);
        let (so_far, reference, tolerance) = (self.so_far, self.reference, self.tolerance);
        let judge =
            Judge { areas: &areas, strictness, transfer, tone, so_far, reference, tolerance };
        let independent = judge.match_noise(theirs, &mut replicas);
        let Attempt { judged, mut verdict, known } = judge.judged(theirs, &mut replicas)?;
        let stored = judged.pool.stored;
        if let Some(equal) = equal_to(&replicas.films, theirs, stored) {
            return Some(verdict.equal(seed + equal as u64));
        }
        verdict.independent = independent;
        match verdict.decision {
            Decision::Differs => {
                if verdict.decided_by.is_none() {
                    let shown = verdict.shown.theirs.values.as_flattened();
                    verdict.regions = regions(&judged, &areas, shown);
                }
                verdict.explained = judge
                    .alike_in_all_pixels(theirs, &mut replicas, stored)
                    .or_else(|| judge.explained(theirs, &mut replicas, &known, stored));
                let is_harmless = |it: &Explanation| it.agrees && !it.is_gain;
                if !verdict.explained.as_ref().is_some_and(is_harmless) {
                    let evidence = Evidence::of(&judged, &areas, &read(theirs, stored));
                    let mut scene = self.scene.clone();
                    scene.image.sampler = replicas.world.image.sampler.clone();
                    let (folder, is_interrupted) = (self.folder, self.is_interrupted);
                    let world = &*replicas.world;
                    let suspects = Suspects { scene: &scene, world, folder, seed, is_interrupted };
                    verdict.causes = suspects.causes(&evidence, strictness);
                    verdict.simplify();
                    if verdict.wants_factors() {
                        let terms = terms(replicas.world, seed..seed + TERM_REPLICAS);
                        let nearest = verdict.causes.nearest.as_ref().map_or(0.0, |it| it.share);
                        let explain_more = |it: &Factors| it.share > nearest;
                        verdict.factors = factors(&terms, &evidence).filter(explain_more);
                    }
                }
            }
            Decision::Agrees if !judged.is_fixed => {
                verdict.plants = judge.planted_defects(&mut replicas, &known, &judged);
                verdict.gains = smallest_gains(&judged.pool, &areas, &judged.ranking);
            }
            _ => {}
        }
        Some(verdict)
    }
}

/// So many of ours are held against several pictures of theirs at least.
const AGAINST_SEVERAL: usize = 16;

impl Case<'_> {
    /// As [`Case::verdict_on_several`], for a scene without random numbers: each picture is judged by itself, and the
    /// first that does not agree is said.
    fn verdict_on_each(&mut self, theirs: &[Picture], renders: Renders<'_>) -> Option<Verdict> {
        let mut last = None;
        for picture in theirs {
            let verdict = self.verdict(picture, renders)?;
            if verdict.decision != Decision::Agrees {
                return Some(verdict);
            }
            last = Some(verdict);
        }
        last
    }

    /// What is to be said of several pictures of one program with other seeds: nothing is assumed of their noise.
    /// `None` if the user interrupted before anything could be.
    pub fn verdict_on_several(
        &mut self,
        theirs: &[Picture],
        renders: Renders<'_>,
    ) -> Option<Verdict> {
        let areas = Areas::of(self.world);
        let (strictness, seed) = (self.strictness, self.seed);
        let (transfer, tone) = (self.transfer, self.tone);
        let mut replicas = Replicas::new(self.world, seed, renders);
        replicas.fill(strictness.first.max(AGAINST_SEVERAL));
        if replicas.films.len() < 3 {
            return None;
        }
        if replicas.films.windows(2).all(|two| two[0] == two[1]) {
            let renders = replicas.renders;
            return self.verdict_on_each(theirs, renders);
        }
        let candidates = Stored::candidates(&theirs[0], transfer, tone);
        let films = &replicas.films;
        let verdict = |stored: Stored| {
            let mut pictures: Vec<Vec<f32>> =
                films.iter().map(|film| stored.values(film)).collect();
            let ours = pictures.len();
            pictures.extend(theirs.iter().map(|picture| read(picture, stored)));
            let tests = several(&pictures[ours..], &pictures[..ours], &areas);
            let (subject, slack) = ((stored, &areas, strictness), stored.slack(&films[0]));
            Verdict::of_several(subject, (&pictures, ours), theirs, &tests, &slack)
        };
        let ways = plausible(&candidates, &theirs[0], films);
        better(ways.into_iter().map(verdict), |verdict| verdict.decision)
    }
}

/// The first that does not differ; else the first.
fn better<T>(all: impl Iterator<Item = T>, decision: impl Fn(&T) -> Decision) -> Option<T> {
    let mut first = None;
    for one in all {
        if decision(&one) != Decision::Differs {
            return Some(one);
        }
        first.get_or_insert(one);
    }
    first
}

/// The seed, counted from the first, of a replica that has the same bits.
fn equal_to(films: &[Film], theirs: &Picture, stored: Stored) -> Option<usize> {
    let theirs = read(theirs, stored);
    films.iter().position(|film| stored.values(film) == theirs)
}

/// A picture judged, its values stored in one of the ways that are possible.
struct Attempt {
    judged: Evaluation,
    verdict: Verdict,
    /// Our replicas, stored alike.
    known: Vec<Vec<f32>>,
}

/// How pictures are judged.
struct Judge<'a> {
    areas: &'a Areas,
    strictness: Strictness,
    transfer: Option<Transfer>,
    tone: (f64, OutOfGamut),
    so_far: &'a dyn Fn(&Evaluation),
    reference: Option<&'a Reference>,
    tolerance: RayTolerance,
}

impl Judge<'_> {
    /// If their noise is unlike ours, ours is made of independent samples if that is nearer to theirs; whether it is.
    fn match_noise(&self, theirs: &Picture, replicas: &mut Replicas<'_, '_>) -> bool {
        let count = replicas.films.len();
        if count < self.strictness.first || replicas.world.samples_per_pixel() == 1 {
            return false;
        }
        let before = self.noise(theirs, &replicas.films);
        if is_alike(before) {
            return false;
        }
        let (usual, next) = (replicas.world.image.sampler.clone(), replicas.next);
        let former = replicas.resample(Some(samplers::Random {}.into()));
        let is_nearer =
            replicas.films.len() == count && is_nearer(self.noise(theirs, &replicas.films), before);
        if !is_nearer {
            replicas.world.image.sampler = usual;
            (replicas.films, replicas.next) = (former, next);
        }
        is_nearer
    }

    fn noise(&self, theirs: &Picture, films: &[Film]) -> f64 {
        let candidates = Stored::candidates(theirs, self.transfer, self.tone);
        let stored = plausible(&candidates, theirs, films)[0];
        let known: Vec<Vec<f32>> = films.iter().map(|film| stored.values(film)).collect();
        let subject = Subject { areas: self.areas, stored, reference: None };
        noise(&read(theirs, stored), subject, &known)
    }

    /// The picture judged, stored in the likeliest way; if it differs so, in the other ways that its values leave open.
    fn judged(&self, theirs: &Picture, replicas: &mut Replicas<'_, '_>) -> Option<Attempt> {
        if replicas.films.len() < 3 {
            return None;
        }
        let candidates = Stored::candidates(theirs, self.transfer, self.tone);
        let ways = plausible(&candidates, theirs, &replicas.films);
        let is_last = |way: usize| way + 1 == ways.len();
        let attempts = ways
            .iter()
            .enumerate()
            .map_while(|(way, stored)| self.judged_as(theirs, *stored, replicas, !is_last(way)));
        better(attempts, |attempt| attempt.verdict.decision)
    }

    /// The picture judged, stored in one way; `keeps` our films for the next.
    fn judged_as(
        &self,
        theirs: &Picture,
        stored: Stored,
        replicas: &mut Replicas<'_, '_>,
        keeps: bool,
    ) -> Option<Attempt> {
        let mut known: Vec<Vec<f32>> =
            replicas.films.iter().map(|film| stored.values(film)).collect();
        let slack = stored.slack(&replicas.films[0]);
        let mut values = read(theirs, stored);
        // it is no mean of pictures whose film points are off
        let reference = self.reference.filter(|_| replicas.direction == [0, 0]);
        let apart = exclude(&mut values, replicas.world, &known, stored, self.tolerance);
        let next = |so_far: Option<&Evaluation>| {
            so_far.into_iter().for_each(self.so_far);
            let film = replicas.render()?;
            let values = stored.values(&film);
            if keeps {
                replicas.films.push(film);
            }
            Some(values)
        };
        let subject = Subject { areas: self.areas, stored, reference };
        let judged = Evaluation::of(&values, subject, self.strictness, &mut known, next)?;
        let as_read = read(theirs, stored);
        let shown = Shown { values: &as_read, excluded: &apart };
        let mut verdict = Verdict::of(&judged, self.areas, self.strictness, shown, &slack);
        verdict.weigh_negative(std::slice::from_ref(theirs), &judged.pool, self.areas);
        Some(Attempt { judged, verdict, known })
    }

    /// The most harmless change that explains the difference, and whether the picture agrees after it.
    fn explained(
        &self,
        theirs: &Picture,
        replicas: &mut Replicas<'_, '_>,
        known: &[Vec<f32>],
        stored: Stored,
    ) -> Option<Explanation> {
        let mean: Vec<f32> = mean_of(known).into_iter().map(|value| value as f32).collect();
        let [mean, alike] =
            [&mean, &known[0]].map(|values| Picture::of_radiance(values, theirs.size));
        let [ours, alike_decoded] = [&mean, &alike].map(Decoded::new);
        let noise = distance_of(&ours, &alike_decoded);
        let as_theirs = Picture { transfer: transfer_of(stored, theirs), ..theirs.clone() };
        let theirs_decoded = Decoded::read_by(&as_theirs, |value| f64::from(stored.read(value)));
        let names = ["ours", "theirs"];
        let found = changes_that_explain(&ours, &theirs_decoded, noise).into_iter().next();
        if let Some((change, _)) = found {
            let what = change.words(names, as_theirs.transfer);
            let changed = change.applied(&as_theirs);
            let agrees = self.agrees(&changed, replicas);
            // a factor that is not the whole difference says little
            let is_gain = matches!(change, Change::Scaled(_));
            if agrees || !is_gain {
                return Some(Explanation { what, agrees, is_gain });
            }
        }
        let direction = half_pixel_directions(replicas.world, &as_theirs, Some(&alike)).first()?.0;
        replicas.direction = direction;
        replicas.films.clear();
        replicas.fill(self.strictness.first);
        if replicas.films.len() < self.strictness.first {
            return None;
        }
        let (what, agrees) =
            (half_pixel_words(direction, "theirs"), self.agrees(&as_theirs, replicas));
        Some(Explanation { what, agrees, is_gain: false })
    }

    /// The samples that are alike in all pixels with which ours are nearest to the picture, if it agrees with these.
    fn alike_in_all_pixels(
        &self,
        theirs: &Picture,
        replicas: &mut Replicas<'_, '_>,
        stored: Stored,
    ) -> Option<Explanation> {
        let values = read(theirs, stored);
        let apart = |film: &Film| -> f64 {
            let pairs = stored.values(film).into_iter().zip(&values);
            pairs.map(|(x, y)| f64::from((x - y).abs())).filter(|apart| apart.is_finite()).sum()
        };
        let (image, films, next) =
            (replicas.world.image.clone(), replicas.films.clone(), replicas.next);
        let own = replicas.world.samples_per_pixel();
        let farthest = ALIKE * apart(films.first()?);
        let mut nearest: Option<(f64, Sampling)> = None;
        for candidate in Sampling::candidates(own) {
            if candidate.is_that_of(replicas) {
                continue;
            }
            let Some(film) = candidate.film(replicas) else { break };
            let distance = apart(&film);
            if distance < nearest.as_ref().map_or(farthest, |nearest| nearest.0) {
                nearest = Some((distance, candidate));
            }
        }
        let agrees = |candidate: &Sampling| {
            candidate.film(replicas).is_some_and(|_| {
                replicas.fill(self.strictness.first);
                self.agrees(theirs, replicas)
            })
        };
        let found = nearest.map(|(_, candidate)| candidate).filter(agrees);
        replicas.world.image = image;
        (replicas.films, replicas.next) = (films, next);
        replicas.world.reseed(next - 1);
        let what = found?.words(own);
        Some(Explanation { what, agrees: true, is_gain: false })
    }

    fn agrees(&self, theirs: &Picture, replicas: &mut Replicas<'_, '_>) -> bool {
        let attempt = self.judged(theirs, replicas);
        attempt.is_some_and(|attempt| attempt.verdict.decision == Decision::Agrees)
    }

    /// Whether defects in our first replica are found.
    fn planted_defects(
        &self,
        replicas: &mut Replicas<'_, '_>,
        known: &[Vec<f32>],
        judged: &Evaluation,
    ) -> Vec<PlantedDefect> {
        let (areas, stored, from) =
            (self.areas, judged.pool.stored, if judged.is_coarse { 2 } else { 0 });
        let found = |film: &Film| planted(known, stored.values(film), (areas, &judged.pool), from);
        let film = &replicas.films[0];
        let percent = |factor: f64| format!("{:.0} %", 100.0 * (factor - 1.0));
        let whole = Area::Tile { corner: [0, 0], side: areas.size[0].max(areas.size[1]) };
        let mut plants = vec![PlantedDefect {
            what: format!("all {} brighter", percent(PLANTED[0])),
            found: found(&brighter(film, areas, whole, PLANTED[0])),
        }];
        let mut objects: Vec<usize> = (0..areas.objects.len()).collect();
        objects.retain(|object| areas.objects[*object].1 >= SEEN);
        objects.sort_by_key(|object| std::cmp::Reverse(areas.objects[*object].1));
        for object in objects.into_iter().take(3) {
            let what = format!("{} {} brighter", areas.objects[object].0, percent(PLANTED[1]));
            let changed = brighter(film, areas, Area::Object(object), PLANTED[1]);
            let brightness = |film: &Film| film.pixels().iter().map(|it| it.max()).sum::<f64>();
            // of an object that is black there is nothing to see
            if brightness(&changed) > LEAST_GAIN * brightness(film) {
                plants.push(PlantedDefect { what, found: found(&changed) });
            }
        }
        if replicas.world.view.stereo().is_none() {
            (replicas.direction, replicas.next) = ([1, 1], replicas.next + 1);
            if let Some(shifted) = replicas.render() {
                plants.push(PlantedDefect {
                    what: "half a pixel off".to_owned(),
                    found: found(&shifted),
                });
            }
            replicas.direction = [0, 0];
        }
        plants
    }
}

fn mean_of(all: &[Vec<f32>]) -> Vec<f64> {
    let count = all.len() as f64;
    (0..all[0].len()).map(|i| all.iter().map(|it| f64::from(it[i])).sum::<f64>() / count).collect()
}

/// The radiance of a picture whose values are stored in this way.
fn read(picture: &Picture, stored: Stored) -> Vec<f32> {
    picture.values.as_flattened().iter().map(|value| stored.read(*value)).collect()
}

fn transfer_of(stored: Stored, theirs: &Picture) -> Transfer {
    match stored {
        Stored::Integers { transfer, .. } => transfer,
        _ => theirs.transfer,
    }
}

/// Where the picture differs, the farthest out first; no two regions share a pixel.
fn regions(judged: &Evaluation, areas: &Areas, shown: &[f32]) -> Vec<Region> {
    let theirs = judged.pool.count() - 1;
    let map = Map::of(&judged.pool, areas, theirs, judged.ranking.noise[theirs]);
    let mut taken = vec![false; areas.object_of.len()];
    let mut regions = Vec::new();
    let outliers: Vec<usize> = map.outliers().collect();
    if judged.is_fixed && !outliers.is_empty() {
        regions.push(Region::of_pixels(&judged.pool, areas, &outliers, shown));
    }
    for difference in judged.ranking.differences(&judged.pool, areas, theirs) {
        let pixels = areas.pixels(difference.area);
        if regions.len() == REGIONS || pixels.iter().any(|pixel| taken[*pixel]) {
            continue;
        }
        pixels.iter().for_each(|pixel| taken[*pixel] = true);
        regions.push(Region::of_area(&judged.pool, areas, &map, (difference, shown)));
    }
    if regions.is_empty() && !outliers.is_empty() {
        regions.push(Region::of_pixels(&judged.pool, areas, &outliers, shown));
    }
    regions
}
