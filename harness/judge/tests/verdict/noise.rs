//! Values of pictures of normal noise.

use groundtruth::math::Pcg32;

/// A number of mean 0 and variance 1, nearly normal.
pub fn normal(random: &mut Pcg32) -> f64 {
    (0..12).map(|_| random.uniform()).sum::<f64>() - 6.0
}

/// The values of a picture of normal noise: of the mean 10, and of this deviation relative to it.
pub fn noisy(random: &mut Pcg32, pixels: usize, noise: f64) -> Vec<f32> {
    (0..3 * pixels).map(|_| (10.0 * (1.0 + noise * normal(random))) as f32).collect()
}
