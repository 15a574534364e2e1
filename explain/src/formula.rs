//! The formula of each term in the book's letters, with this hit's numbers.

use std::fmt;

use groundtruth::lobes::Lobe;
use groundtruth::rgb::Rgb;
use groundtruth::trace::TermSource;

use super::tree::{RecordedRay, RecordedTerm};
use super::written::{Factor, Scattered, written};

/// A term as a product: `k_d c_d / π · cos θ_i · L_i`.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// Its factors, in the order of the book's formula.
    pub factors: Vec<Factor>,
    /// The chapter of the book that brings the formula, as `ch. 13`.
    pub place: String,
    /// The file that computes it, from the root of the repository.
    pub source: String,
}

/// The symbol of a factor that no formula of the book has: a known mistake of a program.
pub const MISTAKEN: &str = "[mistake]";

/// A factor this near to 1, relative to it, is rounding.
const ROUNDING: f64 = 1e-9;

impl Formula {
    /// In letters: `k_d c_d / π · cos θ_i · L_i`.
    pub fn symbols(&self) -> String {
        product(&self.factors, |factor| factor.symbol)
    }

    /// In numbers: `0.8 / π · 0.5 · 2`.
    pub fn numbers(&self) -> String {
        product(&self.factors, |factor| &factor.number)
    }

    /// The product of its factors.
    pub fn value(&self) -> Rgb {
        self.factors.iter().fold(Rgb::WHITE, |product, factor| match factor.divides {
            true => product * factor.value.map(|x| 1.0 / x),
            false => product * factor.value,
        })
    }
}

/// `k_d c_d / π · cos θ_i · L_i = 0.8 / π · 0.5 · 2  (ch. 13, src/lobes/lambertian.rs)`.
impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { place, source, .. } = self;
        write!(f, "{} = {}  ({place}, {source})", self.symbols(), self.numbers())
    }
}

fn product<'a>(factors: &'a [Factor], text: impl Fn(&'a Factor) -> &'a str) -> String {
    let mut product = String::new();
    for (index, factor) in factors.iter().enumerate() {
        product += match (index, factor.divides) {
            (0, false) => "",
            (0, true) => "1 / ",
            (_, false) => " · ",
            (_, true) => " / ",
        };
        product += text(factor);
    }
    product
}

impl RecordedRay {
    /// The formula of one of its terms.
    pub fn formula(&self, term: &RecordedTerm) -> Formula {
        let arriving = |symbol| Factor::color(symbol, term.arriving);
        let formula = match &term.source {
            TermSource::Direct { lobe, f, cos_i, pdf, mis, .. } => {
                let mut factors = written(lobe, Scattered::Lit(*f));
                factors.push(Factor::number("cos θ_i", *cos_i));
                factors.extend(pdf.map(|pdf| Factor::divisor("p", pdf)));
                factors.extend(mis.map(|mis| Factor::number("w", mis)));
                factors.push(arriving("L_i"));
                of_lobe(lobe, factors)
            }
            TermSource::Traced { lobe, pdf, lobe_probability, survival } => {
                let drawn = (lobe_probability * survival) * term.weight;
                let mut factors = written(
                    lobe,
                    match pdf {
                        Some(pdf) => Scattered::Drawn(*pdf * drawn),
                        None => Scattered::Single { weight: drawn, eta: self.scaling(lobe, drawn) },
                    },
                );
                let divisors = [("P", *lobe_probability), ("q", *survival)];
                let divisors = divisors.into_iter().filter(|(_, value)| *value != 1.0);
                let divisors = pdf.map(|pdf| ("p", pdf)).into_iter().chain(divisors);
                factors.extend(divisors.map(|(symbol, value)| Factor::divisor(symbol, value)));
                factors.push(arriving("L_i"));
                of_lobe(lobe, factors)
            }
            TermSource::Ambient { .. } => {
                let factors = vec![Factor::color("k_a c_d", term.weight), arriving("L_i")];
                of_tracer(factors, 14, "src/trace/direct.rs")
            }
            TermSource::Emission { mis } => {
                let factors = weighed(*mis, arriving("l_s c_e"));
                of_tracer(factors, 18, "src/materials/emission.rs")
            }
            TermSource::Background { mis } => {
                of_tracer(weighed(*mis, arriving("L_b")), 3, "src/background/mod.rs")
            }
            TermSource::Light { .. } => {
                let factors = vec![Factor::color("V", term.weight), arriving("L")];
                of_tracer(factors, 16, "src/trace/shadow.rs")
            }
        };
        besides(formula, term.value)
    }

    /// The `η` of the factor `1/η²` that a weight has: the relative index of a refracting lobe, or
    /// 1.
    fn scaling(&self, lobe: &Lobe, weight: Rgb) -> f64 {
        let optics = self.hit.as_ref().and_then(|hit| hit.optics.as_ref());
        let Some(optics) = optics.filter(|_| lobe.refracts()) else { return 1.0 };
        let off = |eta: f64| ((eta * eta) * weight - optics.transmitted).max().abs();
        // the scene may say that radiance keeps its value
        if off(optics.eta) <= off(1.0) { optics.eta } else { 1.0 }
    }
}

fn of_lobe(lobe: &Lobe, factors: Vec<Factor>) -> Formula {
    let [chapter, file] = lobe.place();
    let place = format!("ch. {}", chapter.trim_start_matches("ch"));
    Formula { factors, place, source: format!("src/lobes/{file}.rs") }
}

fn of_tracer(factors: Vec<Factor>, chapter: u32, source: &str) -> Formula {
    Formula { factors, place: format!("ch. {chapter}"), source: source.to_owned() }
}

/// With the weight of multiple importance sampling, if there is one.
fn weighed(mis: Option<f64>, factor: Factor) -> Vec<Factor> {
    mis.map(|mis| Factor::number("w", mis)).into_iter().chain([factor]).collect()
}

/// The formula, with what the term has besides: only a renderer with a known mistake adds a factor.
fn besides(mut formula: Formula, value: Rgb) -> Formula {
    let (found, wanted) = (formula.value().to_array(), value.to_array());
    let ratio = |channel: usize| (found[channel] != 0.0).then(|| wanted[channel] / found[channel]);
    // a black channel says nothing: as another one
    let other = (0..3).find_map(ratio).unwrap_or(1.0);
    let ratios = [0, 1, 2].map(|channel| ratio(channel).unwrap_or(other));
    if ratios.iter().any(|ratio| (ratio - 1.0).abs() > ROUNDING) {
        formula.factors.push(Factor::color(MISTAKEN, Rgb::from(ratios)));
    }
    formula
}
