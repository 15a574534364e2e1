//! Many judgements with one pool of replicas.

use super::pictures::{films, scene, with_sampler, world};
use groundtruth::film::{Film, OutOfGamut};
use groundtruth::math::Pcg32;
use groundtruth::rgb::Rgb;
use groundtruth::samplers;
use groundtruth::world::World;
use judge::verdict::{
    Areas, Bright, Decision, Evaluation, Exclusion, Finding, PoolContext, Quantiser, RayTolerance,
    Stored, Strictness, is_alike, is_nearer, noise, plausible,
};
use pictures::compare::{Picture, Transfer};

pub const LEVEL: f64 = 0.01;

pub const STRICTNESS: Strictness = Strictness { level: LEVEL, first: 8 };

pub const FLOATS: Stored = Stored::Floats { bits: 24 };

pub const BYTES: Stored = Stored::Integers {
    step: 1.0 / 255.0,
    transfer: Transfer::Srgb,
    quantiser: Quantiser::Rounded,
    bright: Bright::Clamped,
};

/// The pool from which each judgement takes its replicas, in another order.
pub struct Shared {
    pub areas: Areas,
    pub films: Vec<Film>,
    /// Of independent samples.
    independent: Vec<Film>,
}

impl Shared {
    pub fn new(name: &str, [side, samples, replicas]: [u32; 3]) -> Self {
        let random = with_sampler(scene(name, [side; 2], samples), samplers::Random {}.into());
        let independent = films(&mut world(&random, 1), (1000..).take(replicas as usize));
        Self { independent, ..Self::usual(name, [side, samples, replicas]) }
    }

    /// For pictures whose noise is ours.
    pub fn usual(name: &str, [side, samples, replicas]: [u32; 3]) -> Self {
        let mut world = world(&scene(name, [side; 2], samples), 1);
        let areas = Areas::of(&world);
        let usual = films(&mut world, (1000..).take(replicas as usize));
        Self { areas, films: usual, independent: Vec::new() }
    }

    /// The replicas in an order that follows from a seed.
    fn order(&self, seed: u64) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.films.len()).collect();
        Pcg32::new(seed, 9).shuffle(&mut order);
        order
    }

    /// Whether a picture in integers differs, its way of storing unknown: in the first way with which it does not, as `Case`
    /// tries them. The scene's picture has gamma 1 and divides by the largest channel.
    pub fn differs(&self, world: &World, theirs: &Picture, seed: u64) -> bool {
        let first: Vec<Film> = self.order(seed)[..STRICTNESS.first]
            .iter()
            .map(|index| self.films[*index].clone())
            .collect();
        let candidates = Stored::candidates(theirs, None, (1.0, OutOfGamut::MaxToOne));
        plausible(&candidates, theirs, &first).into_iter().all(|stored| {
            let values: Vec<f32> =
                theirs.values.iter().flatten().map(|it| stored.read(*it)).collect();
            let (judged, apart) = self.held(world, values.clone(), stored, seed);
            let context = (&self.areas, STRICTNESS);
            let slack = stored.slack(&first[0]);
            let found = Finding::of(judged, context, (values, apart), &slack, theirs);
            found.decision == Decision::Differs
        })
    }

    /// The verdict on a picture, with replicas in an order that follows from a seed.
    pub fn judged(&self, world: &World, theirs: &Film, stored: Stored, seed: u64) -> Evaluation {
        self.held(world, stored.values(theirs), stored, seed).0
    }

    /// The same for stored values, and the pixels that are set apart.
    fn held(
        &self,
        world: &World,
        mut theirs: Vec<f32>,
        stored: Stored,
        seed: u64,
    ) -> (Evaluation, Vec<usize>) {
        let order = self.order(seed);
        let subject = PoolContext { areas: &self.areas, stored, reference: None };
        let first = |films: &[Film]| -> Vec<Vec<f32>> {
            order[..STRICTNESS.first].iter().map(|index| stored.values(&films[*index])).collect()
        };
        let mut films = &self.films;
        let usual = noise(&theirs, subject, &first(films));
        if !self.independent.is_empty()
            && !is_alike(usual)
            && is_nearer(noise(&theirs, subject, &first(&self.independent)), usual)
        {
            films = &self.independent;
        }
        let mut known = first(films);
        let mut next = order[STRICTNESS.first..].iter().map(|index| stored.values(&films[*index]));
        let exclusion = Exclusion { world, stored, tolerance: RayTolerance::DOUBLE };
        let apart = exclusion.exclude(&mut theirs, &known);
        let judged = Evaluation::of(&theirs, subject, STRICTNESS, &mut known, |_| next.next());
        (judged.expect("enough"), apart)
    }
}

/// The film with the colour at each place made of the place and the colour there.
pub fn mapped(film: &Film, of: impl Fn([u32; 2], Rgb) -> Rgb) -> Film {
    let mut mapped = film.clone();
    for at in (0..film.height()).flat_map(|y| (0..film.width()).map(move |x| [x, y])) {
        mapped.set(at, of(at, film.get(at)));
    }
    mapped
}
