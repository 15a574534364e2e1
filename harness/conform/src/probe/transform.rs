//! The matrix of a list of steps, and its inverse.

use serde::{Deserialize, Serialize};

use super::numbers::Real;
use groundtruth::invalid::Invalid;
use groundtruth::math::Step;
use groundtruth::shapes::transform_of;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Transform {
    steps: Vec<Step>,
}

#[derive(Serialize)]
pub struct Transformed {
    matrix: [[Real; 4]; 3],
    inverse: [[Real; 4]; 3],
    condition: Real,
}

impl super::Question for Transform {
    type Answer = Transformed;

    fn answer(&self) -> Result<Transformed, Invalid> {
        let transform = transform_of("steps", &self.steps)?;
        let rows = |it: groundtruth::math::Transform| it.rows().map(|row| row.map(Real));
        Ok(Transformed {
            matrix: rows(transform),
            inverse: rows(transform.inverse()),
            condition: Real(transform.condition()),
        })
    }
}
