//! Sentences about what a tracer leaves out.

use groundtruth::lights::Light;
use groundtruth::printable;
use groundtruth::trace::{Direct, Scatter, Strategy};
use groundtruth::world::{PlacedLight, PlacedMaterial, World};

/// A sentence for the user about each light that the world's tracer leaves out, about each mirror
/// and glass that it does not trace, and about objects without any light.
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
    let materials = world.materials.iter().filter_map(of_material);
    lights.chain(materials).chain(dark(world, strategy)).collect()
}

/// That nothing lights the objects, if it is so: paths find the background by themselves.
fn dark(world: &World, strategy: Strategy) -> Option<String> {
    let shines = world.materials.iter().any(|material| material.recipe.emission().is_some());
    let is_lit = !world.lights.is_empty() || shines || strategy.is_path();
    let is_dark = !is_lit && !world.names.objects.is_empty();
    is_dark.then(|| {
        "no light is on and no material is emissive: surfaces are black, but for the background in mirrors and glass"
            .to_owned()
    })
}

/// What is done with light of this kind instead of counting it at every hit, and why, in words for
/// the user.
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
