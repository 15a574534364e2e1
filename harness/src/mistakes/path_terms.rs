//! Mistakes of path tracers (Suffern, ch. 26): changed values of terms.

use groundtruth::lobes::Lobe;
use groundtruth::rgb::Rgb;
use groundtruth::trace::TermSource;

use super::{Mistake, TermHeard};

pub(super) const ALL: &[Mistake] = &[
    Mistake::term(
        26,
        "light-counted-twice",
        "lamps and sky count in full both where they are sampled and where a path hits them",
        light_counted_twice,
    ),
    Mistake::term(
        26,
        "path-cosine-twice",
        "diffuse paths have cosine-distributed directions and the cosine in their weight",
        |term| match term.traced() {
            Some(Lobe::Lambertian(_)) => term.times(term.cosine_of_ray().map_or(1.0, f64::abs)),
            _ => term.value(),
        },
    ),
    Mistake::term(
        26,
        "path-without-density",
        "diffuse paths count f cos θ, not divided by the density of their direction",
        |term| match term.term.source {
            TermSource::Traced { lobe: Lobe::Lambertian(_), pdf: Some(pdf), .. } => term.times(pdf),
            _ => term.value(),
        },
    ),
    Mistake::term(
        26,
        "choice-not-compensated",
        "paths that choose one of several lobes are not divided by its probability",
        |term| match term.term.source {
            TermSource::Traced { lobe_probability, .. } => term.times(lobe_probability),
            _ => term.value(),
        },
    ),
    Mistake::term(
        26,
        "roulette-not-compensated",
        "paths that survive Russian roulette are not divided by their probability of survival",
        |term| match term.term.source {
            TermSource::Traced { survival, .. } => term.times(survival),
            _ => term.value(),
        },
    ),
];

/// Takes off the weights by which sampled lights and paths that hit them share the same light.
fn light_counted_twice(term: &TermHeard<'_>) -> Rgb {
    match term.term.source {
        TermSource::Emission { mis: Some(_) } | TermSource::Background { mis: Some(_) } => {
            term.arriving
        }
        TermSource::Direct { f, cos_i, pdf, mis: Some(_), .. } => {
            ((cos_i / pdf.unwrap_or(1.0)) * f) * term.arriving
        }
        _ => term.value(),
    }
}
