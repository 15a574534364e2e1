//! Mistakes of lights and shadows (Suffern, ch. 14, 16, 17).

use std::f64::consts::PI;
use std::fmt;
use std::path::Path;
use std::sync::Arc;

use groundtruth::invalid::LENGTHS;
use groundtruth::kinds::Custom;
use groundtruth::lights::{
    AmbientOccluder, Context, Kind, Light, LightContext, LightSample, Segment, Target, Unlit,
};
use groundtruth::math::{Frame, maps};
use groundtruth::scene::{Intersect, Light as Lamp, Scene};
use groundtruth::shapes;

use super::each;
use super::lamps::lamp_light;
use super::materials::is_transparent;
use crate::mistakes::{How, Mistake};

const OFFSET_TOO_LARGE: Mistake =
    Mistake::scene("offset-too-large", |scene, _| with_least_distance(scene, 1.0));

pub(super) const ALL: &[Mistake] = &[
    Mistake::scene("lit-from-behind", lit_from_behind),
    Mistake::new(
        "highlight-direction-not-unit",
        // the longer direction is in the cosine of all direct light, too: there it is taken off
        How::Both(longer_suns, |term| {
            let long = term.single_direction()?;
            Some(term.times(1.0 / long.length()))
        }),
    ),
    Mistake::scene("shadow-rays-without-end", shadow_rays_without_end),
    Mistake::scene("no-offset", |scene, _| with_least_distance(scene, *LENGTHS.start())),
    OFFSET_TOO_LARGE,
    OFFSET_TOO_LARGE.in_form("or than 0.1", How::Scene(|scene, _| with_least_distance(scene, 0.1))),
    OFFSET_TOO_LARGE
        .in_form("or than 0.01", How::Scene(|scene, _| with_least_distance(scene, 0.01))),
    Mistake::scene("occluder-uniform", occluder_uniform),
];

/// The scene as the book's program hits it, whose rays start on the surface and ignore all hits that are nearer. Where that is
/// far, only plain shapes are hit so: the boxes of the many parts of others would grow by it and overlap.
fn with_least_distance(scene: &Scene, epsilon: f64) -> Option<Scene> {
    // glass that is met again and again makes a tree of rays that takes minutes
    if scene.materials.iter().any(|material| is_transparent(&material.recipe)) {
        return None;
    }
    let is_near = epsilon == *LENGTHS.start();
    each(scene, super::objects, |object| {
        (is_near || is_plain(&object.shape)).then(|| {
            (object.intersect, object.epsilon) = (Some(Intersect::Textbook), Some(epsilon));
        })
    })
}

fn is_plain(shape: &shapes::Kind) -> bool {
    use shapes::Kind::*;
    matches!(
        shape,
        Plane(_)
            | Sphere(_)
            | Cuboid(_)
            | Rectangle(_)
            | Disk(_)
            | SolidCylinder(_)
            | SolidCone(_)
            | Torus(_)
    )
}

/// The scene in which lamps that are on have other sources.
pub(super) fn with_lights(scene: &Scene, other: impl Fn(&Lamp) -> Option<Kind>) -> Option<Scene> {
    each(scene, super::lights, |light| {
        light.source = other(light).filter(|_| light.enabled)?;
        Some(())
    })
}

/// Suns whose samples have the direction that the scene says, not made unit.
fn longer_suns(scene: &Scene, _: &Path) -> Option<Scene> {
    with_lights(scene, |light| {
        let Kind::Directional(sun) = &light.source else { return None };
        let length = sun.direction.length();
        Some(with_samples(single(&light.source)?, move |_, sample| {
            let direction = length * sample.direction;
            LightSample { direction, ..sample }
        }))
    })
}

/// A light with changed samples.
struct Changed<F> {
    light: Arc<dyn Light>,
    change: F,
}

impl<F> fmt::Debug for Changed<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.light.fmt(f)
    }
}

impl<F: Fn(&LightContext, LightSample) -> LightSample + Send + Sync> Light for Changed<F> {
    fn sample(&self, from: &LightContext, u: &[[f64; 2]]) -> Option<LightSample> {
        self.light.sample(from, u).map(|sample| (self.change)(from, sample))
    }

    as_in! { light,
        fn draws(&self) -> usize;
        fn is_ambient(&self) -> bool;
        fn object(&self) -> Option<&str>;
        fn is_sky(&self) -> bool;
        fn unlit(&self, from: &LightContext, u: &[[f64; 2]]) -> Unlit;
        fn pdf(&self, from: &LightContext, to: &Target<'_>) -> f64;
    }
}

/// The light with changed samples, as a kind.
pub(super) fn with_samples(
    light: Arc<dyn Light>,
    change: impl Fn(&LightContext, LightSample) -> LightSample + Send + Sync + 'static,
) -> Kind {
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
    with_lights(scene, |light| {
        let built = single(&light.source).filter(|_| !light.shadows)?;
        Some(with_samples(built, |from, sample| {
            let cos_i = from.normal.dot(sample.direction);
            let across = (2.0 * cos_i.min(0.0)) * from.normal;
            LightSample { direction: sample.direction - across, ..sample }
        }))
    })
}

fn shadow_rays_without_end(scene: &Scene, folder: &Path) -> Option<Scene> {
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
    with_lights(scene, |light| {
        let built = match &light.source {
            _ if !light.shadows => None,
            Kind::PointLight(_) | Kind::Spot(_) | Kind::FakeSpherical(_) => {
                light.source.build(&mut Context::default()).ok()
            }
            Kind::Area(area) => lamp_light(scene, folder, area),
            _ => None,
        };
        Some(with_samples(built?, |_, sample| {
            let segment = sample.segment.map(|_| Segment::Infinity);
            LightSample { segment, ..sample }
        }))
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
    with_lights(scene, |light| {
        let Kind::AmbientOccluder(AmbientOccluder { max_distance, .. }) = light.source else {
            return None;
        };
        let light = light.source.build(&mut Context::default()).ok()?;
        Some(Kind::Custom(Custom(Arc::new(Uniform { light, max_distance }))))
    })
}
