//! Pictures that cannot be judged.

use groundtruth::explain::count;

use crate::compare::Picture;

/// Our pictures have the seeds from the first on, fewer than a million.
const LAST_SEED: u64 = u64::MAX - 1_000_000;

/// Why a picture cannot be held against ours with the seeds from `seed` on; `None` if it can.
pub fn refusal(picture: &Picture, seed: u64) -> Option<String> {
    if seed > LAST_SEED {
        return Some(format!("ours have the seeds after {seed} too; at most {LAST_SEED} fits"));
    }
    if picture.transparent > 0 {
        let pixels = count(picture.transparent as usize, "pixel");
        return Some(format!(
            "alpha is below 1 in {pixels}; lay the picture over the scene's background, or write it without alpha"
        ));
    }
    let is_number = |color: &[f32; 3]| color.iter().all(|value| value.is_finite());
    let at = picture.values.iter().position(|color| !is_number(color))?;
    let (width, value) = (picture.size[0] as usize, picture.values[at]);
    let [x, y] = [at % width, at / width];
    Some(format!(
        "pixel {x}, {y} is {value:?}; radiance is finite: find the ray that brings it first"
    ))
}
