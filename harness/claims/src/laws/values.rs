//! Laws of lobes that hold value by value, to rounding.

use ask::Stop;
use groundtruth::math::{Vector, cos, sin};
use serde_json::Value;

use super::pairs::{self, Equality};
use super::{Breach, Finding, apart, negative};
use crate::case::LobeCase;
use crate::lobe::{Evaluated, Sampled};
use crate::measured::Measured;
use crate::naming::{Given, LOBES};

/// Samples, or directions, that are compared one by one.
const COMPARED: usize = 48;

/// As [`equal`] of all kinds, for directions of a lobe.
fn equal(case: &LobeCase<'_>, pairs: &[Equality], found: &str, expected: &str) -> Finding {
    pairs::equal(pairs, &LOBES, [found, expected], |pair| {
        let wi = pair.given.wi;
        (format!("wi = {:?}", wi.to_array()), vec![case.lobe.eval_question(case.wo, &[wi])])
    })
}

/// A pair at a direction.
fn pair(case: &LobeCase<'_>, wi: Vector, [found, expected, slack]: [f64; 3]) -> Equality {
    Equality { given: Given::of(case.wo, wi, case.eta), u: [0.0; 4], found, expected, slack }
}

/// Samples with a density, and the values in their directions.
fn valued(case: &mut LobeCase<'_>) -> Result<Vec<(Sampled, f64, Measured)>, Stop> {
    let samples = case.samples(COMPARED)?.into_iter().flatten();
    let samples: Vec<_> = samples.filter_map(|it| Some((it, it.pdf?))).collect();
    let directions: Vec<Vector> = samples.iter().map(|(it, _)| it.wi).collect();
    let values = case.measured(case.wo, &directions)?;
    let all = samples.into_iter().zip(values).map(|((it, pdf), value)| (it, pdf, value));
    let is_above = |(it, ..): &(Sampled, f64, Measured)| !case.is_level(it.wi);
    Ok(all.filter(is_above).collect())
}

pub fn same_pdf(case: &mut LobeCase<'_>, _: usize) -> Result<Finding, Stop> {
    let values = valued(case)?.into_iter();
    let pair = |(it, pdf, value): (Sampled, f64, Measured)| {
        pair(case, it.wi, [pdf, value.value.pdf, value.pdf_slack])
    };
    let pairs: Vec<Equality> = values.map(pair).collect();
    Ok(equal(case, &pairs, "the pdf of the sample", "the pdf of `eval`"))
}

pub fn weight(case: &mut LobeCase<'_>, _: usize) -> Result<Finding, Stop> {
    let rounding = 64.0 * case.rounding;
    let values = valued(case)?;
    let mut pairs = Vec::new();
    for (it, pdf, value) in values {
        let cosine = it.wi.z().abs();
        pairs.extend((0..3).map(|k| {
            let slack = value.f_slack[k] * cosine
                + it.weight[k].abs() * value.pdf_slack
                // the cosine of a rounded direction
                + rounding * value.value.f[k].abs();
            pair(case, it.wi, [it.weight[k] * pdf, value.value.f[k] * cosine, slack])
        }));
    }
    Ok(equal(case, &pairs, "weight × pdf", "f |cos θi|"))
}

pub fn reciprocal(case: &mut LobeCase<'_>, _: usize) -> Result<Finding, Stop> {
    let mut directions: Vec<Vector> =
        case.samples(COMPARED)?.into_iter().flatten().map(|it| it.wi).collect();
    for side in [1.0, -1.0] {
        directions.extend(case.directions(COMPARED, side));
    }
    // viewers below are asked for only where they are served
    let is_asked = |wi: &Vector| {
        case.is_served(*wi) && !case.is_level(*wi) && (wi.z() > 0.0 || case.claims.from_below)
    };
    directions.retain(is_asked);
    let wo = case.wo;
    let there = case.measured(wo, &directions)?;
    let mut pairs = Vec::new();
    for it in &there {
        let back = case.measured(it.wi, &[wo])?[0];
        let [mine, other] = [wo, it.wi].map(|w| case.index_at(w) * case.index_at(w));
        pairs.extend((0..3).map(|k| {
            let slack = it.f_slack[k] / mine + back.f_slack[k] / other;
            pair(case, it.wi, [it.value.f[k] / mine, back.value.f[k] / other, slack])
        }));
    }
    let squared = if case.eta == 1.0 { "" } else { "/η²" };
    let (found, expected) = (format!("f(wo, wi){squared}"), format!("f(wi, wo){squared}"));
    Ok(equal(case, &pairs, &found, &expected))
}

pub fn turned(case: &mut LobeCase<'_>, _: usize) -> Result<Finding, Stop> {
    let mut directions: Vec<Vector> =
        case.samples(COMPARED)?.into_iter().flatten().map(|it| it.wi).collect();
    directions.retain(|wi| !case.is_level(*wi));
    let angle = case.draw.between(0.1, 3.0);
    let turn = |w: Vector| {
        let (s, c) = (sin(angle), cos(angle));
        Vector::new(c * w.x() - s * w.y(), s * w.x() + c * w.y(), w.z())
    };
    let wo = case.wo;
    let there = case.measured(wo, &directions)?;
    let turned: Vec<Vector> = directions.iter().map(|w| turn(*w)).collect();
    let turned = case.measured(turn(wo), &turned)?;
    let pairs: Vec<Equality> = there
        .iter()
        .zip(&turned)
        .flat_map(|(a, b)| {
            let f = (0..3).map(|k| [b.value.f[k], a.value.f[k], a.f_slack[k] + b.f_slack[k]]);
            let pdf = [[b.value.pdf, a.value.pdf, a.pdf_slack + b.pdf_slack]];
            let all: Vec<_> = f.chain(pdf).map(|numbers| pair(case, a.wi, numbers)).collect();
            all
        })
        .collect();
    Ok(equal(case, &pairs, "f or pdf, turned", "f or pdf"))
}

/// Cosines of directions that nearly lie in the surface.
const LIMB: [f64; 2] = [1e-3, 1e-5];

pub fn positive(case: &mut LobeCase<'_>, _: usize) -> Result<Finding, Stop> {
    let is_bad = |x: f64| !x.is_finite() || x < 0.0;
    let broken = |found: String, numbers: [f64; 4], question: Value| {
        Finding::Broken(Breach {
            found,
            expected: "finite numbers of at least 0".to_owned(),
            error: numbers.map(negative).into_iter().fold(0.0, f64::max),
            mistake: None,
            questions: vec![question],
        })
    };
    let u = case.numbers(COMPARED);
    let samples = case.lobe.sample(case.wo, &u)?;
    for (it, u) in samples.iter().zip(&u).filter_map(|(it, u)| Some(((*it)?, u))) {
        let [r, g, b] = it.weight;
        let numbers = [r, g, b, it.pdf.unwrap_or(1.0)];
        if numbers.into_iter().any(is_bad) {
            let found = format!("a sample with weight = {:?}, pdf = {:?}", it.weight, it.pdf);
            let question = case.lobe.sample_question(case.wo, &[*u]);
            return Ok(broken(found, numbers, question));
        }
    }
    let mut directions: Vec<Vector> = samples.into_iter().flatten().map(|it| it.wi).collect();
    for side in [1.0, -1.0] {
        directions.extend(case.directions(COMPARED, side));
        let level = case.directions(COMPARED, side);
        let lowered =
            LIMB.into_iter().flat_map(|z| level.iter().map(move |w| lowered(*w, side * z)));
        directions.extend(lowered);
    }
    let mut viewers = vec![case.wo];
    viewers.extend(LIMB.map(|z| lowered(case.wo, z.copysign(case.wo.z()))));
    for wo in viewers {
        let values = case.lobe.eval(wo, &directions)?;
        for (wi, Evaluated { f, pdf }) in directions.iter().zip(values) {
            if is_bad(pdf) || f.into_iter().any(is_bad) {
                let found = format!("f = {f:?} and pdf = {pdf:e}");
                let question = case.lobe.eval_question(wo, &[*wi]);
                let [r, g, b] = f;
                return Ok(broken(found, [r, g, b, pdf], question));
            }
        }
    }
    Ok(Finding::Holds)
}

/// The direction with the same azimuth and this cosine.
fn lowered(w: Vector, z: f64) -> Vector {
    let level = Vector::new(w.x(), w.y(), 0.0).unit().unwrap_or(Vector::X);
    (1.0 - z * z).sqrt() * level + z * Vector::Z
}

pub fn sides(case: &mut LobeCase<'_>, _: usize) -> Result<Finding, Stop> {
    let u = case.numbers(8 * COMPARED);
    let samples = case.lobe.sample(case.wo, &u)?;
    for (sample, u) in samples.iter().zip(&u).filter_map(|(it, u)| Some((it.as_ref()?, u))) {
        let wi = sample.wi;
        let length = wi.length();
        let is_unit = (length - 1.0).abs() <= 64.0 * case.rounding;
        if is_unit && (case.is_served(wi) || case.is_level(wi)) {
            continue;
        }
        let expected = match is_unit {
            true => "a sample on the side that is claimed".to_owned(),
            false => format!("a unit direction; its length is {length}"),
        };
        return Ok(Finding::Broken(Breach {
            found: format!("the sample wi = {:?}", wi.to_array()),
            expected,
            error: if is_unit { 1.0 } else { apart(length, 1.0) },
            mistake: None,
            questions: vec![case.lobe.sample_question(case.wo, &[*u])],
        }));
    }
    if case.claims.delta {
        return Ok(Finding::Holds);
    }
    let mut others = case.directions(COMPARED, 1.0);
    others.extend(case.directions(COMPARED, -1.0));
    others.retain(|wi| !case.is_served(*wi));
    let values = case.lobe.eval(case.wo, &others)?;
    let lit = others.iter().zip(values).find(|(_, it)| it.pdf != 0.0 || it.f != [0.0; 3]);
    Ok(lit.map_or(Finding::Holds, |(wi, it)| {
        Finding::Broken(Breach {
            found: format!("f = {:?} and pdf = {:e} at wi = {:?}", it.f, it.pdf, wi.to_array()),
            expected: "0 on the side that is not claimed".to_owned(),
            error: 1.0,
            mistake: None,
            questions: vec![case.lobe.eval_question(case.wo, &[*wi])],
        })
    }))
}

pub fn repeated(case: &mut LobeCase<'_>, _: usize) -> Result<Finding, Stop> {
    let u = case.numbers(4);
    let wi = case.directions(4, case.wo.z().signum());
    // another viewer, so that what is kept of the last call is another's; on the other side if that is served
    let side = if case.claims.from_below { -1.0 } else { 1.0 };
    let between = case.directions(4, side * case.wo.z().signum());
    // answers that cannot be read are not judged
    case.lobe.sample(case.wo, &u)?;
    case.lobe.eval(case.wo, &wi)?;
    let other = case.numbers(4);
    let mut questions = Vec::new();
    if !case.claims.random {
        questions.push(case.lobe.sample_question(case.wo, &u));
    }
    if !case.claims.delta {
        questions.push(case.lobe.eval_question(case.wo, &wi));
    }
    let between = [
        case.lobe.eval_question(between[0], &between),
        case.lobe.sample_question(between[0], &other),
    ];
    pairs::repeated(&mut case.lobe.asked, &questions, &between)
}
