//! Means of samples: their answers for several seeds against our mean, with the errors of both.

use ask::{Asking, triple};
use serde_json::{Value, json};

use super::super::judgement::{Judgement, Profile};
use super::super::laws::LawOutcome;
use super::super::probe::ours;

/// The seeds for which a question is asked.
pub const SEEDS: u64 = 16;
/// The seeds of our own answers.
const OUR_SEEDS: u64 = 32;
/// Ours are other seeds than theirs: a program with our random numbers is held against others, too.
const OURS_FROM: u64 = 1 << 32;

/// How a case is judged: at first, and again with more samples and other seeds if the first look says that it is
/// wrong. The looks are independent. Of means of Student's distribution with 15 degrees of freedom, which is wider than
/// that of means with a known error, 3 standard errors are left by 0.9 % and 5 by 0.016 %: with 3 channels and 1000
/// cases, at most 0.5 % of all runs of a right program have a false alarm.
struct Look {
    more: u64,
    far: f64,
}
const LOOKS: [Look; 2] = [Look { more: 1, far: 3.0 }, Look { more: 10, far: 5.0 }];

/// A mean with its standard error.
#[derive(Clone, Copy, Debug)]
pub struct Estimate {
    /// Of the estimates.
    pub mean: [f64; 3],
    /// Of that mean.
    pub error: [f64; 3],
    /// The number of estimates.
    pub count: u64,
}

fn square(x: f64) -> f64 {
    x * x
}

impl Estimate {
    /// Of these estimates.
    pub fn of(values: &[[f64; 3]]) -> Self {
        let n = values.len() as f64;
        let mean = std::array::from_fn(|i| values.iter().map(|value| value[i]).sum::<f64>() / n);
        let error = std::array::from_fn(|i| {
            let squares = values.iter().map(|value| square(value[i] - mean[i]));
            (squares.sum::<f64>() / (n * (n - 1.0).max(1.0))).sqrt()
        });
        // the mean of equal numbers is this number, without rounding
        let is_one = values.iter().all(|value| *value == values[0]);
        match is_one {
            true => Self { mean: values[0], error: [0.0; 3], count: values.len() as u64 },
            false => Self { mean, error, count: values.len() as u64 },
        }
    }

    /// Of an answer to `radiance`.
    pub fn answered(answer: &Value) -> Option<Self> {
        let mean = triple(&answer["mean"])?;
        let error = triple(&answer["standard_error"]).unwrap_or([0.0; 3]);
        let count = answer["replicas"].as_u64().unwrap_or(1).max(1);
        Some(Self { mean, error, count })
    }

    /// Whether there is no noise.
    pub fn is_exact(&self) -> bool {
        self.error == [0.0; 3]
    }

    /// How far their mean is from ours, in standard errors, at most over the channels. Where ours has more noise than
    /// theirs, ours counts: that of a few estimates may be too small by chance, as when none of them met a small lamp. A
    /// program that answers the same for all seeds has given one estimate.
    pub fn distance(&self, theirs: &Self, rounding: f64) -> f64 {
        let count = if theirs.is_exact() { 1 } else { theirs.count } as f64;
        let size = self.mean.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let channel = |i: usize| {
            let one = square(self.error[i]) * self.count as f64;
            let error = square(theirs.error[i]).max(one / count);
            let all = (error + square(self.error[i])).sqrt() + rounding * size;
            let off = (theirs.mean[i] - self.mean[i]).abs();
            if off == 0.0 { 0.0 } else { off / all }
        };
        let far = (0..3).map(channel);
        far.fold(0.0, |most: f64, x| if x.is_nan() { f64::INFINITY } else { most.max(x) })
    }
}

/// The relative rounding that is no difference; means are rounded many times.
pub fn rounding(profile: Profile) -> f64 {
    match profile {
        Profile::Careful => 1e-10,
        Profile::Book => 1e-4,
    }
}

/// Law: the mean of answers for several seeds is that of ours, within the errors of both. The case is a `radiance` with
/// `samples` and `seed`.
pub fn mean_agrees(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    let mut from = case["radiance"]["seed"].as_u64().unwrap_or(1);
    let mut last = None;
    for Look { more, far } in LOOKS {
        let samples = more * case["radiance"]["samples"].as_u64().unwrap_or(1);
        let with = |seed: u64, replicas: u64| {
            let mut question = case.clone();
            let data = &mut question["radiance"];
            data["samples"] = json!(samples);
            data["seed"] = json!(seed);
            data["replicas"] = json!(replicas);
            question
        };
        let questions: Vec<Value> = (0..SEEDS).map(|i| with(from + i, 1)).collect();
        let answers = ask.ask_all(&questions)?;
        let means: Option<Vec<[f64; 3]>> =
            answers.iter().map(|answer| triple(&answer["mean"])).collect();
        let Some(means) = means.filter(|means| means.iter().flatten().all(|x| x.is_finite()))
        else {
            ask.asked.truncate(1);
            return Ok(Judgement::wrong("mean", f64::INFINITY, "`mean`, three finite numbers"));
        };
        let theirs = Estimate::of(&means);
        // one line in the place of all: it is also what the probe answers
        let summary = json!({"mean": theirs.mean, "standard_error": theirs.error, "samples": samples, "replicas": SEEDS});
        ask.asked = vec![(with(from, SEEDS), summary)];
        let Some(ours) = ours(&with(OURS_FROM + from, OUR_SEEDS)).ok() else {
            return Ok(Judgement::Undecided);
        };
        let Some(ours) = Estimate::answered(&ours) else { return Ok(Judgement::Undecided) };
        let distance = ours.distance(&theirs, rounding(profile));
        if distance <= far {
            return Ok(Judgement::Right(0.0));
        }
        last = Some((ours, distance));
        from += SEEDS;
        // without noise, more samples tell nothing more
        if ours.is_exact() && theirs.is_exact() {
            break;
        }
    }
    let Some((ours, distance)) = last else { return Ok(Judgement::Undecided) };
    let off = match ours.is_exact() {
        true => "without noise".to_owned(),
        false => {
            format!("± {:.2e}; theirs is {distance:.1} standard errors away", largest(ours.error))
        }
    };
    let expected = format!("mean = {:?} {off}", ours.mean);
    Ok(Judgement::wrong("mean", f64::INFINITY, expected))
}

fn largest(numbers: [f64; 3]) -> f64 {
    numbers.into_iter().fold(0.0, f64::max)
}
