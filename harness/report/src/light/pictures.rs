//! The error, variance and mean brightness of pictures.

use groundtruth::film::Film;
use groundtruth::rgb::Rgb;

/// The fraction of the picture's mean that is added (in squares) to a pixel's brightness for
/// relative errors, because black pixels have the brightness 0.
const FLOOR: f64 = 0.1;

/// The mean of pictures of one size, pixel by pixel.
fn mean(films: &[Film]) -> Vec<Rgb> {
    let count = films.len() as f64;
    let pixels = films.first().map_or(0, |film| film.pixels().len());
    let of_pixel = |i: usize| films.iter().fold(Rgb::BLACK, |sum, film| sum + film.pixels()[i]);
    (0..pixels).map(|i| of_pixel(i) / count).collect()
}

/// The variance of each channel of each pixel between these replicas; `None` for fewer than two.
fn variances(films: &[Film]) -> Option<Vec<Rgb>> {
    let degrees_of_freedom = films.len().checked_sub(1).filter(|count| *count > 0)? as f64;
    let of_pixel = |(i, mean): (usize, Rgb)| {
        let squares = films.iter().map(|film| squared(film.pixels()[i] + -1.0 * mean));
        squares.fold(Rgb::BLACK, |sum, square| sum + square) / degrees_of_freedom
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

/// The reference for errors: the mean of replicas.
pub struct Reference {
    /// The picture.
    pub film: Film,
    /// The mean of all its channels.
    pub mean: f64,
    /// The mean of all channels of each replica.
    pub brightnesses: Vec<f64>,
    /// The mean square of its own standard error, absolute and relative.
    own: Squares,
    /// For each pixel the factor that makes squared errors relative.
    weights: Vec<f64>,
}

/// A mean of squares over channels and pixels, absolute and relative to the brightness of each
/// pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Squares {
    /// The mean of the squares of radiance.
    pub radiance: f64,
    /// The mean of the squares relative to `brightness² + (FLOOR · mean)²` of the reference.
    pub relative: f64,
}

impl Squares {
    /// The means of these squares, one for each pixel.
    fn mean(squares: &[Rgb], weights: &[f64]) -> Self {
        let count = squares.len() as f64;
        let weighted = squares.iter().zip(weights).map(|(s, w)| w * s.average());
        Self {
            radiance: squares.iter().map(|s| s.average()).sum::<f64>() / count,
            relative: weighted.sum::<f64>() / count,
        }
    }
}

impl Reference {
    /// The mean of these replicas.
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
        let weights: Vec<f64> = film.pixels().iter().map(weight).collect();
        let of_mean: Vec<Rgb> = variances.iter().map(|v| *v / films.len() as f64).collect();
        let own = Squares::mean(&of_mean, &weights);
        let brightnesses = films.iter().map(brightness).collect();
        Self { film, mean, brightnesses, own, weights }
    }

    /// The standard error of the reference.
    pub fn own_error(&self) -> Squares {
        Squares { radiance: self.own.radiance.sqrt(), relative: self.own.relative.sqrt() }
    }

    /// The mean squared error of pictures minus that of the reference; `None` if the difference is
    /// smaller than that of the reference, and so not significant.
    pub fn squared_error(&self, films: &[Film]) -> [Option<f64>; 2] {
        let of_film = |film: &Film| {
            let differences = film.pixels().iter().zip(self.film.pixels());
            let squares: Vec<Rgb> = differences.map(|(a, b)| squared(*a + -1.0 * *b)).collect();
            Squares::mean(&squares, &self.weights)
        };
        let all: Vec<Squares> = films.iter().map(of_film).collect();
        let left = |of: fn(&Squares) -> f64| {
            let square = all.iter().map(of).sum::<f64>() / all.len() as f64 - of(&self.own);
            (square >= of(&self.own)).then_some(square)
        };
        [left(|s| s.radiance), left(|s| s.relative)]
    }

    /// The relative variance of one picture, estimated from replicas; `None` for fewer than two.
    pub fn relative_variance(&self, films: &[Film]) -> Option<f64> {
        Some(Squares::mean(&variances(films)?, &self.weights).relative)
    }
}
