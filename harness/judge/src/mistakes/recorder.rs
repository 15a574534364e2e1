//! The recorder that finds, beside the radiance of our tracer, that of programs with mistakes.
//!
//! What arrives along a ray is `T · Σ terms`, each term local or `weight · L(child)`. So a frame for each ray that is
//! under way has one sum without a mistake and one for each mistake, and a term of a child takes the child's sums. The
//! sum without a mistake is the tracer's own, bit for bit.

use groundtruth::lobes::Lobes;
use groundtruth::math::Ray;
use groundtruth::rgb::Rgb;
use groundtruth::trace::{Outcome, RayKind, Recorder, ShadingPoint, Term, TermSource};
use groundtruth::world::World;

use super::observed::RaySoFar;
use super::{Mistake, ObservedRay, ObservedSurface, ObservedTerm};

/// A ray that is under way.
#[derive(Debug)]
struct Frame {
    ray: RaySoFar,
    /// Without a mistake, and with each.
    sums: Vec<Rgb>,
    /// The last ray from its hit, if it was cast, and what arrived along it.
    child: Option<(Option<Ray>, Vec<Rgb>)>,
}

impl Frame {
    /// A term of this ray, as the mistake of this number observes it; 0 is none.
    fn observed<'a>(&'a self, world: &'a World, term: &'a Term, index: usize) -> ObservedTerm<'a> {
        let child = self.child.as_ref().filter(|_| is_of_child(&term.source));
        let arriving = child.map_or(term.arriving, |(_, radiance)| radiance[index]);
        let from = child.and_then(|(ray, _)| ray.as_ref());
        ObservedTerm { world, ray: &self.ray, term, arriving, from }
    }
}

/// Finds the radiance of each sample without a mistake and with each of some mistakes.
#[derive(Debug)]
pub struct Reweighing<'a> {
    world: &'a World,
    mistakes: &'a [&'static Mistake],
    is_last_sample: bool,
    frames: Vec<Frame>,
    /// Buffers of frames that have ended.
    spare: Vec<Vec<Rgb>>,
    radiance: Vec<Rgb>,
}

impl<'a> Reweighing<'a> {
    /// A recorder of rays in this world for these mistakes; those that only change the scene change nothing here.
    pub fn new(world: &'a World, mistakes: &'a [&'static Mistake]) -> Self {
        let (frames, spare) = (Vec::new(), Vec::new());
        let radiance = vec![Rgb::BLACK; mistakes.len() + 1];
        Self { world, mistakes, is_last_sample: false, frames, spare, radiance }
    }

    /// Prepares for a sample of a pixel.
    pub fn begin(&mut self, is_last_sample: bool) {
        self.is_last_sample = is_last_sample;
        self.radiance.fill(Rgb::BLACK);
    }

    /// The radiance of the sample: first without a mistake, then with each.
    pub fn radiance(&self) -> &[Rgb] {
        &self.radiance
    }

    /// The term of a program with the first mistake: its own light that arrives, and its own value.
    pub(super) fn altered(&self, term: &Term) -> Term {
        let frame = self.frames.last().expect("a ray is under way");
        let observed = frame.observed(self.world, term, 1);
        let (arriving, value) = (observed.arriving, self.mistakes[0].value(&observed));
        if value == observed.value() {
            return Term { arriving, value, ..*term };
        }
        let (weight, arriving) = factors(value, term.weight, arriving);
        Term { weight, arriving, value, ..*term }
    }

    /// What arrives along the ray that ends, in a program with the first mistake, and the transmittance that makes it so.
    pub(super) fn ended(&self, transmittance: Rgb) -> (Rgb, Rgb) {
        let Frame { ray, sums, .. } = self.frames.last().expect("a ray is under way");
        let observed = ObservedRay { ray, transmittance, sum: sums[1] };
        let arriving = self.mistakes[0].arriving(&observed);
        if arriving == observed.arriving() {
            return (transmittance, arriving);
        }
        (factors(arriving, transmittance, sums[1]).0, arriving)
    }

    /// A buffer of black sums.
    fn sums(&mut self) -> Vec<Rgb> {
        let mut sums = self.spare.pop().unwrap_or_default();
        sums.clear();
        sums.resize(self.mistakes.len() + 1, Rgb::BLACK);
        sums
    }
}

/// Factors of a value: the first gives way, and the second only where it is 0 and the value is not.
fn factors(value: Rgb, first: Rgb, second: Rgb) -> (Rgb, Rgb) {
    let [value, first, second] = [value, first, second].map(Rgb::to_array);
    let both = [0, 1, 2].map(|i| match (value[i] == 0.0, second[i] == 0.0) {
        (true, true) => (first[i], 0.0),
        (false, true) => (1.0, value[i]),
        (_, false) => (value[i] / second[i], second[i]),
    });
    (both.map(|it| it.0).into(), both.map(|it| it.1).into())
}

/// Whether the light of a term arrives along the ray before it.
fn is_of_child(source: &TermSource) -> bool {
    use TermSource::{Ambient, Direct, Traced};
    matches!(source, Traced { .. } | Direct { traced: true, .. } | Ambient { traced: true, .. })
}

impl Recorder for Reweighing<'_> {
    fn enter(&mut self, kind: RayKind, ray: &Ray, _: u32, _: Rgb) {
        let (sums, is_last_sample) = (self.sums(), self.is_last_sample);
        let ray = RaySoFar { kind, ray: *ray, surface: None, is_last_sample };
        self.frames.push(Frame { ray, sums, child: None });
    }

    fn hit(&mut self, point: &ShadingPoint<'_>, lobes: &Lobes) {
        let frame = self.frames.last_mut().expect("a ray is under way");
        frame.ray.surface = Some(ObservedSurface::of(point, lobes));
    }

    fn term(&mut self, term: Term) {
        let frame = self.frames.last_mut().expect("a ray is under way");
        let ours = frame.observed(self.world, &term, 0).value();
        frame.sums[0] += ours;
        for (index, mistake) in (1..).zip(self.mistakes) {
            let value = mistake.value(&frame.observed(self.world, &term, index));
            frame.sums[index] += value;
        }
    }

    fn leave(&mut self, outcome: Outcome, transmittance: Rgb, _: Rgb) {
        let Frame { ray, mut sums, child } = self.frames.pop().expect("a ray is under way");
        sums[0] = transmittance * sums[0];
        for (sum, mistake) in sums[1..].iter_mut().zip(self.mistakes) {
            *sum = mistake.arriving(&ObservedRay { ray: &ray, transmittance, sum: *sum });
        }
        self.spare.extend(child.map(|(_, radiance)| radiance));
        match self.frames.last_mut() {
            Some(before) => {
                let was_cast = !matches!(outcome, Outcome::TooDeep | Outcome::OverBudget);
                let replaced = before.child.replace((was_cast.then_some(ray.ray), sums));
                self.spare.extend(replaced.map(|(_, radiance)| radiance));
            }
            None => {
                self.radiance.copy_from_slice(&sums);
                self.spare.push(sums);
            }
        }
    }
}
