//! The Phong material (Suffern, ch. 15): matte with a highlight.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Material, Response, matte};
use crate::invalid::{Invalid, not_negative};
use crate::kinds::Specification;
use crate::lobes::{GlossySpecular, NormalKind};
use crate::rgb::Rgb;
use crate::shapes::Surface;
use crate::textures::{Paint, Texture};

/// Ambient, diffuse and glossy specular reflection.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Phong {
    /// The share of ambient light that is reflected, mostly 0 to 1; not negative.
    pub ka: f64,
    /// The share of the lights' light that is scattered, mostly 0 to 1; not negative. With 0 for
    /// both, nothing is seen of `cd`.
    pub kd: f64,
    /// The colour of ambient and diffuse reflection, with channels from 0 to 1.
    pub cd: Paint,
    /// The strength of the highlight, mostly 0 to 1; not negative.
    pub ks: f64,
    /// The colour of the highlight; white takes the colour of the light.
    pub cs: Paint,
    /// The exponent `e` of the highlight, not negative: 20 is wide, 2000 is small and sharp.
    pub exponent: f64,
}

impl Default for Phong {
    fn default() -> Self {
        let (cd, cs) = (Rgb::BLACK.into(), Rgb::WHITE.into());
        Self { ka: 0.0, kd: 0.0, cd, ks: 0.0, cs, exponent: 1.0 }
    }
}

/// A Phong surface ready to be asked.
#[derive(Debug)]
pub(super) struct Built {
    matte: matte::Built,
    ks: f64,
    cs: Arc<dyn Texture>,
    exponent: f64,
}

impl Phong {
    pub(super) fn check(&self) -> Result<Built, Invalid> {
        let matte = matte::Matte { ka: self.ka, kd: self.kd, cd: self.cd.clone() };
        Ok(Built {
            matte: matte.check()?,
            ks: not_negative("ks", self.ks)?,
            cs: self.cs.build("cs")?,
            exponent: not_negative("exponent", self.exponent)?,
        })
    }
}

impl Specification for Phong {
    type Built = Arc<dyn Material>;
    type Context = ();

    fn build(&self, (): &mut ()) -> Result<Arc<dyn Material>, Invalid> {
        Ok(Arc::new(self.check()?))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self { cd: self.cd.scaled(factor), cs: self.cs.scaled(factor), ..*self }
    }

    fn specimens() -> Vec<Self> {
        let cd = Rgb::new(0.5, 0.6, 0.1).into();
        vec![Self { ka: 0.25, kd: 0.5, cd, ks: 0.2, exponent: 20.0, ..Self::default() }]
    }
}

impl Material for Built {
    fn respond(&self, at: &Surface, cos_o: f64, response: &mut Response) {
        self.matte.respond(at, cos_o, response);
        if self.ks > 0.0 {
            let reflectance = self.ks * self.cs.color(at);
            let lobe = GlossySpecular { reflectance, exponent: self.exponent };
            response.lobes.push((lobe.into(), NormalKind::Shading));
        }
    }
}
