//! A case: a lobe with parameters, a viewer, and what may be expected of its numbers.

use exact::Draw;
use groundtruth::math::{Frame, Normal, Vector};

use crate::description::{Claims, Sides};
use crate::laws::Integrated;
use crate::lobe::{Evaluated, Lobe, Numbers, Sampled, Trouble};

/// A lobe with parameters and a viewer.
pub struct Case<'a> {
    /// What is asked.
    pub lobe: Lobe<'a>,
    /// What the lobe claims.
    pub claims: &'a Claims,
    /// The index of refraction below the surface over the one above.
    pub eta: f64,
    /// The relative rounding of the program's numbers.
    pub rounding: f64,
    /// The direction to the viewer, in the local frame: z is the normal.
    pub wo: Vector,
    /// Of the directions and numbers of this case.
    pub draw: Draw,
    /// Counts and integrals that several laws need.
    pub integrated: Option<Integrated>,
}

/// Values in a direction, and by how much they change within the rounding of directions.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    /// The direction that the light comes from.
    pub wi: Vector,
    /// The values.
    pub value: Evaluated,
    /// What rounding may do to the channels of f.
    pub f_slack: [f64; 3],
    /// What rounding may do to the density.
    pub pdf_slack: f64,
}

/// A rounding of so many units is always granted.
const UNITS: f64 = 64.0;

impl Case<'_> {
    /// The index on the side of a direction over the one above the surface.
    pub fn index_at(&self, w: Vector) -> f64 {
        if w.z() < 0.0 { self.eta } else { 1.0 }
    }

    /// Whether the lobe claims to scatter light from this direction to the viewer.
    pub fn is_served(&self, wi: Vector) -> bool {
        let is_reflected = wi.z() * self.wo.z() > 0.0;
        match self.claims.sides {
            Sides::Both => true,
            Sides::Reflects => is_reflected,
            Sides::Transmits => !is_reflected,
        }
    }

    /// Whether a direction lies in the surface as far as rounding can tell: then its side says nothing.
    pub fn is_level(&self, wi: Vector) -> bool {
        wi.z().abs() <= UNITS * self.rounding
    }

    /// Random numbers for samples.
    pub fn numbers(&mut self, count: usize) -> Vec<Numbers> {
        (0..count).map(|_| std::array::from_fn(|_| self.draw.between(0.0, 1.0))).collect()
    }

    /// So many samples of fresh numbers.
    ///
    /// # Errors
    /// Says why there are none.
    pub fn samples(&mut self, count: usize) -> Result<Vec<Option<Sampled>>, Trouble> {
        let u = self.numbers(count);
        self.lobe.sample(self.wo, &u)
    }

    /// Directions on the side of `z`, uniform in solid angle.
    pub fn directions(&mut self, count: usize, side: f64) -> Vec<Vector> {
        let mut direction = || {
            let w = Vector::from(self.draw.direction());
            Vector::new(w.x(), w.y(), side * w.z().abs())
        };
        (0..count).map(|_| direction()).collect()
    }

    /// The values in these directions, seen from `wo`, and what rounding may do to them: directions are moved by twice
    /// the square root of the unit of rounding. To first order that is more than the rounding of a direction; to second
    /// order, near a peak of width α, it changes a value by u/α², which is what cancellation in `1 − cos² θ` costs.
    ///
    /// # Errors
    /// Says why there are none.
    pub fn measured(&mut self, wo: Vector, wi: &[Vector]) -> Result<Vec<Measured>, Trouble> {
        let step = 2.0 * self.rounding.sqrt();
        let around = |wi: &Vector| {
            let frame = Frame::around(Normal::new(*wi).unwrap_or(Normal::Z));
            let moved = |by: Vector| (*wi + step * by).unit().unwrap_or(*wi);
            [*wi, moved(frame.u), moved(-frame.u), moved(frame.v), moved(-frame.v)]
        };
        let asked: Vec<Vector> = wi.iter().flat_map(around).collect();
        let values = self.lobe.eval(wo, &asked)?;
        let measured = |(wi, values): (&Vector, &[Evaluated])| {
            let value = values[0];
            let slack = |of: &dyn Fn(&Evaluated) -> f64| {
                let middle = of(&value);
                let moved = values.iter().map(|it| (of(it) - middle).abs()).fold(0.0, f64::max);
                moved + UNITS * self.rounding * middle.abs()
            };
            let f_slack = std::array::from_fn(|k| slack(&|it| it.f[k]));
            Measured { wi: *wi, value, f_slack, pdf_slack: slack(&|it| it.pdf) }
        };
        Ok(wi.iter().zip(values.chunks(5)).map(measured).collect())
    }
}
