//! Combines a scene file that was read again with the changes made in the window.

use groundtruth::scene::Scene;

use crate::scene::numbers;

/// The scene of the new file, with every setting, number and switch that was changed in the window since the file
/// was last read.
pub fn with_changes(before: &Scene, wanted: &Scene, now: Scene) -> Scene {
    let mut now = numbers::with_changes(before, wanted, now);
    let size = |scene: &Scene| [scene.image.width, scene.image.height];
    if size(wanted) != size(before) {
        now.image.resize(wanted.image.width, wanted.image.height);
    }
    if wanted.image.samples != before.image.samples {
        now.image.samples = wanted.image.samples;
    }
    let sampler = |scene: &Scene| format!("{:?}", scene.image.sampler);
    if sampler(wanted) != sampler(before) {
        now.image.sampler.clone_from(&wanted.image.sampler);
    }
    if wanted.tracer != before.tracer {
        now.tracer = wanted.tracer;
    }
    // switches, where a thing of the same name still has the same index
    for ((old, wanted), now) in before.lights.iter().zip(&wanted.lights).zip(&mut now.lights) {
        if old.enabled != wanted.enabled && wanted.name == now.name {
            now.enabled = wanted.enabled;
        }
    }
    for ((old, wanted), now) in before.objects.iter().zip(&wanted.objects).zip(&mut now.objects) {
        if old.enabled != wanted.enabled && wanted.name == now.name {
            now.enabled = wanted.enabled;
        }
    }
    now
}
