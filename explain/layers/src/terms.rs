//! A sample divided into terms.
//!
//! A term is the light of one source that arrives after so many edges and that one lobe scatters to the eye, or to the
//! first hit's lobe that sends it on. The sample is their sum.

use std::collections::BTreeMap;

use groundtruth::math::Ray;
use groundtruth::rgb::Rgb;
use groundtruth::trace::{Outcome, RayKind, Recorder, Term, TermSource};

/// What a term is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct TermKey {
    /// Where its light comes from.
    pub source: LightSource,
    /// The lobe at the eye's hit that sent the ray along which the light arrives, if it does not come from there.
    pub by: Option<&'static str>,
    /// The depth of the ray that meets the light or the lit surface.
    pub depth: u32,
}

/// Where the light of a term comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum LightSource {
    /// The background.
    Background,
    /// A surface that shines.
    Emission,
    /// An ambient light, by its index in the scene.
    Ambient(u32),
    /// The samples of a light, by its index in the scene, and the lobe that they meet.
    Direct(u32, &'static str),
}

impl TermKey {
    /// The lobe of the first hit that scatters the light to the eye; none scatters emission, background and ambient
    /// light that the camera's ray meets.
    pub fn first_lobe(self) -> Option<&'static str> {
        self.by.or(match self.source {
            LightSource::Direct(_, lobe) => Some(lobe),
            LightSource::Background | LightSource::Emission | LightSource::Ambient(_) => None,
        })
    }
}

/// The terms of a ray or of a sample.
pub type Terms = BTreeMap<TermKey, Rgb>;

/// The recorder that divides the radiance of a sample into terms.
#[derive(Clone, Debug, Default)]
pub struct Dividing {
    /// For each ray that is under way, its terms, and those of its last child.
    frames: Vec<(Terms, Terms)>,
    whole: Terms,
}

impl Dividing {
    /// The terms of the sample that was recorded last, without its weight from the filter.
    pub fn into_terms(self) -> Terms {
        self.whole
    }
}

impl Recorder for Dividing {
    fn enter(&mut self, _: RayKind, _: &Ray, _: u32, _: Rgb) {
        self.frames.push((Terms::new(), Terms::new()));
    }

    fn term(&mut self, term: Term) {
        let (sums, child) = self.frames.last_mut().expect("a ray is under way");
        let source = match term.source {
            TermSource::Background { .. } => LightSource::Background,
            TermSource::Emission { .. } => LightSource::Emission,
            TermSource::Ambient { light, .. } => LightSource::Ambient(light),
            TermSource::Direct { light, lobe, .. } => LightSource::Direct(light, lobe.name()),
            TermSource::Traced { lobe, .. } => {
                for (key, arriving) in std::mem::take(child) {
                    let key = TermKey { by: Some(lobe.name()), depth: key.depth + 1, ..key };
                    *sums.entry(key).or_default() += term.weight * arriving;
                }
                return;
            }
            // of a shadow ray, whose surface has the term
            TermSource::Light { .. } => return,
        };
        *sums.entry(TermKey { source, by: None, depth: 0 }).or_default() += term.value;
    }

    fn leave(&mut self, _: Outcome, transmittance: Rgb, _: Rgb) {
        let (mut sums, _) = self.frames.pop().expect("a ray is under way");
        sums.values_mut().for_each(|value| *value = transmittance * *value);
        match self.frames.last_mut() {
            Some((_, child)) => *child = sums,
            None => self.whole = sums,
        }
    }
}
