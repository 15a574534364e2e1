//! Claims of lobes that have a density: of random numbers of their own, and of losing no light; and factors by name.

use ask::{Draw, Reply, Subject, numbers};
use serde_json::{Value, json};

use super::right::card;
use super::subject::Adapter;

const PI: f64 = std::f64::consts::PI;

/// Lambert's lobe with a random generator of its own, or one that looks at `u`, whatever it claims.
struct Lambert {
    claims: Value,
    albedo: f64,
    own: Option<Draw>,
}

impl Lambert {
    fn values(&self, wo: &Value, wi: &Value) -> [f64; 2] {
        let [o, i] = [wo, wi].map(|w| numbers(w).expect("a direction")[2]);
        if o * i > 0.0 { [self.albedo / PI, i.abs() / PI] } else { [0.0, 0.0] }
    }

    fn sample(&mut self, wo: &Value, u: &Value) -> Value {
        let u = numbers(u).expect("numbers");
        let (a, b) = match &mut self.own {
            Some(draw) => (draw.between(0.0, 1.0), draw.between(0.0, 1.0)),
            None => (u[0], u[1]),
        };
        let (r, phi) = (a.sqrt(), 2.0 * PI * b);
        let [x, y] = [groundtruth::math::cos(phi), groundtruth::math::sin(phi)].map(|c| r * c);
        let z = (1.0 - a).sqrt().copysign(numbers(wo).expect("a direction")[2]);
        json!({"wi": [x, y, z], "weight": self.albedo, "pdf": z.abs() / PI})
    }
}

impl Subject for Lambert {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let mut answer = |question: &Value| {
            if question.get("list").is_some() {
                return json!([{"name": "lambert", "claims": self.claims}]);
            }
            if let Some(data) = question.get("eval") {
                let wi = data["wi"].as_array().expect("a list").iter();
                let values: Vec<[f64; 2]> = wi.map(|wi| self.values(&data["wo"], wi)).collect();
                let column = |k: usize| values.iter().map(|it| it[k]).collect::<Vec<f64>>();
                return json!({"f": column(0), "pdf": column(1)});
            }
            let data = &question["sample"];
            let u = data["u"].as_array().expect("a list").iter();
            u.map(|u| self.sample(&data["wo"], u)).collect()
        };
        questions.iter().map(|question| Ok(answer(question))).collect()
    }
}

/// The first law that is broken with these claims, this albedo, and random numbers of its own or those given.
fn first(claims: Value, albedo: f64, is_own: bool) -> Option<&'static str> {
    let own = is_own.then(|| Draw::new(11));
    let card = card(&mut Lambert { claims, albedo, own }, 3, 1);
    Some(card.rows[0].broken().next()?.0.name)
}

/// Law: a lobe that draws its own numbers keeps all laws if it says so, and breaks that of repetition if it does not.
/// Oracle: Lambert's lobe.
#[test]
fn lobes_with_numbers_of_their_own_say_so() {
    assert_eq!(first(json!({"random": true, "reciprocal": true}), 0.7, true), None);
    assert_eq!(first(json!({"reciprocal": true}), 0.7, true), Some("repeated"));
    // the claim excuses nothing else
    assert_eq!(first(json!({"random": true}), 1.2, true), Some("albedo"));
}

/// Law: a lobe with a density that claims to lose nothing has albedo 1; a loss of one percent is found. Oracle: its albedo.
#[test]
fn lobes_that_lose_nothing_have_albedo_1() {
    assert_eq!(first(json!({"lossless": true}), 1.0, false), None);
    assert_eq!(first(json!({"lossless": true}), 0.99, false), Some("albedo"));
    assert_eq!(first(json!({}), 0.99, false), None);
}

/// Law: 1/η² that is left out on both ways is named as η⁴. Oracle: what was planted.
#[test]
fn the_square_of_the_index_left_out_twice_is_named() {
    let card = card(&mut Adapter::new(&["rough_dielectric"], "no 1/eta²", false), 4, 1);
    let broken = card.rows[0].broken().find(|(law, _)| law.name == "reciprocal");
    let (_, broken) = broken.expect("it is found");
    let mistake = broken.breach.mistake.as_deref().unwrap_or_default();
    assert!(mistake.contains("η⁴ (1/η² left out on both ways)"), "{card}");
}
