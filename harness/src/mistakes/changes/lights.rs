//! Mistakes of lights and shadows (Suffern, ch. 14, 16–18).

use std::f64::consts::PI;
use std::fmt;
use std::path::Path;
use std::sync::Arc;

use groundtruth::kinds::{Custom, Resources, Specification};
use groundtruth::lights::{
    AmbientOccluder, Context, Kind, LampObject, Light, LightContext, LightSample, Segment, Target,
    Unlit,
};
use groundtruth::math::{Frame, Point, Vector, maps};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::shapes::{self, SampledSurface, Sampling};

use super::{changed, has_tree_of_rays};
use crate::mistakes::Mistake;

pub(super) const ALL: &[Mistake] = &[
    Mistake::scene(
        14,
        "no-fall-off",
        "light of point lights does not fall off with distance",
        |scene, _| with_exponent(scene, 0.0),
    ),
    Mistake::scene(
        14,
        "linear-fall-off",
        "light of point lights falls off with 1/d instead of 1/d²",
        |scene, _| with_exponent(scene, 1.0),
    ),
    Mistake::scene(
        14,
        "lit-from-behind",
        "light without shadows that comes from behind a surface counts as light from the front",
        lit_from_behind,
    ),
    Mistake::scene(16, "no-shadows", "objects cast no shadows", no_shadows),
    Mistake::scene(
        16,
        "shadow-rays-without-end",
        "objects behind a point light block its light",
        shadow_rays_without_end,
    ),
    Mistake::scene(
        17,
        "occluder-uniform",
        "ambient occlusion draws directions evenly over the hemisphere instead of by the cosine",
        occluder_uniform,
    ),
    Mistake::scene(
        18,
        "no-lamp-area",
        "the light of area lights lacks the factor of the lamp's area (the density of its samples)",
        no_lamp_area,
    ),
    Mistake::scene(18, "lamp-two-sided", "one-sided lamps shine from both sides", lamp_two_sided),
];

fn with_exponent(scene: &Scene, exponent: f64) -> Option<Scene> {
    changed(scene, |scene| {
        let mut any = false;
        for light in &mut scene.lights {
            let attenuation = match &mut light.source {
                Kind::PointLight(light) => &mut light.attenuation,
                Kind::Spot(light) => &mut light.attenuation,
                Kind::FakeSpherical(light) => &mut light.attenuation,
                _ => continue,
            };
            any |= *attenuation > exponent;
            *attenuation = attenuation.min(exponent);
        }
        any
    })
}

fn no_shadows(scene: &Scene, _: &Path) -> Option<Scene> {
    if !has_tree_of_rays(scene) {
        return None;
    }
    changed(scene, |scene| {
        let mut any = false;
        for light in &mut scene.lights {
            any |= light.enabled && light.shadows;
            light.shadows = false;
        }
        any
    })
}

fn lamp_two_sided(scene: &Scene, _: &Path) -> Option<Scene> {
    changed(scene, |scene| {
        let mut any = false;
        for material in &mut scene.materials {
            let is_lamp = matches!(material.recipe, groundtruth::materials::Kind::Emissive(_));
            any |= is_lamp && !material.two_sided;
            material.two_sided |= is_lamp;
        }
        any
    })
}

/// What becomes of a sample of a light.
type Change = Arc<dyn Fn(&LightContext, LightSample) -> LightSample + Send + Sync>;

/// A light with changed samples.
struct Changed {
    light: Arc<dyn Light>,
    change: Change,
}

impl fmt::Debug for Changed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.light.fmt(f)
    }
}

impl Light for Changed {
    fn draws(&self) -> usize {
        self.light.draws()
    }

    fn is_ambient(&self) -> bool {
        self.light.is_ambient()
    }

    fn object(&self) -> Option<&str> {
        self.light.object()
    }

    fn is_sky(&self) -> bool {
        self.light.is_sky()
    }

    fn sample(&self, from: &LightContext, u: &[[f64; 2]]) -> Option<LightSample> {
        self.light.sample(from, u).map(|sample| (self.change)(from, sample))
    }

    fn unlit(&self, from: &LightContext, u: &[[f64; 2]]) -> Unlit {
        self.light.unlit(from, u)
    }

    fn pdf(&self, from: &LightContext, to: &Target<'_>) -> f64 {
        self.light.pdf(from, to)
    }
}

/// The light with changed samples, as a kind.
fn with_samples(light: Arc<dyn Light>, change: Change) -> Kind {
    Kind::Custom(Custom(Arc::new(Changed { light, change })))
}

/// A light at a point or in one direction; `None` for other kinds.
fn single(source: &Kind) -> Option<Arc<dyn Light>> {
    match source {
        Kind::PointLight(_) | Kind::Spot(_) | Kind::Directional(_) => {
            source.build(&mut Context::default()).ok()
        }
        _ => None,
    }
}

/// Light from behind is mirrored at the plane of the surface: it has the same cosine, without its sign.
fn lit_from_behind(scene: &Scene, _: &Path) -> Option<Scene> {
    let mirrored = |from: &LightContext, sample: LightSample| {
        let cos_i = from.normal.dot(sample.direction);
        let across = (2.0 * cos_i.min(0.0)) * from.normal;
        LightSample { direction: sample.direction - across, ..sample }
    };
    changed(scene, |scene| {
        let mut any = false;
        for light in scene.lights.iter_mut().filter(|light| light.enabled && !light.shadows) {
            if let Some(built) = single(&light.source) {
                light.source = with_samples(built, Arc::new(mirrored));
                any = true;
            }
        }
        any
    })
}

fn shadow_rays_without_end(scene: &Scene, _: &Path) -> Option<Scene> {
    let absorbs = |material: &groundtruth::scene::Material| match &material.recipe {
        groundtruth::materials::Kind::Dielectric(it) => {
            !(it.inside.absorption.is_black() && it.outside.absorption.is_black())
        }
        _ => false,
    };
    // over a ray without end a medium would absorb all light, which is another mistake
    if scene.materials.iter().any(absorbs) || !scene.camera.medium.absorption.is_black() {
        return None;
    }
    let endless = |_: &LightContext, sample: LightSample| {
        let segment = sample.segment.map(|_| Segment::Infinity);
        LightSample { segment, ..sample }
    };
    changed(scene, |scene| {
        let mut any = false;
        for light in scene.lights.iter_mut().filter(|light| light.enabled && light.shadows) {
            let built = match light.source {
                Kind::PointLight(_) | Kind::Spot(_) | Kind::FakeSpherical(_) => {
                    light.source.build(&mut Context::default()).ok()
                }
                _ => None,
            };
            if let Some(built) = built {
                light.source = with_samples(built, Arc::new(endless));
                any = true;
            }
        }
        any
    })
}

/// An ambient occluder whose directions are distributed evenly.
#[derive(Debug)]
struct Uniform {
    /// Ours, for the radiance of its samples.
    light: Arc<dyn Light>,
    max_distance: Option<f64>,
}

impl Light for Uniform {
    fn draws(&self) -> usize {
        1
    }

    fn is_ambient(&self) -> bool {
        true
    }

    fn sample(&self, from: &LightContext, u: &[[f64; 2]]) -> Option<LightSample> {
        let direction = Frame::around(from.normal).to_world(maps::hemisphere(u[0], 0.0));
        let segment = match self.max_distance {
            None => Segment::Infinity,
            Some(far) => Segment::To(from.point + far * direction),
        };
        let ours = self.light.sample(from, u)?;
        Some(LightSample { direction, segment: Some(segment), pdf: Some(0.5 / PI), ..ours })
    }
}

fn occluder_uniform(scene: &Scene, _: &Path) -> Option<Scene> {
    changed(scene, |scene| {
        let mut any = false;
        for light in &mut scene.lights {
            if let Kind::AmbientOccluder(AmbientOccluder { max_distance, .. }) = light.source
                && let Ok(built) = light.source.build(&mut Context::default())
            {
                let uniform = Uniform { light: built, max_distance };
                light.source = Kind::Custom(Custom(Arc::new(uniform)));
                any = true;
            }
        }
        any
    })
}

/// What an area light needs of its object.
fn lamp_object(scene: &Scene, folder: &Path, name: &str) -> Option<LampObject> {
    let object = scene.objects.iter().find(|object| object.name == name && object.enabled)?;
    let material = scene.materials.iter().find(|material| material.name == object.material)?;
    let recipe = material.recipe.build(&mut Resources::new(folder)).ok()?;
    let mut context = shapes::Context::new(Resources::new(folder), scene.accel);
    let shape = object.shape.build(&mut context).ok()?;
    let emission = recipe.emission().cloned();
    Some(LampObject { shape, emission, two_sided: material.two_sided })
}

/// The area of a surface, from the density `d²/(A cosθ')` of a point that is drawn by area.
fn area(surface: &dyn SampledSurface) -> Option<f64> {
    /// Farther away than any lamp is large, in directions of which one sees a given point of it.
    const FAR: f64 = 1e6;
    let from =
        [Vector::X, Vector::Y, Vector::Z].into_iter().flat_map(|axis| [FAR * axis, -FAR * axis]);
    from.map(|vector| Point::ORIGIN + vector + 0.5 * FAR * Vector::new(0.3, 0.2, 0.1)).find_map(
        |from| {
            let (at, density) = surface.sample(from, [0.3, 0.6])?;
            let way = from - at.point;
            let cosine = at.normal.dot(way.unit()?).abs();
            (cosine > 0.1).then(|| way.length_squared() / (cosine * density))
        },
    )
}

fn no_lamp_area(scene: &Scene, folder: &Path) -> Option<Scene> {
    changed(scene, |copy| {
        let mut any = false;
        for light in copy.lights.iter_mut().filter(|light| light.enabled) {
            let Kind::Area(source) = &light.source else { continue };
            let Some(lamp) = lamp_object(scene, folder, &source.object) else { continue };
            let Some(area) = lamp.shape.sampled(Sampling::Area).and_then(|it| area(&*it)) else {
                continue;
            };
            let mut context = Context::default();
            context.objects.insert(source.object.clone(), lamp);
            let Ok(built) = Specification::build(source, &mut context) else { continue };
            let weaker = move |_: &LightContext, sample: LightSample| {
                let radiance: Rgb = sample.radiance / area;
                LightSample { radiance, ..sample }
            };
            light.source = with_samples(built, Arc::new(weaker));
            any = true;
        }
        any
    })
}
