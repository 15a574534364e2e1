//! Reference pictures: the error, variance and mean brightness of others.

use groundtruth::film::Film;
use groundtruth::rgb::Rgb;

/// The fraction of the picture's mean that is added (in squares) to a pixel's brightness for
/// relative errors, because black pixels have the brightness 0.
const FLOOR: f64 = 0.1;

fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len() as f64;
    values.sum::<f64>() / count
}

/// The mean of pictures of one size, pixel by pixel.
fn mean_pixels(films: &[Film]) -> Vec<Rgb> {
    let count = films.len() as f64;
    let of_pixel = |i: usize| films.iter().fold(Rgb::BLACK, |sum, film| sum + film.pixels()[i]);
    (0..films[0].pixels().len()).map(|i| of_pixel(i) / count).collect()
}

/// The variance of each channel of each pixel between these replicas; `None` for fewer than two.
fn variances(films: &[Film]) -> Option<Vec<Rgb>> {
    let degrees_of_freedom = films.len().checked_sub(1).filter(|count| *count > 0)? as f64;
    let of_pixel = |(i, mean): (usize, Rgb)| {
        let squares = films.iter().map(|film| squared(film.pixels()[i] + -1.0 * mean));
        squares.fold(Rgb::BLACK, |sum, square| sum + square) / degrees_of_freedom
    };
    Some(mean_pixels(films).into_iter().enumerate().map(of_pixel).collect())
}

fn squared(color: Rgb) -> Rgb {
    color * color
}

/// The mean of all channels of all pixels.
pub fn brightness(film: &Film) -> f64 {
    mean(film.pixels().iter().map(|pixel| pixel.average()))
}

/// That of each picture.
pub fn brightnesses(films: &[Film]) -> Vec<f64> {
    films.iter().map(brightness).collect()
}

/// The reference for errors: the mean of replicas.
pub struct Reference {
    /// The picture.
    pub film: Film,
    /// The mean of all its channels.
    pub mean: f64,
    /// The mean of all channels of each replica.
    pub brightnesses: Vec<f64>,
    /// The mean square of its own standard error, absolute and relative; 0 for a single replica,
    /// whose error is not known.
    own: [f64; 2],
    /// For each pixel the factor that makes squared errors relative: one over `brightness² +
    /// (FLOOR · mean)²`.
    weights: Vec<f64>,
}

/// The means of squares, one for each pixel, over pixels and channels: absolute and relative.
fn mean_squares(squares: &[Rgb], weights: &[f64]) -> [f64; 2] {
    let relative = squares.iter().zip(weights).map(|(square, weight)| weight * square.average());
    [mean(squares.iter().map(|square| square.average())), mean(relative)]
}

impl Reference {
    /// The mean of these replicas.
    ///
    /// # Panics
    /// Without any.
    pub fn new(films: &[Film]) -> Self {
        let mut film = films[0].clone();
        for (i, pixel) in (0..).zip(mean_pixels(films)) {
            film.set([i % film.width(), i / film.width()], pixel);
        }
        let mean = brightness(&film);
        let floor = FLOOR * mean;
        let weight = |pixel: &Rgb| {
            let brightness = pixel.average();
            1.0 / (brightness * brightness + floor * floor)
        };
        let weights: Vec<f64> = film.pixels().iter().map(weight).collect();
        let own = variances(films).map_or([0.0; 2], |variances| {
            let of_mean: Vec<Rgb> = variances.iter().map(|v| *v / films.len() as f64).collect();
            mean_squares(&of_mean, &weights)
        });
        Self { film, mean, brightnesses: brightnesses(films), own, weights }
    }

    /// The standard error of the reference, absolute and relative.
    pub fn own_error(&self) -> [f64; 2] {
        self.own.map(f64::sqrt)
    }

    /// The mean squared difference of a picture, absolute and relative.
    fn squared_difference(&self, film: &Film) -> [f64; 2] {
        let pixels = film.pixels().iter().zip(self.film.pixels());
        let squares: Vec<Rgb> = pixels.map(|(a, b)| squared(*a + -1.0 * *b)).collect();
        mean_squares(&squares, &self.weights)
    }

    /// The mean squared error, absolute and relative, of pictures minus that of their references;
    /// `None` if the difference is smaller than that of the references, and so not significant.
    /// There is a reference for each frame; the pictures are all replicas of the first frame, then
    /// those of the next one.
    pub fn squared_error(references: &[Self], films: &[Film]) -> [Option<f64>; 2] {
        let all: Vec<[f64; 2]> = by_frame(references, films)
            .flat_map(|(frame, films)| films.iter().map(|film| frame.squared_difference(film)))
            .collect();
        [0, 1].map(|i: usize| {
            let own = mean(references.iter().map(|frame| frame.own[i]));
            let square = mean(all.iter().map(|squares| squares[i])) - own;
            (square >= own).then_some(square)
        })
    }

    /// The relative variance of one picture, estimated from the replicas of each frame; `None` for
    /// fewer than two.
    pub fn relative_variance(references: &[Self], films: &[Film]) -> Option<f64> {
        let of_frame = |(frame, films): (&Self, &[Film])| {
            Some(mean_squares(&variances(films)?, &frame.weights)[1])
        };
        let frames: Option<Vec<f64>> = by_frame(references, films).map(of_frame).collect();
        Some(mean(frames?.into_iter()))
    }
}

/// Each reference with its pictures.
fn by_frame<'a>(
    references: &'a [Reference],
    films: &'a [Film],
) -> impl Iterator<Item = (&'a Reference, &'a [Film])> {
    references.iter().zip(films.chunks(films.len() / references.len()))
}
