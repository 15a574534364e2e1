//! Shapes whose data make none.

use crate::library::check_refused;
use crate::prelude::*;
use crate::support::solids::refusal;

/// Law: data that make no shape are refused; the message names the field as it is written in the scene, and says what
/// was found and what is needed. Oracle: the texts in `refused.toml`, beside the data.
#[test]
fn data_that_make_no_shape_are_refused() {
    check_refused(include_str!("refused.toml"), |_, data| {
        refusal(toml::from_str::<Kind>(data).unwrap_or_else(|e| panic!("{data}: {e}")))
    });
}
