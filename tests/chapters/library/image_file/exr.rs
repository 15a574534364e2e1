//! OpenEXR.

use std::path::PathBuf;

use formats::images::decode_layer;
use groundtruth::film::{self, Tone};

use super::*;
use crate::prelude::*;

pub fn exr(name: &str, width: u32, height: u32, color: impl Fn(u32, u32) -> Rgb) -> Vec<u8> {
    let mut picture = Film::new(width, height);
    for y in 0..height {
        for x in 0..width {
            picture.set([x, y], color(x, y));
        }
    }
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("image-{name}.exr"));
    film::write(&picture, &Tone::PLAIN, &path).expect("the folder can be written to");
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

/// Law: values that are no numbers are refused, and the error names the texel. Oracle: the text.
#[test]
fn values_that_are_no_numbers_are_refused() {
    let value = |x: u32, y: u32| match (x, y) {
        (2, 1) => Rgb::new(0.0, f64::NAN, 1.0),
        _ => Rgb::WHITE,
    };
    let file = exr("nan", 3, 2, value);
    assert_refused("nan", &file, "in column 2 from the left, row 1 from the top, both from 0");
}

/// Law: values below 0 become 0, with a note of how many and of the lowest. Oracle: the numbers.
#[test]
fn negative_values_become_0_with_a_note() {
    let value = |x: u32, y: u32| Rgb::new(0.5, 0.25 * (1.0 - f64::from(x)), -0.125 * f64::from(y));
    let file = exr("negative", 3, 2, value);
    let expected: Vec<_> =
        (0..6).map(|i| value(i % 3, i / 3).to_array().map(|c| c.max(0.0))).collect();
    assert_eq!(linear(&file), expected);
    let texels = decode(&file, None, MAX).expect("it loads");
    assert_eq!(texels.notes(), ["5 values below 0, the lowest -0.25, are taken as 0"]);
}

/// An EXR file with this alpha at each column, written by the `exr` crate.
fn with_alpha(name: &str, alpha: [f32; 3]) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("image-{name}.exr"));
    let write =
        ::exr::prelude::write_rgba_file(&path, 3, 2, |x, _| (0.5_f32, 0.25_f32, 1.0_f32, alpha[x]));
    write.expect("the folder can be written to");
    path
}

/// Law: alpha is left out of the colours; the texels in which it is below 1 are counted, except for a rounding error of
/// half precision. Oracle: the numbers.
#[test]
fn alpha_below_1_is_counted() {
    for (name, alpha, count) in [
        ("opaque", [1.0; 3], 0),
        ("rounded", [1.0, 1.0 - 1.0 / 2048.0, 1.5], 0),
        ("transparent", [1.0, 0.5, 0.0], 4),
        ("nearly", [1.0, 0.998, 1.0], 2),
        ("not-a-number", [1.0, f32::NAN, 1.0], 2),
    ] {
        let path = with_alpha(name, alpha);
        let texels = decode(&std::fs::read(&path).expect("written"), None, MAX).expect("right");
        assert_eq!(texels.transparent(), count, "{name}");
        assert!(texels.colors().iter().all(|color| *color == [0.5, 0.25, 1.0]), "{name}");
    }
    let plain = decode(&exr("no-alpha", 2, 2, |_, _| Rgb::WHITE), None, MAX).expect("right");
    assert_eq!(plain.transparent(), 0);
}

/// Law: of a file of two views, which are parts with the attribute `view` (OpenEXR, "Multi-view images"), the one that is
/// named is read; without a name, the file is refused with the names. Oracle: the colours, written by the `exr` crate.
#[test]
fn a_view_is_chosen_by_its_name() {
    use ::exr::prelude::*;
    let grey_of = |view: &str| if view == "left" { 0.25_f32 } else { 0.75 };
    let part = |view: &'static str| {
        let attributes = LayerAttributes {
            view_name: Some(view.into()),
            ..LayerAttributes::named(format!("of-{view}").as_str())
        };
        let channels = SpecificChannels::rgb(move |_| (grey_of(view), 0.5_f32, 1.0_f32));
        Layer::new((2, 1), attributes, ::exr::image::Encoding::FAST_LOSSLESS, channels)
    };
    let mut file = std::io::Cursor::new(Vec::new());
    let image = Image::empty(ImageAttributes::new(IntegerBounds::from_dimensions((2, 1))));
    image
        .with_layer(part("left"))
        .with_layer(part("right"))
        .write()
        .to_buffered(&mut file)
        .expect("memory can be written to");
    let bytes = file.into_inner();
    for view in ["left", "right"] {
        let texels = decode_layer(&bytes, None, Some(view), MAX).expect("it is there");
        assert_eq!(texels.colors(), [[grey_of(view), 0.5, 1.0]; 2], "{view}");
    }
    let refused = refusal(&bytes);
    assert!(["left", "right"].iter().all(|view| refused.contains(view)), "{refused}");
    assert!(decode_layer(&bytes, None, Some("middle"), MAX).is_err());
}

fn attribute(name: &str, kind: &str, value: &[u8]) -> Vec<u8> {
    let size = (value.len() as u32).to_le_bytes();
    [name.as_bytes(), &[0], kind.as_bytes(), &[0], &size, value].concat()
}

/// Law: a deep file and an unknown compression are called not supported, not damaged; so a user knows what to
/// do. Oracle: the text.
#[test]
fn deep_files_and_unknown_compressions_are_not_supported() {
    let mut file = exr("compression", 2, 2, |_, _| Rgb::WHITE);
    let name = b"compression\0compression\0\x01\0\0\0";
    let at = file.windows(name.len()).position(|w| w == name).expect("it is there") + name.len();
    file[at] = 77;
    assert_refused("compression", &file, "compression 77 is not supported");
    assert!(!refusal(&file).contains("damaged"));

    let window: Vec<u8> = [0_i32, 0, 0, 0].iter().flat_map(|c| c.to_le_bytes()).collect();
    // 32 bits floating-point, linear or not, reserved, sampled everywhere
    let channel = [&b"Z\0"[..], &[2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0], b"\0"].concat();
    let deep = [
        vec![0x76, 0x2f, 0x31, 0x01, 2, 0x08, 0, 0], // the second bit of the flags: deep
        attribute("channels", "chlist", &channel),
        attribute("chunkCount", "int", &1_i32.to_le_bytes()),
        attribute("compression", "compression", &[2]),
        attribute("dataWindow", "box2i", &window),
        attribute("displayWindow", "box2i", &window),
        attribute("lineOrder", "lineOrder", &[0]),
        attribute("maxSamplesPerPixel", "int", &1_i32.to_le_bytes()),
        attribute("name", "string", b"deep"),
        attribute("pixelAspectRatio", "float", &1_f32.to_le_bytes()),
        attribute("screenWindowCenter", "v2f", &[0; 8]),
        attribute("screenWindowWidth", "float", &1_f32.to_le_bytes()),
        attribute("type", "string", b"deepscanline"),
        attribute("version", "int", &1_i32.to_le_bytes()),
        vec![0],
        vec![0; 64],
    ]
    .concat();
    assert_refused("deep", &deep, "not supported");
    assert!(!refusal(&deep).contains("damaged"), "{}", refusal(&deep));
}

/// A file whose header claims a huge number of texels.
pub fn claiming() -> Vec<u8> {
    let mut file = exr("huge", 5, 4, |_, _| Rgb::WHITE);
    for name in ["dataWindow\0box2i\0", "displayWindow\0box2i\0"] {
        let start =
            file.windows(name.len()).position(|w| w == name.as_bytes()).expect("it is there");
        // after the size of the attribute: xMin, yMin, xMax, yMax
        let at = start + name.len() + 4 + 8;
        file[at..at + 4].copy_from_slice(&99_999_999_i32.to_le_bytes());
    }
    file
}
