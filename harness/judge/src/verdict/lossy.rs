//! Pictures in JPEG files, which keep the means of blocks and not single values.

use groundtruth::film::Film;
use pictures::compare::Picture;

use super::stored::Stored;

/// The side of a block: of 8 × 8 pixels, with colours of half the resolution.
const BLOCK: usize = 16;

/// So many standard deviations of ours are allowed beside the loss, in the mean of a block.
const DEVIATIONS: f64 = 5.0;

/// Whether the mean of each whole block and channel is that of ours, but for noise and this loss in steps.
pub(super) fn agrees(theirs: &Picture, loss: f64, stored: Stored, films: &[Film]) -> bool {
    let [width, height] = theirs.size.map(|side| side as usize);
    let Some(step) = theirs.step else { return false };
    let (across, down) = (width / BLOCK, height / BLOCK);
    (0..across * down).all(|block| {
        let (left, top) = (block % across * BLOCK, block / across * BLOCK);
        let pixels =
            || (0..BLOCK * BLOCK).map(move |at| (top + at / BLOCK) * width + left + at % BLOCK);
        let mean =
            |of: &dyn Fn(usize) -> f64| pixels().map(of).sum::<f64>() / (BLOCK * BLOCK) as f64;
        (0..3).all(|channel| {
            let of_ours = |film: &Film| {
                mean(&|at| stored.integers(film.pixels()[at]).unwrap_or_default()[channel])
            };
            let ours: Vec<f64> = films.iter().map(of_ours).collect();
            let count = ours.len() as f64;
            let middle = ours.iter().sum::<f64>() / count;
            let squares: f64 = ours.iter().map(|it| (it - middle) * (it - middle)).sum();
            let noise = (squares / (count - 1.0) * (1.0 + 1.0 / count)).sqrt();
            let of_theirs = mean(&|at| f64::from(theirs.values[at][channel]) / step);
            (of_theirs - middle).abs() <= loss + DEVIATIONS * noise
        })
    })
}
