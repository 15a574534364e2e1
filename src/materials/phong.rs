//! The Phong material (Suffern, ch. 15): matte with a highlight.

use super::matte::{self, Matte};
use super::{
    Made, Material, Response, Specification, TexturedField, built_exponent, made, textured,
};
use crate::invalid::Invalid;
use crate::kinds::Resources;
use crate::lobes::{GlossySpecular, NormalKind};
use crate::rgb::Rgb;
use crate::textures::{Amount, Color, Paint, TexturePoint, Value};

/// Ambient, diffuse and glossy specular reflection.
#[kind(Default)]
pub struct Phong {
    /// The share of ambient light that is reflected, mostly 0 to 1; not negative.
    #[default]
    pub ka: Amount,
    /// The share of the lights' light that is scattered, mostly 0 to 1; not negative. With 0 for
    /// both, nothing is seen of `cd`.
    #[default]
    pub kd: Amount,
    /// The colour of ambient and diffuse reflection, with channels from 0 to 1.
    #[default(Rgb::BLACK.into())]
    pub cd: Paint,
    /// The strength of the highlight, mostly 0 to 1; not negative.
    #[default]
    pub ks: Amount,
    /// The colour of the highlight; white takes the colour of the light.
    #[default(Rgb::WHITE.into())]
    pub cs: Paint,
    /// The exponent `e` of the highlight, from 0 to 1e15: 20 is wide, 2000 is small and sharp.
    #[default(Amount::one())]
    pub exponent: Amount,
}

/// A Phong surface ready to be asked.
#[derive(Debug)]
pub(super) struct PhongMaterial {
    matte: matte::MatteMaterial,
    ks: Value,
    cs: Color,
    exponent: Value,
}

impl Phong {
    pub(super) fn check(&self, resources: &mut Resources) -> Result<PhongMaterial, Invalid> {
        let matte = Matte { ka: self.ka.clone(), kd: self.kd.clone(), cd: self.cd.clone() };
        Ok(PhongMaterial {
            matte: matte.check(resources)?,
            ks: self.ks.build("ks", resources)?,
            cs: self.cs.build("cs", resources)?,
            exponent: built_exponent(&self.exponent, resources)?,
        })
    }
}

impl Specification for Phong {
    const FORMULA: &'static str = "\
        ρa = ka · cd, and f = kd · cd / π + ks · cs · max(0, r·ωo)^exponent with r = 2 (n·ωi) n - \
        ωi. The second term has no normalising factor; like all of f it is multiplied by cosθ.";

    fn make(&self, resources: &mut Resources) -> Made {
        made(self.check(resources)?)
    }
}

impl Material for PhongMaterial {
    fn respond(&self, at: &TexturePoint<'_>, cos_o: f64, response: &mut Response) {
        self.matte.respond(at, cos_o, response);
        let ks = self.ks.at(at);
        if ks > 0.0 {
            let reflectance = ks * self.cs.at(at);
            let lobe = GlossySpecular { reflectance, exponent: self.exponent.at(at) };
            response.lobes.push((lobe.into(), NormalKind::Shading));
        }
    }

    fn textures(&self, at: &TexturePoint<'_>) -> Vec<TexturedField<'_>> {
        let Self { matte, ks, cs, exponent } = self;
        let own = [("ks", ks.texture()), ("cs", cs.texture()), ("exponent", exponent.texture())];
        let mut all = matte.textures(at);
        all.extend(textured(own));
        all
    }
}
