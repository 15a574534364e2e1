//! Factors that people leave out or put in twice, recognised by ratios.

use std::f64::consts::PI;

use groundtruth::math::Vector;

/// What factors are functions of.
#[derive(Clone, Copy, Debug)]
pub struct Given {
    /// The direction to the viewer of a lobe.
    pub wo: Vector,
    /// The direction to the light; the point of a map.
    pub wi: Vector,
    /// The index below over the one above.
    pub eta: f64,
    /// The distance of a light's point; NaN if it is not told.
    pub distance: f64,
    /// The cosine at a light's point; NaN if it is not told.
    pub cosine: f64,
}

impl Given {
    /// Directions, and nothing else.
    pub fn of(wo: Vector, wi: Vector, eta: f64) -> Self {
        Self { wo, wi, eta, distance: f64::NAN, cosine: f64::NAN }
    }

    /// The half vector's cosine to the viewer.
    fn half(&self) -> f64 {
        (self.wo + self.wi).unit().map_or(0.0, |h| self.wo.dot(h).abs())
    }

    /// The square of the relative index from the viewer's side to the other.
    fn index_squared(&self) -> f64 {
        let eta = if self.wo.z() < 0.0 { 1.0 / self.eta } else { self.eta };
        eta * eta
    }

    /// The distance from the z axis.
    fn radius(&self) -> f64 {
        (self.wi.x() * self.wi.x() + self.wi.y() * self.wi.y()).sqrt()
    }
}

/// A factor, by its name and its value.
pub struct Factor {
    /// As a formula.
    pub name: &'static str,
    /// Its value.
    pub value: fn(&Given) -> f64,
}

/// Of lobes.
pub const LOBES: [Factor; 12] = [
    Factor { name: "|cos θi|", value: |it| it.wi.z().abs() },
    Factor { name: "1/|cos θi|", value: |it| 1.0 / it.wi.z().abs() },
    Factor { name: "|cos θo|", value: |it| it.wo.z().abs() },
    Factor { name: "1/|cos θo|", value: |it| 1.0 / it.wo.z().abs() },
    Factor { name: "|cos θi|/|cos θo|", value: |it| (it.wi.z() / it.wo.z()).abs() },
    Factor { name: "4 (ωo·h)", value: |it| 4.0 * it.half() },
    Factor { name: "1/(4 ωo·h)", value: |it| 0.25 / it.half() },
    Factor { name: "ωo·h", value: Given::half },
    Factor { name: "η²", value: Given::index_squared },
    Factor { name: "1/η²", value: |it| 1.0 / it.index_squared() },
    Factor {
        name: "η⁴ (1/η² left out on both ways)",
        value: |it| it.index_squared() * it.index_squared(),
    },
    Factor {
        name: "1/η⁴ (η² left out on both ways)",
        value: |it| 1.0 / (it.index_squared() * it.index_squared()),
    },
];

/// Of lights: d is the distance, θ' the angle at the light.
pub const LIGHTS: [Factor; 8] = [
    Factor { name: "d²", value: |it| it.distance * it.distance },
    Factor { name: "1/d²", value: |it| 1.0 / (it.distance * it.distance) },
    Factor { name: "cos θ'", value: |it| it.cosine },
    Factor { name: "1/cos θ'", value: |it| 1.0 / it.cosine },
    Factor { name: "d²/cos θ'", value: |it| it.distance * it.distance / it.cosine },
    Factor { name: "cos θ'/d²", value: |it| it.cosine / (it.distance * it.distance) },
    Factor { name: "d", value: |it| it.distance },
    Factor { name: "1/d", value: |it| 1.0 / it.distance },
];

/// Of maps: r is the distance from the z axis, the sine of a direction.
pub const MAPS: [Factor; 8] = [
    Factor { name: "r", value: Given::radius },
    Factor { name: "1/r", value: |it| 1.0 / it.radius() },
    Factor { name: "2r", value: |it| 2.0 * it.radius() },
    Factor { name: "1/(2r)", value: |it| 0.5 / it.radius() },
    Factor { name: "|z|", value: |it| it.wi.z().abs() },
    Factor { name: "1/|z|", value: |it| 1.0 / it.wi.z().abs() },
    Factor { name: "2 |z|", value: |it| 2.0 * it.wi.z().abs() },
    Factor { name: "1/(2 |z|)", value: |it| 0.5 / it.wi.z().abs() },
];

/// Of all kinds.
const CONSTANTS: [Factor; 10] = [
    Factor { name: "π", value: |_| PI },
    Factor { name: "1/π", value: |_| 1.0 / PI },
    Factor { name: "2", value: |_| 2.0 },
    Factor { name: "½", value: |_| 0.5 },
    Factor { name: "4", value: |_| 4.0 },
    Factor { name: "¼", value: |_| 0.25 },
    Factor { name: "2π", value: |_| 2.0 * PI },
    Factor { name: "1/2π", value: |_| 0.5 / PI },
    Factor { name: "4π", value: |_| 4.0 * PI },
    Factor { name: "1/4π", value: |_| 0.25 / PI },
];

/// How near to a factor a ratio has to be, and in which share of the cases.
const NEAR: f64 = 1e-3;
const SHARE: f64 = 0.9;
/// With fewer ratios nothing is named.
const FEWEST: usize = 8;

/// The factor by which found values are off, if it is the same one in nearly all cases.
pub fn factor(ratios: &[(f64, Given)], own: &[Factor]) -> Option<&'static str> {
    let wrong: Vec<_> = ratios.iter().filter(|(ratio, _)| ratio.is_finite()).collect();
    if wrong.len() < FEWEST {
        return None;
    }
    let fits = |factor: &&Factor| {
        let is_near =
            |(ratio, given): &&&(f64, Given)| (ratio / (factor.value)(given) - 1.0).abs() <= NEAR;
        let near = wrong.iter().filter(is_near).count();
        // a factor of 1 explains nothing
        let is_one = |(_, given): &&&(f64, Given)| ((factor.value)(given) - 1.0).abs() <= NEAR;
        near as f64 >= SHARE * wrong.len() as f64 && !wrong.iter().all(|it| is_one(&it))
    };
    own.iter().chain(&CONSTANTS).find(fits).map(|factor| factor.name)
}

/// The constant that a number is, to so much of it.
pub fn constant(ratio: f64, near: f64) -> Option<&'static str> {
    let nothing = Given::of(Vector::Z, Vector::Z, 1.0);
    let fits = |factor: &&Factor| (ratio / (factor.value)(&nothing) - 1.0).abs() <= near;
    CONSTANTS.iter().find(fits).map(|factor| factor.name)
}
