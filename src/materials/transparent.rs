//! The simple transparent material (Suffern, ch. 27): constant shares, reflected and refracted.

use super::phong::{self, Phong};
use super::{Made, Material, Response, Specification, TexturedField, made, textured, within};
use crate::kinds::{self, Resources};
use crate::lobes::{NormalKind, PerfectSpecular, PerfectTransmitter};
use crate::math::Index;
use crate::rgb::Rgb;
use crate::textures::{Amount, Color, Paint, TexturePoint, Value};

/// A clear body that reflects `kr` and lets through `kt`, whatever the angle; on total internal
/// reflection it reflects everything. It needs `whitted` or a path tracer. It says nothing of what
/// media absorb: rays stay in the one they came through.
#[kind]
pub struct Transparent {
    /// The fields of `phong`, for highlights; none if left out.
    #[default]
    pub phong: Phong,
    /// The share of light that is reflected, from 0 to 1 mostly; not negative.
    #[default]
    pub kr: Amount,
    /// The colour of the reflection.
    #[default(kinds::white())]
    pub cr: Paint,
    /// The share of light that is let through; not negative, and `kr + kt` should be 1.
    pub kt: Amount,
    /// The index of refraction inside over the one outside, `ior` in the book; from 1e-10 to 1e10.
    /// Glass is about 1.5, water 1.33.
    pub eta: Index,
}

#[derive(Debug)]
struct TransparentMaterial {
    phong: phong::PhongMaterial,
    kr: Value,
    cr: Color,
    kt: Value,
    eta: f64,
}

impl Specification for Transparent {
    const FORMULA: &'static str = "\
        ρa and f as of `phong`, with the fields of `phong` in it. Besides it adds kr · cr times \
        the radiance from the mirror direction, and kt/h² times the radiance from the refracted \
        direction, where h is the index of refraction on the other side over that on the viewer's \
        side: `eta` for a viewer on the side that the normal points to, 1/eta for one inside. By \
        Snell's law sinθ = h sinθt. On total reflection (sinθ > h) it adds the radiance of the \
        mirror direction with weight 1, and nothing is refracted.";

    fn make(&self, resources: &mut Resources) -> Made {
        made(TransparentMaterial {
            phong: self.phong.check(resources).map_err(|e| e.inside("phong"))?,
            kr: self.kr.build("kr", resources)?,
            cr: self.cr.build("cr", resources)?,
            kt: self.kt.build("kt", resources)?,
            eta: self.eta,
        })
    }
}

impl Material for TransparentMaterial {
    fn respond(&self, at: &TexturePoint<'_>, cos_o: f64, response: &mut Response) {
        self.phong.respond(at, cos_o, response);
        let kt = self.kt.at(at);
        let transmitter = PerfectTransmitter { transmittance: kt, eta: self.eta };
        // weight 1, not k_r: nothing passes that could make up for the rest
        let reflectance = if transmitter.reflects_totally(cos_o) {
            Rgb::WHITE
        } else {
            self.kr.at(at) * self.cr.at(at)
        };
        if !reflectance.is_black() {
            response.lobes.push((PerfectSpecular { reflectance }.into(), NormalKind::Geometry));
        }
        if kt > 0.0 {
            response.lobes.push((transmitter.into(), NormalKind::Geometry));
        }
    }

    fn transmits(&self) -> bool {
        true
    }

    fn textures(&self, at: &TexturePoint<'_>) -> Vec<TexturedField<'_>> {
        let Self { kr, cr, kt, .. } = self;
        let own = [("kr", kr.texture()), ("cr", cr.texture()), ("kt", kt.texture())];
        let mut all = textured(own);
        all.extend(within("phong", &self.phong, at));
        all
    }
}
