//! Changes in one place of a scene alone: of one material, one object, one kind of shape, one light.

use std::collections::BTreeSet;

use groundtruth::scene::{Scene, Tracer};
use serde_json::json;

use super::known::{self, KnownMistake};

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

/// The mistakes that may be made in one material alone.
pub fn of_one_material() -> impl Iterator<Item = &'static KnownMistake> {
    known::pictures().iter().filter(|known| known.in_one_material)
}

/// The scene with each of these mistakes in a material alone, where it has such a thing. None if the scene cannot be written to
/// a file.
pub fn in_material(scene: &Scene, material: &str) -> Vec<Local> {
    let Ok(whole) = serde_json::to_value(scene) else { return Vec::new() };
    let Some(at) = scene.materials.iter().position(|it| it.name == material) else {
        return Vec::new();
    };
    let changed = |known: &'static KnownMistake| {
        let mut alone = json!({"scene": {"materials": [whole["materials"][at]]}});
        known.change(&mut alone)?;
        let mut whole = whole.clone();
        whole["materials"][at] = alone["scene"]["materials"][0].take();
        let scene = serde_json::from_value(whole).ok()?;
        let words = format!("in material {material} alone, {}", known.words);
        Some(Local { words, scene, everywhere: Some(known.name) })
    };
    of_one_material().filter_map(changed).collect()
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
    let casting = scene.objects.iter().filter(|it| it.enabled && it.casts_shadows);
    let kinds: BTreeSet<String> = casting.filter_map(|it| kind(&it.shape)).collect();
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
    serde_json::to_value(shape).ok()?.as_object()?.keys().next().cloned()
}
