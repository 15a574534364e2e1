//! A comparison as one HTML page.

use groundtruth::film::Tone;

use super::pair::{self, ComparedPictures};
use super::{Comparison, Picture};
use text::told::Told;

/// The page of a comparison of the pictures of these files or scenes, of which this is told; `commands` explain a pixel.
pub fn page(
    comparison: &Comparison,
    told: &Told,
    names: [&str; 2],
    pictures: [&Picture; 2],
    commands: &dyn Fn([u32; 2]) -> Vec<String>,
) -> String {
    let about = format!("compare {}", names.join(" and "));
    let [a, b] = &comparison.names;
    let (names, shown) = ([&**a, &**b], pictures.map(Picture::radiance));
    let pair =
        ComparedPictures { names, pictures, shown, tone: Tone::SCREEN, comparison, commands };
    told.page(&about, &[pair::STYLE], &pair.element().html())
}
