//! Radiance HDR.

use super::*;

fn hdr(header: &str, scanlines: &[u8]) -> Vec<u8> {
    [header.as_bytes(), scanlines].concat()
}

const HEADER: &str = "#?RADIANCE\n# by hand\nFORMAT=32-bit_rle_rgbe\n\n";

fn sized(height: u32, width: u32, scanlines: &[u8]) -> Vec<u8> {
    hdr(&format!("{HEADER}-Y {height} +X {width}\n"), scanlines)
}

/// `m · 2^(e − 136)`, Ward's definition, by repeated doubling.
fn value([r, g, b, e]: [u8; 4]) -> [f64; 3] {
    let steps = i32::from(e) - 136;
    let factor = (0..steps.abs()).fold(1.0, |f, _| if steps > 0 { 2.0 * f } else { 0.5 * f });
    let factor = if e == 0 { 0.0 } else { factor };
    [r, g, b].map(|m| f64::from(m) * factor)
}

/// Law: texels are their mantissas times the power of two, for small and large exponents. Oracle: the
/// definition.
#[test]
fn texels_are_mantissas_times_a_power_of_two() {
    let texels =
        [[128, 64, 0, 129], [255, 1, 3, 136], [200, 100, 50, 20], [0, 0, 0, 0], [9, 200, 7, 250]];
    let file = sized(1, 5, texels.as_flattened());
    assert_eq!(linear(&file), texels.map(value));
    let rgbe = [b"#?RGBE", &file[10..]].concat();
    assert_eq!(linear(&rgbe), texels.map(value), "the other signature");
}

/// Law: a run length of the old form repeats the previous texel. Of consecutive run lengths, each counts 256
/// times as much as the one before. Oracle: the texels written out.
#[test]
fn old_run_lengths_load() {
    let (a, b) = ([128, 64, 32, 130], [10, 20, 200, 128]);
    let short = [a, [1, 1, 1, 3], b, [1, 1, 1, 1]];
    let expected: Vec<_> = [a, a, a, a, b, b].map(value).to_vec();
    assert_eq!(linear(&sized(1, 6, short.as_flattened())), expected);
    let long = [a, [1, 1, 1, 2], [1, 1, 1, 1], b];
    let found = linear(&sized(1, 260, long.as_flattened()));
    assert!(found[..259].iter().all(|c| *c == value(a)), "1 + 2 + 256 of the first");
    assert_eq!(found[259], value(b));
}

/// Law: the length of a scanline of the new form has two bytes, the higher one first. Oracle: the texels written
/// out, for widths on both sides of 256 and the largest.
#[test]
fn wide_scanlines_load() {
    for width in [255_u16, 256, 257, 600, 32_767] {
        let mut line = vec![2, 2];
        line.extend(width.to_be_bytes());
        let texel = |x: u16| [(x / 100 % 250) as u8, 7, (x / 1000) as u8, 130];
        for component in 0..4 {
            let all: Vec<u8> = (0..width).map(|x| texel(x)[component]).collect();
            for literals in all.chunks(128) {
                line.push(literals.len() as u8);
                line.extend(literals);
            }
        }
        let expected: Vec<_> = (0..width).map(|x| value(texel(x))).collect();
        assert_eq!(linear(&sized(1, width.into(), &line)), expected, "width {width}");
    }
}

/// Eight texels in the new form.
fn line() -> Vec<u8> {
    let head = &[2, 2, 0, 8][..];
    let red = &[128 + 8, 200]; // a run
    let green = &[8, 1, 2, 3, 4, 5, 6, 7, 8]; // literals
    let blue = &[128 + 5, 9, 3, 10, 11, 12]; // both
    let exponents = &[4, 129, 130, 131, 132, 128 + 4, 128];
    [head, red, green, blue, exponents].concat()
}

/// A picture of two rows.
pub fn whole() -> Vec<u8> {
    sized(2, 8, &line().repeat(2))
}

/// Law: a scanline of the new form encodes the four components one after the other: a length above 128
/// starts a run, any other starts literals. Oracle: the texels written out.
#[test]
fn new_run_lengths_load() {
    let blue = [9, 9, 9, 9, 9, 10, 11, 12];
    let exponents = [129, 130, 131, 132, 128, 128, 128, 128];
    let texel = |i: usize| value([200, i as u8 + 1, blue[i], exponents[i]]);
    let row: Vec<_> = (0..8).map(texel).collect();
    assert_eq!(linear(&whole()), row.repeat(2));
    for (at, by, because) in [(3, 9, "its length is not"), (4, 128 + 9, "it ends early")] {
        let mut wrong = line();
        wrong[at] = by;
        let because = format!("row 0 from the top, from 0: {because}");
        assert_refused("line", &sized(1, 8, &wrong), &because);
    }
}

/// Law: runs without a previous texel and runs that are too long are refused, also so many consecutive ones
/// that their length overflows. Oracle: the text.
#[test]
fn wrong_old_run_lengths_are_refused() {
    let texel = [128, 64, 32, 130];
    for scanline in [
        vec![[1, 1, 1, 2]],
        vec![texel, [1, 1, 1, 9]],
        vec![texel, [1, 1, 1, 0], [1, 1, 1, 0], [1, 1, 1, 0], [1, 1, 1, 1]],
        [vec![texel], vec![[1, 1, 1, 0]; 20]].concat(),
    ] {
        assert_refused(
            "runs",
            &sized(1, 6, scanline.as_flattened()),
            "row 0 from the top, from 0: it ends",
        );
    }
}

/// Law: EXPOSURE and COLORCORR, by which the values were multiplied, are divided out, every occurrence of
/// them. Oracle: the quotient.
#[test]
fn exposure_is_divided_out() {
    let texel = [128, 64, 32, 130];
    let lines = "EXPOSURE=2.0\nEXPOSURE= 4\nCOLORCORR=1 2 0.5\n";
    let header = HEADER.replace("FORMAT", &format!("{lines}FORMAT"));
    let file = hdr(&format!("{header}-Y 1 +X 1\n"), &texel);
    let [r, g, b] = value(texel);
    assert_eq!(linear(&file), [[r / 8.0, g / 16.0, b / 4.0]]);
    let wrong = String::from_utf8_lossy(&file).replace("EXPOSURE= 4", "EXPOSURE= 0");
    assert!(wrong.contains("= 0"), "the exposure is replaced");
    let zero = HEADER.replace("FORMAT", "EXPOSURE=0\nFORMAT");
    assert_refused("0", &hdr(&format!("{zero}-Y 1 +X 1\n"), &texel), "are finite and positive");
}

/// Law: orientations and colour formats that the decoder does not know are refused, and so are invalid
/// headers. Oracle: the text.
#[test]
fn other_forms_are_refused() {
    let texel = [128, 64, 32, 130];
    for size in ["+Y 1 +X 1", "-Y 1 -X 1", "+X 1 -Y 1", "-X 1 +Y 1"] {
        assert_refused(size, &hdr(&format!("{HEADER}{size}\n"), &texel), "Orientation");
    }
    let xyz = HEADER.replace("rgbe", "xyze");
    assert_refused("XYZ", &hdr(&format!("{xyz}-Y 1 +X 1\n"), &texel), "of a form that is not read");
    assert_refused("signature", b"#?OTHER\n\n-Y 1 +X 1\nabcd", "neither with #?RADIANCE nor");
    assert_refused("size", &sized(0, 5, b""), "5 × 0 texels");
}

/// A file that claims to have this size.
pub fn claiming(size: &str) -> Vec<u8> {
    hdr(&format!("{HEADER}{size}\n"), &[128, 64, 32, 130])
}
