//! Laws of integrals: of the density, and of the light that is scattered or arrives.

use ask::Stop;
use groundtruth::math::Vector;
use statistics::chi_square::goodness_of_fit;
use statistics::means;

use super::directed::{Directed, Drawn};
use super::{Breach, Finding, apart};
use crate::case::LobeCase;
use crate::cells::{Cells, DensitySamples, Integral, Integrals, integrals};
use crate::light::LightCase;
use crate::naming::constant;

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
/// The density times these factors is tried where the density itself does not fit: the first so many of its kind.
const TRIED: usize = 8;
/// A factor has to bring the whole so near to what it should be.
const TOLD: f64 = 0.01;
/// pdf; three channels of f |cos θi|; and the density times each factor.
const INTEGRANDS: usize = 4 + TRIED;

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

/// What is counted and integrated once for all laws that need it.
fn integrated(case: &mut impl Directed, scale: usize) -> Result<&Integrated, Stop> {
    if case.integrated().as_ref().is_none_or(|it| it.scale != scale) {
        *case.integrated() = Some(integrate(case, scale)?);
    }
    Ok(case.integrated().as_ref().expect("just set"))
}

fn integrate<C: Directed>(case: &mut C, scale: usize) -> Result<Integrated, Stop> {
    let placing = case.drawn(PLACING)?;
    let placing: Vec<Vector> = placing.iter().filter_map(with_density).map(|it| it.w).collect();
    let cells = Cells::around(&placing, DEPTH);
    // not all at once: as JSON they are many times as large
    let mut samples = Vec::with_capacity(COUNTED * scale);
    for _ in 0..scale {
        samples.extend(case.drawn(COUNTED)?);
    }
    let mut counts = vec![0; cells.all.len()];
    let mut directions = Vec::with_capacity(samples.len());
    for (index, sample) in samples.iter().enumerate() {
        let Some(sample) = with_density(sample) else { continue };
        counts[cells.index(sample.w)] += 1;
        // more do not make the integrals better, only dearer
        if index < GUIDING {
            directions.push(sample.w);
        }
    }
    let has_deltas = samples.iter().flatten().any(|it| !it.has_density);
    let weights = samples.chunks(samples.len().div_ceil(GROUPS)).map(|group| {
        let weights = group.iter().flatten().map(|it| it.weight);
        let sum = weights.fold([0.0; 3], |sum, w| std::array::from_fn(|k| sum[k] + w[k]));
        sum.map(|sum| sum / group.len() as f64)
    });
    let weights = weights.collect();
    // a tenth of the noise of a count, as a probability; not less where more are counted, or the edge of a lamp would
    // never be known so well: its pieces' errors are added as if all had one sign
    let drawn = COUNTED as f64;
    let tolerance = 0.1 * (drawn / f64::from(1_u32 << DEPTH)).sqrt() / drawn;
    let size = case.size(&weights);
    let tolerances = std::array::from_fn(|k| match k {
        0 => tolerance,
        1..4 => tolerance * size,
        _ => f64::INFINITY,
    });
    let mut values = |w: &[Vector]| {
        let integrands = case.values(w)?.into_iter().map(|it| {
            std::array::from_fn(|k| match k {
                0 => it.pdf,
                1..4 => it.f[k - 1],
                _ => {
                    let value = it.pdf * (C::FACTORS[k - 4].value)(&it.given);
                    // of what a program does not tell nothing is tried
                    if value.is_finite() { value } else { 0.0 }
                }
            })
        });
        Ok::<_, Stop>(integrands.collect())
    };
    let guide = DensitySamples { drawn: samples.len().min(GUIDING), directions: &directions };
    let integrals = integrals(&cells, guide, tolerances, BUDGET, &mut values)?;
    let (scattered, drawn) = (counts.iter().sum(), samples.len() as u64);
    Ok(Integrated { scale, counts, scattered, drawn, weights, has_deltas, integrals })
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

    /// The distance in total variation of the counts from the density, both as if the whole were 1.
    fn apart(&self) -> f64 {
        let (scattered, whole) = (self.scattered as f64, self.integrals.whole.value[0]);
        let pairs = self.counts.iter().zip(&self.integrals.cells);
        let apart =
            pairs.map(|(count, cell)| (*count as f64 / scattered - cell.value[0] / whole).abs());
        0.5 * apart.sum::<f64>()
    }

    /// The mean weight of a channel, and the probability of one as far from an integral that is known to an error.
    fn mean(&self, k: usize, value: f64, error: f64) -> (f64, f64) {
        let groups: Vec<f64> = self.weights.iter().map(|mean| mean[k]).collect();
        let mean = groups.iter().sum::<f64>() / groups.len() as f64;
        // a sum beyond the largest number tells nothing
        if (mean - value).abs() <= error || ![mean, value, error].iter().all(|x| x.is_finite()) {
            return (mean, 1.0);
        }
        // the nearest value that the integral may have
        (mean, means::one_sample(&groups, mean.clamp(value - error, value + error)))
    }

    /// The factor with which the density fits the counts, in its whole too if that is asked.
    fn factor<C: Directed>(&self, share: Option<f64>) -> Option<String> {
        // a whole that is off by no more than the factors are told by fits too many of them
        if share.is_some_and(|share| (self.integrals.whole.value[0] - share).abs() <= 2.0 * TOLD) {
            return None;
        }
        let named = |name: &str| format!("the pdf fits the samples if it is multiplied by {name}");
        // a narrow peak fits whatever is smooth: constants are tried first, then what has the right whole
        if let Some(share) = share
            && self.fit(0) > 1e-3
            && let Some(name) = constant(share / self.integrals.whole.value[0], TOLD)
        {
            return Some(named(name));
        }
        let is_whole = |k: usize| {
            let whole = self.integrals.whole.value[k];
            share.is_none_or(|share| (whole - share).abs() <= TOLD)
        };
        let fits = |k: &usize| is_whole(*k) && self.fit(*k) > 1e-3;
        (4..INTEGRANDS).find(fits).map(|k| named(C::FACTORS[k - 4].name))
    }
}

/// A sample that has a density, and a direction: another law tells of those that have none.
fn with_density(sample: &Option<Drawn>) -> Option<Drawn> {
    sample.filter(|it| it.has_density && it.w.to_array().iter().all(|x| x.is_finite()))
}

/// What is said of integrals that did not settle.
fn unsettled() -> Finding {
    Finding::Undecided(format!("the integral of the pdf did not settle within {BUDGET} values"))
}

pub fn whole<C: Directed>(case: &mut C, scale: usize) -> Result<Finding, Stop> {
    let questions = vec![case.example()];
    let it = integrated(case, scale)?;
    if !it.integrals.is_known {
        return Ok(unsettled());
    }
    let (value, error) = (it.integrals.whole.value[0], it.integrals.whole.error[0]);
    let share = it.scattered as f64 / it.drawn as f64;
    let slack = error + C::GRANTED;
    let is_right = (value - share).abs() <= slack;
    let breach = Breach {
        found: format!("∫ pdf = {value:.5} ± {error:.0e}"),
        expected: format!("{share:.5}, the share of samples that have a density"),
        error: apart(value, share),
        mistake: if is_right { None } else { it.factor::<C>(Some(share)) },
        questions,
    };
    if value > 1.0 + slack {
        return Ok(Finding::Broken(breach));
    }
    if is_right {
        return Ok(Finding::Holds);
    }
    let (n, k) = (it.drawn as f64, it.scattered);
    // the nearest share that is right; of 1 itself a test of counts would tell nothing: no other is expected
    let expected = share.max(value.min(1.0) - slack).min(value + slack);
    let p = goodness_of_fit(&[k, it.drawn - k], &[n * expected, n - n * expected]);
    Ok(Finding::Chance(p, breach))
}

pub fn density<C: Directed>(case: &mut C, scale: usize) -> Result<Finding, Stop> {
    let questions = vec![case.example()];
    let it = integrated(case, scale)?;
    if !it.integrals.is_known {
        return Ok(unsettled());
    }
    let whole = it.integrals.whole.value[0];
    if whole > 1.0 + it.integrals.whole.error[0] + C::GRANTED {
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
    let (scattered, cells) = (it.scattered, it.counts.len());
    Ok(Finding::Chance(
        p,
        Breach {
            found: format!("{count} of {scattered} samples in one cell (χ² of {cells} cells)"),
            expected: format!("{:.1} by the pdf", it.scattered as f64 * cell.value[0] / whole),
            error: it.apart(),
            mistake: if p < 1e-3 { it.factor::<C>(None) } else { None },
            questions,
        },
    ))
}

pub fn albedo(case: &mut LobeCase<'_>, scale: usize) -> Result<Finding, Stop> {
    let questions = vec![case.example()];
    let is_lossless = case.claims.lossless;
    if case.claims.delta {
        let samples = case.drawn(COUNTED / 16 * scale)?;
        let weight = |k: usize| -> Vec<f64> {
            samples.iter().map(|it| it.as_ref().map_or(0.0, |it| it.weight[k])).collect()
        };
        return Ok(conserved([0, 1, 2].map(|k| (weight(k), 0.0)), is_lossless, questions));
    }
    let it = integrated(case, scale)?;
    let groups = |k: usize| it.weights.iter().map(|mean| mean[k]).collect::<Vec<f64>>();
    if it.has_deltas {
        let weights = [0, 1, 2].map(|k| (groups(k), LobeCase::GRANTED));
        return Ok(conserved(weights, is_lossless, questions));
    }
    if !it.integrals.is_known {
        return Ok(unsettled());
    }
    let mut least = (1.0, None);
    for k in 0..3 {
        let (value, error) = (it.integrals.whole.value[1 + k], it.integrals.whole.error[1 + k]);
        let error = error + LobeCase::GRANTED * value.abs();
        let breach = |right: f64, expected: String| Breach {
            found: format!("∫ f |cos θi| = {value:.5} in channel {k}"),
            expected,
            error: apart(value, right),
            mistake: None,
            questions: questions.clone(),
        };
        if value > 1.0 + error || is_lossless && value < 1.0 - error {
            return Ok(Finding::Broken(breach(1.0, conserved_share(is_lossless))));
        }
        let (mean, p) = it.mean(k, value, error);
        if p < least.0 {
            least = (p, Some(breach(mean, format!("{mean:.5}, the mean weight of samples"))));
        }
    }
    Ok(least.1.map_or(Finding::Holds, |breach| Finding::Chance(least.0, breach)))
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
            let found = format!("the mean weight is {mean:.6}");
            let expected = conserved_share(is_lossless);
            let (error, questions) = (apart(mean, 1.0), questions.clone());
            least = (p, Some(Breach { found, expected, error, mistake: None, questions }));
        }
    }
    least.1.map_or(Finding::Holds, |breach| Finding::Chance(least.0, breach))
}

fn conserved_share(is_lossless: bool) -> String {
    if is_lossless { "1, as is claimed: nothing is lost" } else { "at most 1" }.to_owned()
}

/// The light that arrives at a point: its mean by samples, and its integral.
pub fn arriving(case: &mut LightCase<'_>, scale: usize) -> Result<Finding, Stop> {
    let questions = vec![case.example()];
    let it = integrated(case, scale)?;
    if !it.integrals.is_known {
        return Ok(unsettled());
    }
    if it.has_deltas {
        let why = "some samples are of single directions, which have no integral".to_owned();
        return Ok(Finding::Undecided(why));
    }
    let whole = it.integrals.whole;
    let mut least = Finding::Holds;
    for k in 0..3 {
        let value = whole.value[1 + k];
        let (mean, p) = it.mean(k, value, whole.error[1 + k] + LightCase::GRANTED * value.abs());
        if p < 1.0 && !matches!(least, Finding::Chance(other, _) if other <= p) {
            least = Finding::Chance(
                p,
                Breach {
                    found: format!("the mean of radiance / pdf = {mean:.5e} in channel {k}"),
                    expected: format!("{value:.5e}, the integral of the radiance"),
                    error: apart(mean, value),
                    mistake: constant(mean / value, 0.01)
                        .map(|name| format!("what is found is {name} times what is expected")),
                    questions: questions.clone(),
                },
            );
        }
    }
    Ok(least)
}
