//! What one line may cost: no line takes gigabytes, or forever.

use crate::accel;
use crate::invalid::Invalid;
use crate::scene::Scene;
use crate::shapes::{Kind, Shape};
use crate::world::World;

/// Bytes of a line; an inline scene fits, a mesh belongs into a file.
pub const LONGEST_LINE: usize = 1 << 20;
/// Points of sample sets in one answer, and samples of one set.
pub const MOST_POINTS: u32 = 1 << 14;
/// Triangles of all procedural meshes, and parts and copies of shapes, of a line. A mesh file is not counted: it takes what a file
/// of its size takes anywhere else.
pub const MOST_TRIANGLES: u64 = 1 << 18;
/// Ray–object tests, roughly, for one radiance: some seconds.
pub const MOST_WORK: f64 = 2e8;

/// The primitives that building this shape makes.
fn primitives(shape: &Kind) -> u64 {
    match shape {
        Kind::TessellatedSphere(sphere) => {
            2 * u64::from(sphere.horizontal) * u64::from(sphere.vertical)
        }
        Kind::Instance(instance) => primitives(&instance.of),
        Kind::Compound(compound) => {
            let parts = compound.parts.iter().map(|part| primitives(&part.shape));
            parts.fold(0, u64::saturating_add)
        }
        Kind::Lattice(lattice) => {
            let copies = lattice.counts.iter().fold(1_u64, |n, &c| n.saturating_mul(c.into()));
            copies.saturating_add(primitives(&lattice.of))
        }
        Kind::RandomSpheres(spheres) => spheres.count.into(),
        // some 26 parts a stone
        Kind::Archway(arch) => 26 * (2 * u64::from(arch.blocks) + u64::from(arch.wedges)),
        Kind::Rosette(_) => 26 * 115,
        _ => 1,
    }
}

/// Refuses shapes of more triangles than fit.
pub(super) fn buildable<'a>(shapes: impl Iterator<Item = &'a Kind>) -> Result<u64, Invalid> {
    let total = shapes.map(primitives).fold(0, u64::saturating_add);
    if total > MOST_TRIANGLES {
        return Err(Invalid::new(format!(
            "{total} triangles and parts are too many for a line; at most {MOST_TRIANGLES} fit"
        )));
    }
    Ok(total)
}

/// Refuses to look for all hits of more nested shapes than fit.
pub(super) fn all_of(shape: &dyn Shape) -> Result<(), Invalid> {
    if shape.leaves() > MOST_TRIANGLES {
        return Err(Invalid::new(format!(
            "all hits of {} nested shapes are too many to look for; at most {MOST_TRIANGLES} fit, \
             or leave it out to get the nearest hit",
            shape.leaves()
        )));
    }
    Ok(())
}

/// Refuses a radiance that could take too long.
pub(super) fn traceable(
    scene: &Scene,
    world: &World,
    primitives: u64,
    samples: f64,
) -> Result<(), Invalid> {
    let pixels = f64::from(world.image.width) * f64::from(world.image.height);
    let rays = world.most_rays() / (pixels * f64::from(world.samples_per_pixel())) * samples;
    let tests = match scene.accel {
        // a teapot in a stadium is in one cell
        accel::Method::List | accel::Method::Grid => primitives as f64,
        accel::Method::Bvh => (primitives as f64).min(64.0),
    };
    let work = rays * (1.0 + world.lights.len() as f64) * tests.max(1.0);
    if work > MOST_WORK {
        return Err(Invalid::new(format!(
            "this may take {work:.0e} tests of a ray and an object, and at most {MOST_WORK:.0e} \
             fit; ask for fewer samples or replicas, or lower the scene's max_depth"
        )));
    }
    Ok(())
}
