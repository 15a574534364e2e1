//! Mistakes that are a change of the scene, or of its world, which the file of mistakes cannot say: lights, cameras and materials
//! that are wrong, around ours.

/// Methods that are those of the kind in a field.
macro_rules! as_in {
    ($field:ident, $(fn $name:ident(&self $(, $arg:ident: $type:ty)*) $(-> $out:ty)?;)*) => {
        $(fn $name(&self $(, $arg: $type)*) $(-> $out)? { self.$field.$name($($arg),*) })*
    };
}

mod cameras;
mod instances;
mod lights;
mod materials;

use groundtruth::scene::Scene;

use super::Mistake;

pub(super) const ALL: [&[Mistake]; 4] = [cameras::ALL, instances::ALL, lights::ALL, materials::ALL];

/// A copy that is changed.
fn changed(scene: &Scene, change: impl FnOnce(&mut Scene) -> Option<()>) -> Option<Scene> {
    let mut copy = scene.clone();
    change(&mut copy)?;
    Some(copy)
}
