//! The laws: each a file that asks the rays; its sentence, what it needs and its usual causes stand in `laws.txt`.
//!
//! A cause is named only if it predicts what the log says, within the law's tolerance, for every ray that breaks the law.

mod agreed;
mod as_ours;
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
mod pixel;
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

use std::sync::LazyLock;

use groundtruth::math::Vector;

use crate::traced::Traced;
pub use as_ours::partings;
pub use geometry::{Step, angle_between};
pub use nearest::distance_to_truth;
pub use pixel::Passes;
pub use weight::is_near as is_near_color;

/// A law that the rays of a log are held to.
#[derive(Clone, Debug)]
pub struct RayLaw {
    /// A short name for scripts.
    pub name: &'static str,
    /// What holds, as a sentence.
    pub says: &'static str,
    /// The fields without which it cannot be asked.
    pub needs: Vec<&'static str>,
    /// Usual causes, by their keys: what is known to break it.
    pub causes: Vec<(&'static str, &'static str)>,
    check: Check,
}

type Check = fn(&Traced, &mut LawReport);

/// What asks the rays, by the names of `laws.txt`, those laws first from whose breach the others follow: how a ray leaves, what it
/// hits, what it brings, and at last what a picture hardly shows.
const CHECKS: &[(&str, Check)] = &[
    ("finite", finite::check),
    ("tree", tree::check),
    ("one-space", placed::check),
    ("starts-at-hit", starts::check),
    ("mirrored", mirrored::check),
    ("snell", refracted::check),
    ("right-side", side::check),
    ("shadow-ray-to-lamp", lamp::check),
    ("hit-on-ray", hit::check),
    ("nearest-hit", nearest::check),
    ("surfaces-agree", agreed::check),
    ("unit-normals", normals::check),
    ("true-normal", true_normal::check),
    ("not-its-own-start", own_start::check),
    ("not-behind-the-lamp", behind::check),
    ("truly-blocked", occluded::check),
    ("falloff", falloff::check),
    ("shares", shares::check),
    ("energy", energy::check),
    ("lamp-density", lamps::check),
    ("mis-weights", mis::check),
    ("cosine", cosine::check),
    ("weight", weight::check),
    ("throughput", throughput::check),
    ("radiance", radiance::check),
    ("path-sum", path_sum::check),
    ("as-ours", as_ours::check),
    ("samples-differ", samples::check),
    ("drawn-as-claimed", densities::check),
    ("through-its-pixel", pixel::check),
    ("one-camera", camera::check),
    ("fresnel", fresnel::check),
];

/// The laws of how a ray leaves its sender's hit, and those of what it hits, which decides how the next rays leave.
pub const OF_LEAVING: [&str; 5] =
    ["starts-at-hit", "mirrored", "snell", "right-side", "shadow-ray-to-lamp"];
pub const OF_HITS: [&str; 5] =
    ["hit-on-ray", "nearest-hit", "surfaces-agree", "unit-normals", "true-normal"];

/// The laws in this order, in the words of `laws.txt`: `name: sentence`, then what it needs, and its causes by their keys.
pub static LAWS: LazyLock<Vec<RayLaw>> = LazyLock::new(|| {
    let lines: Vec<&str> = include_str!("laws.txt").lines().collect();
    let laws: Vec<&[&str]> = lines.split(|line| line.is_empty()).collect();
    assert_eq!(laws.len(), CHECKS.len(), "a law has words and a check");
    CHECKS.iter().zip(laws).map(|(check, words)| RayLaw::of(*check, words)).collect()
});

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
    /// The keys of the law's causes that predict what the log says.
    pub causes: Vec<&'static str>,
    /// The unit direction that the law gives for the numbers of the log, if it is one of directions.
    pub expected: Option<Vector>,
    /// The ray on the same path from whose breach it follows.
    pub follows: Option<usize>,
}

impl RayLaw {
    fn of((key, check): (&str, Check), words: &[&'static str]) -> Self {
        let mut lines = words.iter().filter_map(|line| line.trim().split_once(": "));
        let (name, says) = lines.next().expect("a law has words");
        assert_eq!(name, key, "words and checks have one order");
        let (needs, causes): (Vec<_>, Vec<_>) = lines.partition(|(key, _)| *key == "needs");
        Self { name, says, needs: needs.into_iter().map(|it| it.1).collect(), causes, check }
    }

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
        let mut findings = findings.into_iter();
        let mut common = findings.next()?.causes.clone();
        findings.for_each(|it| common.retain(|cause| it.causes.contains(cause)));
        self.causes.iter().find(|(key, _)| common.contains(key)).map(|(_, cause)| *cause)
    }
}

impl LawReport {
    /// Counts a ray; if the law is broken, `found` says how, and whether causes predict it.
    fn count<const N: usize>(
        &mut self,
        ray: usize,
        holds: bool,
        found: impl FnOnce() -> (String, [(&'static str, bool); N]),
    ) {
        self.rays += 1;
        if !holds {
            let (words, causes) = found();
            self.find(ray, words, causes);
        }
    }

    fn find<const N: usize>(
        &mut self,
        ray: usize,
        words: String,
        causes: [(&'static str, bool); N],
    ) {
        let causes = causes.into_iter().filter_map(|(key, predicts)| predicts.then_some(key));
        let (causes, expected, follows) = (causes.collect(), None, None);
        self.findings.push(BrokenRay { ray, words, causes, expected, follows });
    }

    /// Notes where a ray should have gone that was counted last, if it breaks the law.
    fn expect(&mut self, ray: usize, direction: Option<Vector>) {
        let last = self.findings.last_mut().filter(|finding| finding.ray == ray);
        last.into_iter().for_each(|finding| finding.expected = direction);
    }
}
