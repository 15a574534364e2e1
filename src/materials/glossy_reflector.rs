//! The glossy reflector (Suffern, ch. 25): a blurred mirror over Phong shading.

use super::phong::{self, Phong};
use super::{
    Made, Material, Response, Specification, TexturedField, built_exponent, made, textured, within,
};
use crate::kinds::{self, Resources};
use crate::lobes::{GlossyReflection, GlossyRule, NormalKind};
use crate::textures::{Amount, Color, Paint, TexturePoint, Value};

/// A blurred mirror of reflectance `kr · cr` over a Phong base. It needs `whitted` or a path
/// tracer, and some samples a pixel: each looks in one direction.
#[kind]
pub struct GlossyReflector {
    /// The fields of `phong`, for what is under the mirror; nothing if left out. Its exponent is
    /// that of the highlights.
    #[default]
    pub phong: Phong,
    /// The share of light that is reflected, from 0 to 1 mostly; not negative.
    pub kr: Amount,
    /// The colour of the reflection.
    #[default(kinds::white())]
    pub cr: Paint,
    /// The exponent `e` of the reflection, from 0 to 1e15: 10 blurs all but the nearest, 10000
    /// hardly anything.
    pub exponent: Amount,
    /// What a reflected ray counts; as in the book if left out.
    #[default]
    pub rule: GlossyRule,
}

#[derive(Debug)]
struct BlurredMirror {
    phong: phong::PhongMaterial,
    kr: Value,
    cr: Color,
    exponent: Value,
    rule: GlossyRule,
}

impl Specification for GlossyReflector {
    const FORMULA: &'static str = "\
        ρa and f as of `phong`, with the fields of `phong` in it. Besides it adds the integral of \
        g(ωi, ωo) · L(ωi) · cosθ over the hemisphere, where L is the radiance that arrives. With r \
        = 2 (n·ωo) n - ωo and p(ω) = (exponent + 1)/(2π) · max(0, r·ω)^exponent, the rule `book` \
        has g · cosθ = kr · cr · p(ωi), and a direction that p draws below the surface is turned \
        by 180 degrees about r; the rule `normalised` has g = kr · cr · (exponent + 2)/(2π) · \
        max(0, r·ωi)^exponent. The viewer is on the side that the normal points to.";

    fn make(&self, resources: &mut Resources) -> Made {
        made(BlurredMirror {
            phong: self.phong.check(resources).map_err(|e| e.inside("phong"))?,
            kr: self.kr.build("kr", resources)?,
            cr: self.cr.build("cr", resources)?,
            exponent: built_exponent(&self.exponent, resources)?,
            rule: self.rule,
        })
    }
}

impl Material for BlurredMirror {
    fn respond(&self, at: &TexturePoint<'_>, cos_o: f64, response: &mut Response) {
        self.phong.respond(at, cos_o, response);
        let reflectance = self.kr.at(at) * self.cr.at(at);
        if !reflectance.is_black() {
            let (exponent, rule) = (self.exponent.at(at), self.rule);
            let lobe = GlossyReflection { reflectance, exponent, rule };
            response.lobes.push((lobe.into(), NormalKind::Shading));
        }
    }

    fn needs_rays(&self) -> bool {
        true
    }

    fn textures(&self, at: &TexturePoint<'_>) -> Vec<TexturedField<'_>> {
        let Self { kr, cr, exponent, .. } = self;
        let own = [("kr", kr.texture()), ("cr", cr.texture()), ("exponent", exponent.texture())];
        let mut all = textured(own);
        all.extend(within("phong", &self.phong, at));
        all
    }
}
