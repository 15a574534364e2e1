//! Mistakes in samples, their maps, matrices and grids.

use std::f64::consts::PI;

use conform::mistakes as m;
use serde_json::json;

use super::super::altered::{at, data};
use super::planted::{Answer, Question, planted};

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
    PLAIN_DISK in ["map.disk.values"] => Answer(|q, a| {
        let Some(u) = data(q)["u"].as_array() else { return a };
        let (r, phi) =
            (u[0].as_f64().unwrap_or(0.0).sqrt(), 2.0 * PI * u[1].as_f64().unwrap_or(0.0));
        json!([r * groundtruth::math::cos(phi), r * groundtruth::math::sin(phi)])
    });
    "the inverse of another map" in ["map.sphere.there_and_back"] => Answer(|q, mut a| {
        if !data(q)["point"].is_null() {
            at(&mut a, "/0", |u| 1.0 - u)
        };
        a
    });
    PIXELS_ALIKE in ["samples.jittered.stream"] => Question(|data| {
        data.pointer_mut("/draw/pixel").into_iter().for_each(|pixel| *pixel = json!([3, 5]));
    });
    ROTATION_Z_REVERSED in ["transform.composed.values"] => Question(|data| {
        for step in data["steps"].as_array_mut().into_iter().flatten() {
            at(step, "/rotate_z", |degrees| -degrees);
        }
    });
    STEPS_REVERSED in ["transform.composed.values"] =>
        Question(|data| { data["steps"].as_array_mut().into_iter().for_each(|steps| steps.reverse()); });
    TRANSPOSED in ["transform.shear.values"] => Answer(|_, mut a| {
        let m = a["matrix"].clone();
        for i in 0..3 {
            for j in 0..3 {
                a["matrix"][i][j] = m[j][i].clone();
            }
        }
        a
    });
    "cells from far to near" in ["grid.boxes.visited"] =>
        Answer(|_, mut a| { a["visited"].as_array_mut().into_iter().for_each(|cells| cells.reverse()); a });
}
