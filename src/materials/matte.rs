//! The matte material (Suffern, ch. 14).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Material, Response};
use crate::invalid::{Invalid, not_negative};
use crate::kinds::Specification;
use crate::lobes::{Lambertian, NormalKind};
use crate::rgb::Rgb;
use crate::shapes::Surface;
use crate::textures::{Paint, Texture};

/// A perfectly diffuse surface; ambient and diffuse reflection share a colour.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Matte {
    /// The share of ambient light that is reflected, mostly 0 to 1; not negative.
    #[serde(default)]
    pub ka: f64,
    /// The share of the lights' light that is scattered, mostly 0 to 1; not negative. With 0 for
    /// both, nothing is seen of `cd`.
    #[serde(default)]
    pub kd: f64,
    /// The colour of ambient and diffuse reflection, with channels from 0 to 1.
    pub cd: Paint,
}

/// A matte surface ready to be asked.
#[derive(Debug)]
pub(super) struct Built {
    ka: f64,
    kd: f64,
    cd: Arc<dyn Texture>,
}

impl Matte {
    pub(super) fn check(&self) -> Result<Built, Invalid> {
        Ok(Built {
            ka: not_negative("ka", self.ka)?,
            kd: not_negative("kd", self.kd)?,
            cd: self.cd.build("cd")?,
        })
    }
}

impl Specification for Matte {
    type Built = Arc<dyn Material>;
    type Context = ();

    fn build(&self, (): &mut ()) -> Result<Arc<dyn Material>, Invalid> {
        Ok(Arc::new(self.check()?))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self { cd: self.cd.scaled(factor), ..*self }
    }

    fn specimens() -> Vec<Self> {
        vec![Self { ka: 0.25, kd: 0.75, cd: Rgb::new(1.0, 0.5, 0.25).into() }]
    }
}

impl Material for Built {
    fn respond(&self, at: &Surface, _: f64, response: &mut Response) {
        if self.ka == 0.0 && self.kd == 0.0 {
            return;
        }
        let cd = self.cd.color(at);
        response.ambient = self.ka * cd;
        if self.kd > 0.0 {
            let lobe = Lambertian { reflectance: self.kd * cd };
            response.lobes.push((lobe.into(), NormalKind::Shading));
        }
    }
}
