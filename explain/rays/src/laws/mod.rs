//! The laws: each a file with its sentence, what it needs, and its usual causes.
//!
//! A cause is named only if it predicts what the log says, within the law's tolerance, for every ray that breaks the law.

mod agreed;
mod behind;
mod camera;
mod cosine;
mod densities;
mod energy;
mod falloff;
mod finite;
mod fresnel;
mod geometry;
mod hit;
mod lamp;
mod lamps;
mod mirrored;
mod mis;
mod nearest;
mod normals;
mod occluded;
mod own_start;
mod path_sum;
mod placed;
mod radiance;
mod refracted;
mod samples;
mod shares;
mod side;
mod starts;
mod surface;
mod throughput;
mod tree;
mod true_normal;
mod weight;

use crate::traced::Traced;
pub use geometry::Step;
pub use nearest::distance_to_truth;
pub use weight::is_near;

/// A law that the rays of a log are held to.
#[derive(Clone, Copy, Debug)]
pub struct RayLaw {
    /// A short name for scripts.
    pub name: &'static str,
    /// What holds, as a sentence.
    pub says: &'static str,
    /// The fields without which it cannot be asked.
    pub needs: &'static [&'static str],
    /// Usual causes: what is known to break it.
    pub causes: &'static [&'static str],
    check: fn(&Traced, &mut LawReport),
}

/// The laws, those first from whose breach the others follow.
pub const LAWS: &[RayLaw] = &[
    finite::LAW,
    tree::LAW,
    placed::LAW,
    hit::LAW,
    nearest::LAW,
    agreed::LAW,
    normals::LAW,
    true_normal::LAW,
    starts::LAW,
    own_start::LAW,
    side::LAW,
    mirrored::LAW,
    refracted::LAW,
    lamp::LAW,
    behind::LAW,
    occluded::LAW,
    falloff::LAW,
    shares::LAW,
    fresnel::LAW,
    energy::LAW,
    lamps::LAW,
    mis::LAW,
    cosine::LAW,
    weight::LAW,
    throughput::LAW,
    radiance::LAW,
    path_sum::LAW,
    samples::LAW,
    densities::LAW,
    camera::LAW,
];

/// What a law found.
#[derive(Clone, Debug, Default)]
pub struct LawReport {
    /// The rays of which it was asked.
    pub rays: usize,
    /// Whether a finding is about all of these rays together, and the ray it names one of them.
    pub is_of_all: bool,
    /// The rays that break it, in the order of the log.
    pub findings: Vec<BrokenRay>,
    /// What else a reader has to know, as why some rays were not judged.
    pub notes: Vec<String>,
}

/// A ray that breaks a law.
#[derive(Clone, Debug)]
pub struct BrokenRay {
    /// Its index.
    pub ray: usize,
    /// What is wrong, beginning after the ray's name: `starts 0.3 from where its parent ended`.
    pub words: String,
    /// Which of the law's causes predict what the log says, a bit for each.
    pub causes: u32,
    /// The ray on the same path from whose breach it follows.
    pub follows: Option<usize>,
}

impl RayLaw {
    /// Asks all rays.
    pub fn ask(&self, traced: &Traced) -> LawReport {
        let mut asked = LawReport::default();
        (self.check)(traced, &mut asked);
        asked.findings.sort_by_key(|finding| finding.ray);
        asked
    }

    /// The cause that explains all of these findings.
    pub fn cause<'a>(
        &self,
        findings: impl IntoIterator<Item = &'a BrokenRay>,
    ) -> Option<&'static str> {
        let common = findings.into_iter().map(|finding| finding.causes).reduce(|a, b| a & b)?;
        self.causes.get(common.trailing_zeros() as usize).copied()
    }
}

impl LawReport {
    /// Counts a ray; if the law is broken, `found` says how, and whether each of the law's causes predicts it.
    fn count<const N: usize>(
        &mut self,
        ray: usize,
        holds: bool,
        found: impl FnOnce() -> (String, [bool; N]),
    ) {
        self.rays += 1;
        if !holds {
            let (words, causes) = found();
            let causes = (0..N).filter(|&at| causes[at]).fold(0, |bits, at| bits | 1 << at);
            self.findings.push(BrokenRay { ray, words, causes, follows: None });
        }
    }
}
