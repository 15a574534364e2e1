//! What a mistake may know of a term or a ray.

use groundtruth::lights::{LightContext, LightSample};
use groundtruth::lobes::{Lobe, Lobes, Normals};
use groundtruth::math::{Point, Ray, Span, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::trace::{RayKind, ShadingPoint, Term, TermSource};
use groundtruth::world::{PlacedLight, World};

/// A surface that a ray met.
#[derive(Clone, Debug)]
pub struct ObservedSurface {
    /// Along the ray, whose direction is unit.
    pub t: f64,
    pub point: Point,
    /// The normals; of a two-sided surface turned to the viewer.
    pub normals: Normals,
    /// Unit, towards the viewer.
    pub wo: Vector,
    pub lobes: Lobes,
    /// The radius, where the point is one of a sphere.
    pub radius: Option<f64>,
}

/// A ray, and the surface that it met.
#[derive(Clone, Debug)]
pub struct RaySoFar {
    pub kind: RayKind,
    pub ray: Ray,
    /// `None` if it met nothing, or is a shadow ray.
    pub surface: Option<ObservedSurface>,
    /// Whether it is of the last of several samples of the pixel.
    pub is_last_sample: bool,
}

/// A term, for a mistake that changes its value.
#[derive(Clone, Copy, Debug)]
pub struct ObservedTerm<'a> {
    pub world: &'a World,
    pub ray: &'a RaySoFar,
    /// The term as the tracer adds it.
    pub term: &'a Term,
    /// The light that arrives, as the program with the mistake finds it.
    pub arriving: Rgb,
    /// The ray along which it arrives, if one was cast.
    pub from: Option<&'a Ray>,
}

/// A ray that ends, for a mistake that changes what arrives along it.
#[derive(Clone, Copy, Debug)]
pub struct ObservedRay<'a> {
    pub ray: &'a RaySoFar,
    /// The transmittance of its medium.
    pub transmittance: Rgb,
    /// The sum of its terms, as the program with the mistake finds it.
    pub sum: Rgb,
}

impl ObservedRay<'_> {
    pub fn arriving(&self) -> Rgb {
        self.transmittance * self.sum
    }
}

/// A point of a lamp, as seen from a shading point.
#[derive(Clone, Copy, Debug)]
pub struct LampHeard {
    /// The cosine between the lamp's normal and the direction to the shading point, without its sign.
    pub cosine: f64,
    pub distance_squared: f64,
}

impl ObservedSurface {
    pub(super) fn of(point: &ShadingPoint<'_>, lobes: &Lobes) -> Self {
        let (t, normals, wo) = (point.hit.t, point.normals, point.wo);
        let (radius, lobes) = (radius(point), lobes.clone());
        Self { t, point: point.hit.surface.point, normals, wo, lobes, radius }
    }

    /// The cosine between the viewer's direction and the true normal; negative on the inner side.
    pub fn cos_o(&self) -> f64 {
        self.normals.geometry.dot(self.wo)
    }

    /// The index of refraction behind the surface over the one in front of it, for the viewer; `None` for opaque
    /// surfaces.
    pub fn eta(&self) -> Option<f64> {
        // only the sign of z counts
        let wo = Vector::new(0.0, 0.0, self.cos_o());
        self.lobes.iter().find_map(|(lobe, _)| lobe.relative_eta(wo))
    }

    /// Whether the viewer sees total internal reflection.
    pub fn reflects_totally(&self) -> bool {
        let cos_o = self.cos_o();
        let passes = |eta: f64| (eta - 1.0) * (eta + 1.0) + cos_o * cos_o >= 0.0;
        self.eta().is_some_and(|eta| !passes(eta))
    }
}

/// The radius of the ball in the box around the object, if the point and its normal are those of this ball.
fn radius(point: &ShadingPoint<'_>) -> Option<f64> {
    /// Of the box, relative: it may be rounded outwards.
    const ROUNDING: f64 = 1e-6;
    let (bounds, surface) = (point.hit.object.shape.bounds(), &point.hit.surface);
    let radius = 0.5 * bounds.extent().max_abs();
    let off = (surface.point - bounds.center()) - radius * Vector::from(surface.normal);
    (off.max_abs() < ROUNDING * radius).then_some(radius)
}

impl ObservedTerm<'_> {
    /// Its value without a mistake at this surface.
    pub fn value(&self) -> Rgb {
        self.term.weight * self.arriving
    }

    pub fn times(&self, factor: f64) -> Rgb {
        factor * self.value()
    }

    /// Light that arrives at a lobe and leaves it without its weight, but for the probabilities by which it is divided.
    pub fn unweighed(&self) -> Option<Rgb> {
        let TermSource::Traced { lobe_probability, survival, .. } = self.term.source else {
            return None;
        };
        Some((1.0 / (lobe_probability * survival)) * self.arriving)
    }

    /// The density of the ray along which the light arrives, if its lobe drew it by one.
    pub fn density(&self) -> Option<f64> {
        let TermSource::Traced { pdf, .. } = self.term.source else { return None };
        pdf
    }

    /// The lobe that scatters light straight from a source, and the cosine of the light's angle.
    pub fn direct(&self) -> Option<(Lobe, f64)> {
        let TermSource::Direct { lobe, cos_i, .. } = self.term.source else { return None };
        Some((lobe, cos_i))
    }

    /// The lobe that sent the ray along which the light arrives.
    pub fn traced(&self) -> Option<Lobe> {
        let TermSource::Traced { lobe, .. } = self.term.source else { return None };
        Some(lobe)
    }

    /// The cosine between the shading normal and the direction of the ray along which the light arrives, without its sign.
    pub fn cosine_of_ray(&self) -> Option<f64> {
        let normal = self.ray.surface.as_ref()?.normals.shading;
        Some(normal.dot(self.from?.direction.unit()?).abs())
    }

    /// The direction of the light of a term of direct light. `None` if no ray was cast and the light has more than
    /// one direction.
    pub fn light_direction(&self) -> Option<Vector> {
        match self.from {
            Some(ray) if self.direct().is_some() => ray.direction.unit(),
            _ => Some(self.single_sample()?.direction),
        }
    }

    /// What a light that has only one direction says of it, for a term of direct light.
    pub fn single_sample(&self) -> Option<LightSample> {
        let TermSource::Direct { light, .. } = self.term.source else { return None };
        let surface = self.ray.surface.as_ref()?;
        let is_its = |placed: &&PlacedLight| placed.index == light && placed.light.draws() == 0;
        let from = LightContext { point: surface.point, normal: surface.normals.shading };
        self.world.lights.iter().find(is_its)?.light.sample(&from, &[])
    }

    /// The point of the lamp from which a term of direct light comes; `None` for other lights, and if no shadow ray was
    /// cast to it.
    pub fn lamp(&self) -> Option<LampHeard> {
        /// The share of a shadow ray, before its end, in which the lamp is looked for, too.
        const BEFORE_LAMP: f64 = 1e-9;
        let TermSource::Direct { light, .. } = self.term.source else { return None };
        let light = self.world.lights.iter().find(|placed| placed.index == light)?;
        let name = light.light.object()?;
        // the shadow ray ends just in front of the lamp, at t = 1
        let ray = self.from?;
        let beyond = Span { min: 1.0 - BEFORE_LAMP, max: f64::INFINITY };
        let hit = self.world.hit(ray, beyond).filter(|hit| &*hit.object.name == name)?;
        let cosine = hit.surface.normal.dot(ray.direction.unit()?).abs();
        let from = self.ray.surface.as_ref()?.point;
        Some(LampHeard { cosine, distance_squared: hit.surface.point.distance_squared(from) })
    }
}
