//! Mistakes in lobes and Fresnel's equations.

use std::f64::consts::PI;

use conform::mistakes as m;
use conform::ours;
use groundtruth::math::power;
use serde_json::json;

use super::super::altered::{at, data, each, instead, only, swap, vector};
use super::{Planted, planted};

/// All of them.
pub fn planted_here() -> Vec<Planted> {
    const FRESNEL: &[&str] = &["fresnel.cosine", "fresnel.directions"];
    const DIFFUSE: &[&str] = &["lobe.lambertian.values"];
    vec![
        planted("η upside down", FRESNEL, Some(&m::ETA_INVERTED), |q, _| {
            instead(q, |data| each(&mut data["eta"], |eta| 1.0 / eta))
        }),
        planted(
            "one polarisation (s)",
            FRESNEL,
            Some(&m::FRESNEL_PERPENDICULAR_ONLY),
            |_, a| json!({"reflected": a["r_s"], "transmitted": a["t_s"]}),
        ),
        planted(
            "one polarisation (p)",
            FRESNEL,
            Some(&m::FRESNEL_PARALLEL_ONLY),
            |_, a| json!({"reflected": a["r_p"], "transmitted": a["t_p"]}),
        ),
        planted("Schlick", &["fresnel.cosine"], Some(&m::SCHLICK), |q, _| {
            let [eta, c] = ["eta", "cos_i"].map(|name| data(q)[name].as_f64().unwrap_or(1.0));
            let r0 = power((eta - 1.0) / (eta + 1.0), 2.0);
            json!({"reflected": r0 + (1.0 - r0) * power(1.0 - c, 5.0)})
        }),
        planted(
            "the amplitude",
            &["fresnel.cosine"],
            Some(&m::ROOT),
            |_, a| json!({"reflected": a["reflected"].as_f64().unwrap_or(0.0).sqrt()}),
        ),
        planted(
            "transmitted for reflected",
            &["fresnel.cosine"],
            Some(&m::COMPLEMENT),
            |_, a| json!({"reflected": a["transmitted"]}),
        ),
        planted(
            "refracted to the front",
            &["fresnel.directions"],
            Some(&m::NEGATED),
            |_, mut a| {
                at(&mut a, "/refracted", |x| -x);
                a
            },
        ),
        planted(
            "reflected for refracted",
            &["fresnel.directions"],
            Some(&m::REFLECTED_INSTEAD),
            |q, mut a| {
                let wo = vector(&data(q)["wo"]);
                if !a["refracted"].is_null() {
                    a["refracted"] = json!([-wo[0], -wo[1], wo[2]]);
                }
                a
            },
        ),
        planted(
            "η ωo for ωo/η",
            &["fresnel.directions"],
            Some(&m::ETA_MULTIPLIED),
            |q, mut a| {
                let (wo, eta) = (vector(&data(q)["wo"]), data(q)["eta"].as_f64().unwrap_or(1.0));
                let right = vector(&a["refracted"]);
                if !a["refracted"].is_null() {
                    a["refracted"] = json!([0, 1, 2].map(|i| right[i] + wo[i] / eta - eta * wo[i]));
                }
                a
            },
        ),
        planted(
            "an index of 0",
            &["fresnel.cosine"],
            Some(&m::INDEX_ZERO),
            |_, _| json!({"reflected": 1.0, "transmitted": 0.0}),
        ),
        planted(
            "a transmitter without an index",
            &["lobe.perfect_transmitter.values"],
            Some(&m::INDEX_ZERO),
            |_, mut a| {
                a["sample"] = json!(null);
                a
            },
        ),
        planted("colours the other way round", DIFFUSE, Some(&m::SWAP_RB), |_, mut a| {
            a.pointer_mut("/f").into_iter().for_each(|f| swap(f, 0, 2));
            a
        }),
        planted("a lobe that is black", DIFFUSE, Some(&m::BLACK), |_, mut a| {
            at(&mut a, "/f", |_| 0.0);
            a
        }),
        planted("the mean of amplitudes", FRESNEL, Some(&m::MEAN_OF_AMPLITUDES), |_, a| {
            let [s, p] = ["r_s", "r_p"].map(|it| a[it].as_f64().unwrap_or(0.0).sqrt());
            json!({"reflected": (s + p) / 2.0})
        }),
        planted("light is lost", &["fresnel.shares"], None, |_, mut a| {
            at(&mut a, "/transmitted", |x| 0.95 * x - 0.01);
            a
        }),
        planted("1/π left out", DIFFUSE, Some(&m::TIMES_PI), |_, mut a| {
            at(&mut a, "/f", |x| PI * x);
            a
        }),
        planted("1/π twice", DIFFUSE, Some(&m::OVER_PI), |_, mut a| {
            at(&mut a, "/f", |x| x / PI);
            a
        }),
        planted("the cosine in f", DIFFUSE, Some(&m::WITH_COS), |q, mut a| {
            let z = data(q)["wi"][2].as_f64().unwrap_or(1.0);
            at(&mut a, "/f", |x| z * x);
            a
        }),
        planted("a density without the cosine", DIFFUSE, Some(&m::WITHOUT_COS), |q, mut a| {
            let z = data(q)["wi"][2].as_f64().unwrap_or(1.0);
            at(&mut a, "/pdf", |x| x / z);
            a
        }),
        planted(
            "uniform directions for cosine-distributed ones",
            &["lobe.lambertian.density"],
            None,
            |q, mut a| {
                if !data(q)["u"].is_null() {
                    let point = ours(
                        &json!({"map": {"to": {"hemisphere": {"exponent": 0.0}}, "u": data(q)["u"]}}),
                    );
                    a["sample"]["wi"] = point.unwrap_or_default();
                }
                a
            },
        ),
        planted("samples too narrow", &["lobe.glossy_specular.density"], None, |q, _| {
            instead(q, |data| each(&mut data["u"][1], |u| 0.5 + 0.5 * u))
        }),
        planted(
            "1/η² left out",
            &["lobe.perfect_transmitter.values"],
            Some(&m::NO_ETA_SQUARED),
            |q, mut a| {
                let eta = data(q)["lobe"]["perfect_transmitter"]["eta"].as_f64().unwrap_or(1.0);
                let is_through = !a["sample"].is_null();
                if is_through {
                    at(&mut a, "/sample/weight", |x| x * eta * eta)
                };
                a
            },
        ),
        planted("the exponent of e + 1", &["lobe.glossy_specular.values"], None, |q, _| {
            instead(q, |data| each(&mut only(&mut data["lobe"])["exponent"], |e| e + 1.0))
        }),
        planted(
            "f depends on the viewer's cosine",
            &["lobe.lambertian.reciprocity"],
            None,
            |q, mut a| {
                let z = data(q)["wo"][2].as_f64().unwrap_or(1.0);
                at(&mut a, "/f", |x| z * x);
                a
            },
        ),
        planted("a weight without the cosine", &["lobe.lambertian.sample"], None, |_, mut a| {
            if !a["sample"].is_null() {
                let z = a["sample"]["wi"][2].as_f64().unwrap_or(1.0);
                at(&mut a, "/sample/weight", |x| x / z);
            }
            a
        }),
        planted(
            "a cosine too much in a mirror's weight",
            &["lobe.perfect_specular.values"],
            Some(&m::WITH_COS),
            |_, mut a| {
                let z = a["sample"]["wi"][2].as_f64().unwrap_or(1.0);
                at(&mut a, "/sample/weight", |x| z * x);
                a
            },
        ),
        planted(
            "a mirror's f for its weight",
            &["lobe.perfect_specular.values"],
            Some(&m::WITHOUT_COS),
            |_, mut a| {
                let z = a["sample"]["wi"][2].as_f64().unwrap_or(1.0);
                at(&mut a, "/sample/weight", |x| x / z);
                a
            },
        ),
        planted("more light than arrives", &["lobe.lambertian.energy"], None, |_, mut a| {
            at(&mut a, "/albedo", |x| 1.0 + x);
            a
        }),
        planted(
            "the mirror sends light back",
            &["lobe.perfect_specular.values"],
            None,
            |q, mut a| {
                a["sample"]["wi"] = data(q)["wo"].clone();
                a
            },
        ),
    ]
}
