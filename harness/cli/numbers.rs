//! Numbers on the command line.

use std::ops::{RangeBounds, RangeInclusive};

/// Parses a number of this range; the error says what to write.
pub fn number(
    range: impl RangeBounds<f64> + Clone + Send + Sync + 'static,
    advice: &'static str,
) -> impl Fn(&str) -> Result<f64, String> + Clone + Send + Sync + 'static {
    move |text| {
        let number = text.parse().ok().filter(|number| range.contains(number));
        number.ok_or_else(|| advice.to_owned())
    }
}

/// Parses a whole number of this range; the error says what to write.
pub fn whole<T>(
    range: RangeInclusive<u64>,
) -> impl Fn(&str) -> Result<T, String> + Clone + Send + Sync + 'static
where
    T: TryFrom<u64> + Clone + Send + Sync + 'static,
{
    move |text| {
        let number = text.parse().ok().filter(|number| range.contains(number));
        number.and_then(|number| T::try_from(number).ok()).ok_or_else(|| advice(text, &range))
    }
}

/// What to write instead.
fn advice(text: &str, range: &RangeInclusive<u64>) -> String {
    let [least, most] = [*range.start(), *range.end()];
    let rounded = text.parse::<f64>().ok().filter(|number| number.fract() == 0.0);
    match rounded.filter(|&number| number >= least as f64 && number <= most as f64) {
        Some(number) => format!("write {number}"),
        None if most >= u64::from(u32::MAX) => {
            format!("write a whole number that is at least {least}")
        }
        None => format!("write a whole number from {least} to {most}"),
    }
}
