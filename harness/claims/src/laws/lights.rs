//! Laws of lights: what arrives at a point, from where, and how that is sampled.

use ask::Stop;
use groundtruth::math::{Point, Vector};
use serde_json::Value;

use super::pairs::{self, Equality};
use super::{Breach, Finding, apart, negative};
use crate::description::SamplingClaim;
use crate::light::{LightCase, LightSample};
use crate::measured::UNITS;
use crate::naming::{Given, LIGHTS};

/// Samples that are compared one by one.
const COMPARED: usize = 48;
/// Samples whose light is looked at from another point.
const MOVED: usize = 24;
/// How far beyond a point of the light it is looked back from, as a share of the distance.
const BEYOND: f64 = 1e-3;
/// At the rim of a curved light a point beyond it sees another part: with more samples that is no excuse.
const SHARE: f64 = 0.5;

fn broken(found: String, expected: &str, error: f64, questions: Vec<Value>) -> Finding {
    let expected = expected.to_owned();
    Finding::Broken(Breach { found, expected, error, mistake: None, questions })
}

/// Samples that bring light.
fn lit(case: &mut LightCase<'_>, count: usize) -> Result<Vec<LightSample>, Stop> {
    let samples = case.samples(count)?.into_iter().flatten();
    Ok(samples.filter(|it| it.is_lit() && it.pdf.is_some()).collect())
}

fn unlit() -> Finding {
    Finding::Undecided("no sample brings light to the point".to_owned())
}

/// Pairs at directions of samples, whose questions are that of the sample and that of the direction.
fn equal(case: &LightCase<'_>, pairs: &[Equality], words: [&str; 2]) -> Finding {
    pairs::equal(pairs, &LIGHTS, words, |pair| {
        let wi = pair.given.wi;
        let questions = vec![case.sample_question(&[pair.u]), case.eval_question(case.from, &[wi])];
        (format!("wi = {:?}", wi.to_array()), questions)
    })
}

pub fn repeated(case: &mut LightCase<'_>, _: usize) -> Result<Finding, Stop> {
    let u: Vec<[f64; 4]> =
        (0..4).map(|_| std::array::from_fn(|_| case.draw.between(0.0, 1.0))).collect();
    let mut wi = case.directions(4);
    wi.extend(lit(case, 4)?.iter().map(|it| it.wi));
    // answers that cannot be read are not judged
    case.eval(case.from, &wi)?;
    let mut questions = vec![case.eval_question(case.from, &wi)];
    if !case.claims.random {
        questions.push(case.sample_question(&u));
    }
    let other = crate::description::point_within(case.points, &mut case.draw);
    let here = std::mem::replace(&mut case.from, Point::from(other));
    let between = [case.sample_question(&u), case.eval_question(case.from, &wi)];
    case.from = here;
    pairs::repeated(&mut case.asked, &questions, &between)
}

pub fn positive(case: &mut LightCase<'_>, _: usize) -> Result<Finding, Stop> {
    let is_bad = |x: f64| !x.is_finite() || x < 0.0;
    let samples: Vec<_> = case.samples(8 * COMPARED)?.into_iter().flatten().collect();
    for it in &samples {
        if it.radiance.into_iter().any(is_bad) || it.pdf.is_some_and(|p| is_bad(p) || p == 0.0) {
            let found = format!("a sample with radiance = {:?}, pdf = {:?}", it.radiance, it.pdf);
            let questions = vec![case.sample_question(&[it.u])];
            let numbers = it.radiance.into_iter().chain(it.pdf);
            let error = numbers.map(negative).fold(0.0, f64::max);
            let expected = "radiance of at least 0, and a pdf above 0";
            return Ok(broken(found, expected, error, questions));
        }
    }
    let mut directions = case.directions(COMPARED);
    directions.extend(samples.iter().take(COMPARED).map(|it| it.wi));
    for (wi, it) in directions.iter().zip(case.eval(case.from, &directions)?) {
        if is_bad(it.value.pdf) || it.value.f.into_iter().any(is_bad) {
            let found = format!("radiance = {:?} and pdf = {:e}", it.value.f, it.value.pdf);
            let questions = vec![case.eval_question(case.from, &[*wi])];
            let numbers = it.value.f.into_iter().chain([it.value.pdf]);
            let error = numbers.map(negative).fold(0.0, f64::max);
            return Ok(broken(found, "finite numbers of at least 0", error, questions));
        }
    }
    Ok(Finding::Holds)
}

pub fn directions(case: &mut LightCase<'_>, _: usize) -> Result<Finding, Stop> {
    for it in case.samples(8 * COMPARED)?.into_iter().flatten() {
        let length = it.wi.length();
        let questions = vec![case.sample_question(&[it.u])];
        if (length - 1.0).abs().is_nan() || (length - 1.0).abs() > UNITS * case.rounding {
            let found = format!("wi = {:?}, of length {length}", it.wi.to_array());
            return Ok(broken(found, "a unit direction", apart(length, 1.0), questions));
        }
        let is_far = it.distance.is_infinite();
        if it.distance.is_nan() || it.distance <= 0.0 || is_far != case.claims.infinite {
            let expected = match case.claims.infinite {
                true => "no distance: the light is infinitely far away",
                false => "a distance above 0",
            };
            let found = format!("distance = {}", it.distance);
            return Ok(broken(found, expected, 1.0, questions));
        }
    }
    Ok(Finding::Holds)
}

pub fn same_pdf(case: &mut LightCase<'_>, _: usize) -> Result<Finding, Stop> {
    let samples = lit(case, COMPARED)?;
    let directions: Vec<Vector> = samples.iter().map(|it| it.wi).collect();
    let values = case.measured(case.from, &directions)?;
    let pair = |(it, value): (&LightSample, crate::measured::Measured)| Equality {
        given: it.given(),
        u: it.u,
        found: it.pdf.unwrap_or(f64::NAN),
        expected: value.value.pdf,
        slack: value.pdf_slack,
    };
    let pairs: Vec<Equality> = samples.iter().zip(values).map(pair).collect();
    if pairs.is_empty() {
        return Ok(unlit());
    }
    Ok(equal(case, &pairs, ["the pdf of the sample", "the pdf of `eval`"]))
}

pub fn same_radiance(case: &mut LightCase<'_>, _: usize) -> Result<Finding, Stop> {
    let samples = lit(case, COMPARED)?;
    let directions: Vec<Vector> = samples.iter().map(|it| it.wi).collect();
    let values = case.measured(case.from, &directions)?;
    let mut pairs = Vec::new();
    for (it, value) in samples.iter().zip(values) {
        pairs.extend((0..3).map(|k| Equality {
            given: it.given(),
            u: it.u,
            found: it.radiance[k],
            expected: value.value.f[k],
            slack: value.f_slack[k],
        }));
    }
    if pairs.is_empty() {
        return Ok(unlit());
    }
    Ok(equal(case, &pairs, ["the radiance of the sample", "the radiance of `eval`"]))
}

/// Looks back at points of the light from a little beyond them.
pub fn sides(case: &mut LightCase<'_>, _: usize) -> Result<Finding, Stop> {
    let samples = lit(case, MOVED)?;
    let is_lit = case.claims.two_sided;
    let mut wrong = Vec::new();
    for it in &samples {
        let beyond = case.from + (1.0 + BEYOND) * it.distance * it.wi;
        let seen = case.eval(beyond, &[-it.wi])?[0].value.f;
        if (seen != [0.0; 3]) != is_lit {
            wrong.push((seen, case.eval_question(beyond, &[-it.wi])));
        }
    }
    if samples.is_empty() {
        return Ok(unlit());
    }
    let Some((seen, question)) = wrong.first() else { return Ok(Finding::Holds) };
    if wrong.len() as f64 <= SHARE * samples.len() as f64 {
        return Ok(Finding::Holds);
    }
    let (wrong, all) = (wrong.len(), samples.len());
    let found = format!("radiance = {seen:?} behind a point, so for {wrong} of {all} points");
    let expected = if is_lit { "light: both sides shine" } else { "0: one side shines" };
    Ok(broken(found, expected, wrong as f64 / all as f64, vec![question.clone()]))
}

/// A point nearer to that of a sample, and the share of the distance that is left; of an infinite light any point.
fn nearer(case: &mut LightCase<'_>, it: &LightSample) -> (Point, f64) {
    if case.claims.infinite {
        let point = crate::description::point_within(case.points, &mut case.draw);
        return (Point::from(point), 1.0);
    }
    let left = case.draw.between(0.2, 0.8);
    (case.from + (1.0 - left) * it.distance * it.wi, left)
}

pub fn along(case: &mut LightCase<'_>, _: usize) -> Result<Finding, Stop> {
    let samples = lit(case, MOVED)?;
    let directions: Vec<Vector> = samples.iter().map(|it| it.wi).collect();
    let here = case.measured(case.from, &directions)?;
    let mut pairs = Vec::new();
    for (it, here) in samples.iter().zip(here) {
        let (point, left) = nearer(case, it);
        let there = case.measured(point, &[it.wi])?[0];
        // the distance that is left, over the whole
        let given = Given { distance: left, ..it.given() };
        pairs.extend((0..3).map(|k| Equality {
            given,
            u: it.u,
            found: there.value.f[k],
            expected: here.value.f[k],
            slack: here.f_slack[k] + there.f_slack[k],
        }));
    }
    if pairs.is_empty() {
        return Ok(unlit());
    }
    Ok(equal(case, &pairs, ["the radiance nearer to the light", "the radiance"]))
}

pub fn distance(case: &mut LightCase<'_>, _: usize) -> Result<Finding, Stop> {
    let samples = lit(case, MOVED)?;
    let directions: Vec<Vector> = samples.iter().map(|it| it.wi).collect();
    let here = case.measured(case.from, &directions)?;
    let Some(first) = here.first().copied() else { return Ok(unlit()) };
    let mut pairs = Vec::new();
    for (it, here) in samples.iter().zip(here) {
        if case.claims.sampling == Some(SamplingClaim::SolidAngle) {
            let slack = here.pdf_slack + first.pdf_slack;
            let (found, expected) = (here.value.pdf, first.value.pdf);
            pairs.push(Equality { given: it.given(), u: it.u, found, expected, slack });
            continue;
        }
        let (point, left) = nearer(case, it);
        let there = case.measured(point, &[it.wi])?[0];
        // the point of the light is the same, and so are its density of area and its cosine
        let squared = left * left;
        pairs.push(Equality {
            given: Given { distance: left, ..it.given() },
            u: it.u,
            found: there.value.pdf,
            expected: here.value.pdf * squared,
            slack: here.pdf_slack * squared + there.pdf_slack,
        });
    }
    let words = match case.claims.sampling {
        Some(SamplingClaim::SolidAngle) => ["the pdf", "the pdf in another direction"],
        _ => ["the pdf at a share d of the distance", "d² times the pdf"],
    };
    Ok(equal(case, &pairs, words))
}
