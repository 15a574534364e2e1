//! The laws of a lobe: what its functions have to be to each other.

mod integrals;
mod values;

use serde_json::Value;

use crate::case::Case;
use crate::description::Claims;
use crate::lobe::Trouble;

pub use integrals::Integrated;

/// A law.
pub struct Law {
    /// Its name on cards.
    pub name: &'static str,
    /// What it says.
    pub sentence: &'static str,
    /// What has usually been done where it is broken.
    pub cause: &'static str,
    /// Whether a lobe of these claims is held to it.
    pub applies: fn(&Claims) -> bool,
    /// Whether it holds in a case; for laws of chance, with so many times the usual samples.
    ///
    /// # Errors
    /// Says why the program's answers cannot be judged.
    pub check: fn(&mut Case<'_>, usize) -> Result<Finding, Trouble>,
}

/// What a law finds in a case.
#[derive(Clone, Debug)]
pub enum Finding {
    /// It holds, as far as this case tells.
    Holds,
    /// It cannot be told, and why.
    Undecided(String),
    /// It is broken.
    Broken(Breach),
    /// If it holds, numbers at least as far off have this probability.
    Chance(f64, Breach),
}

/// A case in which a law is broken.
#[derive(Clone, Debug)]
pub struct Breach {
    /// What was found.
    pub found: String,
    /// What the law says.
    pub expected: String,
    /// The factor that was left out or put in, if it was recognised, in a sentence.
    pub mistake: Option<String>,
    /// The questions that show it.
    pub questions: Vec<Value>,
}

/// All laws. Those that say what others mean stand before them: the first that is broken names the mistake.
pub const LAWS: [Law; 10] = [
    Law {
        name: "repeated",
        sentence: "the same question has the same answer, whatever was asked between",
        cause: "a record kept from the last call, or a generator of random numbers that is not given",
        applies: |_| true,
        check: values::repeated,
    },
    Law {
        name: "positive",
        sentence: "f and pdf are finite and not negative, at the limb too",
        cause: "0/0 or a cosine without its absolute value at grazing directions",
        applies: |claims| !claims.delta,
        check: values::positive,
    },
    Law {
        name: "sides",
        sentence: "light comes from the sides that are claimed, and samples are unit directions there",
        cause: "the normal, or the sign of a cosine, is not that of the viewer's side",
        applies: |_| true,
        check: values::sides,
    },
    Law {
        name: "same pdf",
        sentence: "the pdf of a sample is the pdf of its direction",
        cause: "the Jacobian of the half vector, or the probability of choosing a lobe, is in one of them alone",
        applies: |claims| !claims.delta,
        check: values::same_pdf,
    },
    Law {
        name: "weight",
        sentence: "the weight of a sample is f |cos θi| / pdf",
        cause: "the cosine twice or not at all, or a factor that cancels in one place alone",
        applies: |claims| !claims.delta,
        check: values::weight,
    },
    Law {
        name: "density",
        sentence: "samples have the density pdf",
        cause: "the pdf lacks the Jacobian 1/(4 ωo·h), or the sampled function is another",
        applies: |claims| !claims.delta,
        check: integrals::density,
    },
    Law {
        name: "whole",
        sentence: "the integral of the pdf is 1, less the share of samples that scatter nothing",
        cause: "the pdf lacks a Jacobian or a normalisation, or samples below the surface are thrown away in silence",
        applies: |claims| !claims.delta,
        check: integrals::whole,
    },
    Law {
        name: "turned",
        sentence: "a turn of both directions about the normal changes nothing",
        cause: "a fixed axis of the world, or x and y exchanged, in an isotropic lobe",
        applies: |claims| claims.isotropic && !claims.delta,
        check: values::turned,
    },
    Law {
        name: "reciprocal",
        sentence: "f is the same with viewer and light exchanged (divided by the square of the viewer's index)",
        cause: "1/η² is left out, or a term of the viewer alone",
        applies: |claims| claims.reciprocal && !claims.delta,
        check: values::reciprocal,
    },
    Law {
        name: "albedo",
        sentence: "the mean weight is the integral of f |cos θi|; it is at most 1, and 1 where nothing is lost",
        cause: "more light leaves than arrives: a normalisation or a Fresnel term is left out",
        applies: |_| true,
        check: integrals::albedo,
    },
];
