//! How far pictures are from the truth: errors, noise and brightness.

use crate::film::Film;
use crate::rgb::Rgb;

/// How much of the picture's mean is added to a pixel's brightness where errors are relative, so that
/// black pixels count too.
const FLOOR: f64 = 0.1;

/// The mean of pictures of one size, pixel by pixel.
fn mean(films: &[Film]) -> Vec<Rgb> {
    let count = films.len() as f64;
    let pixels = films.first().map_or(0, |film| film.pixels().len());
    let of_pixel = |i: usize| films.iter().fold(Rgb::BLACK, |sum, film| sum + film.pixels()[i]);
    (0..pixels).map(|i| of_pixel(i) / count).collect()
}

/// The variance of each channel of each pixel from one picture to the next, as these replicas show it;
/// `None` for fewer than two.
fn variances(films: &[Film]) -> Option<Vec<Rgb>> {
    let freedom = films.len().checked_sub(1).filter(|freedom| *freedom > 0)? as f64;
    let of_pixel = |(i, mean): (usize, Rgb)| {
        let squares = films.iter().map(|film| squared(film.pixels()[i] + -1.0 * mean));
        squares.fold(Rgb::BLACK, |sum, square| sum + square) / freedom
    };
    Some(mean(films).into_iter().enumerate().map(of_pixel).collect())
}

fn squared(color: Rgb) -> Rgb {
    color * color
}

/// The mean of all channels of all pixels.
pub fn brightness(film: &Film) -> f64 {
    film.pixels().iter().map(|pixel| pixel.average()).sum::<f64>() / film.pixels().len() as f64
}

/// What errors are measured against: the mean of replicas.
pub struct Reference {
    /// The picture.
    pub film: Film,
    /// The mean of all its channels.
    pub mean: f64,
    /// The square of its own standard error, radiance and relative, in the mean over the picture.
    own: Squares,
    /// What squared errors of a pixel are multiplied by, to be relative.
    weights: Vec<f64>,
}

/// A mean of squares over channels and pixels, of radiance and relative to each pixel's own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Squares {
    /// Of radiance.
    pub radiance: f64,
    /// Each pixel's square over that of its brightness in the reference and a tenth of the picture's.
    pub relative: f64,
}

impl Reference {
    /// From two replicas or more.
    ///
    /// # Panics
    /// With fewer than two.
    pub fn new(films: &[Film]) -> Self {
        let variances = variances(films).expect("two replicas or more");
        let mut film = films[0].clone();
        for (i, pixel) in (0..).zip(mean(films)) {
            film.set([i % film.width(), i / film.width()], pixel);
        }
        let mean = brightness(&film);
        let floor = FLOOR * mean;
        let weight = |pixel: &Rgb| {
            let brightness = pixel.average();
            1.0 / (brightness * brightness + floor * floor)
        };
        let weights = film.pixels().iter().map(weight).collect();
        let none = Squares { radiance: 0.0, relative: 0.0 };
        let mut reference = Self { film, mean, own: none, weights };
        let of_mean: Vec<Rgb> = variances.iter().map(|v| *v / films.len() as f64).collect();
        reference.own = reference.averaged(&of_mean);
        reference
    }

    fn averaged(&self, squares: &[Rgb]) -> Squares {
        let count = squares.len() as f64;
        let weighted = squares.iter().zip(&self.weights).map(|(s, w)| w * s.average());
        Squares {
            radiance: squares.iter().map(|s| s.average()).sum::<f64>() / count,
            relative: weighted.sum::<f64>() / count,
        }
    }

    /// Its own standard error.
    pub fn own_error(&self) -> Squares {
        Squares { radiance: self.own.radiance.sqrt(), relative: self.own.relative.sqrt() }
    }

    /// The mean squared error of pictures, that of the reference taken off. `None` where what is left is
    /// smaller than that: it cannot be told.
    pub fn squared_error(&self, films: &[Film]) -> [Option<f64>; 2] {
        let of_film = |film: &Film| {
            let differences = film.pixels().iter().zip(self.film.pixels());
            let squares: Vec<Rgb> = differences.map(|(a, b)| squared(*a + -1.0 * *b)).collect();
            self.averaged(&squares)
        };
        let all: Vec<Squares> = films.iter().map(of_film).collect();
        let left = |of: fn(&Squares) -> f64| {
            let square = all.iter().map(of).sum::<f64>() / all.len() as f64 - of(&self.own);
            (square >= of(&self.own)).then_some(square)
        };
        [left(|s| s.radiance), left(|s| s.relative)]
    }

    /// The variance of one picture, relative, as replicas show it; `None` for fewer than two.
    pub fn relative_variance(&self, films: &[Film]) -> Option<f64> {
        Some(self.averaged(&variances(films)?).relative)
    }
}
