//! The reflective material (Suffern, ch. 24): a mirror over Phong shading.

use super::phong::{self, Phong};
use super::{Made, Material, Response, Specification, TexturedField, made, textured, within};
use crate::kinds::{self, Resources};
use crate::lobes::{NormalKind, PerfectSpecular};
use crate::textures::{Amount, Color, Paint, TexturePoint, Value};

/// A mirror of reflectance `kr · cr` over a Phong base. It needs `whitted` or a path tracer.
#[kind]
pub struct Reflective {
    /// The fields of `phong`, for what is under the mirror; nothing if left out.
    #[default]
    pub phong: Phong,
    /// The share of light that is mirrored, from 0 to 1 mostly; not negative.
    pub kr: Amount,
    /// The colour of the mirror.
    #[default(kinds::white())]
    pub cr: Paint,
}

#[derive(Debug)]
struct ReflectiveMaterial {
    phong: phong::PhongMaterial,
    kr: Value,
    cr: Color,
}

impl Specification for Reflective {
    const FORMULA: &'static str = "\
        ρa and f as of `phong`, with the fields of `phong` in it. Besides it adds kr · cr times \
        the radiance that arrives from the mirror direction 2 (n·ωo) n - ωo, without any cosine, \
        and on both sides of the surface.";

    fn make(&self, resources: &mut Resources) -> Made {
        made(ReflectiveMaterial {
            phong: self.phong.check(resources).map_err(|e| e.inside("phong"))?,
            kr: self.kr.build("kr", resources)?,
            cr: self.cr.build("cr", resources)?,
        })
    }
}

impl Material for ReflectiveMaterial {
    fn respond(&self, at: &TexturePoint<'_>, cos_o: f64, response: &mut Response) {
        self.phong.respond(at, cos_o, response);
        let reflectance = self.kr.at(at) * self.cr.at(at);
        if !reflectance.is_black() {
            response.lobes.push((PerfectSpecular { reflectance }.into(), NormalKind::Shading));
        }
    }

    fn needs_rays(&self) -> bool {
        true
    }

    fn textures(&self, at: &TexturePoint<'_>) -> Vec<TexturedField<'_>> {
        let mut all = textured([("kr", self.kr.texture()), ("cr", self.cr.texture())]);
        all.extend(within("phong", &self.phong, at));
        all
    }
}
