//! An audit: some rows of a part are rendered again, and must have the same bits.

use groundtruth::render;
use groundtruth::world::World;
use rayon::prelude::*;

use super::{ChannelSums, Contradiction, MergeError, NotFinite, SumsFile};

/// Renders rows (counted from the top) of all replicas of a part again, in parallel, and compares the sums and the
/// values that are not finite. `progress` is called after each replica. The world must be of the part's scene; its
/// seed changes.
///
/// # Errors
/// [`Contradiction::Audit`] names the first pixel that differs; a file that cannot be read.
pub fn audit(
    part: &SumsFile,
    world: &mut World,
    rows: &[u32],
    mut progress: impl FnMut(),
) -> Result<(), MergeError> {
    let width = part.header().size[0];
    let pixels: Vec<[u32; 2]> =
        rows.iter().flat_map(|&row| (0..width).map(move |column| [column, row])).collect();
    let mut sums = vec![Some([ChannelSums::default(); 3]); pixels.len()];
    let mut not_finite = Vec::new();
    for seed in part.header().seeds.iter() {
        world.reseed(seed);
        let values: Vec<[f64; 3]> =
            pixels.par_iter().map(|&pixel| render::pixel(world, pixel).to_array()).collect();
        for ((sums, values), &pixel) in sums.iter_mut().zip(values).zip(&pixels) {
            not_finite.extend(NotFinite::of(values, pixel, width, seed));
            *sums = sums.and_then(|sums| added(sums, values));
        }
        progress();
    }
    let differs = |pixel| Contradiction::Audit {
        path: part.path().to_owned(),
        pixel,
        seeds: part.header().seeds.clone(),
    };
    let mut found = Vec::new();
    for &row in rows {
        found.extend(part.row(row)?);
    }
    for ((ours, theirs), &pixel) in sums.iter().zip(found.chunks_exact(3)).zip(&pixels) {
        // sums that do not fit are not those of a file
        if ours.as_ref().map(|ours| &ours[..]) != Some(theirs) {
            return Err(differs(pixel).into());
        }
    }
    let mut theirs = part.checked()?.not_finite;
    theirs.retain(|entry| rows.contains(&entry.pixel(width)[1]));
    not_finite.sort_unstable();
    match not_finite
        .iter()
        .find(|e| !theirs.contains(e))
        .or(theirs.iter().find(|e| !not_finite.contains(e)))
    {
        Some(entry) => Err(differs(entry.pixel(width)).into()),
        None => Ok(()),
    }
}

/// The sums with one value more for each channel; `None` if they do not fit.
fn added(sums: [ChannelSums; 3], values: [f64; 3]) -> Option<[ChannelSums; 3]> {
    let mut next = sums;
    for (sums, x) in next.iter_mut().zip(values) {
        if x.is_finite() {
            *sums = sums.checked_add(ChannelSums::of(x)?)?;
        }
    }
    Some(next)
}
