//! The scene as a backdrop: its surfaces in their own colours, lit from the eye.

use groundtruth::lobes::Lobes;
use groundtruth::materials::Response;
use groundtruth::math::{Frame, Ray, Span, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::world::{Hit, World};

/// The share of light that a surface is drawn with if one looks through it.
const FADED: f64 = 0.16;
/// The most surfaces that are drawn one behind the other.
const MAX_SURFACES: usize = 24;
/// The radiance of a surface seen at grazing angle, as a part of that of one seen straight.
const GRAZING: f64 = 0.3;
/// Where no surface is.
const EMPTY: Rgb = Rgb::grey(0.055);

/// The scene lit by a lamp at the eye: every side of it can be seen, whatever its own lights are. One looks through
/// the surfaces of transparent materials and of faded objects.
#[derive(Clone, Copy, Debug)]
pub struct Backdrop<'a> {
    /// The scene.
    pub world: &'a World,
    /// The indices of the objects that are looked through.
    pub faded: &'a [u32],
}

impl Backdrop<'_> {
    /// The radiance along a ray, from 0 to 1.
    pub fn color(&self, ray: &Ray) -> Rgb {
        self.color_before(ray, EMPTY)
    }

    /// The same with another colour where no surface is.
    pub fn color_before(&self, ray: &Ray, empty: Rgb) -> Rgb {
        let (mut ray, mut color, mut left) = (*ray, Rgb::BLACK, 1.0);
        for _ in 0..MAX_SURFACES {
            let Some(hit) = self.world.hit(&ray, Span::AHEAD) else { break };
            let opacity = if self.is_faded(&hit) { FADED } else { 1.0 };
            color += left * opacity * lit(&hit, &ray);
            left *= 1.0 - opacity;
            if left == 0.0 {
                return color;
            }
            ray.origin = hit.surface.leave(ray.direction);
        }
        color + left * empty
    }

    /// The first hit of a surface that is not looked through.
    pub fn first_opaque(&self, ray: &Ray, span: Span) -> Option<Hit<'_>> {
        let (mut ray, mut span) = (*ray, span);
        for _ in 0..MAX_SURFACES {
            let hit = self.world.hit(&ray, span)?;
            if !self.is_faded(&hit) {
                return Some(hit);
            }
            span.max -= hit.t;
            ray.origin = hit.surface.leave(ray.direction);
        }
        None
    }

    fn is_faded(&self, hit: &Hit<'_>) -> bool {
        hit.material.recipe.transmits() || self.faded.contains(&hit.object.index)
    }
}

/// A surface's own colour, lit from where it is seen.
fn lit(hit: &Hit<'_>, ray: &Ray) -> Rgb {
    let direction = ray.direction.unit().unwrap_or_default();
    let normal = if hit.front { hit.surface.normal } else { -hit.surface.normal };
    let cosine = -normal.dot(direction);
    let mut response = Response::default();
    let at = hit.texture_point();
    hit.material.recipe.respond(&at, cosine, &mut response);
    let shining = hit
        .material
        .recipe
        .emission()
        .map_or(Rgb::BLACK, |emission| emission.radiance(&at, cosine));
    let wo = Frame::around(normal).to_local(-direction);
    let own = albedo(&response.lobes, wo) + shining;
    (GRAZING + (1.0 - GRAZING) * cosine) * own.map(|value| value.clamp(0.0, 1.0))
}

/// The share of light from all sides that is scattered to a viewer in this direction of the local frame.
fn albedo(lobes: &Lobes, wo: Vector) -> Rgb {
    lobes.iter().map(|(lobe, ..)| lobe.albedo(wo)).sum()
}
