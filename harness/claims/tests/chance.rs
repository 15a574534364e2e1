//! Tests of chance are judged for the whole card: by Holm's rule, and again with ten times the samples. The subjects
//! are mirrors whose weights have a chosen probability.

use ask::{Reply, Subject, numbers};
use std::collections::BTreeMap;

use claims::ClaimsCard;
use serde_json::{Value, json};
use statistics::means::one_sample;

/// The level of a card (docs/laws.md).
const LEVEL: f64 = 0.01;
/// Samples that the law of sides asks for.
const OF_SIDES: usize = 384;
/// Samples of a mirror, and ten times as many when it is asked again.
const DRAWN: [usize; 2] = [1024, 10_240];
/// Half the distance of the two weights of a mirror.
const SPREAD: f64 = 1e-3;

/// The weights of so many samples: alternately above and below 1 + off.
fn weights(off: f64, count: usize) -> Vec<f64> {
    (0..count).map(|i| 1.0 + off + if i % 2 == 0 { SPREAD } else { -SPREAD }).collect()
}

/// The distance of the mean of the weights from 1 that has this probability, by bisection.
fn off_for(p: f64, count: usize) -> f64 {
    let (mut low, mut high) = (0.0, SPREAD);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        match one_sample(&weights(middle, count), 1.0) > p {
            true => low = middle,
            false => high = middle,
        }
    }
    high
}

/// Mirrors that claim to lose nothing: of each, the probability of its weights at first and when it is asked again.
struct Mirrors {
    off: Vec<[f64; 2]>,
    /// How many samples each was asked for.
    asked: BTreeMap<usize, usize>,
}

impl Mirrors {
    fn new(p: &[[f64; 2]]) -> Self {
        let off = |p: &[f64; 2]| [off_for(p[0], DRAWN[0]), off_for(p[1], DRAWN[1])];
        Self { off: p.iter().map(off).collect(), asked: BTreeMap::new() }
    }

    fn answer(&mut self, question: &Value) -> Value {
        if question.get("list").is_some() {
            let claims = json!({"delta": true, "lossless": true});
            let one = |i: usize| json!({"name": i.to_string(), "claims": claims});
            return (0..self.off.len()).map(one).collect();
        }
        let data = &question["sample"];
        let Some(list) = data["u"].as_array() else {
            let count = question["eval"]["wi"].as_array().map_or(0, Vec::len);
            return json!({"f": vec![0.0; count], "pdf": vec![0.0; count]});
        };
        let mirror: usize = data["lobe"].as_str().and_then(|it| it.parse().ok()).expect("a name");
        let wo = numbers(&data["wo"]).expect("a direction");
        let asked = self.asked.entry(mirror).or_insert(0);
        let is_again = *asked >= OF_SIDES + DRAWN[0];
        // the law of repetition asks for four
        if list.len() > 4 {
            *asked += list.len();
        }
        let off = self.off[mirror][usize::from(is_again)];
        let sample = |weight| json!({"wi": [-wo[0], -wo[1], wo[2]], "weight": weight, "pdf": null});
        weights(off, list.len()).into_iter().map(sample).collect()
    }
}

impl Subject for Mirrors {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        questions.iter().map(|question| Ok(self.answer(question))).collect()
    }
}

/// Which mirrors break a law.
fn broken(p: &[[f64; 2]]) -> (Vec<usize>, ClaimsCard) {
    let mut mirrors = Mirrors::new(p);
    let card = super::right::card(&mut mirrors, 1, 3);
    let is_broken = |i: &usize| card.rows[*i].broken().next().is_some();
    ((0..p.len()).filter(is_broken).collect(), card)
}

/// Law: of m tests of chance the one of the k-th smallest probability is rejected if all before it are and it is at
/// most 0.01/(m − k + 1) (Holm, 1979). Oracle: this rule, for probabilities just below and above each border.
#[test]
fn chance_is_judged_by_holms_rule() {
    let (below, above) = (0.9, 1.1);
    for (shares, expected) in [
        ([below, below, below], &[0, 1, 2][..]),
        ([below, below, above], &[0, 1]),
        ([below, above, below], &[0]),
        ([above, below, below], &[]),
        ([above, above, above], &[]),
    ] {
        // an order that is not that of the list: the second is the least
        let p = [shares[1] * LEVEL / 2.0, shares[0] * LEVEL / 3.0, shares[2] * LEVEL];
        // when they are asked again, nothing is left to chance
        let (found, card) = broken(&p.map(|p| [p, 1e-9]));
        let mut expected: Vec<usize> = expected.iter().map(|rank| [1, 0, 2][*rank]).collect();
        expected.sort_unstable();
        assert_eq!(card.tests, 3, "tests of chance: {card}");
        assert_eq!(found, expected, "broken of three with the probabilities {p:?}\n{card}");
    }
}

/// Law: a law that chance may have broken is broken if ten times the samples are less probable than 0.01 over the
/// number of tests, too. Oracle: probabilities on both sides of that.
#[test]
fn what_is_asked_again_has_to_fail_again() {
    for (again, is_broken) in [(0.9 * LEVEL, true), (1.1 * LEVEL, false), (0.5, false)] {
        let (found, card) = broken(&[[0.5 * LEVEL, again]]);
        assert_eq!(!found.is_empty(), is_broken, "p = {again} when it is asked again\n{card}");
    }
    for (again, is_broken) in [(0.9 * LEVEL / 2.0, true), (1.1 * LEVEL / 2.0, false)] {
        let (found, card) = broken(&[[0.4 * LEVEL, again], [0.5, 0.5]]);
        assert_eq!(
            !found.is_empty(),
            is_broken,
            "p = {again} of two when it is asked again\n{card}"
        );
    }
}
