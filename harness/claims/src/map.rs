//! A map from the unit square under questions: its points, their density, and the way back.

use ask::{Draw, Stop, number, numbers};
use groundtruth::math::Vector;
use serde_json::{Value, json};

use crate::asked::{Asked, BATCH, list, needed};
use crate::description::Claims;
use crate::domain::Domain;
use crate::laws::Integrated;

/// A case of a map: its parameters.
pub struct MapCase<'a> {
    /// What is asked.
    pub asked: Asked<'a>,
    /// What the map claims.
    pub claims: &'a Claims,
    /// What it covers.
    pub domain: Domain,
    /// The relative rounding of the program's numbers.
    pub rounding: f64,
    /// Of the points of this case.
    pub draw: Draw,
    /// Counts and integrals that several laws need.
    pub integrated: Option<Integrated>,
}

impl MapCase<'_> {
    /// The question for the points of these pairs.
    pub fn map_question(&self, u: &[[f64; 2]]) -> Value {
        self.asked.question("map", [("u", json!(u))])
    }

    /// The question for the density at these points, or for the way back.
    pub fn question_at(&self, name: &str, x: &[Vector]) -> Value {
        let coordinates = |x: &Vector| json!(x.to_array()[..self.domain.coordinates()]);
        self.asked.question(name, [("x", x.iter().map(coordinates).collect())])
    }

    /// The points of these pairs; the third coordinate is 0 in a plane.
    ///
    /// # Errors
    /// Says why there are none.
    pub fn map(&mut self, u: &[[f64; 2]]) -> Result<Vec<Vector>, Stop> {
        let questions: Vec<Value> = u.chunks(BATCH).map(|u| self.map_question(u)).collect();
        let count = self.domain.coordinates();
        let answers = self.asked.answers(&questions)?;
        let mut all = Vec::with_capacity(u.len());
        for (answer, u) in answers.iter().zip(u.chunks(BATCH)) {
            for x in list(answer, "the answer to `map`", u.len())? {
                let found = numbers(x).filter(|x| x.len() == count);
                let x = needed(found, "x", x)?;
                all.push(Vector::new(x[0], x[1], x.get(2).copied().unwrap_or(0.0)));
            }
        }
        Ok(all)
    }

    /// The densities at these points.
    ///
    /// # Errors
    /// Says why there are none.
    pub fn pdf(&mut self, x: &[Vector]) -> Result<Vec<f64>, Stop> {
        self.at("pdf", x, number)
    }

    /// The pairs of these points.
    ///
    /// # Errors
    /// Says why there are none.
    pub fn inverse(&mut self, x: &[Vector]) -> Result<Vec<[f64; 2]>, Stop> {
        self.at("inverse", x, |u| numbers(u)?.try_into().ok())
    }

    fn at<T>(
        &mut self,
        name: &str,
        x: &[Vector],
        read: impl Fn(&Value) -> Option<T>,
    ) -> Result<Vec<T>, Stop> {
        let questions: Vec<Value> = x.chunks(BATCH).map(|x| self.question_at(name, x)).collect();
        let answers = self.asked.answers(&questions)?;
        let mut all = Vec::with_capacity(x.len());
        for (answer, x) in answers.iter().zip(x.chunks(BATCH)) {
            for value in list(answer, &format!("the answer to `{name}`"), x.len())? {
                all.push(needed(read(value), name, value)?);
            }
        }
        Ok(all)
    }

    /// Pairs in the square, so far from its sides.
    pub fn pairs(&mut self, count: usize, margin: f64) -> Vec<[f64; 2]> {
        let mut one = || self.draw.between(margin, 1.0 - margin);
        (0..count).map(|_| [one(), one()]).collect()
    }
}
