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

use super::observed::{ObservedRay, ObservedSurface, ObservedTerm, RaySoFar};
use super::{How, Mistake};

/// A ray that is under way.
#[derive(Debug)]
struct Frame {
    ray: RaySoFar,
    /// Without a mistake, and with each.
    sums: Vec<Rgb>,
    /// The last ray from its hit, and what arrived along it.
    child: Option<(Ray, Vec<Rgb>)>,
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
        let radiance = vec![Rgb::BLACK; mistakes.len() + 1];
        Self {
            world,
            mistakes,
            is_last_sample: false,
            frames: Vec::new(),
            spare: Vec::new(),
            radiance,
        }
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

    /// A buffer of black sums.
    fn sums(&mut self) -> Vec<Rgb> {
        let mut sums = self.spare.pop().unwrap_or_default();
        sums.clear();
        sums.resize(self.mistakes.len() + 1, Rgb::BLACK);
        sums
    }
}

/// Whether the light of a term arrives along the ray before it.
fn is_of_child(source: &TermSource) -> bool {
    match source {
        TermSource::Traced { .. } => true,
        TermSource::Direct { traced, .. } | TermSource::Ambient { traced, .. } => *traced,
        TermSource::Background { .. } | TermSource::Emission { .. } | TermSource::Light { .. } => {
            false
        }
    }
}

impl Recorder for Reweighing<'_> {
    fn enter(&mut self, kind: RayKind, ray: &Ray, _: u32, _: Rgb) {
        let (ray, sums) = (RaySoFar { kind, ray: *ray, surface: None }, self.sums());
        self.frames.push(Frame { ray, sums, child: None });
    }

    fn outcome(&mut self, _: Outcome) {}

    fn surface(&mut self, point: &ShadingPoint<'_>, lobes: &Lobes) {
        let frame = self.frames.last_mut().expect("a ray is under way");
        frame.ray.surface = Some(ObservedSurface::of(point, lobes));
    }

    fn term(&mut self, term: Term) {
        let Frame { ray, sums, child } = self.frames.last_mut().expect("a ray is under way");
        let child = child.as_ref().filter(|_| is_of_child(&term.source));
        let from = child.map(|(ray, _)| ray);
        let arriving = |index: usize| child.map_or(term.arriving, |(_, radiance)| radiance[index]);
        sums[0] += term.weight * arriving(0);
        for (index, mistake) in (1..).zip(self.mistakes) {
            let arriving = arriving(index);
            sums[index] += match mistake.how {
                How::Term(value) | How::Both(_, value) => value(&ObservedTerm {
                    world: self.world,
                    ray,
                    term: &term,
                    arriving,
                    from,
                    is_last_sample: self.is_last_sample,
                }),
                How::Ray(_) | How::Scene(_) => term.weight * arriving,
            };
        }
    }

    fn leave(&mut self, transmittance: Rgb, _: Rgb) {
        let Frame { ray, mut sums, child } = self.frames.pop().expect("a ray is under way");
        let is_last_sample = self.is_last_sample;
        sums[0] = transmittance * sums[0];
        for (sum, mistake) in sums[1..].iter_mut().zip(self.mistakes) {
            let heard = ObservedRay { ray: &ray, transmittance, sum: *sum, is_last_sample };
            *sum = match mistake.how {
                How::Ray(arriving) => arriving(&heard),
                How::Term(_) | How::Both(..) | How::Scene(_) => heard.arriving(),
            };
        }
        self.spare.extend(child.map(|(_, radiance)| radiance));
        match self.frames.last_mut() {
            Some(before) => {
                let replaced = before.child.replace((ray.ray, sums));
                self.spare.extend(replaced.map(|(_, radiance)| radiance));
            }
            None => {
                self.radiance.copy_from_slice(&sums);
                self.spare.push(sums);
            }
        }
    }
}
