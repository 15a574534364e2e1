//! Mistakes that are a change of the scene.

use std::path::Path;

use groundtruth::scene::{Scene, Tracer};

use super::Mistake;

pub(super) const ALL: &[Mistake] = &[
    Mistake::scene(16, "no-shadows", "objects cast no shadows", no_shadows),
    Mistake::scene(24, "one-bounce-less", "rays are traced to one depth less", |scene, _| {
        deeper_by(scene, -1)
    }),
    Mistake::scene(24, "one-bounce-more", "rays are traced to one depth more", |scene, _| {
        deeper_by(scene, 1)
    }),
];

/// A copy with this change, if it changes something.
fn changed(scene: &Scene, change: impl FnOnce(&mut Scene) -> bool) -> Option<Scene> {
    let mut copy = scene.clone();
    change(&mut copy).then_some(copy)
}

/// Path tracers do not apply: they find shadows by paths, too.
fn no_shadows(scene: &Scene, _: &Path) -> Option<Scene> {
    if !matches!(scene.tracer, Tracer::RayCast | Tracer::Whitted(_)) {
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

fn deeper_by(scene: &Scene, change: i32) -> Option<Scene> {
    changed(scene, |scene| {
        let Some(depth) = scene.tracer.max_depth() else { return false };
        let other = depth.checked_add_signed(change);
        *depth = other.unwrap_or(*depth);
        other.is_some()
    })
}
