//! Lobes and Fresnel's equations (Suffern, ch. 13, 15, 24, 25, 27, 28).

use ask::{Draw, number, triple};
use serde_json::{Value, json};

use super::super::judgement::{Judgement, Profile};
use super::super::mistakes as m;
use super::super::values::{self, Rules};
use super::Mistakes;
use groundtruth::math::{Vector, cos, power, sin};

/// A unit direction above the surface, as three numbers whose squares add up to 1 within rounding.
pub fn outside(draw: &mut Draw) -> [f64; 3] {
    let z = draw.between(0.05, 1.0);
    let (phi, sine) = (draw.between(0.0, std::f64::consts::TAU), ((1.0 - z) * (1.0 + z)).sqrt());
    [sine * cos(phi), sine * sin(phi), z]
}

/// Those of `fresnel`.
pub const FRESNEL: Mistakes = Mistakes {
    questions: &[],
    answers: &[
        (&m::SCHLICK, |question, field, _| schlick(question, field)),
        (&m::MEAN_OF_AMPLITUDES, |_, field, right| {
            let mean = 0.5 * (number(&right["r_s"])?.sqrt() + number(&right["r_p"])?.sqrt());
            (field == "reflected").then_some(vec![mean])
        }),
        (&m::REFLECTED_INSTEAD, |question, field, _| {
            let [wo, n] = ["wo", "n"].map(|it| triple(&question["fresnel"][it]).map(Vector::from));
            let (wo, n) = (wo?, n?);
            (field == "refracted").then(|| (2.0 * n.dot(wo) * n - wo).to_array().to_vec())
        }),
        (&m::ETA_MULTIPLIED, |question, field, _| {
            let asked = &question["fresnel"];
            let [wo, n] = ["wo", "n"].map(|it| triple(&asked[it]).map(Vector::from));
            let multiplied = eta_multiplied(wo?, n?, asked["eta"].as_f64()?, false)?;
            (field == "refracted").then_some(multiplied)
        }),
        (&m::ETA_MULTIPLIED, |question, field, _| {
            let asked = &question["fresnel"];
            let [wo, n] = ["wo", "n"].map(|it| triple(&asked[it]).map(Vector::from));
            let multiplied = eta_multiplied(wo?, n?, asked["eta"].as_f64()?, true)?;
            (field == "refracted").then_some(multiplied)
        }),
        (&m::REFRACTED_SIGN, |question, field, _| {
            let asked = &question["fresnel"];
            let [wo, n] = ["wo", "n"].map(|it| triple(&asked[it]).map(Vector::from));
            let refracted = wrong_sign(wo?, n?, asked["eta"].as_f64()?)?;
            (field == "refracted").then_some(refracted)
        }),
    ],
};

/// `−η ωo − (cosθt − cosθi/η) n`, with both terms as the book has them but for the first factor, or with `η cosθi` in
/// the second one, too.
fn eta_multiplied(wo: Vector, n: Vector, eta: f64, is_both: bool) -> Option<Vec<f64>> {
    let cosine = n.dot(wo);
    let square = 1.0 - (1.0 - cosine * cosine) / (eta * eta);
    let second = if is_both { cosine * eta } else { cosine / eta };
    let refracted = -eta * wo - (square.sqrt() - second) * n;
    (square >= 0.0).then(|| refracted.to_array().to_vec())
}

/// `−ωo/η − (cosθt + cosθi/η) n`.
fn wrong_sign(wo: Vector, n: Vector, eta: f64) -> Option<Vec<f64>> {
    let cosine = n.dot(wo);
    let square = 1.0 - (1.0 - cosine * cosine) / (eta * eta);
    let refracted = -(1.0 / eta) * wo - (square.sqrt() + cosine / eta) * n;
    (square >= 0.0).then(|| refracted.to_array().to_vec())
}

fn lobe_eta_multiplied(question: &Value, field: &str, is_both: bool) -> Option<Vec<f64>> {
    let asked = &question["lobe"];
    let lobe = asked["lobe"].as_object()?.values().next()?;
    let wo = Vector::from(triple(&asked["wo"])?);
    (field == "sample.wi").then(|| eta_multiplied(wo, Vector::Z, lobe["eta"].as_f64()?, is_both))?
}

fn schlick(question: &Value, field: &str) -> Option<Vec<f64>> {
    let asked = &question["fresnel"];
    let eta = asked["eta"].as_f64()?;
    let cosine = asked["cos_i"].as_f64().or_else(|| {
        let [wo, n] = [&asked["wo"], &asked["n"]].map(triple);
        Some(Vector::from(wo?).dot(Vector::from(n?)))
    })?;
    let r0 = (eta - 1.0) / (eta + 1.0);
    let rest = 1.0 - cosine;
    let reflected = r0 * r0 + (1.0 - r0 * r0) * rest * rest * rest * rest * rest;
    match field {
        "reflected" => Some(vec![reflected]),
        "transmitted" => Some(vec![1.0 - reflected]),
        _ => None,
    }
}

/// Those of `lobe`.
pub const LOBE: Mistakes = Mistakes {
    questions: &[],
    answers: &[
        (&m::WITH_COS, |question, field, right| by_cosine(question, field, right, 1.0)),
        (&m::WITHOUT_COS, |question, field, right| by_cosine(question, field, right, -1.0)),
        (&m::ETA_MULTIPLIED, |question, field, _| lobe_eta_multiplied(question, field, false)),
        (&m::ETA_MULTIPLIED, |question, field, _| lobe_eta_multiplied(question, field, true)),
        (&m::NO_ETA_SQUARED, |question, field, right| by_eta(question, field, right, 2.0)),
        (&m::ETA_SQUARED_TWICE, |question, field, right| by_eta(question, field, right, -2.0)),
        (&m::ETA_ONCE, |question, field, right| by_eta(question, field, right, 1.0)),
        (&m::REFRACTED_SIGN, |question, field, _| {
            let asked = &question["lobe"];
            let eta = asked["lobe"].as_object()?.values().next()?["eta"].as_f64()?;
            let wo = Vector::from(triple(&asked["wo"])?);
            let (n, eta) = if wo.z() < 0.0 { (-Vector::Z, 1.0 / eta) } else { (Vector::Z, eta) };
            (field == "sample.wi").then(|| wrong_sign(wo, n, eta))?
        }),
        (&m::HIGHLIGHT_OF_HALF_VECTOR, |question, field, right| {
            let asked = &question["lobe"];
            let e = asked["lobe"]["glossy_specular"]["exponent"].as_f64()?;
            let [wi, wo] = ["wi", "wo"].map(|it| triple(&asked[it]).map(Vector::from));
            let (wi, wo) = (wi?, wo?);
            let mirrored = (2.0 * wi.z() * wo.z() - wi.dot(wo)).max(0.0);
            let half = (wi + wo).unit()?.z();
            (field == "f").then(|| times(power(half / mirrored, e), right, field))?
        }),
        (&m::MIRRORED_ONCE, |question, field, _| {
            let wo = triple(&question["lobe"]["wo"])?;
            (field == "sample.wi").then(|| vec![-wo[0], -wo[1], 0.0])
        }),
        (&m::MIRRORED_ONCE, |question, field, _| {
            let wo = triple(&question["lobe"]["wo"])?;
            let along = Vector::new(-wo[0], -wo[1], 0.0).unit()?;
            (field == "sample.wi").then(|| along.to_array().to_vec())
        }),
        (&m::MIRRORED_ONCE, |question, field, right| {
            let asked = &question["lobe"];
            let e = asked["lobe"]["glossy_specular"]["exponent"].as_f64()?;
            let [wi, wo] = ["wi", "wo"].map(|it| triple(&asked[it]).map(Vector::from));
            let (wi, wo) = (wi?, wo?);
            let [once, twice] = [1.0, 2.0].map(|k| k * wi.z() * wo.z() - wi.dot(wo));
            (field == "f").then(|| times(power((once / twice).max(0.0), e), right, field))?
        }),
        (&m::EXPONENT_FOR_DENSITY, |question, field, right| {
            let e = question["lobe"]["lobe"].as_object()?.values().next()?["exponent"].as_f64()?;
            let factor = match field {
                "pdf" => e / (e + 1.0),
                "sample.weight" => (e + 1.0) / e,
                _ => return None,
            };
            times(factor, right, field)
        }),
    ],
};

/// Judges by our own answer.
pub fn lobe(question: &Value, answer: &Value, profile: Profile, rules: &Rules) -> Judgement {
    if question["lobe"]["lobe"].to_string().contains("\"eta\"")
        && answer.get("sample").is_some_and(Value::is_null)
    {
        // a sample that is none: total reflection where there is none, as with an index of 0
        return values::judge(question, answer, profile, rules).with([&m::INDEX_ZERO]);
    }
    // only mirrors and refractions are asked for a sample here
    let is_specular = question["lobe"].get("u").is_some();
    let mut answer = answer.clone();
    if is_specular
        && let Some(pdf) = answer.pointer_mut("/sample/pdf")
        && number(pdf).is_some_and(|pdf| pdf >= 0.0)
    {
        // mirrors have no density: some programs say 1, some 0, ours that it is infinite
        *pdf = json!("inf");
    }
    values::judge(question, &answer, profile, rules)
}

/// The value times this power of the cosine of `wi`.
fn by_cosine(question: &Value, field: &str, right: &Value, exponent: f64) -> Option<Vec<f64>> {
    let cosine = match question["lobe"].get("wi") {
        Some(wi) => triple(wi)?[2],
        None => triple(&right["sample"]["wi"])?[2],
    };
    let factor = power(cosine.abs(), exponent);
    ["f", "pdf", "sample.weight"].contains(&field).then(|| times(factor, right, field))?
}

/// The value times this power of η, the index of the inside over that of the outside.
fn by_eta(question: &Value, field: &str, right: &Value, exponent: f64) -> Option<Vec<f64>> {
    let lobe = question["lobe"]["lobe"].as_object()?.values().next()?;
    times(power(lobe["eta"].as_f64()?, exponent), right, field)
}

fn times(factor: f64, right: &Value, field: &str) -> Option<Vec<f64>> {
    let value = field.split('.').fold(right, |value, key| &value[key]);
    let numbers = match number(value) {
        Some(x) => vec![x],
        None => value.as_array()?.iter().map(number).collect::<Option<Vec<f64>>>()?,
    };
    Some(numbers.into_iter().map(|x| factor * x).collect())
}
