//! A light under questions: what it sends to a point, its density and samples, for given parameters.

use ask::{Draw, Stop, number, triple};
use groundtruth::math::{Normal, Point, Vector};
use serde_json::{Value, json};

use crate::asked::{Asked, BATCH, Numbers, color, list, needed};
use crate::description::Claims;
use crate::laws::Integrated;
use crate::lobe::Evaluated;
use crate::measured::{Measured, measured};
use crate::naming::Given;

/// A case of a light: parameters, and a point that is lit.
pub struct LightCase<'a> {
    /// What is asked.
    pub asked: Asked<'a>,
    /// What the light claims.
    pub claims: &'a Claims,
    /// The relative rounding of the program's numbers.
    pub rounding: f64,
    /// The box that holds the points.
    pub points: [[f64; 3]; 2],
    /// The point that is lit.
    pub from: Point,
    /// Of the directions and numbers of this case.
    pub draw: Draw,
    /// Counts and integrals that several laws need.
    pub integrated: Option<Integrated>,
}

/// The answer of `eval` for one direction.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// Radiance in place of f, and the density of `sample`.
    pub value: Evaluated,
    /// The distance of the light and the cosine there, if they are told.
    pub given: Given,
}

/// The answer of `sample` for one list of random numbers.
#[derive(Clone, Copy, Debug)]
pub struct LightSample {
    /// The numbers.
    pub u: Numbers,
    /// The direction to the light.
    pub wi: Vector,
    /// The distance of its point; infinite if none is told.
    pub distance: f64,
    /// The cosine between its normal and the direction back; NaN if no normal is told.
    pub cosine: f64,
    /// What arrives.
    pub radiance: [f64; 3],
    /// Per steradian; `None` for a single direction, which has none.
    pub pdf: Option<f64>,
}

impl LightSample {
    /// Whether light arrives.
    pub fn is_lit(&self) -> bool {
        self.radiance != [0.0; 3]
    }

    /// What factors are functions of.
    pub fn given(&self) -> Given {
        let (distance, cosine) = (self.distance, self.cosine);
        Given { distance, cosine, ..Given::of(Vector::Z, self.wi, 1.0) }
    }
}

impl LightCase<'_> {
    /// The question for what comes from these directions.
    pub fn eval_question(&self, from: Point, wi: &[Vector]) -> Value {
        let wi: Value = wi.iter().map(|wi| json!(wi.to_array())).collect();
        self.asked.question("eval", [("from", json!(from.to_array())), ("wi", wi)])
    }

    /// The question for the samples of these numbers.
    pub fn sample_question(&self, u: &[Numbers]) -> Value {
        self.asked.question("sample", [("from", json!(self.from.to_array())), ("u", json!(u))])
    }

    /// What comes to a point from these directions.
    ///
    /// # Errors
    /// Says why there is no answer.
    pub fn eval(&mut self, from: Point, wi: &[Vector]) -> Result<Vec<Seen>, Stop> {
        let questions: Vec<Value> =
            wi.chunks(BATCH).map(|wi| self.eval_question(from, wi)).collect();
        let mut all = Vec::with_capacity(wi.len());
        for (answer, wi) in self.asked.answers(&questions)?.iter().zip(wi.chunks(BATCH)) {
            let values = |key: &str| list(&answer[key], &format!("`{key}`"), wi.len());
            let told = |key: &str| match answer[key].is_null() {
                true => Ok(None),
                false => values(key).map(Some),
            };
            let (distances, normals) = (told("distance")?, told("normal")?);
            let pairs = values("radiance")?.iter().zip(values("pdf")?).zip(wi);
            for (i, ((radiance, pdf), wi)) in pairs.enumerate() {
                let f = needed(color(radiance), "radiance", radiance)?;
                let pdf = needed(number(pdf), "pdf", pdf)?;
                let mut given = Given::of(Vector::Z, *wi, 1.0);
                given.distance = distances.and_then(|all| number(&all[i])).unwrap_or(f64::NAN);
                given.cosine = cosine(normals.map_or(&Value::Null, |all| &all[i]), *wi);
                all.push(Seen { value: Evaluated { f, pdf }, given });
            }
        }
        Ok(all)
    }

    /// The samples of fresh numbers; `None` where no light comes from.
    ///
    /// # Errors
    /// Says why there are none.
    pub fn samples(&mut self, count: usize) -> Result<Vec<Option<LightSample>>, Stop> {
        let u: Vec<Numbers> =
            (0..count).map(|_| std::array::from_fn(|_| self.draw.between(0.0, 1.0))).collect();
        let questions: Vec<Value> = u.chunks(BATCH).map(|u| self.sample_question(u)).collect();
        let mut all = Vec::with_capacity(count);
        for (answer, u) in self.asked.answers(&questions)?.iter().zip(u.chunks(BATCH)) {
            for (it, u) in list(answer, "the answer to `sample`", u.len())?.iter().zip(u) {
                all.push(if it.is_null() { None } else { Some(sampled(it, *u)?) });
            }
        }
        Ok(all)
    }

    /// Values in these directions, and what rounding may do to them.
    ///
    /// # Errors
    /// Says why there are none.
    pub fn measured(&mut self, from: Point, wi: &[Vector]) -> Result<Vec<Measured>, Stop> {
        let rounding = self.rounding;
        measured(wi, rounding, |wi| {
            Ok(self.eval(from, wi)?.into_iter().map(|it| it.value).collect())
        })
    }

    /// Directions all over the sphere.
    pub fn directions(&mut self, count: usize) -> Vec<Vector> {
        (0..count).map(|_| Vector::from(self.draw.direction())).collect()
    }
}

/// The cosine between a normal and the way back; NaN without a normal.
fn cosine(normal: &Value, wi: Vector) -> f64 {
    let normal = triple(normal).and_then(|n| Normal::new(n.into()));
    normal.map_or(f64::NAN, |n| n.dot(wi).abs())
}

fn sampled(sample: &Value, u: Numbers) -> Result<LightSample, Stop> {
    let wi = Vector::from(needed(triple(&sample["wi"]), "wi", &sample["wi"])?);
    let radiance = needed(color(&sample["radiance"]), "radiance", &sample["radiance"])?;
    let real = |key: &str| match &sample[key] {
        Value::Null => Ok(None),
        value => needed(number(value), key, value).map(Some),
    };
    let (pdf, distance) = (real("pdf")?, real("distance")?.unwrap_or(f64::INFINITY));
    Ok(LightSample { u, wi, distance, cosine: cosine(&sample["normal"], wi), radiance, pdf })
}
