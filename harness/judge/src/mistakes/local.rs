//! Changes in one place of a scene alone: of one material, one object, one kind of shape, one light.

use std::collections::BTreeSet;

use groundtruth::scene::{Scene, Tracer};
use serde_json::Value;

use super::changes::edits::edit_each;
pub use super::changes::textures::{CHANGES, TextureChange};

/// A scene with a change in one place.
#[derive(Clone, Debug)]
pub struct Local {
    /// Completes the sentence "the picture agrees with ours if …".
    pub words: String,
    /// The changed scene.
    pub scene: Scene,
    /// The mistake that makes the same change everywhere, if there is one.
    pub everywhere: Option<&'static str>,
}

/// The scene with each change of the textures of a material, where it has such a thing. None if the scene cannot be written to
/// a file.
pub fn in_material(scene: &Scene, material: &str) -> Vec<Local> {
    let Ok(whole) = serde_json::to_value(scene) else { return Vec::new() };
    let Some(at) = scene.materials.iter().position(|it| it.name == material) else {
        return Vec::new();
    };
    let changed = |change: &TextureChange| {
        let mut whole = whole.clone();
        let is_changed = edit_each(&mut whole["materials"][at], &change.edit);
        let scene = is_changed.then(|| serde_json::from_value(whole).ok())??;
        let words = format!("in material {material} alone, {}", change.known.words);
        Some(Local { words, scene, everywhere: Some(change.known.name) })
    };
    CHANGES.iter().filter_map(changed).collect()
}

/// The scene without an object.
pub fn without(scene: &Scene, object: &str) -> Option<Local> {
    let mut scene = scene.clone();
    let left_out = scene.objects.iter_mut().find(|it| it.enabled && it.name == object)?;
    left_out.enabled = false;
    Some(Local { words: format!("{object} is left out"), scene, everywhere: None })
}

/// Shadows that are missing in part, in scenes whose light all comes from samples of lights: shapes of one of several
/// kinds cast none, or one of several lights makes none.
pub fn without_shadows(scene: &Scene) -> Vec<Local> {
    if !matches!(scene.tracer, Tracer::RayCast | Tracer::Whitted(_)) {
        return Vec::new();
    }
    let mut all = Vec::new();
    let casting = |scene: &Scene| -> BTreeSet<String> {
        let objects = scene.objects.iter().filter(|it| it.enabled && it.casts_shadows);
        objects.filter_map(|it| kind(&it.shape)).collect()
    };
    let kinds = casting(scene);
    for name in kinds.iter().filter(|_| kinds.len() > 1) {
        let mut scene = scene.clone();
        let its = scene.objects.iter_mut().filter(|it| kind(&it.shape).as_ref() == Some(name));
        its.for_each(|object| object.casts_shadows = false);
        let words = format!("shapes of the kind {name} cast no shadows");
        all.push(Local { words, scene, everywhere: None });
    }
    let shadowed: Vec<usize> = (0..scene.lights.len())
        .filter(|light| scene.lights[*light].enabled && scene.lights[*light].shadows)
        .collect();
    for light in shadowed.iter().copied().filter(|_| shadowed.len() > 1) {
        let mut scene = scene.clone();
        scene.lights[light].shadows = false;
        let words = format!("objects cast no shadows in the light of {}", scene.lights[light].name);
        all.push(Local { words, scene, everywhere: None });
    }
    all
}

/// The kind of a shape, as scene files name it; `None` for kinds that these do not have.
fn kind(shape: &groundtruth::shapes::Kind) -> Option<String> {
    match serde_json::to_value(shape).ok()? {
        Value::Object(table) => table.into_iter().next().map(|(name, _)| name),
        _ => None,
    }
}
