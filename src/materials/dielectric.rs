//! The dielectric (Suffern, ch. 28): realistic transparency with colour filtering.

use super::phong::{self, Phong};
use super::{
    Boundary, Made, Material, Medium, Response, Specification, TexturedField, made, within,
};
use crate::kinds::Resources;
use crate::lobes::{FresnelReflector, FresnelTransmitter, NormalKind};
use crate::textures::TexturePoint;

/// Glass, water: a boundary between two media, with Fresnel reflection and refraction, and
/// absorption on either side. It needs `whitted` or a path tracer.
#[kind(Default)]
pub struct Dielectric {
    /// The fields of `phong`, for highlights of the direct light; none if left out.
    #[default]
    pub phong: Phong,
    /// The medium on the inner side, as `{ eta = 1.5 }` for clear glass.
    pub inside: Medium,
    /// The medium on the outer side, to which the normal points; air if left out.
    #[default]
    pub outside: Medium,
}

#[derive(Debug)]
struct DielectricMaterial {
    phong: phong::PhongMaterial,
    eta: f64,
    boundary: Boundary,
}

impl Specification for Dielectric {
    const FORMULA: &'static str = "\
        ρa and f as of `phong`, with the fields of `phong` in it. Besides it adds R times the \
        radiance from the mirror direction and (1 - R)/h² times the radiance from the refracted \
        direction, where h is the index `eta` of the medium on the other side over that of the \
        medium on the viewer's side: `outside` is where the normal points to. By Snell's law sinθ \
        = h sinθt. R = (a² + b²)/2 with a = (h cosθ - cosθt)/(h cosθ + cosθt) and b = (cosθ - h \
        cosθt)/(cosθ + h cosθt); on total reflection (sinθ > h) R = 1.";

    fn make(&self, resources: &mut Resources) -> Made {
        let (inside, outside) = (self.inside.checked("inside")?, self.outside.checked("outside")?);
        made(DielectricMaterial {
            phong: self.phong.check(resources).map_err(|e| e.inside("phong"))?,
            eta: inside.eta / outside.eta,
            boundary: Boundary { inside, outside },
        })
    }
}

impl Material for DielectricMaterial {
    fn respond(&self, at: &TexturePoint<'_>, cos_o: f64, response: &mut Response) {
        self.phong.respond(at, cos_o, response);
        response.lobes.push((FresnelReflector { eta: self.eta }.into(), NormalKind::Geometry));
        response.lobes.push((FresnelTransmitter { eta: self.eta }.into(), NormalKind::Geometry));
    }

    fn boundary(&self) -> Option<Boundary> {
        Some(self.boundary)
    }

    fn textures(&self, at: &TexturePoint<'_>) -> Vec<TexturedField<'_>> {
        within("phong", &self.phong, at).collect()
    }
}
