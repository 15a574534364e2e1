//! Mistakes that are a change of the scene which the file of mistakes cannot say: kinds of lights, cameras and materials that
//! are wrong, around ours.

mod cameras;
mod instances;
mod lamps;
mod lights;
mod materials;

use groundtruth::scene::Scene;

use super::Mistake;

pub(super) use materials::NOT_INVERTED;

pub(super) const ALL: [&[Mistake]; 5] =
    [cameras::ALL, instances::ALL, lamps::ALL, lights::ALL, materials::ALL];

/// A copy with this change, which returns whether it changed something.
fn changed(scene: &Scene, change: impl FnOnce(&mut Scene) -> bool) -> Option<Scene> {
    let mut copy = scene.clone();
    change(&mut copy).then_some(copy)
}
