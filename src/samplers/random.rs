//! Pure random samples (Suffern, ch. 4 and 5).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Sampler;
use crate::math::Pcg32;

/// Independent uniform points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Random {}

without_settings!(Random);

impl Sampler for Random {
    fn fill(&self, n: u32, random: &mut Pcg32) -> Vec<[f64; 2]> {
        (0..n).map(|_| [random.uniform(), random.uniform()]).collect()
    }

    fn round_up(&self, n: u32) -> u32 {
        n
    }
}
