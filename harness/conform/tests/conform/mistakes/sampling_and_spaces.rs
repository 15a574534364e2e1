//! Mistakes in samples, their maps, matrices and grids.

use std::f64::consts::PI;

use conform::mistakes as m;
use groundtruth::math;
use serde_json::{Value, json};

use super::super::altered::{at, data, each, only, swap};
use super::planted::{Answer, Numbers, Question, planted};

planted! {
    "a biased shuffle" in ["samples.multi_jittered.strata", "samples.n_rooks.strata"] => Answer(|_, mut a| {
        // one point is copied over another
        let first = a.pointer("/0/0").cloned().unwrap_or_default();
        if let Some(second) = a.pointer_mut("/0/1") {
            *second = first;
        }
        a
    });
    "samples of 1" in ["samples.jittered.strata", "samples.random.strata"] =>
        Answer(|_, mut a| { a.pointer_mut("/0/0").into_iter().for_each(|point| *point = json!([1.0, 0.5])); a });
    "points that are words" in ["samples.regular.values"] => Answer(|_, mut a| {
        for point in a[0].as_array_mut().into_iter().flatten() {
            *point = json!(["here", "there"]);
        }
        a
    });
    "too few samples" in ["samples.hammersley.values", "samples.regular.strata"] =>
        Answer(|_, mut a| { a.pointer_mut("/0").and_then(Value::as_array_mut).map(Vec::pop); a });
    SWAP_U in ["samples.hammersley.values"] => Answer(|_, mut a| {
        a.pointer_mut("/0")
            .and_then(Value::as_array_mut)
            .into_iter()
            .flatten()
            .for_each(|point| swap(point, 0, 1));
        a
    });
    PLAIN_DISK in ["map.disk.values"] => Answer(|q, a| {
        let Some(u) = data(q)["u"].as_array() else { return a };
        let (r, phi) =
            (u[0].as_f64().unwrap_or(0.0).sqrt(), 2.0 * PI * u[1].as_f64().unwrap_or(0.0));
        json!([r * groundtruth::math::cos(phi), r * groundtruth::math::sin(phi)])
    });
    SWAP_U in ["map.hemisphere.values", "map.sphere.values"] => Question(|data| swap(&mut data["u"], 0, 1));
    EXPONENT_OFF in ["map.hemisphere.values"] =>
        Question(|data| each(&mut data["to"]["hemisphere"]["exponent"], |e| e + 1.0));
    "the inverse of another map" in ["map.sphere.there_and_back"] => Answer(|q, mut a| {
        if !data(q)["point"].is_null() {
            at(&mut a, "/0", |u| 1.0 - u)
        };
        a
    });
    STEPS_REVERSED in ["transform.composed.values"] =>
        Question(|data| { data["steps"].as_array_mut().into_iter().for_each(|steps| steps.reverse()); });
    ROTATIONS_REVERSED in ["transform.rotate.values"] => Question(|data| {
        let steps = data["steps"].as_array_mut().into_iter().flatten();
        steps.for_each(|step| each(only(step), |degrees| -degrees));
    });
    INVERSE_FOR_MATRIX in ["transform.scale.values", "transform.translate.values"] =>
        Answer(|_, a| json!({"matrix": a["inverse"]}));
    TRANSPOSED in ["transform.shear.values"] => Answer(|_, mut a| {
        let m = a["matrix"].clone();
        for i in 0..3 {
            for j in 0..3 {
                a["matrix"][i][j] = m[j][i].clone();
            }
        }
        a
    });
    "the inverse of a shear has the wrong determinant" in ["transform.composed.inverse"] => Answer(|_, mut a| {
        a["inverse"]
            .as_array_mut()
            .into_iter()
            .flatten()
            .for_each(|row| each(row, |x| 1.01 * x));
        a
    });
    ONE_CELL_LESS in ["grid.boxes.resolution"] => Numbers("/resolution", |n| n - 1.0);
    NO_MULTIPLIER in ["grid.boxes.resolution"] => Question(|data| data["multiplier"] = json!(1.0));
    "cells from far to near" in ["grid.boxes.visited"] =>
        Answer(|_, mut a| { a["visited"].as_array_mut().into_iter().for_each(|cells| cells.reverse()); a });
    EXPONENT_LESS in ["map.hemisphere.values"] => Answer(|q, _| {
        let e = data(q)["to"]["hemisphere"]["exponent"].as_f64().unwrap_or(0.0).max(1.0);
        let [u, v] = [0, 1].map(|i| data(q)["u"][i].as_f64().unwrap_or(0.0));
        let (cos, phi) = (math::power(1.0 - v, 1.0 / e), 2.0 * PI * u);
        let sin = (1.0 - cos * cos).sqrt();
        json!([sin * math::cos(phi), sin * math::sin(phi), cos])
    });
}
