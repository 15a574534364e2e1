//! Streams of samples: mistakes that no single answer shows.

use conform::{Profile, Status};
use serde_json::{Value, json};

use super::altered::{Altered, card_with, data, instead};

/// Law: a stream that is not what its sets promise is judged wrong, in this respect. Oracle: the mistake, planted in our
/// own draws.
fn is_found(words: &[&str], symptom: &str, alter: fn(&Value, Value) -> Value) {
    let card = card_with(&mut Altered(alter), words, Profile::Careful, 12, false);
    for row in &card.rows {
        assert!(row.count(Status::Wrong) > 0, "{}: {:?}", row.name, row.counts);
        let failure = row.failure.as_ref().expect("an example");
        assert_eq!(failure.wrong.symptom, symptom, "{}", row.name);
    }
}

#[test]
fn one_sample_set_in_every_pixel_is_found() {
    let all = ["samples.jittered.stream", "samples.multi_jittered.stream", "samples.random.stream"];
    is_found(&all, "uneven", |question, _| {
        instead(question, |data| data["draw"]["pixel"] = json!([0, 0]))
    });
}

#[test]
fn one_random_number_for_x_and_y_is_found() {
    is_found(&["samples.jittered.stream"], "cells", |question, answer| {
        let side = data(question)["n"].as_f64().unwrap_or(0.0).sqrt();
        let [x, y] = [0, 1].map(|i| side * answer[i].as_f64().unwrap_or(0.0));
        json!([x / side, (y.floor() + x.fract()) / side])
    });
}

#[test]
fn points_that_never_move_in_their_cells_are_found() {
    is_found(&["samples.n_rooks.stream"], "cells", |question, answer| {
        let n = data(question)["n"].as_f64().unwrap_or(1.0);
        let middle = |i: usize| ((n * answer[i].as_f64().unwrap_or(0.0)).floor() + 0.5) / n;
        json!([middle(0), middle(1)])
    });
}

#[test]
fn a_draw_that_comes_twice_is_found() {
    fn twice(question: &Value, _: Value) -> Value {
        instead(question, |data| {
            let index = data["draw"]["index"].as_u64().unwrap_or(0);
            data["draw"]["index"] = json!(index / 2);
        })
    }
    is_found(&["samples.multi_jittered.stream"], "cells", twice);
    is_found(&["samples.n_rooks.stream"], "columns", twice);
}

#[test]
fn pixels_that_share_their_draws_with_neighbours_are_found() {
    is_found(&["samples.jittered.stream", "samples.sobol.stream"], "pixels", |question, answer| {
        let draw = &data(question)["draw"];
        let [x, y] = [0, 1].map(|i| draw["pixel"][i].as_u64());
        // the set of one pixel is asked for, too, in row 5
        match (draw["index"].as_u64(), x) {
            (Some(0), Some(x)) if y != Some(5) => {
                instead(question, |data| data["draw"]["pixel"][0] = json!(x / 2))
            }
            _ => answer,
        }
    });
}
