//! The matte material (Suffern, ch. 14).

use super::{Made, Material, Response, Specification, TexturedField, made, textured};
use crate::invalid::Invalid;
use crate::kinds::Resources;
use crate::lobes::{Lambertian, NormalKind};
use crate::textures::{Amount, Color, Paint, TexturePoint, Value};

/// A perfectly diffuse surface; ambient and diffuse reflection share a colour.
#[kind]
pub struct Matte {
    /// The share of ambient light that is reflected, mostly 0 to 1; not negative.
    #[default]
    pub ka: Amount,
    /// The share of the lights' light that is scattered, mostly 0 to 1; not negative. With 0 for
    /// both, nothing is seen of `cd`.
    #[default]
    pub kd: Amount,
    /// The colour of ambient and diffuse reflection, with channels from 0 to 1.
    pub cd: Paint,
}

/// A matte surface ready to be asked.
#[derive(Debug)]
pub(super) struct MatteMaterial {
    ka: Value,
    kd: Value,
    cd: Color,
}

impl Matte {
    pub(super) fn check(&self, resources: &mut Resources) -> Result<MatteMaterial, Invalid> {
        Ok(MatteMaterial {
            ka: self.ka.build("ka", resources)?,
            kd: self.kd.build("kd", resources)?,
            cd: self.cd.build("cd", resources)?,
        })
    }
}

impl Specification for Matte {
    const FORMULA: &'static str = "ρa = ka · cd, and f = kd · cd / π.";

    fn make(&self, resources: &mut Resources) -> Made {
        made(self.check(resources)?)
    }
}

impl Material for MatteMaterial {
    fn respond(&self, at: &TexturePoint<'_>, _: f64, response: &mut Response) {
        let (ka, kd) = (self.ka.at(at), self.kd.at(at));
        if ka == 0.0 && kd == 0.0 {
            return;
        }
        let cd = self.cd.at(at);
        response.ambient = ka * cd;
        if kd > 0.0 {
            let lobe = Lambertian { reflectance: kd * cd };
            response.lobes.push((lobe.into(), NormalKind::Shading));
        }
    }

    fn textures(&self, _: &TexturePoint<'_>) -> Vec<TexturedField<'_>> {
        let Self { ka, kd, cd } = self;
        textured([("ka", ka.texture()), ("kd", kd.texture()), ("cd", cd.texture())])
    }
}
