//! Sentences about what a tracer leaves out.

use crate::lights::Light;
use crate::printable;
use crate::trace::{Direct, Scatter, Strategy};
use crate::world::{PlacedLight, PlacedMaterial, World};

/// A sentence for the user about each light that the world's tracer leaves out, and about each mirror and
/// glass that it does not trace.
pub fn omissions(world: &World) -> Vec<String> {
    let strategy = Strategy::of(world.tracer);
    let tracer = world.tracer.name();
    let of_light = |light: &PlacedLight| {
        let [what, why] = leaves_out(strategy, &*light.light)?;
        Some(format!("{tracer} {what} the light \"{}\": {why}", printable::name(&light.name)))
    };
    let of_material = |material: &PlacedMaterial| {
        let is_left_out = strategy.scatter == Scatter::Nothing && material.recipe.needs_rays();
        is_left_out.then(|| {
            format!(
                "{tracer} traces no reflections or refractions of the material \"{}\"; `whitted` and the \
                 path tracers do",
                printable::name(&material.name)
            )
        })
    };
    let lights = world.lights.iter().filter_map(of_light);
    lights.chain(world.materials.iter().filter_map(of_material)).collect()
}

/// What is done with light of this kind instead of counting it at every hit, and why, in words for the
/// user.
fn leaves_out(strategy: Strategy, light: &dyn Light) -> Option<[&'static str; 2]> {
    match strategy.direct {
        _ if !strategy.is_path() => None,
        _ if light.is_ambient() => {
            Some(["leaves out", "ambient light stands for what paths find by themselves"])
        }
        Direct::Never if !light.is_met() => Some([
            "leaves out",
            "no path can meet it, as it has no surface; `path` and `global_trace` sample it",
        ]),
        Direct::FirstHit if !light.is_met() => Some([
            "counts at the first hit only",
            "no path can meet it, as it has no surface; `path` samples it at every hit",
        ]),
        _ => None,
    }
}
