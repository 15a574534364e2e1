//! What all laws found in a log.

use std::collections::{HashMap, HashSet};

use groundtruth::math::Vector;
use groundtruth::render::Renderer;
use groundtruth::world::World;
use rayon::prelude::*;

use crate::laws::{BrokenRay, LAWS, LawReport, OF_HITS, OF_LEAVING, Passes, RayLaw, partings};
use crate::replay::{Parting, explains, parting};
use crate::traced::Traced;

/// The part of the rays of a law that is few.
const FEW: f64 = 5e-3;

/// The laws and what each found.
#[derive(Debug)]
pub struct RayVerdict {
    /// The log.
    pub traced: Traced,
    /// Each law with what it found, in the order of [`LAWS`].
    pub asked: Vec<(&'static RayLaw, LawReport)>,
    /// The known mistakes with which a tracer sends the same rays: their names, and what they do wrong.
    pub mistakes: Vec<[&'static str; 2]>,
}

/// What all laws found in a pixel.
#[derive(Clone, Copy, Debug)]
pub struct PixelVerdict {
    /// Which; `None` of a log without pixels.
    pub pixel: Option<[u32; 2]>,
    /// Its rays.
    pub rays: usize,
    /// What they break, without what follows from another finding.
    pub findings: usize,
    /// The first broken law, and the ray that breaks it.
    pub first: Option<(&'static RayLaw, usize)>,
}

/// What became of a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Some ray breaks it.
    Broken,
    /// It holds for all rays that it was asked of.
    Held,
    /// No ray has what it needs.
    NotAsked,
}

impl Outcome {
    /// All of them, in the order in which they are told.
    pub const ALL: [Self; 3] = [Self::Broken, Self::Held, Self::NotAsked];

    /// Its word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Broken => "broken",
            Self::Held => "held",
            Self::NotAsked => "not asked",
        }
    }
}

impl RayVerdict {
    /// Asks all laws.
    pub fn of(traced: Traced) -> Self {
        let mut asked: Vec<(&'static RayLaw, LawReport)> =
            LAWS.par_iter().map(|law| (law, law.ask(&traced))).collect();
        follow(&traced, &mut asked);
        Self { traced, asked, mistakes: Vec::new() }
    }

    /// Names the mistakes of some programs, each beside its name and what it does wrong, that send the rays of this log.
    pub fn name_mistakes<R: Renderer>(
        &mut self,
        programs: impl Iterator<Item = ([&'static str; 2], R)>,
    ) {
        let Some(world) = self.traced.scene_world().filter(|_| self.is_broken()) else { return };
        let trees = told_apart(partings(&self.traced, world));
        let passes = |world: &World, root: usize| {
            Passes::of(&self.traced, world, root).is_none_or(|it| it.holds())
        };
        if trees.iter().all(|(root, parted)| parted.is_none() && passes(world, *root)) {
            return;
        }
        let sends = |program: &R| {
            trees.par_iter().all(|(root, parted)| {
                passes(program.world(), *root)
                    && match parted {
                        Some(parting) => explains(program, &self.traced, (*root, parting)),
                        None => parting(&self.traced, *root, program).is_none(),
                    }
            })
        };
        self.mistakes = programs.filter(|(_, program)| sends(program)).map(|it| it.0).collect();
    }

    /// Whether some law is broken.
    pub fn is_broken(&self) -> bool {
        self.asked.iter().any(|(_, asked)| asked.outcome() == Outcome::Broken)
    }

    /// The laws of this outcome.
    pub fn of_outcome(
        &self,
        outcome: Outcome,
    ) -> impl Iterator<Item = (&'static RayLaw, &LawReport)> {
        let all = self.asked.iter().map(|(law, asked)| (*law, asked));
        all.filter(move |(_, asked)| asked.outcome() == outcome)
    }

    /// What a law found.
    pub fn report(&self, law: &RayLaw) -> Option<&LawReport> {
        self.asked.iter().find(|(asked, _)| asked.name == law.name).map(|(_, report)| report)
    }

    /// What a law lacks that was not asked: of its needs those fields are there that some ray has, as far as the first ones show.
    pub fn missing(&self, law: &RayLaw) -> Vec<&'static str> {
        const LOOKED_AT: usize = 1000;
        let rays = self.traced.log.rays.iter().take(LOOKED_AT);
        let there: HashSet<String> =
            rays.flat_map(|ray| ray.fields()).map(|(name, _)| name).collect();
        let is_there = |need: &&&str| match **need {
            "objects or a scene" => self.traced.world.is_some(),
            need => there.contains(need.split([' ', ',']).next().unwrap_or_default()),
        };
        let (_, missing): (Vec<&str>, Vec<&str>) = law.needs.iter().partition(is_there);
        if missing.is_empty() { law.needs.clone() } else { missing }
    }

    /// The findings about a ray, with their laws.
    pub fn of_ray(&self, ray: usize) -> impl Iterator<Item = (&'static RayLaw, &BrokenRay)> {
        self.asked.iter().flat_map(move |(law, asked)| {
            let first = asked.findings.partition_point(|finding| finding.ray < ray);
            let its = asked.findings[first..].iter().take_while(move |it| it.ray == ray);
            its.map(|finding| (*law, finding))
        })
    }

    /// The unit direction that a ray should have had, if it breaks a law of directions.
    pub fn expected(&self, ray: usize) -> Option<Vector> {
        self.of_ray(ray).find_map(|(_, finding)| finding.expected)
    }

    /// The pixels in the order of the log, each with its number of findings that follow from no other, and the first of them.
    pub fn pixels(&self) -> Vec<PixelVerdict> {
        let (mut pixels, mut places) = (Vec::<PixelVerdict>::new(), HashMap::new());
        for ray in &self.traced.log.rays {
            let place = *places.entry(ray.pixel).or_insert(pixels.len());
            if place == pixels.len() {
                pixels.push(PixelVerdict { pixel: ray.pixel, rays: 0, findings: 0, first: None });
            }
            pixels[place].rays += 1;
        }
        for (law, asked) in &self.asked {
            for finding in asked.roots() {
                let pixel = &mut pixels[places[&self.traced.ray(finding.ray).pixel]];
                pixel.findings += 1;
                pixel.first.get_or_insert((law, finding.ray));
            }
        }
        pixels
    }

    /// The broken law that says most, with its first finding: of those that follow from no other, the first in the list that
    /// more than a few rays break, of laws of directions and hits that which is broken earliest on a path; where only few do, the
    /// first.
    pub fn first(&self) -> Option<(&'static RayLaw, &LawReport, &BrokenRay)> {
        let broken = || {
            self.asked.iter().filter_map(|(law, asked)| Some((*law, asked, asked.roots().next()?)))
        };
        let mut common = broken().filter(|(_, asked, _)| asked.is_common()).peekable();
        let is_of_way =
            |law: &RayLaw| OF_LEAVING.contains(&law.name) || OF_HITS.contains(&law.name);
        if common.peek().is_none_or(|(law, ..)| !is_of_way(law)) {
            return common.next().or_else(|| broken().next());
        }
        let depth = |finding: &&BrokenRay| self.traced.way_up(finding.ray).count();
        let of_way = common
            .filter(|(law, ..)| is_of_way(law))
            .filter_map(|(law, asked, _)| Some((law, asked, asked.roots().min_by_key(depth)?)));
        of_way.min_by_key(|(_, _, finding)| depth(finding))
    }
}

impl LawReport {
    /// What became of the law.
    pub fn outcome(&self) -> Outcome {
        match (self.findings.is_empty(), self.rays) {
            (false, _) => Outcome::Broken,
            (true, 0) => Outcome::NotAsked,
            (true, _) => Outcome::Held,
        }
    }

    /// Whether more than a few rays break it, or all of them together.
    fn is_common(&self) -> bool {
        self.is_of_all || self.roots().count() as f64 >= FEW * self.rays as f64
    }

    /// The findings that follow from no other.
    pub fn roots(&self) -> impl Iterator<Item = &BrokenRay> {
        self.findings.iter().filter(|finding| finding.follows.is_none())
    }
}

/// Of camera rays, some of those that part and some of those that do not: they tell programs apart.
fn told_apart(trees: Vec<(usize, Option<Parting>)>) -> Vec<(usize, Option<Parting>)> {
    const OF_EACH: usize = 16;
    let (parted, others): (Vec<_>, Vec<_>) = trees.into_iter().partition(|it| it.1.is_some());
    let some = |trees: Vec<_>| {
        let step = trees.len().div_ceil(OF_EACH).max(1);
        trees.into_iter().step_by(step)
    };
    some(parted).chain(some(others)).collect()
}

/// Marks what follows from what comes before it on the path: from an earlier law that the ray itself or its sender breaks, and from
/// a wrong hit of the sender. From a normal that is none follows a wrong mirrored direction, from that a wrong hit.
fn follow(traced: &Traced, asked: &mut [(&'static RayLaw, LawReport)]) {
    let mut first: HashMap<usize, usize> = HashMap::new();
    let mut wrong_hits = HashSet::new();
    for (place, (law, asked)) in asked.iter().enumerate() {
        for finding in &asked.findings {
            first.entry(finding.ray).or_insert(place);
            wrong_hits.extend(OF_HITS.contains(&law.name).then_some(finding.ray));
        }
    }
    for (place, (law, asked)) in asked.iter_mut().enumerate() {
        let is_leaving = OF_LEAVING.contains(&law.name);
        for finding in &mut asked.findings {
            let breaks_earlier = |ray: &usize| first.get(ray).is_some_and(|&law| law < place);
            // what is no number makes all after it no number
            let is_inherited = |ray: &usize| place == 0 && first.get(ray) == Some(&0);
            let leaves_wrong_hit = |ray: &usize| is_leaving && wrong_hits.contains(ray);
            let sender = traced.parents[finding.ray];
            finding.follows = Some(finding.ray).filter(breaks_earlier).or_else(|| {
                sender
                    .filter(|ray| breaks_earlier(ray) || is_inherited(ray) || leaves_wrong_hit(ray))
            });
        }
    }
}
