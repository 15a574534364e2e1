//! Pictures that cannot be judged.

use text::brief::count;

use pictures::compare::Picture;

/// Our pictures have the seeds from the first on, fewer than a million.
const LAST_SEED: u64 = u64::MAX - 1_000_000;

/// Why ours cannot have the seeds from this one on; `None` if they can.
pub fn refusal_of_seed(seed: u64) -> Option<String> {
    (seed > LAST_SEED)
        .then(|| format!("--seed: ours have the seeds after it too; at most {LAST_SEED} fits"))
}

/// Why a picture cannot be held against ours; `None` if it can.
pub fn refusal(picture: &Picture) -> Option<String> {
    if let Some(problem) = refusal_of_alpha(picture) {
        return Some(problem);
    }
    let is_number = |color: &[f32; 3]| color.iter().all(|value| value.is_finite());
    let at = picture.values.iter().position(|color| !is_number(color))?;
    let (width, value) = (picture.size[0] as usize, picture.values[at]);
    let [x, y] = [at % width, at / width];
    Some(format!(
        "pixel {x}, {y} is {value:?}; radiance is finite: find the ray that brings it first"
    ))
}

/// Why a picture with alpha cannot be judged.
pub fn refusal_of_alpha(picture: &Picture) -> Option<String> {
    (picture.transparent > 0).then(|| {
        let pixels = count(picture.transparent as usize, "pixel");
        format!("alpha is below 1 in {pixels}; lay the picture over the scene's background, or write it without alpha")
    })
}
