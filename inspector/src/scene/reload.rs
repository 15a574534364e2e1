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
    let lights = |scene: &Scene| switches(scene.lights.iter().map(|l| (&l.name, l.enabled)));
    keep_switches(
        lights(before),
        lights(wanted),
        now.lights.iter_mut().map(|l| (&l.name, &mut l.enabled)),
    );
    let objects = |scene: &Scene| switches(scene.objects.iter().map(|o| (&o.name, o.enabled)));
    keep_switches(
        objects(before),
        objects(wanted),
        now.objects.iter_mut().map(|o| (&o.name, &mut o.enabled)),
    );
    now
}

fn switches<'a>(all: impl Iterator<Item = (&'a String, bool)>) -> Vec<(String, bool)> {
    all.map(|(name, on)| (name.clone(), on)).collect()
}

/// Sets the switches that were changed, where an element of the same name still has the same index.
fn keep_switches<'a>(
    before: Vec<(String, bool)>,
    wanted: Vec<(String, bool)>,
    now: impl Iterator<Item = (&'a String, &'a mut bool)>,
) {
    for ((old, wanted), (name, on)) in before.into_iter().zip(wanted).zip(now) {
        if old != wanted && wanted.0 == *name {
            *on = wanted.1;
        }
    }
}
