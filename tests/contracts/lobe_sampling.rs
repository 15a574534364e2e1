//! Samples of lobes follow their densities.

use std::f64::consts::PI;

use groundtruth::lobes::Lobe;
use groundtruth::math::{Pcg32, Vector, acos, atan2, cos, sin};
use statistics::chi_square::goodness_of_fit;
use statistics::significance::sidak;

use super::lobe::viewers;
use super::{Holds, ensure};

/// The probability that any of the tests below raises a false alarm, for seeds chosen at random.
const LEVEL: f64 = 1e-3;
/// At least as many tests as there will be: seven viewers, and specimens of every lobe.
const TESTS: usize = 500;

/// Odd numbers of cells, so that no border of a cell coincides with one of a lobe.
const ROWS: usize = 15;
const COLUMNS: usize = 31;
/// Steps of the quadrature in each cell: the narrowest specimen is six steps wide.
const FINE_ROWS: usize = 64;
const FINE_COLUMNS: usize = 32;
/// The allowed error of the quadrature, as a share of the whole.
const QUADRATURE: f64 = 2e-3;

/// A density wrong by ±4 % in alternate cells is found (see [`chi_square`]).
const SAMPLES: u64 = 200_000;

/// Law: the directions of `sample` have the density `pdf`, and the rest up to 1 is the share of `None`.
/// Oracle: χ² against the midpoint rule on `pdf`, on a grid in θ and φ.
pub fn samples_follow_the_pdf(lobe: &Lobe) -> Holds {
    if lobe.is_specular() {
        return Ok(()); // a single direction
    }
    for (i, wo) in viewers().into_iter().enumerate() {
        let mut observed = vec![0_u64; ROWS * COLUMNS];
        let mut random = Pcg32::new(1, i as u64);
        for _ in 0..SAMPLES {
            let u = [random.uniform(), random.uniform()];
            if let Some(sample) = lobe.sample(wo, u) {
                observed[cell(sample.wi)] += 1;
            }
        }
        let share = observed.iter().sum::<u64>() as f64 / SAMPLES as f64;
        let mut expected = masses(lobe, wo);
        let whole: f64 = expected.iter().sum();
        // the noise of a share is below 1/√n
        let noise = 4.0 / (SAMPLES as f64).sqrt();
        let right = (share - whole).abs() <= QUADRATURE + noise && whole <= 1.0 + QUADRATURE;
        ensure!(right, "{wo:?}: pdf adds up to {whole}, {share} of the samples are directions");
        if whole == 0.0 {
            continue; // the lobe sends no light to this viewer
        }
        expected.iter_mut().for_each(|e| *e *= share * SAMPLES as f64 / whole);
        let p = goodness_of_fit(&observed, &expected);
        ensure!(p > sidak(LEVEL, TESTS), "{wo:?}: p = {p:e}");
    }
    Ok(())
}

fn cell(w: Vector) -> usize {
    let row = (acos(w.z().clamp(-1.0, 1.0)) / PI * ROWS as f64) as usize;
    let turn = atan2(w.y(), w.x()) / (2.0 * PI) + 0.5;
    let column = (turn * COLUMNS as f64) as usize;
    row.min(ROWS - 1) * COLUMNS + column.min(COLUMNS - 1)
}

/// The integral of the density over each cell.
fn masses(lobe: &Lobe, wo: Vector) -> Vec<f64> {
    let (rows, columns) = (ROWS * FINE_ROWS, COLUMNS * FINE_COLUMNS);
    let (d_theta, d_phi) = (PI / rows as f64, 2.0 * PI / columns as f64);
    let around: Vec<(f64, f64)> = (0..columns)
        .map(|j| (j as f64 + 0.5) * d_phi - PI)
        .map(|phi| (cos(phi), sin(phi)))
        .collect();
    let mut masses = vec![0.0; ROWS * COLUMNS];
    for i in 0..rows {
        let theta = (i as f64 + 0.5) * d_theta;
        let (sine, cosine) = (sin(theta), cos(theta));
        for (j, (x, y)) in around.iter().enumerate() {
            let wi = Vector::new(sine * x, sine * y, cosine);
            let mass = lobe.pdf(wo, wi) * sine * d_theta * d_phi;
            masses[i / FINE_ROWS * COLUMNS + j / FINE_COLUMNS] += mass;
        }
    }
    masses
}
