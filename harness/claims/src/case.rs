//! A case of a lobe: parameters, a viewer, and what may be expected of its numbers.

use ask::{Draw, Stop};
use groundtruth::math::Vector;

use crate::asked::Numbers;
use crate::description::{Claims, Sides};
use crate::laws::Integrated;
use crate::lobe::{Lobe, Sampled};
use crate::measured::{Measured, UNITS, measured};

/// A lobe with parameters and a viewer.
pub struct LobeCase<'a> {
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

impl LobeCase<'_> {
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
    pub fn samples(&mut self, count: usize) -> Result<Vec<Option<Sampled>>, Stop> {
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

    /// The values in these directions, seen from `wo`, and what rounding may do to them.
    ///
    /// # Errors
    /// Says why there are none.
    pub fn measured(&mut self, wo: Vector, wi: &[Vector]) -> Result<Vec<Measured>, Stop> {
        let lobe = &mut self.lobe;
        measured(wi, self.rounding, |wi| lobe.eval(wo, wi))
    }
}
