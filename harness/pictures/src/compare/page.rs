//! A comparison as one HTML page.

use groundtruth::film::Tone;

use super::pair::{self, Pair};
use super::{Comparison, Picture};
use crate::html::{self, escaped};

/// The page of a comparison of the pictures of these files or scenes; `commands` explain a pixel.
pub fn page(
    comparison: &Comparison,
    names: [&str; 2],
    pictures: [&Picture; 2],
    commands: &dyn Fn([u32; 2]) -> Vec<String>,
) -> String {
    let title = names.map(escaped).join(" and ");
    let [a, b] = &comparison.names;
    let (names, shown) = ([&**a, &**b], pictures.map(Picture::radiance));
    let pair = Pair { names, pictures, shown, tone: Tone::SCREEN, comparison, commands };
    let words = escaped(&comparison.to_string());
    let body = format!("<h1>{title}</h1>\n<pre>{words}</pre>\n{}", pair.html());
    html::page(&title, &[pair::STYLE], &body)
}
