//! Limits of time and memory for one line.

use groundtruth::accel;
use groundtruth::invalid::Invalid;
use groundtruth::render::{MAX_COUNTED, RaysPerSample};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::shapes::{Kind, Shape};
use groundtruth::trace::RayBudget;
use groundtruth::world::World;

/// Bytes of a line; an inline scene fits, a mesh belongs into a file.
pub const LONGEST_LINE: usize = 1 << 20;
/// Points of sample sets in one answer, and samples of one set.
pub const MAX_POINTS: u32 = 1 << 14;
/// Triangles of all procedural meshes and lists, and parts and copies of shapes, in a line. Mesh files are
/// not counted: their cost is limited by their size.
pub const MAX_TRIANGLES: u64 = 1 << 18;
/// The approximate number of cells of a grid in a cube; other grids have at most a few times as many.
pub const MAX_CELLS: f64 = (1 << 20) as f64;
/// Ray–object tests, roughly, for one radiance: some seconds.
pub const MAX_WORK: f64 = 2e8;

/// The primitives that building this shape makes; an error names the field that asks for too many.
fn primitives(shape: &Kind) -> Result<u64, Invalid> {
    match shape {
        Kind::TessellatedSphere(sphere) => {
            let triangles = 2 * u64::from(sphere.horizontal) * u64::from(sphere.vertical);
            few(triangles).map_err(|e| e.inside("horizontal").inside("tessellated_sphere"))
        }
        Kind::Instance(instance) => {
            primitives(&instance.of).map_err(|e| e.inside("of").inside("instance"))
        }
        Kind::Compound(compound) => {
            let parts = compound.parts.iter().map(|part| &part.shape);
            buildable(parts, |part, e| e.inside("shape").inside(part))
                .map_err(|e| e.inside("parts").inside("compound"))
        }
        Kind::Lattice(lattice) => {
            let copies = lattice.counts.iter().fold(1_u64, |n, &c| n.saturating_mul(c.into()));
            let of = primitives(&lattice.of).map_err(|e| e.inside("of"));
            let all =
                of.and_then(|of| few(copies.saturating_add(of)).map_err(|e| e.inside("counts")));
            all.map_err(|e| e.inside("lattice"))
        }
        Kind::RandomSpheres(spheres) => {
            few(spheres.count.into()).map_err(|e| e.inside("count").inside("random_spheres"))
        }
        Kind::Archway(arch) => {
            let (blocks, wedges) = (2 * u64::from(arch.blocks), u64::from(arch.wedges));
            let field = if blocks > wedges { "blocks" } else { "wedges" };
            // some 26 parts a stone
            few(26 * (blocks + wedges)).map_err(|e| e.inside(field).inside("archway"))
        }
        Kind::Rosette(_) => Ok(26 * 115),
        Kind::Mesh(mesh) => {
            let triangles = mesh.triangles.as_ref().map_or(1, |triangles| triangles.len() as u64);
            few(triangles).map_err(|e| e.inside("triangles").inside("mesh"))
        }
        _ => Ok(1),
    }
}

/// `count`, if a line may have that many primitives.
fn few(count: u64) -> Result<u64, Invalid> {
    if count > MAX_TRIANGLES {
        return Err(Invalid::new(format!(
            "{count} triangles and parts are too many for a line; at most {MAX_TRIANGLES} fit"
        )));
    }
    Ok(count)
}

/// Refuses shapes with too many triangles; `here` adds the path of the shape with this index.
pub(super) fn buildable<'a>(
    shapes: impl Iterator<Item = &'a Kind>,
    here: impl Fn(usize, Invalid) -> Invalid,
) -> Result<u64, Invalid> {
    let mut total = 0_u64;
    for (index, shape) in shapes.enumerate() {
        total = total.saturating_add(primitives(shape).map_err(|e| here(index, e))?);
    }
    few(total)
}

/// Refuses to find all hits of too many nested shapes.
pub(super) fn all_of(shape: &dyn Shape) -> Result<(), Invalid> {
    if shape.leaves() > MAX_TRIANGLES {
        return Err(Invalid::new(format!(
            "all hits of {} nested shapes are too many to look for; at most {MAX_TRIANGLES} fit, \
             or leave it out to get the nearest hit",
            shape.leaves()
        )));
    }
    Ok(())
}

/// Refuses so many samples if they would take too long: `look` is one of them, and others are those of the
/// whole picture. Returns the number of rays at which tracing them must end: estimates may be too low.
pub(super) fn traceable(
    scene: &Scene,
    world: &World,
    primitives: u64,
    samples: f64,
    look: impl FnOnce(&World, &mut RayBudget) -> Rgb,
) -> Result<u64, Invalid> {
    let tests = match scene.accel {
        // a teapot in a stadium is in one cell
        accel::Method::List | accel::Method::Grid => primitives as f64,
        accel::Method::Bvh => (primitives as f64).min(64.0),
    };
    let tests = tests.max(1.0);
    let most = (MAX_WORK / tests) as u64;
    let mut asked = RayBudget::up_to(most.min(MAX_COUNTED));
    look(world, &mut asked);
    asked.check(|| "a single sample".to_owned()).map_err(|e| Invalid::new(e.to_string()))?;
    let all = RaysPerSample::measured(world, most);
    let about = if all.is_cut { "at least" } else { "about" };
    let work = (asked.spent() as f64).max(all.mean) * samples * tests;
    if work > MAX_WORK {
        return Err(Invalid::new(format!(
            "this would take {about} {work:.0e} tests of a ray and an object, and at most \
             {MAX_WORK:.0e} fit; ask for fewer samples or replicas, or lower the scene's max_depth"
        )));
    }
    Ok(2 * most)
}
