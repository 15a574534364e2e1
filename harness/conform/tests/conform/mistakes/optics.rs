//! Mistakes in lobes and Fresnel's equations.

use std::f64::consts::PI;

use conform::mistakes as m;
use conform::ours;
use groundtruth::math::power;
use serde_json::{Value, json};

use super::super::altered::{data, each, swap, vector, with};
use super::planted::{Answer, Numbers, Question, planted};

const FRESNEL: [&str; 2] = ["fresnel.cosine", "fresnel.directions"];
const DIFFUSE: [&str; 1] = ["lobe.lambertian.values"];

planted! {
    ETA_INVERTED in FRESNEL => Question(|data| each(&mut data["eta"], |eta| 1.0 / eta));
    SCHLICK in ["fresnel.cosine"] => Answer(|q, _| {
        let [eta, c] = ["eta", "cos_i"].map(|name| data(q)[name].as_f64().unwrap_or(1.0));
        let r0 = power((eta - 1.0) / (eta + 1.0), 2.0);
        json!({"reflected": r0 + (1.0 - r0) * power(1.0 - c, 5.0)})
    });
    POLARISATIONS_EXCHANGED in ["fresnel.cosine"] => Answer(|_, mut a| {
        for [s, p] in [["r_s", "r_p"], ["t_s", "t_p"]] {
            (a[s], a[p]) = (a[p].clone(), a[s].clone());
        }
        a
    });
    ROOT in ["fresnel.cosine"] => Answer(|_, a| json!({"reflected": a["reflected"].as_f64().unwrap_or(0.0).sqrt()}));
    COMPLEMENT in ["fresnel.cosine"] => Answer(|_, a| json!({"reflected": a["transmitted"]}));
    NEGATED in ["fresnel.directions"] => Numbers("/refracted", |x| -x);
    REFLECTED_INSTEAD in ["fresnel.directions"] => Answer(|q, mut a| {
        let wo = vector(&data(q)["wo"]);
        if !a["refracted"].is_null() {
            a["refracted"] = json!([-wo[0], -wo[1], wo[2]]);
        }
        a
    });
    ETA_MULTIPLIED in ["fresnel.directions"] => Answer(|q, mut a| {
        let (wo, eta) = (vector(&data(q)["wo"]), data(q)["eta"].as_f64().unwrap_or(1.0));
        let right = vector(&a["refracted"]);
        if !a["refracted"].is_null() {
            a["refracted"] = json!([0, 1, 2].map(|i| right[i] + wo[i] / eta - eta * wo[i]));
        }
        a
    });
    INDEX_ZERO in ["lobe.perfect_transmitter.values"] => Answer(|_, mut a| { a["sample"] = json!(null); a });
    SWAP_RB in DIFFUSE => Answer(|_, mut a| { a.pointer_mut("/f").into_iter().for_each(|f| swap(f, 0, 2)); a });
    BLACK in DIFFUSE => Numbers("/f", |_| 0.0);
    MEAN_OF_AMPLITUDES in FRESNEL => Answer(|_, a| {
        let [s, p] = ["r_s", "r_p"].map(|it| a[it].as_f64().unwrap_or(0.0).sqrt());
        json!({"reflected": (s + p) / 2.0})
    });
    "light is lost" in ["fresnel.shares"] => Numbers("/transmitted", |x| 0.95 * x - 0.01);
    OVER_PI in DIFFUSE => Numbers("/f", |x| x / PI);
    WITH_COS in DIFFUSE =>
        Answer(|q, a| { let z = data(q)["wi"][2].as_f64().unwrap_or(1.0); with(a, "/f", |x| z * x) });
    WITHOUT_COS in DIFFUSE =>
        Answer(|q, a| { let z = data(q)["wi"][2].as_f64().unwrap_or(1.0); with(a, "/pdf", |x| x / z) });
    "uniform directions for cosine-distributed ones" in ["lobe.lambertian.density"] => Answer(|q, mut a| {
        if !data(q)["u"].is_null() {
            let point = ours(
                &json!({"map": {"to": {"hemisphere": {"exponent": 0.0}}, "u": data(q)["u"]}}),
            );
            a["sample"]["wi"] = point.unwrap_or_default();
        }
        a
    });
    "samples too narrow" in ["lobe.glossy_specular.density"] =>
        Question(|data| each(&mut data["u"][1], |u| 0.5 + 0.5 * u));
    NO_ETA_SQUARED in ["lobe.perfect_transmitter.values"] => Answer(|q, a| {
        let eta = data(q)["lobe"]["perfect_transmitter"]["eta"].as_f64().unwrap_or(1.0);
        with(a, "/sample/weight", |x| x * eta * eta)
    });
    "f depends on the viewer's cosine" in ["lobe.lambertian.reciprocity"] =>
        Answer(|q, a| { let z = data(q)["wo"][2].as_f64().unwrap_or(1.0); with(a, "/f", |x| z * x) });
    "a weight without the cosine" in ["lobe.lambertian.sample"] => Answer(without_cosine);
    WITH_COS in ["lobe.perfect_specular.values"] =>
        Answer(|_, a| { let z = a["sample"]["wi"][2].as_f64().unwrap_or(1.0); with(a, "/sample/weight", |x| z * x) });
    WITHOUT_COS in ["lobe.perfect_specular.values"] => Answer(without_cosine);
    MIRRORED_ONCE in ["lobe.glossy_specular.values"] => Answer(|q, a| {
        let [wi, wo] = ["wi", "wo"].map(|it| vector(&data(q)[it]));
        let flat = wi[0] * wo[0] + wi[1] * wo[1];
        let lobe = &data(q)["lobe"]["glossy_specular"];
        let e = lobe["exponent"].as_f64().unwrap_or(1.0);
        let [once, twice] = [0.0, 1.0].map(|k| k * wi[2] * wo[2] - flat);
        with(a, "/f", |f| f * power(once.max(0.0) / twice, e))
    });
    "more light than arrives" in ["lobe.lambertian.energy"] => Numbers("/albedo", |x| 1.0 + x);
}

/// The weight of a sample without the cosine in it.
fn without_cosine(_: &Value, answer: Value) -> Value {
    let z = answer["sample"]["wi"][2].as_f64().unwrap_or(1.0);
    with(answer, "/sample/weight", |x| x / z)
}
