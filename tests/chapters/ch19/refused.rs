//! Shapes whose data make none.

use crate::prelude::*;
use crate::support::solids::refusal;

/// Law: data that make no shape are refused; the message names the field as it is written in the scene, and says what
/// was found and what is needed. Oracle: the texts in `refused.toml`, beside the data.
#[test]
fn data_that_make_no_shape_are_refused() {
    let cases: toml::Table = include_str!("refused.toml").parse().expect("it is TOML");
    for (data, says) in &cases {
        let kind: Kind = toml::from_str(data).unwrap_or_else(|e| panic!("{data}: {e}"));
        assert_eq!(refusal(kind), says.as_str().expect("a text"), "{data}");
    }
    at_least!(cases.len(), 80);
}
