//! Pictures of one scene from different seeds, and each of them held against all others.

use rayon::prelude::*;

use super::residuals::mean_of;
use super::{Mean, Stored};

/// Pictures of one size, as their stored values. Which of them is judged makes no difference to what is done with any.
#[derive(Clone, Debug)]
pub struct Pool {
    /// Columns and rows.
    pub size: [usize; 2],
    /// How their values are stored.
    pub stored: Stored,
    pictures: Vec<Vec<f32>>,
    /// For each value, the mean over all pictures.
    mean: Vec<f64>,
    /// For each value, the sum of the squares of the differences from the mean.
    squares: Vec<f64>,
    agreement: Vec<Agreement>,
    /// What all pictures are held against, instead of the mean of the others.
    pub reference: Option<Mean>,
}

/// Which pictures have the same value.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Agreement {
    All,
    /// All but this one, which all others agree against.
    AllBut(u32),
    Few,
    /// Some value is no number: it is left out everywhere.
    NotFinite,
}

/// A value of a picture against those of all others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Against {
    /// The others differ among each other.
    Varied {
        /// The value less their mean.
        difference: f64,
        /// Their variance.
        variance: f64,
    },
    /// All others have the same value, and this one too.
    Same,
    /// All others have the same value, and this one another.
    Outlier,
    /// Left out.
    Nothing,
}

impl Pool {
    /// The pool of these pictures, at least three: each has three values a pixel.
    pub fn new(size: [usize; 2], stored: Stored, pictures: Vec<Vec<f32>>) -> Self {
        assert!(pictures.len() >= 3, "a variance of others needs two");
        let values = 3 * size[0] * size[1];
        let (mean, mut squares) = (mean_of(&pictures), vec![0.0; values]);
        for picture in &pictures {
            assert_eq!(picture.len(), values, "pictures of one size");
            let values = squares.iter_mut().zip(&mean).zip(picture);
            values.for_each(|((sum, mean), x)| {
                *sum += (f64::from(*x) - mean) * (f64::from(*x) - mean)
            });
        }
        let agreement =
            (0..values).into_par_iter().map(|i| agreement(&pictures, i, stored)).collect();
        Self { size, stored, pictures, mean, squares, agreement, reference: None }
    }

    /// Holds each picture against this mean of others, if there is one.
    #[must_use]
    pub fn against_mean(self, reference: Option<Mean>) -> Self {
        Self { reference, ..self }
    }

    /// The variance of the mean that a picture is held against, in units of that of one picture.
    pub fn variance_of_mean(&self) -> f64 {
        1.0 / self.reference.as_ref().map_or(self.count() as f64 - 1.0, |mean| mean.pictures)
    }

    /// The number of pictures.
    pub fn count(&self) -> usize {
        self.pictures.len()
    }

    /// The stored values of a picture.
    pub fn picture(&self, index: usize) -> &[f32] {
        &self.pictures[index]
    }

    /// A value of a picture, by its index, against those of all others.
    pub fn against(&self, picture: usize, index: usize) -> Against {
        match self.agreement[index] {
            Agreement::NotFinite => Against::Nothing,
            Agreement::All => Against::Same,
            Agreement::AllBut(other) if other as usize == picture => Against::Outlier,
            Agreement::AllBut(_) | Agreement::Few => {
                let n = self.count() as f64;
                let value = f64::from(self.pictures[picture][index]);
                let own = value - self.mean[index];
                // without the picture itself: of the mean, and of the sum of squares
                let difference = own * n / (n - 1.0);
                let squares = (self.squares[index] - own * difference).max(0.0);
                let held = self.reference.as_ref().map(|mean| value - mean.values[index]);
                let difference = held.unwrap_or(difference);
                Against::Varied { difference, variance: squares / (n - 2.0) }
            }
        }
    }

    /// The mean of all other pictures at a value, or that of the reference.
    pub fn mean_of_others(&self, picture: usize, index: usize) -> f64 {
        if let Some(mean) = &self.reference {
            return mean.values[index];
        }
        let n = self.count() as f64;
        let own = f64::from(self.pictures[picture][index]);
        self.mean[index] - (own - self.mean[index]) / (n - 1.0)
    }

    /// Whether no value differs between any two pictures but for one picture.
    pub fn is_fixed_but_for(&self, picture: usize) -> bool {
        let is_fixed = |it: &Agreement| match it {
            Agreement::All | Agreement::NotFinite => true,
            Agreement::AllBut(other) => *other as usize == picture,
            Agreement::Few => false,
        };
        self.agreement.iter().all(is_fixed)
    }
}

fn agreement(pictures: &[Vec<f32>], index: usize, stored: Stored) -> Agreement {
    let values = || pictures.iter().map(|picture| f64::from(picture[index]));
    if values().any(|value| !value.is_finite()) {
        return Agreement::NotFinite;
    }
    // one of the first three has the value of nearly all, if nearly all have one
    let [a, b, c] = [0, 1, 2].map(|i| f64::from(pictures[i][index]));
    let of_a = stored.tolerance(a);
    let is_a = (a - b).abs() <= of_a || (a - c).abs() <= of_a;
    let (common, tolerance) = if is_a { (a, of_a) } else { (b, stored.tolerance(b)) };
    let is_same = |value: f64| (common - value).abs() <= tolerance;
    let mut others = (0..).zip(values()).filter(|(_, value)| !is_same(*value));
    match (others.next(), others.next()) {
        (None, _) => Agreement::All,
        (Some((only, _)), None) => Agreement::AllBut(only),
        _ => Agreement::Few,
    }
}
