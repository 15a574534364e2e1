//! The signed differences of two pictures, and how they are shown.

use groundtruth::film::Film;
use groundtruth::rgb::Rgb;

use super::{Decoded, Picture, is_equal};
use statistics::quantile;

/// The colour of what is not a number.
pub const NOT_A_NUMBER: Rgb = Rgb::new(1.0, 0.0, 1.0);

/// The radiance of the second picture less that of the first, of each channel; 0 for values that count as equal.
#[derive(Clone, Debug)]
pub struct Differences {
    size: [u32; 2],
    values: Vec<[f64; 3]>,
    /// The finite magnitudes that are not 0.
    magnitudes: Vec<f64>,
}

impl Differences {
    /// Of two pictures of one size; channels within the relative `tolerance` are equal.
    pub fn of(a: &Picture, b: &Picture, tolerance: f64) -> Self {
        let [a, b] = [a, b].map(Decoded::new);
        let of_channel = |x: f32, y: f32, difference: f64| {
            if is_equal(&a, &b, (x, y), tolerance) { 0.0 } else { difference }
        };
        let of_pixel = |(x, y): (&[f32; 3], &[f32; 3])| {
            let [of_a, of_b] = [a.linear(*x), b.linear(*y)];
            [0, 1, 2].map(|i| of_channel(x[i], y[i], of_b[i] - of_a[i]))
        };
        let values: Vec<[f64; 3]> =
            a.picture.values.iter().zip(&b.picture.values).map(of_pixel).collect();
        let magnitudes = values.as_flattened().iter().map(|value| value.abs());
        let magnitudes = magnitudes.filter(|value| *value > 0.0 && value.is_finite()).collect();
        Self { size: a.picture.size, values, magnitudes }
    }

    /// The difference of a pixel.
    pub fn at(&self, [x, y]: [u32; 2]) -> [f64; 3] {
        self.values[y as usize * self.size[0] as usize + x as usize]
    }

    /// The differences of all pixels, row by row.
    pub fn values(&self) -> &[[f64; 3]] {
        &self.values
    }

    /// The magnitude that this share of all differences is within; 1 if there are none.
    pub fn within(&self, share: f64) -> f64 {
        quantile(&self.magnitudes, share).unwrap_or(1.0)
    }

    /// As a picture around a middle grey: a difference of `largest` is white, of `-largest` black.
    pub fn film(&self, largest: f64) -> Film {
        let mut film = Film::new(self.size[0], self.size[1]);
        for (index, value) in self.values.iter().enumerate() {
            let shown = Rgb::from(*value).map(|c| (0.5 + 0.5 * c / largest).clamp(0.0, 1.0));
            let is_number = value.iter().all(|channel| !channel.is_nan());
            let at = [index as u32 % self.size[0], index as u32 / self.size[0]];
            film.set(at, if is_number { shown } else { NOT_A_NUMBER });
        }
        film
    }
}
