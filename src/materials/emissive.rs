//! The emissive material (Suffern, ch. 18 and 24): a surface that shines.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Material, Response};
use crate::invalid::{Invalid, not_negative};
use crate::kinds::{self, Specification};
use crate::rgb::Rgb;
use crate::shapes::Surface;
use crate::textures::{Paint, Texture};

/// Radiance `ls · ce` in every direction on the outer side; black on the inner.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Emissive {
    /// Multiplies the colour; not negative.
    #[serde(default = "kinds::one")]
    pub ls: f64,
    /// The colour of the light it sends out.
    #[serde(default = "kinds::white::<Paint>")]
    pub ce: Paint,
}

#[derive(Debug)]
struct Built {
    ls: f64,
    ce: Arc<dyn Texture>,
}

impl Specification for Emissive {
    type Built = Arc<dyn Material>;
    type Context = ();

    fn build(&self, (): &mut ()) -> Result<Arc<dyn Material>, Invalid> {
        Ok(Arc::new(Built { ls: not_negative("ls", self.ls)?, ce: self.ce.build("ce")? }))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self { ce: self.ce.scaled(factor), ..*self }
    }

    fn specimens() -> Vec<Self> {
        vec![Self { ls: 2.5, ce: Rgb::new(1.0, 1.0, 0.5).into() }]
    }
}

impl Material for Built {
    fn respond(&self, _: &Surface, _: f64, _: &mut Response) {}

    fn emitted(&self, at: &Surface, cos_o: f64) -> Rgb {
        if cos_o > 0.0 { self.ls * self.ce.color(at) } else { Rgb::BLACK }
    }
}
