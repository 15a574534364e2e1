//! A verdict on two sets of pictures as one HTML page.

use super::{AreaDifference, SetsVerdict};
use crate::verdict::{STYLE, map_film, map_with_legend};
use pictures::compare::pair;
use text::document::several;
use text::told::Told;

/// The page of a verdict of which this is told: the pictures, and the differences of pixels in standard deviations, with
/// the areas that differ framed.
pub fn page(verdict: &SetsVerdict, told: &Told) -> String {
    const WORDS: &str = "Of each pixel (of tiles, if the picture is large); brighter where it is larger after. Areas that \
         differ are framed.";
    let size = verdict.shown[0].size;
    let framed =
        |area: &AreaDifference| pair::frame(&area.name, area.bounds.map(|it| it as u32), size);
    let map = map_with_legend(
        ("Difference in standard deviations of the noise", WORDS),
        (&map_film(&verdict.z, size), "map of the difference"),
        verdict.areas.iter().map(framed),
    );
    let body = several()
        .with(pair::views(["the mean before", "the mean after"], verdict.shown.each_ref()))
        .with(map);
    told.page("verify --before … --after …", &[pair::STYLE, STYLE], &body.html())
}
