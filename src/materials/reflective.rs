//! The reflective material (Suffern, ch. 24): a mirror over Phong shading.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::phong::{self, Phong};
use super::{Material, Response};
use crate::invalid::{Invalid, not_negative};
use crate::kinds::{self, Specification};
use crate::lobes::{NormalKind, PerfectSpecular};
use crate::rgb::Rgb;
use crate::shapes::Surface;
use crate::textures::{Paint, Texture};

/// A mirror of reflectance `kr · cr` over a Phong base. It needs `whitted` or a path tracer.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Reflective {
    /// The fields of `phong`, for what is under the mirror; nothing if left out.
    #[serde(default)]
    pub phong: Phong,
    /// The share of light that is mirrored, from 0 to 1 mostly; not negative.
    pub kr: f64,
    /// The colour of the mirror.
    #[serde(default = "kinds::white::<Paint>")]
    pub cr: Paint,
}

#[derive(Debug)]
struct Built {
    phong: phong::Built,
    kr: f64,
    cr: Arc<dyn Texture>,
}

impl Specification for Reflective {
    type Built = Arc<dyn Material>;
    type Context = ();

    fn build(&self, (): &mut ()) -> Result<Arc<dyn Material>, Invalid> {
        Ok(Arc::new(Built {
            phong: self.phong.check().map_err(|e| e.inside("phong"))?,
            kr: not_negative("kr", self.kr)?,
            cr: self.cr.build("cr")?,
        }))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self { phong: self.phong.scaled(factor), cr: self.cr.scaled(factor), ..*self }
    }

    fn specimens() -> Vec<Self> {
        let phong = Phong::specimens().remove(0);
        vec![Self { phong, kr: 0.75, cr: Rgb::new(0.9, 1.0, 0.9).into() }]
    }
}

impl Material for Built {
    fn respond(&self, at: &Surface, cos_o: f64, response: &mut Response) {
        self.phong.respond(at, cos_o, response);
        let reflectance = self.kr * self.cr.color(at);
        if !reflectance.is_black() {
            response.lobes.push((PerfectSpecular { reflectance }.into(), NormalKind::Shading));
        }
    }
}
