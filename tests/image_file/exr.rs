//! OpenEXR.

use std::path::Path;

use groundtruth::film::{self, Film, OutOfGamut, Tone};
use groundtruth::rgb::Rgb;

use super::*;

/// A tone that changes nothing: EXR files store radiance.
const PLAIN: Tone = Tone { exposure: 1.0, gamma: 1.0, out_of_gamut: OutOfGamut::MaxToOne };

fn exr(name: &str, width: u32, height: u32, color: impl Fn(u32, u32) -> Rgb) -> Vec<u8> {
    let mut picture = Film::new(width, height);
    for y in 0..height {
        for x in 0..width {
            picture.set([x, y], color(x, y));
        }
    }
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("image-{name}.exr"));
    film::write(&picture, &PLAIN, &path).expect("the folder can be written to");
    std::fs::read(&path).expect("it was written")
}

/// Law: values come back rounded to single precision, also those above 1. Oracle: the numbers.
#[test]
fn pictures_load() {
    let value = |x: u32, y: u32| Rgb::new(f64::from(x) + 0.25, 1e-6 * f64::from(y), 1e5);
    let file = exr("right", 3, 2, value);
    let expected: Vec<_> =
        (0..6).map(|i| value(i % 3, i / 3).to_array().map(|c| f64::from(c as f32))).collect();
    assert_eq!(linear(&file), expected);
    assert_eq!(rows(&decode(&file, None, MAX).expect("right")), expected, "linear by itself");
}

/// Law: values that are not finite are refused, and the error names the texel. Oracle: the text.
#[test]
fn infinite_values_are_refused() {
    for (name, wrong) in [("nan", f64::NAN), ("infinite", f64::INFINITY)] {
        let file =
            exr(
                name,
                3,
                2,
                |x, y| {
                    if (x, y) == (2, 1) { Rgb::new(0.0, wrong, 1.0) } else { Rgb::WHITE }
                },
            );
        assert_refused(name, &file, "in column 2 from the left, row 1 from the top, both from 0");
    }
}

/// Law: cut off anywhere, a file is refused. Oracle: many prefixes.
#[test]
fn truncated_files_are_refused() {
    let file = exr("cut", 5, 4, |x, y| Rgb::grey(f64::from(x * y)));
    for length in 4..file.len() {
        refusal(&file[..length]);
    }
}

/// Law: a header that claims a huge number of texels is refused before any is read. Oracle: the text.
#[test]
fn huge_sizes_are_refused_at_once() {
    let mut file = exr("huge", 5, 4, |_, _| Rgb::WHITE);
    for name in ["dataWindow\0box2i\0", "displayWindow\0box2i\0"] {
        let start =
            file.windows(name.len()).position(|w| w == name.as_bytes()).expect("it is there");
        // after the size of the attribute: xMin, yMin, xMax, yMax
        let at = start + name.len() + 4 + 8;
        file[at..at + 4].copy_from_slice(&99_999_999_i32.to_le_bytes());
    }
    assert_refused("huge", &file, "100000000 × 4 texels, with the images before it, are too many");
}
