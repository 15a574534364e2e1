//! Factors that people leave out or put in twice, recognised by ratios.

use std::f64::consts::PI;

use groundtruth::math::Vector;

/// A factor, by its name and its value for two directions.
pub struct Factor {
    /// As a formula.
    pub name: &'static str,
    /// For the viewer's and the light's direction, and the index below over the one above.
    pub value: fn(Vector, Vector, f64) -> f64,
}

/// The half vector's cosine to the viewer.
fn half(wo: Vector, wi: Vector) -> f64 {
    (wo + wi).unit().map_or(0.0, |h| wo.dot(h).abs())
}

/// The relative index from the viewer's side to the other.
fn relative(wo: Vector, eta: f64) -> f64 {
    if wo.z() < 0.0 { 1.0 / eta } else { eta }
}

/// The factors that ratios are compared with.
pub const FACTORS: [Factor; 16] = [
    Factor { name: "|cos θi|", value: |_, wi, _| wi.z().abs() },
    Factor { name: "1/|cos θi|", value: |_, wi, _| 1.0 / wi.z().abs() },
    Factor { name: "|cos θo|", value: |wo, _, _| wo.z().abs() },
    Factor { name: "1/|cos θo|", value: |wo, _, _| 1.0 / wo.z().abs() },
    Factor { name: "|cos θi|/|cos θo|", value: |wo, wi, _| (wi.z() / wo.z()).abs() },
    Factor { name: "4 (ωo·h)", value: |wo, wi, _| 4.0 * half(wo, wi) },
    Factor { name: "1/(4 ωo·h)", value: |wo, wi, _| 0.25 / half(wo, wi) },
    Factor { name: "ωo·h", value: |wo, wi, _| half(wo, wi) },
    Factor { name: "η²", value: |wo, _, eta| relative(wo, eta) * relative(wo, eta) },
    Factor { name: "1/η²", value: |wo, _, eta| 1.0 / (relative(wo, eta) * relative(wo, eta)) },
    Factor { name: "π", value: |_, _, _| PI },
    Factor { name: "1/π", value: |_, _, _| 1.0 / PI },
    Factor { name: "2", value: |_, _, _| 2.0 },
    Factor { name: "½", value: |_, _, _| 0.5 },
    Factor { name: "4", value: |_, _, _| 4.0 },
    Factor { name: "¼", value: |_, _, _| 0.25 },
];

/// How near to a factor a ratio has to be, and in which share of the cases.
const NEAR: f64 = 1e-3;
const SHARE: f64 = 0.9;
/// With fewer ratios nothing is named.
const FEWEST: usize = 8;

/// The factor by which found values are off, if it is the same one in nearly all cases.
pub fn factor(ratios: &[(f64, Vector, Vector)], eta: f64) -> Option<&'static str> {
    let wrong: Vec<_> = ratios.iter().filter(|(ratio, ..)| ratio.is_finite()).collect();
    if wrong.len() < FEWEST {
        return None;
    }
    let fits = |factor: &&Factor| {
        let is_near = |(ratio, wo, wi): &&&(f64, Vector, Vector)| {
            let value = (factor.value)(*wo, *wi, eta);
            (ratio / value - 1.0).abs() <= NEAR
        };
        let near = wrong.iter().filter(is_near).count();
        // a factor of 1 explains nothing
        let is_one = |(_, wo, wi): &&&(f64, Vector, Vector)| {
            ((factor.value)(*wo, *wi, eta) - 1.0).abs() <= NEAR
        };
        near as f64 >= SHARE * wrong.len() as f64 && !wrong.iter().all(|it| is_one(&it))
    };
    FACTORS.iter().find(fits).map(|factor| factor.name)
}
