//! Verdicts on pictures.

use groundtruth::render::Canvas;
use groundtruth::world::World;
use judge::verdict::{self, Case, Decision};
use pictures::compare::Picture;
use pyo3::prelude::*;
use text::told::Told;

use crate::scene::{Built, Changes, wrong};

/// A verdict: whether the pictures agree (`None` if nobody can say), as text, as a page and as JSON.
type Judged = (Option<bool>, String, String, String);

/// Judges pictures of radiance, three floats a pixel, as those of a scene at their size.
#[pyfunction]
pub fn verify(
    py: Python<'_>,
    scene: &str,
    changes: Changes,
    pictures: Vec<Vec<u8>>,
    size: [u32; 2],
) -> PyResult<Judged> {
    let mut built = Built::of(scene, &changes)?;
    let values = |bytes: &Vec<u8>| -> Vec<f32> {
        bytes.as_chunks::<4>().0.iter().map(|bytes| f32::from_ne_bytes(*bytes)).collect()
    };
    let pictures: Vec<Picture> =
        pictures.iter().map(|bytes| Picture::of_radiance(&values(bytes), size)).collect();
    let seed = built.world.seed;
    let refusal = pictures.iter().find_map(verdict::refusal);
    if let Some(problem) = refusal.or_else(|| verdict::refusal_of_seed(seed)) {
        return Err(wrong(problem));
    }
    // asked by the thread that judges, which has let Python go on meanwhile
    let is_interrupted = || Python::attach(|py| py.check_signals().is_err());
    let judged = py.detach(|| {
        let case = Case {
            is_over: &is_interrupted,
            transfer: pictures[0].stated,
            ..Case::new(&built.scene, &built.folder, seed)
        };
        let renders = &mut |world: &World, canvas: &Canvas| {
            canvas.render(world);
            !is_interrupted()
        };
        case.verdict(&mut built.world, &pictures, renders)
    });
    let judged = judged.ok_or_else(|| wrong("interrupted; nothing is known yet"))?;
    let agrees = match judged.decision {
        Decision::Agrees => Some(true),
        Decision::Differs => Some(false),
        Decision::Undecided => None,
    };
    let worst = judged.regions.first().map(|region| region.worst);
    let next = match worst {
        Some([x, y]) => format!("explain(scene, ({x}, {y}))"),
        None => format!("verify(scene, pictures, seed={})", seed.wrapping_add(1)),
    };
    let told = Told { verdict: judged.sentence(), details: judged.details(), next };
    let page = verdict::page(&judged, "an array", &told);
    Ok((agrees, told.text(), page, told.json(&judged).map_err(wrong)?))
}
