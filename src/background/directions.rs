//! Importance sampling of a sky by image: texels in proportion to their radiance.

use std::sync::Arc;

use super::ImageSky;
use crate::math::{ONE_MINUS, Vector};

/// A density of directions. The probability of a texel is proportional to its largest radiance
/// times its solid angle; within the texel, all points of the image are equally likely. The density
/// is positive wherever the sky shines, so that no light is missed (Pharr, Jakob, Humphreys,
/// *Physically Based Rendering*, on infinite area lights).
#[derive(Debug)]
pub struct Directions {
    sky: Arc<ImageSky>,
    /// The weights of the rows.
    rows: Sums,
    /// The weights of the texels in each row.
    columns: Vec<Sums>,
}

impl Directions {
    /// The density for this sky.
    pub fn new(sky: &Arc<ImageSky>) -> Self {
        let [width, height] = sky.size();
        let weight = |texel: [u32; 2]| sky.brightest_around(texel) * sky.solid_angle_of(texel);
        let row = |row: u32| Sums::new((0..width).map(|column| weight([column, row])));
        let columns: Vec<Sums> = (0..height).map(row).collect();
        let rows = Sums::new(columns.iter().map(Sums::total));
        Self { sky: Arc::clone(sky), rows, columns }
    }

    /// Whether the sky is black everywhere.
    pub fn is_black(&self) -> bool {
        self.rows.total() <= 0.0
    }

    /// A unit direction for two numbers in `[0, 1)`; `None` for a black sky, and sometimes in
    /// texels across the rim of an angular map.
    pub fn sample(&self, [u1, u2]: [f64; 2]) -> Option<Vector> {
        let (row, v) = self.rows.draw(u2)?;
        let (column, u) = self.columns[row].draw(u1)?;
        let [width, height] = self.sky.size().map(f64::from);
        self.sky.direction([(column as f64 + u) / width, (row as f64 + v) / height])
    }

    /// The density of [`Directions::sample`] per steradian: the probability of the texel divided by
    /// its area in the image, then by the solid angle per area. 0 at the poles and on the rim,
    /// where it would be infinite.
    pub fn pdf(&self, direction: Vector) -> f64 {
        let Some([u, v]) = self.sky.uv(direction) else { return 0.0 };
        let [width, height] = self.sky.size().map(f64::from);
        let index = |x: f64, count: f64| ((x * count) as usize).min(count as usize - 1);
        let (column, row) = (index(u, width), index(v, height));
        let probability = self.rows.share(row) * self.columns[row].share(column);
        let solid_angle = self.sky.solid_angle(direction);
        let pdf = probability * width * height / solid_angle;
        if solid_angle > 0.0 && pdf.is_finite() { pdf } else { 0.0 }
    }
}

/// The running sums of weights, to draw an index in proportion to its weight.
#[derive(Debug)]
struct Sums(Vec<f64>);

impl Sums {
    fn new(weights: impl Iterator<Item = f64>) -> Self {
        let running = |sum: &mut f64, weight: f64| {
            *sum += weight;
            Some(*sum)
        };
        Self(weights.scan(0.0, running).collect())
    }

    fn total(&self) -> f64 {
        self.0.last().copied().unwrap_or(0.0)
    }

    /// The sums without and with an index.
    fn around(&self, index: usize) -> [f64; 2] {
        [index.checked_sub(1).map_or(0.0, |before| self.0[before]), self.0[index]]
    }

    /// The index at this share of the total, and the position within it, in `[0, 1)`. `None` if all
    /// weights are 0.
    fn draw(&self, u: f64) -> Option<(usize, f64)> {
        let total = self.total();
        if total <= 0.0 {
            return None;
        }
        // rounding could give the total, which is beyond the last index
        let target = (u * total).min(total.next_down());
        let index = self.0.partition_point(|sum| *sum <= target);
        let [before, with] = self.around(index);
        Some((index, ((target - before) / (with - before)).min(ONE_MINUS)))
    }

    /// The probability of an index.
    fn share(&self, index: usize) -> f64 {
        let [before, with] = self.around(index);
        if self.total() > 0.0 { (with - before) / self.total() } else { 0.0 }
    }
}
