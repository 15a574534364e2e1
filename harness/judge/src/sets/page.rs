//! A verdict on two sets of pictures as one HTML page.

use std::fmt::Write;

use groundtruth::film::{Tone, data_uri};

use super::{AreaDifference, SetsVerdict};
use crate::verdict::{frame, map_film};
use pictures::compare::pair;
use pictures::html::{self, escaped};

/// The page of a verdict; `words` are what the command prints.
pub fn page(verdict: &SetsVerdict, words: &str) -> String {
    let sentence = escaped(&verdict.sentence());
    let mut body = format!("<h1>{sentence}</h1>\n");
    body += &pair::views(["the mean before", "the mean after"], verdict.shown.each_ref());
    body += &map(verdict);
    let words = words.split_once('\n').map_or("", |(_, rest)| rest);
    let _ = write!(body, "<h3>In numbers</h3>\n<pre>{}</pre>\n", escaped(words));
    html::page(&sentence, &[pair::STYLE], &body)
}

/// The differences of pixels in standard deviations, with the areas that differ framed.
fn map(verdict: &SetsVerdict) -> String {
    let size = verdict.shown[0].size;
    let framed = |area: &AreaDifference| frame(&area.name, area.bounds, size);
    let frames: String = verdict.areas.iter().map(framed).collect();
    format!(
        "<h3>Where</h3>\n<p>The difference of each pixel (of tiles, if the picture is large) in standard deviations: \
         grey is 0, white and black are ±6 and more, brighter where it is larger after. Areas that differ are framed.</p>\n\
         <div class=\"map\"><img alt=\"map of the difference\" src=\"{}\">{frames}</div>\n",
        data_uri(&map_film(&verdict.z, size), &Tone::PLAIN)
    )
}
