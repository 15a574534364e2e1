//! Which intersection routines a scene asks for.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How rays are intersected with objects.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(title = "intersection routines")]
pub enum Intersect {
    /// The library's own: no epsilon, no lost roots, no leaks.
    #[default]
    Robust,
    /// As the book prints them (chapters 3 and 19), with rays that start at the hit point and a constant
    /// epsilon, to see how they fail: surface acne, lost roots, leaks.
    Textbook,
}

impl Intersect {
    /// Every choice.
    pub const ALL: [Self; 2] = [Self::Robust, Self::Textbook];

    /// What scene files call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Robust => "robust",
            Self::Textbook => "textbook",
        }
    }

    pub(super) fn is_default(&self) -> bool {
        *self == Self::default()
    }
}
