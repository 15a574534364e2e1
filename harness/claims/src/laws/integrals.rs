//! Laws of integrals: of the density, and of the light that is scattered.

use groundtruth::math::Vector;
use statistics::chi_square::goodness_of_fit;
use statistics::means;

use super::{Breach, Finding};
use crate::case::Case;
use crate::cells::{Cells, Integral, Integrals, Samples, integrals};
use crate::lobe::{Sampled, Trouble};
use crate::naming::FACTORS;

/// Samples that place the cells, and samples that are counted.
const PLACING: usize = 2048;
const COUNTED: usize = 16_384;
/// The first of these guide the integrals.
const GUIDING: usize = 8_192;
/// Each hemisphere is divided so often.
const DEPTH: u32 = 5;
/// Values in one case.
const BUDGET: usize = 400_000;
/// Groups of samples whose mean weights are compared.
const GROUPS: usize = 64;
/// The density times these factors is tried where the density itself does not fit: the first so many of [`FACTORS`].
const TRIED: usize = 8;
/// pdf; three channels of f |cos θi|; and the density times each factor.
const INTEGRANDS: usize = 4 + TRIED;
/// A density or an albedo that is off by less than this is called right.
const GRANTED: f64 = 2e-3;

/// Counts and integrals of a case.
#[derive(Debug)]
pub struct Integrated {
    scale: usize,
    /// The samples in each cell.
    counts: Vec<u64>,
    /// Samples that have a density.
    scattered: u64,
    /// All samples.
    drawn: u64,
    /// Mean weights of groups of samples; those that scatter nothing count as 0.
    weights: Vec<[f64; 3]>,
    /// Whether some samples are of single directions.
    has_deltas: bool,
    integrals: Integrals<INTEGRANDS>,
}

impl Case<'_> {
    /// What f and weights are multiplied with for the energy of light: radiance over the square of the index stays the
    /// same across a boundary, radiance does not.
    fn invariant(&self, wi: Vector) -> f64 {
        let ratio = self.index_at(wi) / self.index_at(self.wo);
        ratio * ratio
    }

    /// What is counted and integrated once for all laws that need it.
    fn integrated(&mut self, scale: usize) -> Result<&Integrated, Trouble> {
        if self.integrated.as_ref().is_none_or(|it| it.scale != scale) {
            self.integrated = Some(self.integrate(scale)?);
        }
        Ok(self.integrated.as_ref().expect("just set"))
    }

    fn integrate(&mut self, scale: usize) -> Result<Integrated, Trouble> {
        let placing = self.samples(PLACING)?;
        let placing: Vec<Vector> =
            placing.iter().filter_map(with_density).map(|it| it.wi).collect();
        let cells = Cells::around(&placing, DEPTH);
        let samples = self.samples(COUNTED * scale)?;
        let mut counts = vec![0; cells.all.len()];
        let mut directions = Vec::with_capacity(samples.len());
        for (index, sample) in samples.iter().enumerate() {
            let Some(sample) = with_density(sample) else { continue };
            // a direction in the surface is on the side that is served
            let wi = match self.is_level(sample.wi) && !self.is_served(sample.wi) {
                true => Vector::new(sample.wi.x(), sample.wi.y(), -sample.wi.z()),
                false => sample.wi,
            };
            counts[cells.index(wi)] += 1;
            // more do not make the integrals better, only dearer
            if index < GUIDING {
                directions.push(wi);
            }
        }
        let has_deltas = samples.iter().flatten().any(|it| it.pdf.is_none());
        let weights = samples.chunks(samples.len().div_ceil(GROUPS)).map(|group| {
            let scattered = group.iter().flatten();
            let weights = scattered.map(|it| it.weight.map(|w| w * self.invariant(it.wi)));
            let sum = weights.fold([0.0; 3], |sum, w| std::array::from_fn(|k| sum[k] + w[k]));
            sum.map(|sum| sum / group.len() as f64)
        });
        let weights = weights.collect();
        // a tenth of the noise of a count, as a probability
        let drawn = samples.len() as f64;
        let tolerance = 0.1 * (drawn / f64::from(1_u32 << DEPTH)).sqrt() / drawn;
        let tolerances = std::array::from_fn(|k| if k < 4 { tolerance } else { f64::INFINITY });
        let (wo, eta) = (self.wo, self.eta);
        let invariant: [f64; 2] = [1.0, -1.0].map(|z| self.invariant(z * Vector::Z));
        let lobe = &mut self.lobe;
        let mut values = |wi: &[Vector]| {
            let values = lobe.eval(wo, wi)?.into_iter().zip(wi);
            let integrands = values.map(|(it, wi)| {
                std::array::from_fn(|k| match k {
                    0 => it.pdf,
                    1..4 => it.f[k - 1] * wi.z().abs() * invariant[usize::from(wi.z() < 0.0)],
                    _ => it.pdf * (FACTORS[k - 4].value)(wo, *wi, eta),
                })
            });
            Ok::<_, Trouble>(integrands.collect())
        };
        let guide = Samples { drawn: samples.len().min(GUIDING), directions: &directions };
        let integrals = integrals(&cells, guide, tolerances, BUDGET, &mut values)?;
        let (scattered, drawn) = (counts.iter().sum(), samples.len() as u64);
        Ok(Integrated { scale, counts, scattered, drawn, weights, has_deltas, integrals })
    }
}

impl Integrated {
    /// The probability of counts as far off as these if samples had the density of an integrand, up to a constant.
    fn fit(&self, integrand: usize) -> f64 {
        let cells = self.integrals.cells.iter().map(|cell| cell.value[integrand]);
        let whole: f64 = cells.clone().sum();
        let expected: Vec<f64> = cells.map(|cell| self.scattered as f64 * cell / whole).collect();
        match whole > 0.0 {
            true => goodness_of_fit(&self.counts, &expected),
            // no density: it fits where there are no samples
            false => f64::from(u8::from(self.scattered == 0)),
        }
    }

    /// The factor with which the density fits the counts, in its whole too if that is asked.
    fn factor(&self, share: Option<f64>) -> Option<String> {
        let is_whole = |k: usize| {
            let whole = self.integrals.whole.value[k];
            share.is_none_or(|share| (whole - share).abs() <= 0.01)
        };
        let fits = |k: &usize| is_whole(*k) && self.fit(*k) > 1e-3;
        let name = FACTORS[(4..INTEGRANDS).find(fits)? - 4].name;
        Some(format!("the pdf fits the samples if it is multiplied by {name}"))
    }
}

/// A sample that has a density, and a direction: the law of sides tells of those that have none.
fn with_density(sample: &Option<Sampled>) -> Option<Sampled> {
    sample.filter(|it| it.pdf.is_some() && it.wi.to_array().iter().all(|x| x.is_finite()))
}

/// What is said of integrals that did not settle.
fn unsettled() -> Finding {
    let why = format!("the integral of the pdf did not settle within {BUDGET} values");
    Finding::Undecided(why)
}

pub fn whole(case: &mut Case<'_>, scale: usize) -> Result<Finding, Trouble> {
    let questions = vec![case.lobe.sample_question(case.wo, &[[0.5; 4]])];
    let it = case.integrated(scale)?;
    if !it.integrals.is_known {
        return Ok(unsettled());
    }
    let (value, error) = (it.integrals.whole.value[0], it.integrals.whole.error[0]);
    let share = it.scattered as f64 / it.drawn as f64;
    let is_right = (value - share).abs() <= error + GRANTED;
    let breach = Breach {
        found: format!("∫ pdf = {value:.5} ± {error:.0e}"),
        expected: format!("{share:.5}, the share of samples that have a density"),
        mistake: if is_right { None } else { it.factor(Some(share)) },
        questions,
    };
    if value > 1.0 + error + GRANTED {
        return Ok(Finding::Broken(breach));
    }
    if is_right {
        return Ok(Finding::Holds);
    }
    let (n, k) = (it.drawn as f64, it.scattered);
    let expected = value.min(1.0);
    let p = goodness_of_fit(&[k, it.drawn - k], &[n * expected, n - n * expected]);
    Ok(Finding::Chance(p, breach))
}

pub fn density(case: &mut Case<'_>, scale: usize) -> Result<Finding, Trouble> {
    let questions = vec![case.lobe.sample_question(case.wo, &[[0.5; 4]])];
    let it = case.integrated(scale)?;
    if !it.integrals.is_known {
        return Ok(unsettled());
    }
    let whole = it.integrals.whole.value[0];
    if whole > 1.0 + it.integrals.whole.error[0] + GRANTED {
        return Ok(Finding::Undecided("the pdf is no density: its integral is above 1".to_owned()));
    }
    // of samples and density each as if the whole were 1: the law of the whole says the rest
    let p = it.fit(0);
    let most = it.counts.iter().zip(&it.integrals.cells).max_by(|a, b| {
        let off = |(count, cell): &(&u64, &Integral<INTEGRANDS>)| {
            let expected = it.scattered as f64 * cell.value[0] / whole;
            (**count as f64 - expected).abs() / expected.max(1.0).sqrt()
        };
        off(a).total_cmp(&off(b))
    });
    let (count, cell) = most.expect("there are cells");
    Ok(Finding::Chance(
        p,
        Breach {
            found: format!(
                "{count} of {} samples in one cell (χ² of {} cells)",
                it.scattered,
                it.counts.len()
            ),
            expected: format!("{:.1} by the pdf", it.scattered as f64 * cell.value[0] / whole),
            mistake: if p < 1e-3 { it.factor(None) } else { None },
            questions,
        },
    ))
}

pub fn albedo(case: &mut Case<'_>, scale: usize) -> Result<Finding, Trouble> {
    let questions = vec![case.lobe.sample_question(case.wo, &[[0.5; 4]])];
    let is_lossless = case.claims.lossless;
    if case.claims.delta {
        let samples = case.samples(COUNTED / 16 * scale)?;
        let weight = |k: usize| -> Vec<f64> {
            let of = |it: &Sampled| it.weight[k] * case.invariant(it.wi);
            samples.iter().map(|it| it.as_ref().map_or(0.0, of)).collect()
        };
        return Ok(conserved([0, 1, 2].map(|k| (weight(k), 0.0)), is_lossless, questions));
    }
    let it = case.integrated(scale)?;
    let groups = |k: usize| it.weights.iter().map(|mean| mean[k]).collect::<Vec<f64>>();
    if it.has_deltas {
        return Ok(conserved([0, 1, 2].map(|k| (groups(k), GRANTED)), is_lossless, questions));
    }
    if !it.integrals.is_known {
        return Ok(unsettled());
    }
    let mut least = (1.0, None);
    for k in 0..3 {
        let (value, error) = (it.integrals.whole.value[1 + k], it.integrals.whole.error[1 + k]);
        let error = error + GRANTED * value;
        let breach = |expected: String| Breach {
            found: format!("∫ f |cos θi| = {value:.5} in channel {k}"),
            expected,
            mistake: None,
            questions: questions.clone(),
        };
        if value > 1.0 + error {
            return Ok(Finding::Broken(breach("at most 1".to_owned())));
        }
        if is_lossless && value < 1.0 - error {
            return Ok(Finding::Broken(breach("1, as is claimed: nothing is lost".to_owned())));
        }
        let mean = groups(k).iter().sum::<f64>() / it.weights.len() as f64;
        if (mean - value).abs() <= error {
            continue;
        }
        // the nearest value that the integral may have
        let nearest = mean.clamp(value - error, value + error);
        let p = means::one_sample(&groups(k), nearest);
        if p < least.0 {
            least = (p, Some(breach(format!("{mean:.5}, the mean weight of samples"))));
        }
    }
    Ok(match least {
        (p, Some(breach)) => Finding::Chance(p, breach),
        _ => Finding::Holds,
    })
}

/// The mean weights of lobes with single directions: at most 1, and 1 where nothing is lost.
fn conserved(
    weights: [(Vec<f64>, f64); 3],
    is_lossless: bool,
    questions: Vec<serde_json::Value>,
) -> Finding {
    let mut least: (f64, Option<Breach>) = (1.0, None);
    for (values, granted) in weights {
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        // weights in single precision are rounded
        let granted = granted + 1e-6;
        if mean <= 1.0 + granted && (!is_lossless || mean >= 1.0 - granted) {
            continue;
        }
        let p = means::one_sample(&values, 1.0);
        if p < least.0 {
            let expected = if is_lossless { "1: nothing is lost" } else { "at most 1" };
            let (found, expected) = (format!("the mean weight is {mean:.6}"), expected.to_owned());
            least =
                (p, Some(Breach { found, expected, mistake: None, questions: questions.clone() }));
        }
    }
    match least {
        (p, Some(breach)) => Finding::Chance(p, breach),
        _ => Finding::Holds,
    }
}
