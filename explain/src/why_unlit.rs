//! Why a light adds nothing at a hit: the hit is asked again, with the random numbers that were
//! drawn there.

use std::sync::Arc;

use groundtruth::lights::{Light, LightSample};
use groundtruth::lobes::{Bsdf, Lit};
use groundtruth::materials::Response;
use groundtruth::math::{Ray, Span};
use groundtruth::rgb::Rgb;
use groundtruth::samplers::{Draws, PathKey};
use groundtruth::scene;
use groundtruth::shapes::Facet;
use groundtruth::textures::TexturePoint;
use groundtruth::trace::{Direct, ShadingPoint, Strategy, TermSource};
use groundtruth::world::{Hit, PlacedLight, World};

use super::unsent::why_unsent;
use super::{RecordedRay, RecordedTerm, Unlit, UnlitLight};

/// Adds to each hit of a recorded sample of this world the lights that add nothing there, in the
/// scene's order. `lights` are those of its scene; of one that is not among them
/// [`Unlit::NoDirection`] stands for all reasons why it has no sample.
pub fn add_unlit(
    (world, lights): (&World, &[scene::Light]),
    draws: Draws<'_>,
    root: &mut RecordedRay,
) {
    ask((world, lights), draws, root, PathKey::CAMERA);
}

fn ask(
    (world, lights): (&World, &[scene::Light]),
    draws: Draws<'_>,
    ray: &mut RecordedRay,
    path: PathKey,
) {
    let RecordedRay { terms, children, .. } = ray;
    for term in terms.iter() {
        let child = children.iter_mut().find(|child| term.ray == Some(child.number));
        if let (TermSource::Traced { lobe, .. }, Some(child)) = (&term.source, child) {
            ask((world, lights), draws, child, path.then(lobe.branch()));
        }
    }
    let hit = ray.hit.as_ref().and_then(|_| world.hit(&ray.ray, Span::AHEAD));
    let Some(hit) = hit else { return };
    let point = &ShadingPoint::new(&hit, -ray.ray.direction);
    let mut response = Response::default();
    hit.material.recipe.respond(&hit.texture_point(), point.cos_o, &mut response);
    let bsdf = Bsdf::new(&response.lobes, point.normals, point.wo);
    let (strategy, depth) = (Strategy::of(world.tracer), ray.depth);
    let ambient = response.ambient;
    let vertex = Vertex { world, lights, strategy, draws, path, depth, point, ambient, bsdf };
    let unlit = (0..).zip(&world.names.lights).filter_map(|(index, name)| {
        let reason = match world.lights.iter().find(|light| light.index == index) {
            Some(light) => vertex.reason(ray, light)?,
            None => Unlit::SwitchedOff,
        };
        Some(UnlitLight { light: Arc::clone(name), reason })
    });
    ray.unlit = unlit.collect();
}

/// A hit as tracing met it.
struct Vertex<'a> {
    world: &'a World,
    /// The scene's.
    lights: &'a [scene::Light],
    strategy: Strategy,
    draws: Draws<'a>,
    path: PathKey,
    depth: u32,
    point: &'a ShadingPoint<'a>,
    /// The reflectance for ambient light.
    ambient: Rgb,
    bsdf: Bsdf<'a>,
}

impl Vertex<'_> {
    /// Why a light that is on adds nothing: the first reason that holds; `None` if it adds
    /// something.
    fn reason(&self, ray: &RecordedRay, light: &PlacedLight) -> Option<Unlit> {
        let its = |term: &&RecordedTerm| term.light.as_ref() == Some(&light.name);
        let mut terms = ray.terms.iter().filter(its);
        if terms.clone().any(|term| !term.value.is_black()) {
            return None;
        }
        let Some(term) = terms.next() else { return Some(self.no_term(light)) };
        let shadow = term.ray.and_then(|number| ray.child(number));
        let is_own =
            |it: &&RecordedRay| it.blocked_by.as_ref() == Some(&self.point.hit.object.name);
        let edges = shadow.filter(is_own).and_then(|it| self.own_mesh(&it.ray, Span::AHEAD));
        Some(match shadow.and_then(|shadow| shadow.blocked_by.clone()) {
            Some(blocked_by) => Unlit::Blocked { blocked_by, edges },
            None if !term.arriving.is_black() => Unlit::OtherColors,
            None => match self.hidden(light).filter(|_| shadow.is_none()) {
                Some(hidden) => hidden,
                // a sample without radiance makes no direct term
                None if !light.light.is_ambient() => Unlit::Absorbed,
                None => Unlit::Dark,
            },
        })
    }

    /// Whether the surface itself hides what the light sends, which then takes no shadow ray.
    fn hidden(&self, light: &PlacedLight) -> Option<Unlit> {
        let casts_shadows = light.shadows || self.strategy.meets(&*light.light);
        let sample = self.sample(light).ok()?;
        let is_hidden = casts_shadows && sample.segment.is_some() && sample.blocked.is_black();
        let is_behind = self.point.normals.geometry.dot(sample.direction) <= 0.0;
        (is_hidden && is_behind).then(|| self.behind_true_surface(&sample))
    }

    fn behind_true_surface(&self, sample: &LightSample) -> Unlit {
        let (normals, surface) = (self.point.normals, &self.point.hit.surface);
        let [cos_shading, cos_i] =
            [normals.shading, normals.geometry].map(|normal| normal.dot(sample.direction));
        let to_light = Ray::new(surface.leave(sample.direction), sample.direction);
        let max = sample.segment.map_or(f64::INFINITY, |segment| segment.length(surface.point));
        let edges = self.own_mesh(&to_light, Span { max, ..Span::AHEAD });
        Unlit::BehindTrueSurface { cos_i, cos_shading, edges }
    }

    /// How far ahead a ray from the hit meets the mesh of the hit, in mean edges of its triangle.
    fn own_mesh(&self, ray: &Ray, span: Span) -> Option<f64> {
        let there = self.world.hit_of(self.point.hit.object, ray, span)?;
        let [from, to] = [self.point.hit, &there].map(Hit::texture_point);
        let (mean_edge, _) = (mean_edge(&from)?, mean_edge(&to)?);
        (from.leaf() == to.leaf()).then(|| from.local.distance(to.local) / mean_edge)
    }

    /// Why a light has no term.
    fn no_term(&self, light: &PlacedLight) -> Unlit {
        let is_ambient = light.light.is_ambient();
        let is_sampled = self.strategy.samples_lights(self.depth);
        if !is_sampled || is_ambient && self.strategy.is_path() {
            return unsampled(self.strategy, &*light.light);
        }
        let set = self.strategy.lit_lobes();
        match is_ambient {
            true if self.ambient.is_black() => return Unlit::NoAmbientReflectance,
            false if !self.bsdf.is_lit(set) => return self.unlit_surface(),
            _ => {}
        }
        match self.sample(light) {
            Ok(sample) => self.unlit_sample(&sample, &self.bsdf.lit(set, sample.direction)),
            Err(reason) => reason,
        }
    }

    /// The light's sample, or why there is none.
    fn sample(&self, light: &PlacedLight) -> Result<LightSample, Unlit> {
        let from = self.point.light_context();
        let u = light.numbers(self.path, |purpose| self.draws.draw(purpose));
        light.light.sample(&from, &u).ok_or_else(|| match self.lights.get(light.index as usize) {
            Some(light) => why_unsent(self.world, &light.source, &from, &u),
            None => Unlit::NoDirection,
        })
    }

    /// Why samples of lights meet no lobe of the surface.
    fn unlit_surface(&self) -> Unlit {
        match self.bsdf.lobes().is_empty() {
            true => Unlit::NoLobes,
            false if self.point.cos_o <= 0.0 => Unlit::ViewerBehind { cos_o: self.point.cos_o },
            false => Unlit::TracedLobesOnly,
        }
    }

    /// Why a light's sample contributes nothing. `lit` are the lobes' values for it.
    fn unlit_sample(&self, sample: &LightSample, lit: &[Lit<'_>]) -> Unlit {
        let sent = sample.radiance + sample.blocked;
        let [shading, geometry] = [self.point.normals.shading, self.point.normals.geometry];
        let [cos_i, cos_true] = [shading, geometry].map(|normal| normal.dot(sample.direction));
        if sent.is_black() {
            Unlit::Dark
        } else if lit.iter().any(|lit| !(lit.f * sent).is_black()) {
            Unlit::TooWeak
        } else if !lit.is_empty() {
            Unlit::OtherColors
        } else if cos_i <= 0.0 {
            Unlit::BehindSurface { cos_i }
        } else if cos_true <= 0.0 {
            self.behind_true_surface(sample)
        } else {
            Unlit::OutsideLobes { cos_i }
        }
    }
}

/// The mean edge of the triangle of a hit; `None` where the textures of an instance are left in place: lengths there are others.
fn mean_edge(hit: &TexturePoint<'_>) -> Option<f64> {
    let Facet { corners: [a, b, c], barycentric: [beta, gamma], .. } = hit.facet()?;
    let mean_edge = (a.distance(b) + b.distance(c) + c.distance(a)) / 3.0;
    // equal but for rounding: a placed point is elsewhere by a good part of the mesh
    let here = a + beta * (b - a) + gamma * (c - a);
    (hit.local.distance(here) < 1e-6 * mean_edge).then_some(mean_edge)
}

/// Why a light is not sampled at a hit.
fn unsampled(strategy: Strategy, light: &dyn Light) -> Unlit {
    match strategy.direct {
        _ if light.is_ambient() => Unlit::LeftOut,
        Direct::FirstHit if strategy.max_depth > 0 => Unlit::FirstHitOnly,
        Direct::Shading | Direct::FirstHit | Direct::EveryHit => Unlit::TooDeep,
        Direct::Never if light.is_met() => Unlit::NotSampled,
        Direct::Never => Unlit::LeftOut,
    }
}
