//! How much of each term of ours a picture holds: the fewest factors that explain it.

use std::f64::consts::PI;

use serde::Serialize;

use super::causes::finite;
use super::evidence::Evidence;
use super::linear::{Equations, product};
use super::share::Share;
use super::terms::TermFilm;

/// How much of a term a picture holds.
#[derive(Clone, Debug, Serialize)]
pub struct TermFactor {
    /// The term; several if the picture cannot tell them apart.
    pub terms: Vec<String>,
    /// How many times ours it holds.
    pub factor: f64,
    /// The standard deviation of the factor.
    pub error: f64,
    /// The part of our picture that the term is.
    pub share: f64,
}

/// The factors of terms that explain a picture; those that are left out are 1.
#[derive(Clone, Debug, Serialize)]
pub struct Factors {
    /// The factors, the one that explains most first.
    pub factors: Vec<TermFactor>,
    /// The part of the squared difference that they explain, weighted by the noise.
    pub share: f64,
}

/// Factors that mean something, but for 0.
const KNOWN: [(f64, &str); 4] = [(0.5, "1/2"), (2.0, "2"), (PI, "π"), (1.0 / PI, "1/π")];

/// A factor is named if its error is at most this part of what it is called: of a larger one it may be equal by chance.
const CERTAIN: f64 = 0.003;

/// A term is left out if its factor is at most this, or is 0 within an error of at most so much.
const NOTHING: [f64; 2] = [0.02, 0.1];

impl TermFactor {
    /// What the factor is, if it is known and certain enough.
    pub fn meaning(&self) -> Option<&'static str> {
        let [none, uncertain] = NOTHING;
        let from_zero = self.factor.abs();
        let is_within = from_zero <= 3.0 * self.error && self.error <= uncertain;
        if is_within || from_zero <= none && self.error <= none {
            return Some("left out");
        }
        let is_it = |value: &f64| {
            let apart = (self.factor - value).abs();
            apart <= 3.0 * self.error && self.error <= CERTAIN * value
        };
        KNOWN.iter().find(|(value, _)| is_it(value)).map(|(_, name)| *name)
    }

    /// Whether it is far from 1, for its error.
    pub fn is_off(&self) -> bool {
        (self.factor - 1.0).abs() > (5.0 * self.error).max(0.01)
    }
}

impl Factors {
    /// Whether these are fewer, or as many and leave less than half as much.
    fn is_better(&self, other: &Self) -> bool {
        let ([own, its], [left, rest]) =
            ([self, other].map(|it| it.factors.len()), [self, other].map(|it| 1.0 - it.share));
        own < its || own == its && left < 0.5 * rest
    }
}

/// Two terms whose pictures are so alike cannot be told apart: the cosine of their angle.
const ALIKE: f64 = 0.98;

/// Terms below this part of the picture are not fitted.
const SMALLEST: f64 = 1e-4;

/// A picture is explained by factors if they leave at most this part of the squared difference.
const LEFT: f64 = 0.2;

/// More factors explain nothing to a reader.
const MOST: usize = 4;

/// Few factors are enough if they explain this part of what all explain.
const ENOUGH: f64 = 0.999;

/// A column of the fit: names of terms that cannot be told apart, and their tiles.
type Column = (Vec<String>, Vec<f64>);

/// The fewest factors of terms that explain a picture, by weighted least squares over tiles: one for each source and
/// lobe, or for each source. If neither explains it, one for each channel of a source; else for all light of a depth; else
/// for each term. `None` if no few factors explain it.
pub fn factors(terms: &[TermFilm], evidence: &Evidence<'_>) -> Option<Factors> {
    let tiles_of = |term: &TermFilm| {
        let values: Vec<f64> =
            term.film.pixels().iter().flat_map(|color| color.to_array()).collect();
        evidence.tiles(|at| values[at])
    };
    let tiles: Vec<Vec<f64>> = terms.iter().map(tiles_of).collect();
    let fit = |name: &dyn Fn(&TermFilm) -> String| {
        fitted(columns(terms.iter().map(name).zip(&tiles), evidence), evidence)
    };
    let by_lobe = fit(&|term| term.name.clone());
    let by_source = fit(&|term| term.source.clone());
    match (by_lobe, by_source) {
        (Some(lobe), Some(source)) if source.is_better(&lobe) => return Some(source),
        (Some(found), _) | (None, Some(found)) => return Some(found),
        (None, None) => {}
    }
    let channels = ["red", "green", "blue"].into_iter().enumerate().flat_map(|(channel, color)| {
        terms
            .iter()
            .zip(&tiles)
            .map(move |(term, tiles)| (format!("{color} of {}", term.source), only(tiles, channel)))
    });
    let channels: Vec<(String, Vec<f64>)> = channels.collect();
    let channels = channels.iter().map(|(name, tiles)| (name.clone(), tiles));
    fitted(columns(channels, evidence), evidence)
        .or_else(|| fit(&|term| format!("light {}", term.depth_name())))
        .or_else(|| fit(&|term| format!("{}, {}", term.name, term.depth_name())))
}

/// The tiles of a channel; those of the others are 0.
fn only(tiles: &[f64], channel: usize) -> Vec<f64> {
    let each = tiles.len() / 3;
    let its = |at: usize| if at / each == channel { tiles[at] } else { 0.0 };
    (0..tiles.len()).map(its).collect()
}

/// Adds tiles to sums of tiles.
fn add(sums: &mut [f64], tiles: &[f64]) {
    sums.iter_mut().zip(tiles).for_each(|(sum, value)| *sum += value);
}

/// The columns of terms: those of one name are one, and those that the picture cannot tell apart.
fn columns<'a>(
    terms: impl Iterator<Item = (String, &'a Vec<f64>)>,
    evidence: &Evidence<'_>,
) -> Vec<Column> {
    let weights = evidence.weights();
    let total: f64 = evidence.mean.iter().sum();
    let mut named: Vec<(String, Vec<f64>)> = Vec::new();
    for (name, tiles) in terms {
        match named.iter_mut().find(|(it, _)| *it == name) {
            Some((_, sum)) => add(sum, tiles),
            None => named.push((name, tiles.clone())),
        }
    }
    let mut columns: Vec<Column> = Vec::new();
    for (name, tiles) in named {
        if tiles.iter().sum::<f64>() < SMALLEST * total {
            continue;
        }
        match columns.iter_mut().find(|(_, column)| cosine(column, &tiles, &weights) > ALIKE) {
            Some((names, column)) => {
                names.push(name);
                add(column, &tiles);
            }
            None => columns.push((vec![name], tiles)),
        }
    }
    columns
}

/// The fewest factors that explain the picture about as well as all do.
fn fitted(columns: Vec<Column>, evidence: &Evidence<'_>) -> Option<Factors> {
    let weights = evidence.weights();
    let theirs = evidence.tiles(|at| finite(evidence.theirs[at]));
    let tiles: Vec<&[f64]> = columns.iter().map(|(_, values)| &**values).collect();
    let mut difference = theirs;
    for column in &tiles {
        difference.iter_mut().zip(*column).for_each(|(rest, value)| *rest -= value);
    }
    let equations = Equations::new(&tiles, &difference, &weights)?;
    let all: Vec<usize> = (0..tiles.len()).collect();
    let whole = equations.explained(&all)?;
    let mut chosen: Vec<usize> = Vec::new();
    while chosen.is_empty() || equations.explained(&chosen)? < ENOUGH * whole {
        let with = |next: usize| [&*chosen, &[next]].concat();
        let gain = |next: &usize| equations.explained(&with(*next)).unwrap_or(0.0);
        let rest = all.iter().copied().filter(|next| !chosen.contains(next));
        let best = rest.max_by(|a, b| gain(a).total_cmp(&gain(b)))?;
        chosen.push(best);
        if chosen.len() > MOST {
            return None;
        }
    }
    let (solution, variances) = equations.solved(&chosen)?;
    let mut rest = difference.clone();
    for (column, more) in chosen.iter().zip(&solution) {
        rest.iter_mut().zip(tiles[*column]).for_each(|(rest, value)| *rest -= more * value);
    }
    let noise = evidence.squares_of_noise();
    let share = Share::of(&difference, [&rest, &rest], &weights, &noise).part;
    if share < 1.0 - LEFT {
        return None;
    }
    // what is left beyond noise makes the factors less certain
    let after = product(&rest, &rest, &weights);
    let beyond = (after / (rest.len() as f64 - chosen.len() as f64)).max(1.0);
    let ours: f64 = tiles.iter().map(|values| values.iter().sum::<f64>()).sum();
    let factor = |(index, column): (usize, &usize)| TermFactor {
        terms: columns[*column].0.clone(),
        factor: 1.0 + solution[index],
        error: (beyond * variances[index]).sqrt(),
        share: tiles[*column].iter().sum::<f64>() / ours,
    };
    let factors: Vec<TermFactor> = chosen.iter().enumerate().map(factor).collect();
    // light is not taken away
    if factors.iter().any(|it| it.factor < -(3.0 * it.error).max(NOTHING[0])) {
        return None;
    }
    Some(Factors { factors: factors.into_iter().filter(TermFactor::is_off).collect(), share })
}

/// The cosine of the angle between two pictures.
fn cosine(a: &[f64], b: &[f64], weights: &[f64]) -> f64 {
    product(a, b, weights) / (product(a, a, weights) * product(b, b, weights)).sqrt()
}
