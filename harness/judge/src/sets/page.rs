//! A verdict on two sets of pictures as one HTML page.

use groundtruth::film::{Tone, data_uri};

use super::{AreaDifference, SetsVerdict};
use crate::verdict::{STYLE, frame, map_film, map_scale};
use pictures::compare::pair;
use pictures::told::Told;

/// The page of a verdict of which this is told.
pub fn page(verdict: &SetsVerdict, told: &Told) -> String {
    let body = pair::views(["the mean before", "the mean after"], verdict.shown.each_ref())
        + &map(verdict);
    told.page("verify --before … --after …", &[pair::STYLE, STYLE], &body)
}

/// The differences of pixels in standard deviations, with the areas that differ framed.
fn map(verdict: &SetsVerdict) -> String {
    let size = verdict.shown[0].size;
    let framed = |area: &AreaDifference| frame(&area.name, area.bounds, size);
    let frames: String = verdict.areas.iter().map(framed).collect();
    format!(
        "<h2>Difference in standard deviations of the noise</h2>\n<p>Of each pixel (of tiles, if the picture is large); \
         brighter where it is larger after. Areas that differ are framed.</p>\n\
         <div class=\"map\"><img alt=\"map of the difference\" src=\"{}\">{frames}</div>\n{}",
        data_uri(&map_film(&verdict.z, size), &Tone::PLAIN),
        map_scale()
    )
}
