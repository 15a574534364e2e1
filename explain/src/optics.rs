//! Reflection and transmission at a boundary between two media, in the terms of chapters 27 and 28.

use groundtruth::lobes::{Lobes, NormalKind, refract};
use groundtruth::materials::Medium;
use groundtruth::math::{Normal, atan2, to_degrees};
use groundtruth::rgb::Rgb;
use groundtruth::trace::ShadingPoint;
use serde::Serialize;

/// Refraction at a hit, for the ray that met it. Angles are in degrees from the true normal.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Optics {
    /// The index of refraction behind the surface over the one in front of it.
    pub eta: f64,
    /// The critical angle: reflection is total from it on. Only if `eta < 1`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub critical_angle: Option<f64>,
    /// The angle of refraction; `None` on total internal reflection.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle_of_refraction: Option<f64>,
    /// The share of light that is reflected, `R` (`k_r` in the book).
    pub reflected: Rgb,
    /// The share that is transmitted, `T` (`k_t` in the book), without the `1/η²` of radiance.
    pub transmitted: Rgb,
    /// Whether refraction multiplies radiance by `1/η²`, as the scene says it; worked out by an
    /// explanation.
    #[serde(skip)]
    pub scales_radiance: bool,
    /// The media in front of and behind the surface, if the material has them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub media: Option<[Medium; 2]>,
}

impl Optics {
    /// The optics of a hit whose lobes refract; `None` for opaque surfaces.
    pub(crate) fn of(point: &ShadingPoint<'_>, lobes: &Lobes) -> Option<Self> {
        let wo = point.frame(NormalKind::Geometry).to_local(point.wo);
        let eta = lobes.iter().find_map(|(lobe, _)| lobe.relative_eta(wo))?;
        let front = if wo.z() < 0.0 { -Normal::Z } else { Normal::Z };
        let share = |transmits: bool| -> Rgb {
            let specular = lobes.iter().filter(|(lobe, _)| lobe.is_specular());
            let its = specular.filter(|(lobe, _)| lobe.relative_eta(wo).is_some() == transmits);
            its.map(|(lobe, _)| lobe.albedo(wo)).sum()
        };
        let angle = |sin: f64, cos: f64| to_degrees(atan2(sin, cos));
        let media = point.hit.material.recipe.boundary().map(|boundary| {
            let [inside, outside] = [boundary.inside, boundary.outside];
            if point.cos_o < 0.0 { [inside, outside] } else { [outside, inside] }
        });
        Some(Self {
            eta,
            critical_angle: (eta < 1.0).then(|| angle(eta, ((1.0 - eta) * (1.0 + eta)).sqrt())),
            angle_of_refraction: refract(wo, front, eta)
                .map(|t| angle((t.x() * t.x() + t.y() * t.y()).sqrt(), t.z().abs())),
            reflected: share(false),
            transmitted: (eta * eta) * share(true),
            scales_radiance: true,
            media,
        })
    }
}
