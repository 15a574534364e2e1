//! Streams of samples: mistakes that no single answer shows.

use conform::{Profile, Status};
use serde_json::{Value, json};

use super::altered::{Altered, card_with, data, instead};

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or(0.0)
}

/// Families, what is wrong in them, and the mistake.
type Planted = (&'static [&'static str], &'static str, fn(&Value, Value) -> Value);

const PLANTED: [Planted; 6] = [
    // one sample set in every pixel
    (
        &["samples.jittered.stream", "samples.multi_jittered.stream", "samples.random.stream"],
        "uneven",
        |question, _| instead(question, |data| data["draw"]["pixel"] = json!([0, 0])),
    ),
    // one random number for x and y
    (&["samples.jittered.stream"], "cells", |question, answer| {
        let side = number(&data(question)["n"]).sqrt();
        let [x, y] = [0, 1].map(|i| side * number(&answer[i]));
        json!([x / side, (y.floor() + x.fract()) / side])
    }),
    // points that never move in their cells
    (&["samples.n_rooks.stream"], "cells", |question, answer| {
        let n = number(&data(question)["n"]);
        json!([0, 1].map(|i| ((n * number(&answer[i])).floor() + 0.5) / n))
    }),
    (&["samples.multi_jittered.stream"], "cells", twice),
    (&["samples.n_rooks.stream"], "columns", twice),
    // pixels that share their draws with neighbours
    (&["samples.jittered.stream", "samples.sobol.stream"], "pixels", |question, answer| {
        let draw = &data(question)["draw"];
        let [x, y] = [0, 1].map(|i| draw["pixel"][i].as_u64());
        // the set of one pixel is asked for, too, in row 5
        match (draw["index"].as_u64(), x) {
            (Some(0), Some(x)) if y != Some(5) => {
                instead(question, |data| data["draw"]["pixel"][0] = json!(x / 2))
            }
            _ => answer,
        }
    }),
];

/// Each draw comes twice.
fn twice(question: &Value, _: Value) -> Value {
    instead(question, |data| {
        let index = data["draw"]["index"].as_u64().unwrap_or(0);
        data["draw"]["index"] = json!(index / 2);
    })
}

/// Law: a stream that is not what its sets promise is judged wrong, in this respect. Oracle: the mistake, planted in our
/// own draws.
#[test]
fn mistakes_in_streams_are_found() {
    for (words, symptom, alter) in PLANTED {
        let card = card_with(&mut Altered(alter), words, Profile::Careful, 12, false);
        for row in &card.rows {
            assert!(row.count(Status::Wrong) > 0, "{}: {:?}", row.name, row.counts);
            let failure = row.failure.as_ref().expect("an example");
            assert_eq!(failure.wrong.symptom, symptom, "{}", row.name);
        }
    }
}
