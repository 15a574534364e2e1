//! The simple transparent material (Suffern, ch. 27): constant shares, reflected and refracted.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::phong::{self, Phong};
use super::{Material, Response};
use crate::invalid::{Invalid, not_negative, positive};
use crate::kinds::{self, Specification};
use crate::lobes::{NormalKind, PerfectSpecular, PerfectTransmitter};
use crate::rgb::Rgb;
use crate::shapes::Surface;
use crate::textures::{Paint, Texture};

/// A clear body that reflects `kr` and lets through `kt`, whatever the angle; on total internal
/// reflection it reflects everything. It needs `whitted` or a path tracer. It says nothing of what
/// media absorb: rays stay in the one they came through.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Transparent {
    /// The fields of `phong`, for highlights; none if left out.
    #[serde(default)]
    pub phong: Phong,
    /// The share of light that is reflected, from 0 to 1 mostly; not negative.
    #[serde(default)]
    pub kr: f64,
    /// The colour of the reflection.
    #[serde(default = "kinds::white::<Paint>")]
    pub cr: Paint,
    /// The share of light that is let through; not negative, and `kr + kt` should be 1.
    pub kt: f64,
    /// The index of refraction inside over the one outside, `ior` in the book; positive. Glass is
    /// about 1.5, water 1.33.
    pub eta: f64,
}

#[derive(Debug)]
struct Built {
    phong: phong::Built,
    kr: f64,
    cr: Arc<dyn Texture>,
    kt: f64,
    eta: f64,
}

impl Specification for Transparent {
    type Built = Arc<dyn Material>;
    type Context = ();

    fn build(&self, (): &mut ()) -> Result<Arc<dyn Material>, Invalid> {
        Ok(Arc::new(Built {
            phong: self.phong.check().map_err(|e| e.inside("phong"))?,
            kr: not_negative("kr", self.kr)?,
            cr: self.cr.build("cr")?,
            kt: not_negative("kt", self.kt)?,
            eta: positive("eta", self.eta)?,
        }))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self { phong: self.phong.scaled(factor), cr: self.cr.scaled(factor), ..*self }
    }

    fn specimens() -> Vec<Self> {
        let phong = Phong { ks: 0.2, exponent: 2000.0, ..Phong::default() };
        let glass = Self { phong, kr: 0.1, cr: Rgb::WHITE.into(), kt: 0.9, eta: 1.5 };
        vec![Self { eta: 0.75, ..glass.clone() }, glass]
    }
}

impl Material for Built {
    fn respond(&self, at: &Surface, cos_o: f64, response: &mut Response) {
        self.phong.respond(at, cos_o, response);
        let transmitter = PerfectTransmitter { transmittance: self.kt, eta: self.eta };
        // weight 1, not k_r: nothing passes that could make up for the rest
        let reflectance = if transmitter.reflects_totally(cos_o) {
            Rgb::WHITE
        } else {
            self.kr * self.cr.color(at)
        };
        if !reflectance.is_black() {
            response.lobes.push((PerfectSpecular { reflectance }.into(), NormalKind::Geometry));
        }
        if self.kt > 0.0 {
            response.lobes.push((transmitter.into(), NormalKind::Geometry));
        }
    }

    fn transmits(&self) -> bool {
        true
    }
}
