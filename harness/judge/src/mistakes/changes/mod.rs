//! Mistakes that are a change of the scene.

mod cameras;
pub(super) mod edits;
mod instances;
mod lamps;
mod lights;
mod materials;
mod skies;
mod tables;
pub(super) mod textures;

use groundtruth::scene::{Scene, Tracer};

use super::{Mistake, known};

pub(super) use materials::NOT_INVERTED;

pub(super) const ALL: [&[Mistake]; 10] = [
    &[
        Mistake::scene(&known::ONE_BOUNCE_LESS, |scene, _| deeper_by(scene, -1)),
        Mistake::scene(&known::ONE_BOUNCE_MORE, |scene, _| deeper_by(scene, 1)),
    ],
    cameras::ALL,
    edits::ALL,
    instances::ALL,
    lamps::ALL,
    lights::ALL,
    materials::ALL,
    skies::ALL,
    tables::ALL,
    textures::ALL,
];

/// A copy with this change, which returns whether it changed something.
fn changed(scene: &Scene, change: impl FnOnce(&mut Scene) -> bool) -> Option<Scene> {
    let mut copy = scene.clone();
    change(&mut copy).then_some(copy)
}

/// Whether all light comes from the samples of lights: paths also find lamps and the sky by themselves.
fn has_tree_of_rays(scene: &Scene) -> bool {
    matches!(scene.tracer, Tracer::RayCast | Tracer::Whitted(_))
}

fn deeper_by(scene: &Scene, change: i32) -> Option<Scene> {
    changed(scene, |scene| {
        let Some(depth) = scene.tracer.max_depth() else { return false };
        let other = depth.checked_add_signed(change);
        *depth = other.unwrap_or(*depth);
        other.is_some()
    })
}
