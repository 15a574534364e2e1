//! A picture held against ours, its values stored in each way that is possible; and what is tried when it differs.

use std::mem::take;
use std::ops::Deref;

use groundtruth::film::Film;
use groundtruth::samplers;
use groundtruth::world::World;

use super::hopeless::{is_hopeless, steps};
use super::planted::brighter;
use super::sampling::Sampling;
use super::{
    Area, Areas, Case, Decision, Evaluation, Exclusion, Explanation, Finding, PlantedDefect,
    PoolContext, Progress, Replicas, Stored, is_alike, is_nearer, noise, planted,
};
use pictures::compare::Picture;

/// The gain that is planted everywhere, and the one in an object.
const PLANTED: [f64; 2] = [1.02, 1.05];

/// Objects in which a defect is planted have at least so many pixels.
const SEEN: u32 = 100;

/// So few of ours refute a way to store values.
const FEW: usize = 4;

/// A plant makes the picture at least this many times as bright.
const LEAST_GAIN: f64 = 1.0001;

/// Pictures with samples alike in all pixels are tried if ours with such are at most so far from theirs, as a part of the
/// distance of our usual ones: a wrong picture is nearer to some of them by chance.
const ALIKE: f64 = 0.9;

/// How pictures are judged.
#[derive(Clone, Copy)]
pub(super) struct Judge<'a> {
    pub areas: &'a Areas,
    pub case: Case<'a>,
}

impl<'a> Deref for Judge<'a> {
    type Target = Case<'a>;

    fn deref(&self) -> &Self::Target {
        &self.case
    }
}

impl Judge<'_> {
    /// The same, if pictures encode radiance as they are read in this way.
    pub fn reading(self, way: Stored) -> Self {
        let transfer = way.transfer().or(self.transfer);
        Self { case: Case { transfer, ..self.case }, ..self }
    }

    /// Tells a preliminary verdict, held against the first replicas. If the noise of the picture is unlike theirs, ours is
    /// made of independent samples if that is nearer to it; whether it is.
    pub fn match_noise(&self, theirs: &Picture, replicas: &mut Replicas<'_, '_>) -> bool {
        let count = replicas.films.len();
        if count < self.strictness.first {
            return false;
        }
        let judged = self.likeliest(theirs, &replicas.films, Evaluation::now);
        if !judged.is_fixed {
            (self.so_far)(Progress::Preliminary(&judged));
        }
        let before = judged.ranking.noise[count];
        if replicas.world.samples_per_pixel() == 1 || is_alike(before) {
            return false;
        }
        let (former, next) = (take(&mut replicas.films), replicas.next);
        let usual = replicas.world.image.sampler.replace(samplers::Random {}.into());
        replicas.next = replicas.first;
        replicas.fill(count);
        let is_nearer = replicas.films.len() == count
            && is_nearer(self.likeliest(theirs, &replicas.films, noise), before);
        if !is_nearer {
            replicas.world.image.sampler = usual;
            (replicas.films, replicas.next) = (former, next);
        }
        is_nearer
    }

    /// What is found of a picture and ours, their values stored in the likeliest way.
    fn likeliest<T>(
        &self,
        theirs: &Picture,
        films: &[Film],
        find: impl Fn(&[f32], PoolContext<'_>, &[Vec<f32>]) -> T,
    ) -> T {
        let stored = self.ways(theirs, films)[0];
        let known = stored.all(films);
        let subject = PoolContext { areas: self.areas, stored, reference: None };
        find(&read(theirs, stored), subject, &known)
    }

    /// The picture judged, stored in the likeliest way; if it differs so, in the other ways that its values leave open.
    pub fn judged(&self, theirs: &Picture, replicas: &mut Replicas<'_, '_>) -> Option<Finding> {
        if replicas.films.len() < 3 {
            return None;
        }
        let mut ways = self.ways(theirs, &replicas.films);
        let films = &replicas.films[..replicas.films.len().min(FEW)];
        let is_hopeless = |way: &Stored| {
            (self.is_over)() || self.is_hopeless_as(*way, theirs, replicas.world, films)
        };
        let first = ways[0];
        ways.retain(|way| *way == first || !is_hopeless(way));
        let is_last = |way: usize| way + 1 == ways.len();
        let attempts = ways
            .iter()
            .enumerate()
            .map_while(|(way, stored)| self.judged_as(theirs, *stored, replicas, !is_last(way)));
        better(attempts)
    }

    /// The picture judged, stored in one way; `keeps` our films for the next.
    pub fn judged_as(
        &self,
        theirs: &Picture,
        stored: Stored,
        replicas: &mut Replicas<'_, '_>,
        keeps: bool,
    ) -> Option<Finding> {
        let mut known = stored.all(&replicas.films);
        let slack = stored.slack(&replicas.films[0]);
        let mut values = read(theirs, stored);
        // it is no mean of pictures whose film points are off
        let reference = self.reference.filter(|_| replicas.direction == [0, 0]);
        let exclusion = Exclusion { world: replicas.world, stored, tolerance: self.tolerance };
        let apart = exclusion.exclude(&mut values, &known);
        let next = |so_far: Option<&Evaluation>| {
            so_far.into_iter().for_each(|judged| (self.so_far)(Progress::Judged(judged)));
            let film = replicas.render()?;
            let values = stored.values(&film);
            if keeps {
                replicas.films.push(film);
            }
            Some(values)
        };
        let subject = PoolContext { areas: self.areas, stored, reference };
        let judged = Evaluation::of(&values, subject, self.strictness, &mut known, next)?;
        let shown = (read(theirs, stored), apart);
        let context = (self.areas, self.strictness);
        Some(Finding::of(judged, context, shown, &slack, theirs))
    }

    /// The samples that are alike in all pixels with which ours are nearest to the picture, if it agrees with these.
    pub fn alike_in_all_pixels(
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
        let (own, next) = (replicas.world.samples_per_pixel(), replicas.next);
        let farthest = ALIKE * apart(replicas.films.first()?);
        let found = replicas.aside(|replicas| {
            let mut nearest: Option<(f64, Sampling, Film)> = None;
            for candidate in Sampling::candidates(own) {
                if candidate.is_that_of(replicas) {
                    continue;
                }
                let film = candidate.film(replicas).filter(|_| !(self.is_over)());
                let Some(film) = film else { break };
                let distance = apart(&film);
                if distance < nearest.as_ref().map_or(farthest, |nearest| nearest.0) {
                    nearest = Some((distance, candidate, film));
                }
            }
            let (_, candidate, film) = nearest?;
            candidate.resume(replicas, film);
            self.agrees(theirs, replicas)?.then_some(candidate)
        });
        replicas.next = next;
        replicas.world.reseed(next - 1);
        let what = found?.words(own);
        Some(Explanation { what, agrees: true, is_gain: false })
    }

    /// Whether the picture agrees with these replicas, of which few are rendered if these refute it; `None` if the user
    /// interrupts.
    pub fn agrees(&self, theirs: &Picture, replicas: &mut Replicas<'_, '_>) -> Option<bool> {
        for count in steps(self.strictness) {
            replicas.fill(count);
            if self.is_hopeless(theirs, replicas.world, replicas.films.get(..count)?) {
                return Some(false);
            }
        }
        replicas.fill(self.strictness.first);
        // what is known of an explanation is not what is known of the picture
        let silent = Self { case: Case { so_far: &|_| {}, ..self.case }, ..*self };
        Some(silent.judged(theirs, replicas)?.decision == Decision::Agrees)
    }

    /// Whether the picture is too far out to agree with more replicas, however its values are stored.
    fn is_hopeless(&self, theirs: &Picture, world: &World, films: &[Film]) -> bool {
        self.ways(theirs, films)
            .into_iter()
            .all(|way| self.is_hopeless_as(way, theirs, world, films))
    }

    /// The same, if its values are stored in one way.
    fn is_hopeless_as(&self, way: Stored, theirs: &Picture, world: &World, films: &[Film]) -> bool {
        let subject = PoolContext { areas: self.areas, stored: way, reference: None };
        let exclusion = Exclusion { world, stored: way, tolerance: self.tolerance };
        is_hopeless(read(theirs, way), exclusion, subject, &way.all(films))
    }

    /// Whether defects in our first replica are found.
    pub fn planted_defects(
        &self,
        replicas: &mut Replicas<'_, '_>,
        judged: &Evaluation,
    ) -> Vec<PlantedDefect> {
        let (areas, pool, from) = (self.areas, &judged.pool, if judged.is_coarse { 2 } else { 0 });
        let found = |film: &Film| planted(pool.stored.values(film), pool, areas, from);
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
            let shifted = replicas.aside(|replicas| {
                (replicas.direction, replicas.next) = ([1, 1], replicas.next + 1);
                replicas.render()
            });
            let what = "half a pixel off".to_owned();
            plants.extend(shifted.map(|film| PlantedDefect { what, found: found(&film) }));
        }
        plants
    }
}

/// The first that does not differ; else the first.
pub(super) fn better(all: impl Iterator<Item = Finding>) -> Option<Finding> {
    let mut first = None;
    for one in all {
        if one.decision != Decision::Differs {
            return Some(one);
        }
        first.get_or_insert(one);
    }
    first
}

/// The radiance of a picture whose values are stored in this way.
pub(super) fn read(picture: &Picture, stored: Stored) -> Vec<f32> {
    picture.values.as_flattened().iter().map(|value| stored.read(*value)).collect()
}
