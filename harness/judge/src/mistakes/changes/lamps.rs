//! Mistakes of area lights (Suffern, ch. 18).

use std::path::Path;
use std::sync::Arc;

use groundtruth::kinds::{Resources, Specification};
use groundtruth::lights::{Area, Context, Kind, LampObject, Light, LightSample};
use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::shapes::{self, SampledSurface, Sampling};

use super::lights::{with_lights, with_samples};
use crate::mistakes::Mistake;

pub(super) const ALL: &[Mistake] = &[Mistake::scene("no-lamp-area", no_lamp_area)];

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

/// The light of a lamp, built outside a world.
pub(super) fn lamp_light(scene: &Scene, folder: &Path, source: &Area) -> Option<Arc<dyn Light>> {
    let mut context = Context::default();
    context.objects.insert(source.object.clone(), lamp_object(scene, folder, &source.object)?);
    source.build(&mut context).ok()
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
    with_lights(scene, |light| {
        let Kind::Area(source) = &light.source else { return None };
        let lamp = lamp_object(scene, folder, &source.object)?;
        let area = area(&*lamp.shape.sampled(Sampling::Area)?)?;
        Some(with_samples(lamp_light(scene, folder, source)?, move |_, sample| {
            let radiance: Rgb = sample.radiance / area;
            LightSample { radiance, ..sample }
        }))
    })
}
