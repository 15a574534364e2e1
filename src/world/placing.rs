//! The lists of a scene checked and built: lights, materials, objects.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::{Names, PlacedLight, PlacedMaterial, PlacedObject};
use crate::background::Sky;
use crate::invalid::{Invalid, Key, length, shown};
use crate::kinds::Resources;
use crate::lights::{self, LampObject};
use crate::scene::{self, Scene};
use crate::shapes::{Context, PartMaterial};
use formats::printable;

/// An element of a list, for error messages.
fn item(list: &str, index: usize, name: &str) -> impl Fn(Invalid) -> Invalid {
    move |invalid| invalid.inside(Key::Item(index, Some(name.to_owned()))).inside(list)
}

/// Refuses a name that an earlier element has.
fn unique<'a>(list: &str, names: impl ExactSizeIterator<Item = &'a str>) -> Result<(), Invalid> {
    let mut known = std::collections::HashMap::with_capacity(names.len());
    for (index, name) in names.enumerate() {
        if let Some(first) = known.insert(name, index) {
            let problem =
                format!("`{}` is the name of {list}[{first}] already", printable::name(name));
            return Err(item(list, index, name)(Invalid::field("name", problem)));
        }
    }
    Ok(())
}

pub(super) fn placed_lights(
    scene: &Scene,
    background: &Sky,
    materials: &[PlacedMaterial],
    objects: &mut [PlacedObject],
) -> Result<Vec<PlacedLight>, Invalid> {
    unique("lights", scene.lights.iter().map(|light| light.name.as_str()))?;
    let mut context = lights_context(scene, background, materials, objects);
    let mut lamps: BTreeMap<String, &str> = BTreeMap::new();
    let mut sky: Option<&str> = None;
    let mut lights = Vec::new();
    for (index, light) in scene.lights.iter().enumerate() {
        let here = |e: Invalid| item("lights", index, &light.name)(e.inside("source"));
        let lamp_is_hidden = match &light.source {
            lights::Kind::Area(area) => context.hidden.contains(&area.object),
            _ => false,
        };
        if lamp_is_hidden && !light.enabled {
            continue; // both are switched off
        }
        let built = light.source.build(&mut context).map_err(here)?;
        if let Some(name) = built.object() {
            if let Some(other) = lamps.insert(name.to_owned(), &light.name) {
                let [name, other] = [name, other].map(printable::name);
                let problem = format!("`{name}` is the lamp of the light \"{other}\" already");
                return Err(here(Invalid::field("object", problem).inside("area")));
            }
            for object in objects.iter_mut().filter(|object| &*object.name == name) {
                object.shines = light.enabled;
                object.lamp_of = light.enabled.then_some(lights.len() as u32);
            }
        }
        if built.is_sky()
            && let Some(other) = sky.replace(&light.name)
        {
            let other = printable::name(other);
            let problem = format!("the background is the light \"{other}\" already");
            return Err(here(Invalid::field("environment", problem)));
        }
        if light.enabled {
            let (name, index, shadows) = (light.name.as_str().into(), index as u32, light.shadows);
            lights.push(PlacedLight { name, index, shadows, light: built });
        }
    }
    Ok(lights)
}

/// What area lights may name, if there are any. Objects that are switched off have no shape here.
fn lights_context(
    scene: &Scene,
    background: &Sky,
    materials: &[PlacedMaterial],
    objects: &[PlacedObject],
) -> lights::Context {
    let mut context = lights::Context {
        background: background.clone(),
        hidden: scene.objects.iter().filter(|o| !o.enabled).map(|o| o.name.clone()).collect(),
        ..lights::Context::default()
    };
    if !scene.lights.iter().any(|light| matches!(light.source, lights::Kind::Area(_))) {
        return context;
    }
    for object in objects {
        let material = &materials[object.material as usize];
        let (shape, two_sided) = (Arc::clone(&object.shape), material.two_sided);
        let emission = material.recipe.emission().cloned();
        context.objects.insert(object.name.to_string(), LampObject { shape, emission, two_sided });
    }
    context
}

pub(super) fn placed_materials(
    scene: &Scene,
    resources: &mut Resources,
) -> Result<Vec<PlacedMaterial>, Invalid> {
    unique("materials", scene.materials.iter().map(|material| material.name.as_str()))?;
    let mut placed = |(index, material): (usize, &scene::Material)| {
        let here = item("materials", index, &material.name);
        let uses_before = resources.uses_of_uv();
        let recipe = material.recipe.build(resources).map_err(|e| here(e.inside("recipe")))?;
        let bump = material.bump.as_ref().map(|bump| bump.build(resources)).transpose();
        let bump = bump.map_err(|e| here(e.inside("bump")))?;
        if material.two_sided && recipe.transmits() {
            let problem = "a transparent material must know its inside and cannot be two-sided";
            return Err(here(Invalid::field("two_sided", problem)));
        }
        let (name, index) = (material.name.as_str().into(), index as u32);
        let (two_sided, casts_shadows) = (material.two_sided, material.casts_shadows);
        let needs_uv = resources.uses_of_uv() > uses_before;
        Ok(PlacedMaterial { name, index, two_sided, recipe, bump, casts_shadows, needs_uv })
    };
    scene.materials.iter().enumerate().map(&mut placed).collect()
}

/// Refuses an epsilon that is no length, and one that nothing uses.
fn check_epsilon(epsilon: Option<f64>, is_used: bool) -> Result<(), Invalid> {
    let Some(epsilon) = epsilon else { return Ok(()) };
    length("epsilon", epsilon)?;
    if !is_used {
        let problem = format!(
            "found {}, but only the textbook's routines have an epsilon: leave it out, or add \
             `intersect = \"textbook\"`",
            shown(epsilon)
        );
        return Err(Invalid::field("epsilon", problem));
    }
    Ok(())
}

/// The objects that are on, and notes on the files that the scene names.
pub(super) fn placed_objects(
    scene: &Scene,
    resources: Resources,
    materials: &[PlacedMaterial],
    names: &Names,
) -> Result<(Vec<PlacedObject>, Vec<String>), Invalid> {
    let known: BTreeMap<String, PartMaterial> = materials
        .iter()
        .map(|m| {
            (m.name.to_string(), PartMaterial { index: m.index, casts_shadows: m.casts_shadows })
        })
        .collect();
    unique("objects", scene.objects.iter().map(|object| object.name.as_str()))?;
    check_epsilon(scene.epsilon, scene.uses_textbook())?;
    let mut context = Context::new(resources, scene.accel).with_materials(known);
    let mut objects = Vec::new();
    for (index, object) in scene.objects.iter().enumerate() {
        let here = item("objects", index, &object.name);
        let material = context.material(&object.material).map_err(&here)?;
        let textbook = scene.textbook_epsilon(object);
        check_epsilon(object.epsilon, textbook.is_some()).map_err(&here)?;
        context.set_textbook(textbook);
        let built = context.object(&object.shape, material).map_err(|e| here(e.inside("shape")));
        let (shape, made_of) = built?;
        if !object.enabled {
            continue;
        }
        let needs_uv = |index: u32| materials[index as usize].needs_uv;
        if let Some(found) = shape.material_without_uv(material.index, &needs_uv) {
            let name = printable::name(&materials[found as usize].name);
            let problem = format!(
                "its material `{name}` has an image without `mapping`, which needs texture coordinates, \
                 but only meshes with `uvs` have these: give the image a mapping"
            );
            return Err(here(Invalid::field("shape", problem)));
        }
        let blocks = |part: &PartMaterial| object.casts_shadows && part.casts_shadows;
        objects.push(PlacedObject {
            name: Arc::clone(&names.objects[index]),
            index: index as u32,
            material: material.index,
            casts_shadows: made_of.iter().any(blocks),
            shines: true,
            lamp_of: None,
            shape,
        });
    }
    Ok((objects, context.notes().to_vec()))
}
