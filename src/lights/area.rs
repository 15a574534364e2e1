//! The area light (Suffern, ch. 18): an object that shines.

use std::sync::Arc;

use super::{
    Context, Light, LightContext, LightSample, Made, Segment, Specification, Target, made,
};
use crate::invalid::Invalid;
use crate::materials::Emission;
use crate::math::{self, UNIT_ROUNDOFF, Vector};
use crate::rgb::Rgb;
use crate::shapes::{SampledSurface, Sampling, Shape, Surface};
use crate::textures::TexturePoint;
use formats::printable;

/// The light of an emissive object, whose surface is sampled: soft shadows. Its radiance is that of
/// the object's material, on the side of the true normal. Switched off, the object is dark too.
#[kind(PartialEq)]
pub struct Area {
    /// The `name` of the object: a rectangle, disk, sphere, triangle, mesh, tessellated sphere or
    /// an instance of one. Its material is emissive.
    pub object: String,
    /// How its surface is sampled. If left out: by solid angle where that is known (spheres,
    /// rectangles, and instances of them that keep angles), else by area, as in the book.
    pub sampling: Option<Sampling>,
}

/// The shapes that can be lamps, for errors.
const SAMPLED: &str =
    "rectangle, disk, sphere, triangle, mesh, tessellated_sphere, and instances of these";
/// Those that can be sampled by solid angle.
const BY_SOLID_ANGLE: &str = "sphere and rectangle, and instances of them that keep angles";

#[derive(Debug)]
struct Lamp {
    object: String,
    shape: Arc<dyn Shape>,
    surface: Box<dyn SampledSurface>,
    emission: Emission,
    two_sided: bool,
}

impl Specification for Area {
    const FORMULA: &'static str = "\
        adds the integral of f(ωi, ωo) · Le · cosθ cosθ' / d² over the area of the surface of \
        `object` that is visible from the hit: Le = ls · ce of the material of that object, θ' is \
        the angle between its normal and the direction to the hit, d the distance. Where cosθ' is \
        negative nothing is added, or if that material is two-sided |cosθ'| is used. Each sample \
        draws one point; how it is drawn changes the noise only. Switched off, the object is \
        black.";

    fn make(&self, context: &mut Context) -> Made {
        let name = &self.object;
        let shown = printable::name(name);
        let object = context.object(name).map_err(|e| e.inside("object"))?;
        let Some(emission) = object.emission.clone() else {
            let problem =
                format!("the material of `{shown}` does not shine; an `emissive` one is needed");
            return Err(Invalid::field("object", problem));
        };
        let by = |sampling| object.shape.sampled(sampling);
        let surface = match self.sampling {
            None => by(Sampling::SolidAngle).or_else(|| by(Sampling::Area)),
            Some(sampling) => by(sampling),
        };
        let Some(surface) = surface else {
            let solid_angle = self.sampling == Some(Sampling::SolidAngle);
            let (field, which, can) = match solid_angle && by(Sampling::Area).is_some() {
                true => ("sampling", " by solid angle", BY_SOLID_ANGLE),
                false => ("object", "", SAMPLED),
            };
            let problem =
                format!("the shape of `{shown}` cannot be sampled{which}; these can: {can}");
            return Err(Invalid::field(field, problem));
        };
        let (shape, two_sided) = (Arc::clone(&object.shape), object.two_sided);
        made(Lamp { object: name.clone(), shape, surface, emission, two_sided })
    }
}

impl Lamp {
    /// The cosine at the lamp, if the side towards `from` shines. On the back of a two-sided lamp
    /// it is taken with the opposite normal.
    fn cosine(&self, from: math::Point, at: &Surface) -> Option<f64> {
        let cosine = at.normal.dot((from - at.point).unit()?);
        let cosine = if self.two_sided { cosine.abs() } else { cosine };
        (cosine > 0.0).then_some(cosine)
    }

    /// The radiance of the point drawn with the numbers `u`.
    fn radiance(&self, from: math::Point, u: [f64; 2], at: &Surface, cosine: f64) -> Rgb {
        if self.emission.is_plain() {
            return self.emission.radiance(&TexturePoint::new(at), cosine);
        }
        let hit = self.surface.candidate(from, u);
        self.emission.radiance(&TexturePoint::of_hit(at, &*self.shape, &hit), cosine)
    }
}

/// The end of the shadow ray to a point of a lamp. It is in front of the lamp by more than the
/// error of a hit: the lamp, and a surface in its plane, block no light, even at grazing angles.
fn end(from: math::Point, at: &Surface, direction: Vector) -> math::Point {
    // the error of a hit on such a surface is a few u of the coordinates
    let size = at.point.to_vector().max_abs() + from.to_vector().max_abs();
    let error = at.error.max(32.0 * UNIT_ROUNDOFF * size);
    Surface { error, border: None, ..*at }.leave(-direction)
}

impl Light for Lamp {
    fn object(&self) -> Option<&str> {
        Some(&self.object)
    }

    fn draws(&self) -> usize {
        1
    }

    fn sample(&self, from: &LightContext, u: &[[f64; 2]]) -> Option<LightSample> {
        let (at, pdf) = self.surface.sample(from.point, u[0])?;
        let cosine = self.cosine(from.point, &at)?;
        let direction = (at.point - from.point).unit()?;
        Some(LightSample {
            direction,
            segment: Some(Segment::To(end(from.point, &at, direction))),
            radiance: self.radiance(from.point, u[0], &at, cosine),
            blocked: Rgb::BLACK,
            pdf: Some(pdf),
        })
    }

    fn pdf(&self, from: &LightContext, to: &Target<'_>) -> f64 {
        match to {
            Target::Surface(at) if self.cosine(from.point, at).is_some() => {
                self.surface.pdf(from.point, at)
            }
            Target::Surface(_) | Target::Infinity(_) => 0.0,
        }
    }
}
