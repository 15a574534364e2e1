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

use groundtruth::scene::{Object, Scene};

use super::Mistake;
use super::places::any;

pub(super) const ALL: [&[Mistake]; 4] = [cameras::ALL, instances::ALL, lights::ALL, materials::ALL];

/// A copy of which one of these items, or more, are changed.
fn each<T>(
    scene: &Scene,
    items: fn(&mut Scene) -> &mut Vec<T>,
    change: impl FnMut(&mut T) -> Option<()>,
) -> Option<Scene> {
    let mut copy = scene.clone();
    any(items(&mut copy).iter_mut().filter_map(change))?;
    Some(copy)
}

fn objects(scene: &mut Scene) -> &mut Vec<Object> {
    &mut scene.objects
}
