//! Pure random samples (Suffern, ch. 4 and 5).

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::Sampler;
use crate::invalid::Invalid;
use crate::kinds::Specification;
use crate::math::Pcg32;

/// Independent uniform points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Random {}

impl Specification for Random {
    type Built = Arc<dyn Sampler>;
    type Context = ();

    fn build(&self, (): &mut ()) -> Result<Arc<dyn Sampler>, Invalid> {
        Ok(Arc::new(*self))
    }

    fn scaled(&self, _: f64) -> Self {
        *self
    }

    fn specimens() -> Vec<Self> {
        vec![Self {}]
    }
}

impl Sampler for Random {
    fn fill(&self, n: u32, random: &mut Pcg32) -> Vec<[f64; 2]> {
        (0..n).map(|_| [random.uniform(), random.uniform()]).collect()
    }

    fn round_up(&self, n: u32) -> u32 {
        n
    }
}
