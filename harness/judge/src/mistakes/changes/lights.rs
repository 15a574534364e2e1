//! Mistakes of lights and shadows (Suffern, ch. 14, 16–18).

use std::f64::consts::PI;
use std::fmt;
use std::path::Path;
use std::sync::Arc;

use groundtruth::background::{Background, Pattern};
use groundtruth::invalid::LENGTHS;
use groundtruth::kinds::Resources;
use groundtruth::lights::{
    AmbientOccluder, Kind, Light, LightContext, LightSample, Segment, Target,
};
use groundtruth::math::{Frame, Point, Vector, maps};
use groundtruth::scene::{Intersect, Scene};
use groundtruth::shapes::{self, SampledSurface, Sampling};
use groundtruth::world::{DEFAULT_SEED, PlacedLight, World};

use super::changed;
use super::materials::is_transparent;
use crate::mistakes::Mistake;
use crate::mistakes::places::any;

pub(super) const ALL: &[Mistake] = &[
    Mistake::world("lit-from-behind", lit_from_behind),
    // the longer direction is in the cosine of all direct light, too: there it is taken off
    Mistake::both("highlight-direction-not-unit", longer_suns, |term| {
        Some(term.times(1.0 / term.single_sample()?.direction.length()))
    }),
    Mistake::world("shadow-rays-without-end", shadow_rays_without_end),
    Mistake::scene("no-offset", |scene, _| with_least_distance(scene, *LENGTHS.start())),
    Mistake::scene("offset-too-large", |scene, _| with_least_distance(scene, 1.0)),
    Mistake::scene("offset-too-large", |scene, _| with_least_distance(scene, 0.1))
        .in_form("or than 0.1"),
    Mistake::scene("offset-too-large", |scene, _| with_least_distance(scene, 0.01))
        .in_form("or than 0.01"),
    Mistake::world("occluder-uniform", occluder_uniform),
    Mistake::world("no-lamp-area", no_lamp_area),
    Mistake::world("sky-sampled-turned", |world, scene, folder| {
        sky_sampled(world, scene, folder, |degrees| degrees + 90.0)
    }),
    Mistake::world("sky-sampled-turned", |world, scene, folder| {
        sky_sampled(world, scene, folder, |degrees| degrees + 180.0)
    })
    .in_form("or by 180°"),
    Mistake::world("sky-sampled-turned", |world, scene, folder| {
        sky_sampled(world, scene, folder, |_| 0.0)
    })
    .in_form("or not turned"),
    Mistake::world("sky-sampled-turned", |world, scene, folder| {
        sky_sampled(world, scene, folder, |degrees| -degrees)
    })
    .in_form("or turned the other way"),
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
        let objects = scene.objects.iter_mut();
        any(objects.filter(|it| is_near || is_plain(&it.shape)).map(|object| {
            (object.intersect, object.epsilon) = (Some(Intersect::Textbook), Some(epsilon));
        }))
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

/// Replaces lights that are on; each is given with what the scene says of it.
fn with_lights(
    world: &mut World,
    scene: &Scene,
    other: impl Fn(&PlacedLight, &Kind) -> Option<Arc<dyn Light>>,
) -> Option<()> {
    any(world.lights.iter_mut().filter_map(|placed| {
        placed.light = other(placed, &scene.lights[placed.index as usize].source)?;
        Some(())
    }))
}

/// Suns whose samples have the direction that the scene says, not made unit.
fn longer_suns(world: &mut World, scene: &Scene, _: &Path) -> Option<()> {
    with_lights(world, scene, |placed, source| {
        let Kind::Directional(sun) = source else { return None };
        let length = sun.direction.length();
        Some(with_samples(placed, move |_, _, sample| {
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

impl<F> Light for Changed<F>
where
    F: Fn(&LightContext, &[[f64; 2]], LightSample) -> LightSample + Send + Sync,
{
    fn sample(&self, from: &LightContext, u: &[[f64; 2]]) -> Option<LightSample> {
        self.light.sample(from, u).map(|sample| (self.change)(from, u, sample))
    }

    as_in! { light,
        fn draws(&self) -> usize;
        fn is_ambient(&self) -> bool;
        fn object(&self) -> Option<&str>;
        fn is_sky(&self) -> bool;
        fn pdf(&self, from: &LightContext, to: &Target<'_>) -> f64;
    }
}

fn with_samples(
    placed: &PlacedLight,
    change: impl Fn(&LightContext, &[[f64; 2]], LightSample) -> LightSample + Send + Sync + 'static,
) -> Arc<dyn Light> {
    Arc::new(Changed { light: placed.light.clone(), change })
}

/// Light from behind is mirrored at the plane of the surface: it has the same cosine, without its sign.
fn lit_from_behind(world: &mut World, scene: &Scene, _: &Path) -> Option<()> {
    with_lights(world, scene, |placed, source| {
        // at a point or in one direction
        let is_single =
            matches!(source, Kind::PointLight(_) | Kind::Spot(_) | Kind::Directional(_));
        (is_single && !placed.shadows).then(|| {
            with_samples(placed, |from, _, sample| {
                let cos_i = from.normal.dot(sample.direction);
                let across = (2.0 * cos_i.min(0.0)) * from.normal;
                LightSample { direction: sample.direction - across, ..sample }
            })
        })
    })
}

fn shadow_rays_without_end(world: &mut World, scene: &Scene, _: &Path) -> Option<()> {
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
    with_lights(world, scene, |placed, source| {
        let ends = matches!(
            source,
            Kind::PointLight(_) | Kind::Spot(_) | Kind::FakeSpherical(_) | Kind::Area(_)
        );
        (ends && placed.shadows).then(|| {
            with_samples(placed, |_, _, sample| {
                let segment = sample.segment.map(|_| Segment::Infinity);
                LightSample { segment, ..sample }
            })
        })
    })
}

/// Ambient occluders whose directions are distributed evenly.
fn occluder_uniform(world: &mut World, scene: &Scene, _: &Path) -> Option<()> {
    with_lights(world, scene, |placed, source| {
        let Kind::AmbientOccluder(AmbientOccluder { max_distance, .. }) = *source else {
            return None;
        };
        Some(with_samples(placed, move |from, u, sample| {
            let direction = Frame::around(from.normal).to_world(maps::hemisphere(u[0], 0.0));
            let segment = match max_distance {
                None => Segment::Infinity,
                Some(far) => Segment::To(from.point + far * direction),
            };
            LightSample { direction, segment: Some(segment), pdf: Some(0.5 / PI), ..sample }
        }))
    })
}

/// The area of a surface, from the density `d²/(A cosθ')` of a point that is drawn by area.
fn area(surface: &dyn SampledSurface) -> Option<f64> {
    /// Farther away than any lamp is large, in directions of which one sees a given point of it.
    const FAR: f64 = 1e6;
    let axes = [Vector::X, Vector::Y, Vector::Z].into_iter();
    axes.flat_map(|axis| [FAR * axis, -FAR * axis]).find_map(|vector| {
        let from = Point::ORIGIN + vector + 0.5 * FAR * Vector::new(0.3, 0.2, 0.1);
        let (at, density) = surface.sample(from, [0.3, 0.6])?;
        let way = from - at.point;
        let cosine = at.normal.dot(way.unit()?).abs();
        (cosine > 0.1).then(|| way.length_squared() / (cosine * density))
    })
}

fn no_lamp_area(world: &mut World, scene: &Scene, folder: &Path) -> Option<()> {
    with_lights(world, scene, |placed, source| {
        let Kind::Area(lamp) = source else { return None };
        let object = scene.objects.iter().find(|object| object.name == lamp.object)?;
        let mut context = shapes::Context::new(Resources::new(folder), scene.accel);
        let shape = object.shape.build(&mut context).ok()?;
        let area = area(&*shape.sampled(Sampling::Area)?)?;
        Some(with_samples(placed, move |_, _, sample| LightSample {
            radiance: sample.radiance / area,
            ..sample
        }))
    })
}

/// Samples the sky of a scene whose image is turned otherwise.
fn sky_sampled(
    world: &mut World,
    scene: &Scene,
    folder: &Path,
    turned: fn(f64) -> f64,
) -> Option<()> {
    let mut other = scene.clone();
    let Background::Pattern(Pattern::Image(image)) = &mut other.background else { return None };
    let degrees = turned(image.rotate_y);
    if std::mem::replace(&mut image.rotate_y, degrees) == degrees {
        return None;
    }
    let other = World::build_seeded(&other, folder, DEFAULT_SEED).ok()?;
    with_lights(world, scene, |placed, source| {
        let light = other.lights.iter().find(|it| it.index == placed.index)?;
        matches!(source, Kind::Environment(_)).then(|| light.light.clone())
    })
}
