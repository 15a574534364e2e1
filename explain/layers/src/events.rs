//! What happens in a pixel: the first hit of its centre sample, and the events of all its samples.

use groundtruth::accel::Counts;
use groundtruth::math::{Ray, Span};
use groundtruth::render::{self, Renderer};
use groundtruth::rgb::Rgb;
use groundtruth::trace::{Outcome, RayKind, Recorder, Term, Unlimited};
use groundtruth::world::{Hit, Search, World};

use crate::terms::{Dividing, TermKey, Terms};

/// The index of a pixel's centre sample: of all its samples on the film, the nearest to the pixel's centre, and of
/// equally near ones the first. `None` in the gap of a stereo pair.
pub fn centre_sample(world: &World, pixel: [u32; 2]) -> Option<u32> {
    let samples = 0..world.samples_per_pixel();
    let off_centre = samples.filter_map(|index| {
        let sample = render::camera_sample(world, pixel, index)?;
        let centre = render::film_point(&world.image, sample.pixel, [0.5, 0.5]);
        let [dx, dy] = [0, 1].map(|axis| sample.film[axis] - centre[axis]);
        Some((index, dx * dx + dy * dy))
    });
    off_centre.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| index)
}

/// The first hit of a pixel's centre sample.
pub fn first_hit(world: &World, pixel: [u32; 2]) -> Option<Hit<'_>> {
    let sample = render::camera_sample(world, pixel, centre_sample(world, pixel)?)?;
    world.hit(&sample.ray?, Span::AHEAD)
}

/// The parts of [`Events`] that cost time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wanted {
    /// The cost of the searches.
    pub cost: bool,
    /// The terms.
    pub terms: bool,
}

/// The events of all samples of a pixel.
#[derive(Clone, Debug, Default)]
pub(crate) struct Events {
    /// The weighed radiance of each sample, times the exposure time.
    pub radiances: Vec<Rgb>,
    /// The pixel of the picture.
    pub radiance: Rgb,
    /// The number of rays, those that were too deep to be cast among them.
    pub rays: u64,
    /// The largest depth of a ray that was cast and is no shadow ray.
    pub depth: u32,
    /// The cost of the searches of all rays, shadow rays among them.
    pub cost: Counts,
    /// What each term adds to the pixel.
    pub terms: Terms,
}

impl Events {
    /// Traces all samples of a pixel.
    pub fn of(renderer: &impl Renderer, pixel: [u32; 2], wanted: Wanted) -> Self {
        let world = renderer.world();
        let (mut events, count) = (Self::default(), world.samples_per_pixel());
        for index in 0..count {
            let terms = wanted.terms.then(Dividing::default);
            let (cost, events_so_far) = (wanted.cost, &mut events);
            let mut recorder = Listening { world, events: events_so_far, cost, terms, last: 0 };
            let radiance = renderer.sample(pixel, index, &mut recorder, &mut Unlimited);
            let terms = recorder.terms;
            events.radiances.push(radiance);
            let Some(terms) = terms else { continue };
            let camera = render::camera_sample(world, pixel, index);
            let weight = camera.map_or(0.0, |camera| camera.weight);
            let factor = weight * world.view.exposure_time / f64::from(count);
            for (key, value) in terms.into_terms() {
                *events.terms.entry(key).or_default() += factor * value;
            }
        }
        events.radiance = render::expose(world, events.radiances.iter().copied());
        let exposed = |radiance: &mut Rgb| *radiance = world.view.exposure_time * *radiance;
        events.radiances.iter_mut().for_each(exposed);
        events
    }

    /// The variance of the samples, each channel by itself, by n − 1; 0 for a single sample.
    pub fn variance(&self) -> Rgb {
        let mean = render::mean(self.radiances.iter().copied());
        let squares: Rgb =
            self.radiances.iter().map(|&radiance| (radiance - mean) * (radiance - mean)).sum();
        squares / self.radiances.len().saturating_sub(1).max(1) as f64
    }

    /// The standard error of the pixel, as if its samples were independent.
    pub fn standard_error(&self) -> Rgb {
        (self.variance() / self.radiances.len() as f64).map(f64::sqrt)
    }

    /// The sum of some of the terms.
    pub fn sum(&self, of: impl Fn(&TermKey) -> bool) -> Rgb {
        self.terms.iter().filter(|(key, _)| of(key)).map(|(_, &value)| value).sum()
    }
}

/// The recorder of one sample.
struct Listening<'a> {
    world: &'a World,
    /// Those of all samples so far.
    events: &'a mut Events,
    /// Whether the cost of searches is counted.
    cost: bool,
    terms: Option<Dividing>,
    /// The depth of the ray that began last.
    last: u32,
}

impl Recorder for Listening<'_> {
    fn enter(&mut self, kind: RayKind, ray: &Ray, depth: u32, weight: Rgb) {
        self.events.rays += 1;
        self.last = depth;
        if let Some(terms) = &mut self.terms {
            terms.enter(kind, ray, depth, weight);
        }
    }

    fn search(&mut self, search: Search, ray: &Ray, span: Span) {
        // a ray that is searched along is cast
        self.events.depth = self.events.depth.max(self.last);
        if self.cost {
            let cost = self.world.search_cost(search, ray, span);
            self.events.cost.tests += cost.tests;
            self.events.cost.steps += cost.steps;
        }
    }

    fn term(&mut self, term: Term) {
        if let Some(terms) = &mut self.terms {
            terms.term(term);
        }
    }

    fn leave(&mut self, outcome: Outcome, transmittance: Rgb, arriving: Rgb) {
        if let Some(terms) = &mut self.terms {
            terms.leave(outcome, transmittance, arriving);
        }
    }
}
