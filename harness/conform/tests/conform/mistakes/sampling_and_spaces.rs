//! Mistakes in samples, their maps, matrices and grids.

use std::f64::consts::PI;

use conform::mistakes as m;
use groundtruth::math;
use serde_json::{Value, json};

use super::super::altered::{at, data, each, instead, only, swap};
use super::{Planted, planted};

/// All of them.
pub fn planted_here() -> Vec<Planted> {
    vec![
        planted(
            "a biased shuffle",
            &["samples.multi_jittered.strata", "samples.n_rooks.strata"],
            None,
            |_, mut a| {
                // one point is copied over another
                let first = a.pointer("/0/0").cloned().unwrap_or_default();
                if let Some(second) = a.pointer_mut("/0/1") {
                    *second = first;
                }
                a
            },
        ),
        planted(
            "samples of 1",
            &["samples.jittered.strata", "samples.random.strata"],
            None,
            |_, mut a| {
                a.pointer_mut("/0/0").into_iter().for_each(|point| *point = json!([1.0, 0.5]));
                a
            },
        ),
        planted("points that are words", &["samples.regular.values"], None, |_, mut a| {
            for point in a[0].as_array_mut().into_iter().flatten() {
                *point = json!(["here", "there"]);
            }
            a
        }),
        planted(
            "too few samples",
            &["samples.hammersley.values", "samples.regular.strata"],
            None,
            |_, mut a| {
                a.pointer_mut("/0").and_then(Value::as_array_mut).map(Vec::pop);
                a
            },
        ),
        planted(
            "x and y of Hammersley's set swapped",
            &["samples.hammersley.values"],
            Some(&m::SWAP_U),
            |_, mut a| {
                a.pointer_mut("/0")
                    .and_then(Value::as_array_mut)
                    .into_iter()
                    .flatten()
                    .for_each(|point| swap(point, 0, 1));
                a
            },
        ),
        planted(
            "polar coordinates for the concentric map",
            &["map.disk.values"],
            Some(&m::PLAIN_DISK),
            |q, a| {
                let Some(u) = data(q)["u"].as_array() else { return a };
                let (r, phi) =
                    (u[0].as_f64().unwrap_or(0.0).sqrt(), 2.0 * PI * u[1].as_f64().unwrap_or(0.0));
                json!([r * groundtruth::math::cos(phi), r * groundtruth::math::sin(phi)])
            },
        ),
        planted(
            "u and v swapped",
            &["map.hemisphere.values", "map.sphere.values"],
            Some(&m::SWAP_U),
            |q, _| instead(q, |data| swap(&mut data["u"], 0, 1)),
        ),
        planted("exponent e + 1", &["map.hemisphere.values"], Some(&m::EXPONENT_OFF), |q, _| {
            instead(q, |data| each(&mut data["to"]["hemisphere"]["exponent"], |e| e + 1.0))
        }),
        planted("the inverse of another map", &["map.sphere.there_and_back"], None, |q, mut a| {
            if !data(q)["point"].is_null() {
                at(&mut a, "/0", |u| 1.0 - u)
            };
            a
        }),
        planted(
            "steps last to first",
            &["transform.composed.values"],
            Some(&m::REVERSED_STEPS),
            |q, _| {
                instead(q, |data| {
                    data["steps"].as_array_mut().into_iter().for_each(|steps| steps.reverse());
                })
            },
        ),
        planted(
            "turned backwards",
            &["transform.rotate.values"],
            Some(&m::TURNED_BACKWARDS),
            |q, _| {
                instead(q, |data| {
                    let steps = data["steps"].as_array_mut().into_iter().flatten();
                    steps.for_each(|step| each(only(step), |degrees| -degrees));
                })
            },
        ),
        planted(
            "inverse for matrix",
            &["transform.scale.values", "transform.translate.values"],
            Some(&m::INVERSE_FOR_MATRIX),
            |_, a| json!({"matrix": a["inverse"]}),
        ),
        planted(
            "rows for columns",
            &["transform.shear.values"],
            Some(&m::TRANSPOSED),
            |_, mut a| {
                let m = a["matrix"].clone();
                for i in 0..3 {
                    for j in 0..3 {
                        a["matrix"][i][j] = m[j][i].clone();
                    }
                }
                a
            },
        ),
        planted(
            "the inverse of a shear has the wrong determinant",
            &["transform.composed.inverse"],
            None,
            |_, mut a| {
                a["inverse"]
                    .as_array_mut()
                    .into_iter()
                    .flatten()
                    .for_each(|row| each(row, |x| 1.01 * x));
                a
            },
        ),
        planted(
            "one cell less",
            &["grid.boxes.resolution"],
            Some(&m::ONE_CELL_LESS),
            |_, mut a| {
                at(&mut a, "/resolution", |n| n - 1.0);
                a
            },
        ),
        planted("no multiplier", &["grid.boxes.resolution"], Some(&m::NO_MULTIPLIER), |q, _| {
            instead(q, |data| data["multiplier"] = json!(1.0))
        }),
        planted("cells from far to near", &["grid.boxes.visited"], None, |_, mut a| {
            a["visited"].as_array_mut().into_iter().for_each(|cells| cells.reverse());
            a
        }),
        planted("e for e + 1", &["map.hemisphere.values"], Some(&m::EXPONENT_LESS), |q, _| {
            let e = data(q)["to"]["hemisphere"]["exponent"].as_f64().unwrap_or(0.0).max(1.0);
            let [u, v] = [0, 1].map(|i| data(q)["u"][i].as_f64().unwrap_or(0.0));
            let (cos, phi) = (math::power(1.0 - v, 1.0 / e), 2.0 * PI * u);
            let sin = (1.0 - cos * cos).sqrt();
            json!([sin * math::cos(phi), sin * math::sin(phi), cos])
        }),
    ]
}
