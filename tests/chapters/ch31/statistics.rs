//! Statistics of noise: moments at lattice points and between them, and the spectrum of octaves.

use groundtruth::noise::LatticeNoise;

use super::oracle::{self, built, linear};
use crate::prelude::*;

/// The mean of the values, and their variance.
fn moments(values: &[f64]) -> [f64; 2] {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    [mean, values.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / n]
}

/// Law: along any axis a row of 256 lattice points has each entry of the table once. Therefore mean and
/// variance there are those of the table, about 0 and 1/3. Oracle: the sorted table; the variance of a
/// uniform number, within five standard deviations of 256: √(1/3/256) and √((1/5 − 1/9)/256).
/// Book: lattice noise and its tables.
#[test]
fn a_row_of_lattice_points_has_each_entry_once() {
    let noise = built(Noise::default());
    let mut table = noise.lattice().values().to_vec();
    table.sort_by(f64::total_cmp);
    for axis in 0..3 {
        for start in [[0, 0, 0], [5, -200, 31], [-77, 13, 1000]] {
            let corner = Point::from(start.map(f64::from));
            let at = |i: i32| corner.with(axis, corner.along(axis) + f64::from(i));
            let mut row: Vec<f64> = (0..256).map(|i| noise.value(at(i))).collect();
            row.sort_by(f64::total_cmp);
            assert_eq!(row, table, "along axis {axis} from {start:?}");
        }
    }
    let [mean, variance] = moments(&table);
    assert!(mean.abs() < 0.18, "the mean is {mean}, expected 0");
    assert!((variance - 1.0 / 3.0).abs() < 0.094, "the variance is {variance}, expected 1/3");
}

/// Law: in the middle of cells the variance of noise is the table's times `(Σ w²)³` of the weights: 1/8 for
/// linear noise, (164/256)³ for cubic; the mean of linear noise is the table's. Oracle: sums of independent
/// knots, within 25 %, as some knots of a cell may be the same entry (simulated for linear noise: 0.86 to
/// 1.09 of the expected variance). The mean over whole periods is exact: weights add up to 1.
/// Book: linear and cubic interpolation.
#[test]
fn noise_varies_less_in_the_middle_of_cells() {
    for (noise, share) in [(linear(1), 0.125), (Noise::default(), oracle::power(164.0 / 256.0, 3))]
    {
        for seed in [253, 1, 2] {
            let noise = built(Noise { seed, ..noise });
            let middle = |i: i32| {
                let [x, y, z] = [i % 256, i / 256 % 16, i / 4096];
                noise.value(Point::new(f64::from(x) + 0.5, f64::from(y) + 0.5, f64::from(z) + 0.5))
            };
            let [mean, variance] = moments(&(0..256 * 16 * 16).map(middle).collect::<Vec<_>>());
            let [of_table, spread] = moments(noise.lattice().values());
            let ratio = variance / (share * spread);
            assert!((0.75..1.25).contains(&ratio), "{ratio} of the expected variance, seed {seed}");
            // clamps move the mean of cubic noise a little
            let off = (mean - of_table).abs();
            assert!(off < if share == 0.125 { 1e-13 } else { 3e-3 }, "mean {mean}, {of_table}");
        }
    }
}

/// Samples of a line over one period, which is a period of all octaves: eight for the shortest wave of a
/// band.
const SAMPLES: usize = 8192;
/// The longest wave of the first band is 1/8 of the period; each band begins at half the wavelength.
const LONGEST: usize = 8;
const BANDS: usize = 7;
/// The number of lines. A band has at least 8 waves on each line, thus 384 or more exponentially distributed
/// powers; their mean is known to 1/√384 = 5 %. Five standard deviations of the ratio of two such means are
/// 36 %.
const LINES: u32 = 48;
const POWER: f64 = 0.36;

/// The mean power of the sum of octaves in each band, along lines through the lattice. The lines run along z,
/// as all rows along x are shifted copies of one row.
fn spectrum(noise: &LatticeNoise, bound: f64, random: &mut Pcg32) -> Vec<f64> {
    let mut powers = vec![0.0; BANDS];
    for _ in 0..LINES {
        let [x, y] = [(); 2].map(|()| 256.0 * random.uniform());
        let sum = |i: usize| {
            let z = 256.0 * i as f64 / SAMPLES as f64;
            bound * (2.0 * noise.value_fbm(Point::new(x, y, z)) - 1.0)
        };
        let waves = fourier(&(0..SAMPLES).map(|i| [sum(i), 0.0]).collect::<Vec<_>>());
        for (band, power) in powers.iter_mut().enumerate() {
            let of_band = &waves[LONGEST << band..LONGEST << (band + 1)];
            *power += of_band.iter().map(|[re, im]| re * re + im * im).sum::<f64>();
        }
    }
    powers
}

/// The Fourier transform of a power of two of complex numbers (Cooley and Tukey).
fn fourier(values: &[[f64; 2]]) -> Vec<[f64; 2]> {
    if values.len() == 1 {
        return values.to_vec();
    }
    let every_second =
        |from: usize| values.iter().skip(from).step_by(2).copied().collect::<Vec<_>>();
    let [even, odd] = [0, 1].map(|from| fourier(&every_second(from)));
    let half = even.len();
    let wave = |k: usize| {
        let angle = -TAU * k as f64 / values.len() as f64;
        let (turn, [re, im]) = ([cos(angle), sin(angle)], odd[k % half]);
        let turned = [re * turn[0] - im * turn[1], re * turn[1] + im * turn[0]];
        [even[k % half][0] + turned[0], even[k % half][1] + turned[1]]
    };
    (0..values.len()).map(wave).collect()
}

/// Law: the power spectrum of fBm in octave bands is the sum of the spectra of its octaves: each is that of
/// single noise, shifted by one more octave and multiplied by gain² once more. So it falls by a factor of 4
/// from band to band with gain 1/2, and rises with gain 2. Oracle: that sum, from the spectrum of a single
/// octave.
#[test]
fn the_spectrum_falls_as_the_octaves_say() {
    const OCTAVES: usize = 4;
    let mut random = Pcg32::new(31, 2);
    let one = spectrum(&built(Noise::default()), 1.0, &mut random);
    for gain in [0.5, 0.8, 2.0] {
        let noise = built(Noise { gain, ..Noise::of_octaves(OCTAVES as u32) });
        let bound = oracle::bound(gain, OCTAVES as u32);
        let found = spectrum(&noise, bound, &mut random);
        for band in OCTAVES - 1..BANDS {
            let octave = |j: usize| oracle::power(gain * gain, j as u32) * one[band - j];
            let expected: f64 = (0..OCTAVES).map(octave).sum();
            let ratio = found[band] / expected;
            assert!(
                (1.0 - POWER..1.0 / (1.0 - POWER)).contains(&ratio),
                "gain {gain}, band {band}: {ratio} of the power expected"
            );
        }
    }
}
