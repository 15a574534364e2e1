//! The constant texture (Suffern, ch. 29): a plain colour.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Specification, Texture, TexturePoint};
use crate::invalid::Invalid;
use crate::kinds::Resources;
use crate::rgb::Rgb;

/// The same colour everywhere.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Constant {
    /// The colour.
    pub color: Rgb,
}

impl Specification for Constant {
    fn build(&self, _: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        self.color.checked("color")?;
        Ok(Arc::new(self.clone()))
    }
}

impl Texture for Constant {
    fn color(&self, _: &TexturePoint<'_>) -> Rgb {
        self.color
    }
}
