//! A random colour for each of many shapes (Suffern, ch. 22: the spheres of a grid).

use super::{Made, Specification, Texture, TexturePoint, made};
use crate::kinds::Resources;
use crate::math::{Pcg32, hash};
use crate::rgb::Rgb;

/// A random colour for each shape in a compound, lattice or set of random spheres, uniform in the
/// RGB cube and constant over the shape.
#[kind(PartialEq)]
pub struct RandomColors {
    /// The seed of the random colours.
    #[default]
    pub seed: u64,
}

impl Specification for RandomColors {
    fn make(&self, _: &mut Resources) -> Made {
        made(self.clone())
    }
}

impl Texture for RandomColors {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        let mut random = Pcg32::new(hash(&[self.seed, at.leaf()]), 0);
        let mut channel = || random.uniform();
        Rgb::new(channel(), channel(), channel())
    }
}
