//! A scene whose picture gets the size of another one.

use groundtruth::scene::Scene;

/// A size that no picture of a scene has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "a picture of {} columns is no stereo pair: it has two images of equal width and {gap} columns between them",
    columns
)]
pub struct NoPair {
    columns: u32,
    gap: u32,
}

/// Gives the whole picture of a scene this size; the width of its view stays. Returns whether the picture has its
/// shape, up to rounding to whole pixels.
///
/// # Errors
/// If the scene is a stereo pair, and no pair has so many columns.
pub fn fit(scene: &mut Scene, [columns, height]: [u32; 2]) -> Result<bool, NoPair> {
    let width = match &scene.camera.stereo {
        None => columns,
        Some(stereo) => match columns.checked_sub(stereo.gap) {
            Some(both) if both >= 2 && both.is_multiple_of(2) => both / 2,
            _ => return Err(NoPair { columns, gap: stereo.gap }),
        },
    };
    let [w, h] = [scene.image.width, scene.image.height].map(u64::from);
    let is_alike = (w * u64::from(height)).abs_diff(h * u64::from(width)) <= w.max(h);
    scene.image.resize(width, height);
    Ok(is_alike)
}
