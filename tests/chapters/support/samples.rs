//! Points of the unit square: samplers, strata, and whether points are uniform.

use groundtruth::math::floor;
use groundtruth::samplers::{Kind, Sampler};
use statistics::{chi_square, ks};

use crate::prelude::*;

/// The probability of a false alarm for each statistical law that uses this level.
pub const LEVEL: f64 = 1e-3;

pub fn built(kind: impl Into<Kind>) -> Arc<dyn Sampler> {
    kind.into().build(&mut ()).expect("a valid sampler")
}

/// How many points fall into each of `columns × rows` cells.
pub fn occupied(points: &[[f64; 2]], columns: u32, rows: u32) -> Vec<u32> {
    let mut cells = vec![0; (columns * rows) as usize];
    for [x, y] in points {
        let (i, j) = ((x * f64::from(columns)) as u32, (y * f64::from(rows)) as u32);
        cells[(j * columns + i) as usize] += 1;
    }
    cells
}

/// Fails unless each of `columns × rows` cells has exactly one of the points.
pub fn assert_once_each(what: &str, points: &[[f64; 2]], columns: u32, rows: u32) {
    let cells = (0..).zip(occupied(points, columns, rows));
    let wrong: Vec<(u32, u32)> = cells.filter(|(_, count)| *count != 1).collect();
    assert!(
        wrong.is_empty(),
        "{what}: each of {columns} × {rows} cells has one of {} points, but these (cell, points) do \
         not: {wrong:?}",
        points.len()
    );
}

/// Independent uniform points of the unit square.
pub fn random_points(count: u32, seed: u64) -> Vec<[f64; 2]> {
    let mut random = Pcg32::new(seed, 6);
    (0..count).map(|_| [random.uniform(), random.uniform()]).collect()
}

/// Fails unless independent points are uniform over the unit square: each coordinate by the
/// Kolmogorov–Smirnov test, both together by χ² over 7 × 11 cells; as one of `families` such tests.
pub fn assert_uniform(what: &str, points: &[[f64; 2]], families: usize) {
    let level = sidak(LEVEL, 3 * families);
    let along = |axis: usize| ks::uniform(&points.iter().map(|p| p[axis]).collect::<Vec<_>>());
    let mut cells = [0; 77];
    for [x, y] in points {
        cells[(floor(7.0 * x) + 7.0 * floor(11.0 * y)) as usize] += 1;
    }
    let both = chi_square::goodness_of_fit(&cells, &[points.len() as f64 / 77.0; 77]);
    let [x, y] = [0, 1].map(along);
    assert!(
        x > level && y > level && both > level,
        "{what}: {} points are uniform with the probabilities {x:e} along x, {y:e} along y and \
         {both:e} over cells, expected more than {level:e} of each",
        points.len()
    );
}
