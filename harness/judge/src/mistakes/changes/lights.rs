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
use groundtruth::scene::{Intersect, Scene};
use groundtruth::shapes;

use super::changed;
use super::lamps::lamp_light;
use super::materials::is_transparent;
use crate::mistakes::{How, Mistake};

const OFFSET_TOO_LARGE: Mistake =
    Mistake::scene("offset-too-large", |scene, _| with_least_distance(scene, 1.0));

pub(super) const ALL: &[Mistake] = &[
    Mistake::scene("lit-from-behind", lit_from_behind),
    Mistake {
        name: "highlight-direction-not-unit",
        // the longer direction is in the cosine of all direct light, too: there it is taken off
        how: How::Both(longer_suns, |term| match term.single_direction() {
            Some(long) => term.times(1.0 / long.length()),
            None => term.value(),
        }),
        form: None,
    },
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
    changed(scene, |scene| {
        let mut any = false;
        for object in scene.objects.iter_mut().filter(|it| is_near || is_plain(&it.shape)) {
            (object.intersect, object.epsilon) = (Some(Intersect::Textbook), Some(epsilon));
            any = true;
        }
        any
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

/// Suns whose samples have the direction that the scene says, not made unit.
fn longer_suns(scene: &Scene, _: &Path) -> Option<Scene> {
    changed(scene, |scene| {
        let mut any = false;
        for light in scene.lights.iter_mut().filter(|light| light.enabled) {
            let Kind::Directional(sun) = &light.source else { continue };
            let (length, Some(built)) = (sun.direction.length(), single(&light.source)) else {
                continue;
            };
            let longer = move |_: &LightContext, sample: LightSample| {
                let direction = length * sample.direction;
                LightSample { direction, ..sample }
            };
            light.source = with_samples(built, Arc::new(longer));
            any = true;
        }
        any
    })
}

/// What becomes of a sample of a light.
pub(super) type Change = Arc<dyn Fn(&LightContext, LightSample) -> LightSample + Send + Sync>;

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
pub(super) fn with_samples(light: Arc<dyn Light>, change: Change) -> Kind {
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
    let original = scene;
    let endless = |_: &LightContext, sample: LightSample| {
        let segment = sample.segment.map(|_| Segment::Infinity);
        LightSample { segment, ..sample }
    };
    changed(scene, |scene| {
        let mut any = false;
        for light in scene.lights.iter_mut().filter(|light| light.enabled && light.shadows) {
            let built = match &light.source {
                Kind::PointLight(_) | Kind::Spot(_) | Kind::FakeSpherical(_) => {
                    light.source.build(&mut Context::default()).ok()
                }
                Kind::Area(area) => lamp_light(original, folder, area),
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
