//! A comparison as one HTML page that needs nothing beside it, and no script.

use groundtruth::film::{OutOfGamut, Tone};

use super::pair::{self, Pair};
use super::{Comparison, Picture};
use crate::html::escaped;

const STYLE: &str = "\
body { font: 15px/1.4 system-ui, sans-serif; margin: 2em auto; max-width: 80em; padding: 0 1em; }
pre { overflow-x: auto; }
";

/// The page of a comparison of the pictures of these files or scenes; `commands` explain a pixel.
pub fn page(
    comparison: &Comparison,
    names: [&str; 2],
    pictures: [&Picture; 2],
    commands: &dyn Fn([u32; 2]) -> Vec<String>,
) -> String {
    let [name_a, name_b] = names.map(escaped);
    let tone = Tone { exposure: 1.0, gamma: 2.2, out_of_gamut: OutOfGamut::MaxToOne };
    let [a, b] = &comparison.names;
    let (names, shown) = ([&**a, &**b], pictures.map(Picture::radiance));
    let pair = Pair { names, pictures, shown, tone, comparison, commands };
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>{name_a} and {name_b}</title>\n\
         <style>\n{STYLE}{}</style>\n<h1>{name_a} and {name_b}</h1>\n<pre>{}</pre>\n{}</html>\n",
        pair::STYLE,
        escaped(&comparison.to_string()),
        pair.html()
    )
}
