//! The printed noise, and wood that is made of it.

use groundtruth::kinds::Resources;
use groundtruth::math::{Normal, Pcg32, Point, power};
use groundtruth::noise::{Interpolation, Noise};
use groundtruth::shapes::Surface;
use groundtruth::textures::{Kind, TexturePoint, Wood};

use super::formulas::{assert_says, line_of};
use super::numbers;
use super::truth::{V, add, largest_difference, times};

/// The list of numbers after these words.
fn list(text: &str, words: &str) -> Vec<f64> {
    let (_, rest) = text.split_once(words).unwrap_or_else(|| panic!("no {words:?}"));
    numbers(rest.split_once(']').expect("it ends").0)
}

/// The noise of a description: its tables, and its formulas written out here.
struct Printed {
    permutation: Vec<f64>,
    /// One number for each index, or one component of the vectors.
    values: Vec<f64>,
}

impl Printed {
    fn value(&self, at: [i64; 3]) -> f64 {
        let p = |i: i64| self.permutation[i.rem_euclid(256) as usize] as i64;
        self.values[p(at[0] + p(at[1] + p(at[2]))) as usize]
    }

    /// fBm, not scaled to a range.
    fn sum(&self, p: V, octaves: i32, gain: f64, lacunarity: f64) -> f64 {
        let octave =
            |j: i32| self.octave(times(power(lacunarity, f64::from(j)), p), Interpolation::Cubic);
        (0..octaves).map(|j| power(gain, f64::from(j)) * octave(j)).sum()
    }

    fn octave(&self, p: V, interpolation: Interpolation) -> f64 {
        let cell = p.map(f64::floor);
        let x = [0, 1, 2].map(|i| p[i] - cell[i]);
        let at = |i: i64, j: i64, k: i64| {
            self.value([cell[0] as i64 + i, cell[1] as i64 + j, cell[2] as i64 + k])
        };
        if interpolation == Interpolation::Linear {
            let weight = |i: i64, x: f64| if i == 0 { 1.0 - x } else { x };
            let corners = (0..8).map(|n| [n & 1, n >> 1 & 1, n >> 2]);
            return corners
                .map(|[i, j, k]| weight(i, x[0]) * weight(j, x[1]) * weight(k, x[2]) * at(i, j, k))
                .sum();
        }
        let spline = |x: f64, k: [f64; 4]| {
            let c3 = (-k[0] + 3.0 * k[1] - 3.0 * k[2] + k[3]) / 2.0;
            let c2 = k[0] - 2.5 * k[1] + 2.0 * k[2] - k[3] / 2.0;
            x * (x * (x * c3 + c2) + (k[2] - k[0]) / 2.0) + k[1]
        };
        const PLANES: [i64; 4] = [-1, 0, 1, 2];
        let row = |j, k| spline(x[0], PLANES.map(|i| at(i, j, k)));
        let slice = |k| spline(x[1], PLANES.map(|j| row(j, k)));
        spline(x[2], PLANES.map(slice)).clamp(-1.0, 1.0)
    }
}

/// Law: the printed tables in the printed formulas are the noise of the textures. Oracle: the formulas,
/// written out here.
#[test]
fn the_printed_noise_is_that_of_the_textures() {
    let text = line_of("ch31/fbm");
    for formula in [
        "P[(ix + P[(iy + P[iz mod 256]) mod 256]) mod 256]",
        "x (x (x c3 + c2) + c1) + c0 with c3 = (-k0 + 3 k1 - 3 k2 + k3)/2, c2 = k0 - 5/2 k1 + 2 k2 - k3/2, c1 = (k2 \
         - k0)/2 and c0 = k1",
        "fBm(p) is (S + M)/(2 M) with S = Σ gain^j noise(lacunarity^j p) and M = Σ gain^j",
        "Turbulence is Σ |noise(2^j p)|/2^j divided by Σ 1/2^j",
    ] {
        assert_says(&text, formula);
    }
    let printed = Printed {
        permutation: list(&text, "P = ["),
        values: list(&text, "The numbers of seed 253: ["),
    };
    assert_eq!([printed.permutation.len(), printed.values.len()], [256, 256]);
    let mut random = Pcg32::new(31, 0);
    for interpolation in [Interpolation::Linear, Interpolation::Cubic] {
        let (gain, lacunarity) = (0.75, 3.0);
        let noise = Noise { interpolation, octaves: 3, gain, lacunarity, seed: 253 };
        let noise = noise.build().expect("it is valid");
        for _ in 0..100 {
            let p = [0; 3].map(|_| 40.0 * random.uniform() - 20.0);
            let octave = |j: i32, factor: f64| {
                printed.octave(times(power(factor, f64::from(j)), p), interpolation)
            };
            let sum: f64 = (0..3).map(|j| power(gain, f64::from(j)) * octave(j, lacunarity)).sum();
            let most: f64 = (0..3).map(|j| power(gain, f64::from(j))).sum();
            let found = noise.value_fbm(Point::from(p));
            assert!((found - (sum + most) / (2.0 * most)).abs() < 1e-12, "fBm({p:?}) = {found}");
            let sum: f64 = (0..3).map(|j| octave(j, 2.0).abs() / power(2.0, f64::from(j))).sum();
            let found = noise.value_turbulence(Point::from(p));
            assert!((found - sum / 1.75).abs() < 1e-12, "turbulence({p:?}) = {found}");
        }
    }
}

/// The tables of the vectors' components.
fn vectors(text: &str, permutation: &[f64]) -> [Printed; 3] {
    let (_, rest) = text.split_once("The vectors of seed 253: ").expect("they are printed");
    let all = numbers(rest.split_once("]]").expect("they end").0);
    assert_eq!(all.len(), 3 * 256);
    [0, 1, 2].map(|axis| Printed {
        permutation: permutation.to_vec(),
        values: all.iter().skip(axis).step_by(3).copied().collect(),
    })
}

fn smooth(a: f64, b: f64, x: f64) -> f64 {
    let y = ((x - a) / (b - a)).clamp(0.0, 1.0);
    y * y * (3.0 - 2.0 * y)
}

/// Law: the printed formula of wood, with the printed noise, is that of the texture. Oracle: the formula,
/// written out here.
#[test]
fn the_printed_wood_is_that_of_the_texture() {
    let text = line_of("ch31/wooden-cube");
    for formula in [
        "q = p + ring_noise · fBm vector(ring_noise_frequency p); w = trunk_wobble · noise vector(0, 0, \
         trunk_wobble_frequency q_y); (x, y, z) = q + (w_x, 0, w_z)",
        "r = ring_frequency √(x² + z²); r += angular_wobble · smooth(0, 5, r) · noise(angular_wobble_frequency (x, \
         y/10, z)); r += ring_unevenness · noise(r, r, r); s = r - ⌊r⌋; ring = smooth(0.1, 0.55, s) - smooth(0.7, \
         0.95, s)",
        "valid = 1 - smooth(0.2, 0.6, ω), h = valid · noise(g) (0.3 + 0.7 k), and the amount grainy · smooth(0.5, 1, \
         c²) with c = 0.8 - h clamped to 0 … 1",
        "dark share = grain + (1 - grain) ringy · ring",
    ] {
        assert_says(&text, formula);
    }
    let permutation = list(&text, "P = [");
    let [vx, vy, vz] = vectors(&text, &permutation);
    let noise = Printed { permutation, values: list(&text, "The numbers of seed 253: [") };
    let wood = Wood { size: 0.5, ..Wood::default() };
    let Noise { octaves, gain, lacunarity, seed, .. } = wood.noise;
    assert_eq!(seed, 253);
    let (light, dark) = ([0.85, 0.55, 0.28], [0.3, 0.12, 0.04]);
    let built = Kind::from(wood.clone()).build(&mut Resources::default()).expect("it is valid");
    let mut random = Pcg32::new(31, 1);
    for _ in 0..200 {
        let local = [0; 3].map(|_| 8.0 * random.uniform() - 4.0);
        let p = times(1.0 / wood.size, local);
        let at = times(wood.ring_noise_frequency, p);
        let moved = [&vx, &vy, &vz].map(|of| of.sum(at, octaves as i32, gain, lacunarity));
        let q = add(p, times(wood.ring_noise, moved));
        let along = [0.0, 0.0, wood.trunk_wobble_frequency * q[1]];
        let [wx, wz] =
            [&vx, &vz].map(|of| wood.trunk_wobble * of.octave(along, Interpolation::Cubic));
        let [x, y, z] = add(q, [wx, 0.0, wz]);
        let value = |p: V| noise.octave(p, Interpolation::Cubic);
        let mut r = wood.ring_frequency * (x * x + z * z).sqrt();
        let around = times(wood.angular_wobble_frequency, [x, y / 10.0, z]);
        r += wood.angular_wobble * smooth(0.0, 5.0, r) * value(around);
        r += wood.ring_unevenness * value([r; 3]);
        let s = r - r.floor();
        let ring = smooth(0.1, 0.55, s) - smooth(0.7, 0.95, s);
        let octave = |width: f64, g: V, k: f64| {
            let valid = 1.0 - smooth(0.2, 0.6, width);
            let c = (0.8 - valid * value(g) * (0.3 + 0.7 * k)).clamp(0.0, 1.0);
            (valid, wood.grainy * smooth(0.5, 1.0, c * c))
        };
        let g = times(wood.grain_frequency, [x, y / 20.0, z]);
        let (valid, coarse) = octave(0.2, g, ring);
        let ring = ring * (1.0 - 0.4 * valid);
        let (_, fine) = octave(0.4, times(2.0, g), ring);
        let grain = coarse.max(fine) / 2.0;
        let share = grain + (1.0 - grain) * wood.ringy * ring;
        let expected = add(times(1.0 - share, light), times(share, dark));
        let surface = Surface::flat(Point::from(local), Point::from(local), Normal::Y);
        let found = built.color(&TexturePoint::new(&surface)).to_array();
        // a point's noise is steep: at 25 grains a unit, rounding grows a hundredfold
        assert!(largest_difference(found, expected) < 1e-11, "{local:?}: {found:?}, {expected:?}");
    }
}
