//! The tracer's own lobes as subjects: what they promise, they keep.

use ask::{Reply, Subject, numbers};
use claims::ClaimsCard;
use groundtruth::lobes::{Lobe, LobeSample};
use groundtruth::math::Vector;
use serde_json::{Value, json};

use super::right::card;

/// All specimens of all kinds of lobes, each with a name.
struct Own(Vec<(String, Lobe)>);

impl Own {
    fn new() -> Self {
        let of = |entry: &groundtruth::kinds::Entry<Lobe>| {
            let (module, specimens) = (entry.module, (entry.specimens)());
            (1..).zip(specimens).map(move |(i, lobe)| (format!("{module} {i}"), lobe)).collect()
        };
        Self(Lobe::ENTRIES.iter().flat_map::<Vec<_>, _>(of).collect())
    }
}

fn vector(value: &Value) -> Vector {
    let v = numbers(value).expect("a direction");
    Vector::new(v[0], v[1], v[2])
}

fn described((name, lobe): &(String, Lobe)) -> Value {
    let is_delta = lobe.is_specular();
    let transmits = lobe.sample(Vector::Z, [0.3, 0.4]).is_some_and(|sample| sample.wi.z() < 0.0);
    let mut claims = json!({
        "reciprocal": lobe.claims().reciprocal && !is_delta, "delta": is_delta,
        "sides": if transmits { "transmits" } else { "reflects" }, "from_below": true, "isotropic": true,
    });
    if let Some(eta) = lobe.relative_eta(Vector::Z) {
        claims["eta"] = json!(eta);
    }
    json!({"name": name, "claims": claims})
}

impl Subject for Own {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let answer = |question: &Value| -> Value {
            if question.get("list").is_some() {
                return self.0.iter().map(described).collect();
            }
            let is_eval = question.get("eval").is_some();
            let data = &question[if is_eval { "eval" } else { "sample" }];
            let (_, lobe) = self.0.iter().find(|(name, _)| data["lobe"] == **name).expect("listed");
            let wo = vector(&data["wo"]);
            let list = |key: &str| data[key].as_array().expect("a list").iter();
            if is_eval {
                let wi: Vec<Vector> = list("wi").map(vector).collect();
                let f: Vec<[f64; 3]> = wi.iter().map(|wi| lobe.f(wo, *wi).to_array()).collect();
                let pdf: Vec<f64> = wi.iter().map(|wi| lobe.pdf(wo, *wi)).collect();
                return json!({"f": f, "pdf": pdf});
            }
            let shown = |it: LobeSample| json!({"wi": it.wi.to_array(), "weight": it.weight.to_array(), "pdf": it.pdf});
            let drawn = list("u").map(|u| {
                let u = numbers(u).expect("numbers");
                lobe.sample(wo, [u[0], u[1]])
            });
            drawn.map(|it| it.map_or(Value::Null, shown)).collect()
        };
        questions.iter().map(|question| Ok(answer(question))).collect()
    }
}

/// The laws that a row breaks.
fn broken(card: &ClaimsCard, name: &str) -> Vec<&'static str> {
    let row = card.rows.iter().find(|row| row.name == name).expect("it was asked");
    row.broken().map(|(law, _)| law.name).collect()
}

/// Law: each lobe of the tracer keeps all laws, but for the energy that the book's highlights create: they do not promise
/// it. Oracle: the laws, which know nothing of the tracer, and what each lobe promises.
#[test]
fn own_lobes_keep_what_they_promise() {
    let mut own = Own::new();
    let card = card(&mut own, 3, 1);
    assert!(own.0.len() > 10);
    for (name, lobe) in &own.0 {
        let mut broken = broken(&card, name);
        if !lobe.claims().conserves_energy {
            broken.retain(|law| *law != "albedo");
        }
        assert!(broken.is_empty(), "{name} breaks {broken:?}\n{card}");
    }
}
