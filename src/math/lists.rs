//! Lists of so many numbers, in files.

use serde::de::Error;
use serde::{Deserialize, Deserializer};

/// Reads a list of exactly `N`. (Of a longer list an array takes the first `N`, without a word.)
///
/// # Errors
/// Another number of them, or one that cannot be read.
pub fn exactly<'de, D, T, const N: usize>(deserializer: D) -> Result<[T; N], D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    let list = Vec::deserialize(deserializer)?;
    let found = list.len();
    list.try_into()
        .map_err(|_| Error::invalid_length(found, &format!("an array of length {N}").as_str()))
}

/// The same where there may be none.
///
/// # Errors
/// As [`exactly`].
pub fn exactly_if_any<'de, D, T, const N: usize>(
    deserializer: D,
) -> Result<Option<[T; N]>, D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    exactly(deserializer).map(Some)
}
