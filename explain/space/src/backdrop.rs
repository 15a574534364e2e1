//! The scene as a backdrop: its surfaces in their own colours, lit from the eye.

use groundtruth::lobes::Lobes;
use groundtruth::materials::Response;
use groundtruth::math::{Frame, Point, Ray, Span, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::world::{Hit, World};

/// The opacity of a surface that one looks through, seen straight and seen at grazing angle: its outline stays.
const FADED: [f64; 2] = [0.1, 0.6];
/// The most surfaces that are drawn one behind the other.
const MAX_SURFACES: usize = 24;
/// The radiance of a surface seen at grazing angle, as a part of that of one seen straight.
const GRAZING: f64 = 0.3;
/// The colour of surfaces that let light through.
const GLASS: Rgb = Rgb::new(0.6, 0.75, 0.8);
/// A surface this close before a point does not hide it, as a part of the distance to the eye: the point lies on it.
const CLOSE: f64 = 1e-5;

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
    /// The radiance along a ray, from 0 to 1, with this colour where no surface is; and the index of the first object that it
    /// meets, looked through or not.
    pub fn seen(&self, ray: &Ray, empty: Rgb) -> (Rgb, Option<u32>) {
        let (mut ray, mut color, mut left, mut object) = (*ray, Rgb::BLACK, 1.0, None);
        for _ in 0..MAX_SURFACES {
            let Some(hit) = self.world.hit(&ray, Span::AHEAD) else { break };
            object = object.or(Some(hit.object.index));
            let cosine = cosine(&hit, &ray);
            let opacity = if self.is_faded(&hit) { faded(cosine) } else { 1.0 };
            color += left * opacity * lit(&hit, &ray, cosine);
            left *= 1.0 - opacity;
            if left == 0.0 {
                return (color, object);
            }
            ray.origin = hit.surface.leave(ray.direction);
        }
        (color + left * empty, object)
    }

    /// The first surface between an eye and a point that is not looked through.
    pub fn hides(&self, eye: Point, point: Point) -> Option<Hit<'_>> {
        let mut ray = Ray::new(eye, point - eye);
        let mut span = Span { min: 0.0, max: 1.0 - CLOSE };
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

    /// Divides a segment into `pieces` equal ones and returns the runs of those that are hidden from an eye and of those that
    /// are not, as parts of its length from 0 to 1; a piece is hidden if its middle is.
    pub fn runs(&self, eye: Point, from: Point, to: Point, pieces: u32) -> Vec<([f64; 2], bool)> {
        let mut runs: Vec<([f64; 2], bool)> = Vec::new();
        let at = |piece: u32| f64::from(piece) / f64::from(pieces);
        for piece in 0..pieces {
            let [start, end] = [at(piece), at(piece + 1)];
            let hidden = self.hides(eye, from + 0.5 * (start + end) * (to - from)).is_some();
            match runs.last_mut() {
                Some((run, was_hidden)) if *was_hidden == hidden => run[1] = end,
                _ => runs.push(([start, end], hidden)),
            }
        }
        runs
    }

    fn is_faded(&self, hit: &Hit<'_>) -> bool {
        hit.material.recipe.transmits() || self.faded.contains(&hit.object.index)
    }
}

/// The opacity of a surface that one looks through, for the cosine of the angle under which it is seen.
fn faded(cosine: f64) -> f64 {
    let [straight, grazing] = FADED;
    let slant = (1.0 - cosine) * (1.0 - cosine);
    straight + (grazing - straight) * slant
}

/// The cosine of the angle under which a surface is seen, from 0 to 1.
fn cosine(hit: &Hit<'_>, ray: &Ray) -> f64 {
    hit.surface.normal.dot(ray.direction.unit().unwrap_or_default()).abs()
}

/// A surface's own colour, lit from where it is seen under this cosine.
fn lit(hit: &Hit<'_>, ray: &Ray, cosine: f64) -> Rgb {
    if hit.material.recipe.transmits() {
        return GLASS;
    }
    let normal = if hit.front { hit.surface.normal } else { -hit.surface.normal };
    let mut response = Response::default();
    let at = hit.texture_point();
    hit.material.recipe.respond(&at, cosine, &mut response);
    let emission = hit.material.recipe.emission();
    let shining = emission.map_or(Rgb::BLACK, |emission| emission.radiance(&at, cosine));
    let direction = ray.direction.unit().unwrap_or_default();
    let wo = Frame::around(normal).to_local(-direction);
    let own = albedo(&response.lobes, wo) + shining;
    (GRAZING + (1.0 - GRAZING) * cosine) * own.map(|value| value.clamp(0.0, 1.0))
}

/// The share of light from all sides that is scattered to a viewer in this direction of the local frame.
fn albedo(lobes: &Lobes, wo: Vector) -> Rgb {
    lobes.iter().map(|(lobe, ..)| lobe.albedo(wo)).sum()
}
