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

/// Reads a list of exactly `N` rows of exactly `M` numbers each.
///
/// # Errors
/// As [`exactly`], of the list or of a row.
pub fn rows<'de, D, const N: usize, const M: usize>(
    deserializer: D,
) -> Result<[[f64; M]; N], D::Error>
where
    D: Deserializer<'de>,
{
    exactly(deserializer).map(|rows: [Row<f64, M>; N]| rows.map(|Row(row)| row))
}

/// Reads a list, which may be left out, of rows of exactly `M` each.
///
/// # Errors
/// As [`exactly`], of a row.
pub fn of_rows_if_any<'de, D, T, const M: usize>(
    deserializer: D,
) -> Result<Option<Vec<[T; M]>>, D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    let rows: Vec<Row<T, M>> = Vec::deserialize(deserializer)?;
    Ok(Some(rows.into_iter().map(|Row(row)| row).collect()))
}

/// A list of exactly `N`.
#[derive(Deserialize)]
#[serde(bound = "T: Deserialize<'de>")]
struct Row<T, const N: usize>(#[serde(deserialize_with = "exactly")] [T; N]);

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
