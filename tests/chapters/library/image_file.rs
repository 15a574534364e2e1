//! Image files: a valid file loads with the right values, any other gives one clear error.
//!
//! The files are made here, byte by byte, from the formats' definitions.

mod exr;
mod field;
mod files;
mod guard;
mod hdr;
mod jpeg;
mod png;
mod pnm;
mod scenes;

use formats::images::{Encoding, Texels, decode};

use crate::prelude::*;

/// More texels than any image here should have.
const MAX: u64 = 1 << 20;

/// The linear texels of a valid image, from the top row down.
fn linear(bytes: &[u8]) -> Vec<[f64; 3]> {
    let texels = decode(bytes, Some(Encoding::Linear), MAX);
    rows(&texels.unwrap_or_else(|e| panic!("it is refused: {e}")))
}

fn rows(texels: &Texels) -> Vec<[f64; 3]> {
    let rows = (0..texels.height()).rev();
    rows.flat_map(|row| (0..texels.width()).map(move |column| [column, row]))
        .map(|[column, row]| texels.color(column, row).map(f64::from))
        .collect()
}

/// The error message for bytes that must be refused.
fn refusal(bytes: &[u8]) -> String {
    match decode(bytes, None, MAX) {
        Ok(texels) => panic!("it loads as {} × {}", texels.width(), texels.height()),
        Err(problem) => problem,
    }
}

fn assert_refused(what: &str, bytes: &[u8], because: &str) {
    let problem = refusal(bytes);
    assert!(problem.contains(because), "{what}: `{problem}` does not say `{because}`");
}

/// The grey `v/max` in single precision, as texels are kept.
fn grey(v: u32, max: u32) -> [f64; 3] {
    [f64::from((f64::from(v) / f64::from(max)) as f32); 3]
}

/// Law: sRGB is the default, and its decoding inverts `1.055 L^(1/2.4) − 0.055`, `12.92 L` below 0.0031308
/// (IEC 61966-2-1); with `encoding = "linear"` a sample is `v/255`. Oracle: the standard's encoding.
#[test]
fn srgb_is_decoded_unless_it_is_linear() {
    let all: Vec<u8> = (0..=255).collect();
    let bytes = [b"P5 256 1 255\n", &all[..]].concat();
    for default in [None, Some(Encoding::Srgb)] {
        let decoded = rows(&decode(&bytes, default, MAX).expect("it is right"));
        for (v, color) in decoded.iter().enumerate() {
            let l = color[0];
            let encoded =
                if l <= 0.0031308 { 12.92 * l } else { 1.055 * power(l, 1.0 / 2.4) - 0.055 };
            // single precision, and the standard's two branches differ by some 1e-6 where they meet
            let apart = (255.0 * encoded - v as f64).abs();
            assert!(apart < 1e-4, "{v} is decoded to {l}, which is encoded as {}", 255.0 * encoded);
        }
    }
    for (v, color) in linear(&bytes).iter().enumerate() {
        assert_eq!(*color, grey(v as u32, 255));
    }
}

/// Law: a file of an unknown format is refused by its first bytes. Oracle: the text.
#[test]
fn other_formats_are_refused() {
    assert_refused("nothing", b"", "the file is empty");
    for (what, bytes) in [("text", &b"hello"[..]), ("GIF", b"GIF89a")] {
        assert_refused(what, bytes, "not those of a PNG, JPEG, PPM, HDR, EXR or PFM file");
    }
    assert_refused("PAM", b"P7\nWIDTH 1\nHEIGHT 1\nDEPTH 1\nMAXVAL 1\nENDHDR\n\0", "not those of");
}

/// Law: a file that is cut off anywhere is refused, in every format; bytes after its end are ignored, with a note.
/// Oracle: every prefix; the image without them.
#[test]
fn files_are_refused_if_they_are_cut_and_noted_if_they_are_longer() {
    let pfm = b"Pf 1 1 -1\n\0\0\x80\x3f".to_vec();
    let ppm = b"P6 2 2 255\nabcdefghijkl".to_vec();
    let exr = exr::exr("cut", 5, 4, |x, y| Rgb::grey(f64::from(x * y)));
    for file in [hdr::whole(), jpeg::grey_block(77), png::whole(), ppm, pfm, exr.clone()] {
        (0..file.len()).for_each(|length| drop(refusal(&file[..length])));
        if file != exr {
            let longer = decode(&[&file[..], b"more"].concat(), Some(Encoding::Linear), MAX);
            let longer = longer.expect("it is whole");
            assert_eq!(rows(&longer), linear(&file));
            assert_eq!(longer.notes(), ["4 bytes after its end are ignored"]);
        }
    }
}

/// Law: a file that claims a huge number of texels is refused by its header, before any is read. Oracle: the text,
/// and that the test needs little memory.
#[test]
fn huge_sizes_are_refused_at_once() {
    let beyond = "with the images before it, are too many; at most 1048576 more fit";
    assert_refused("JPEG", &jpeg::claiming(), &format!("65535 × 65535 texels, {beyond}"));
    assert_refused("EXR", &exr::claiming(), &format!("100000000 × 4 texels, {beyond}"));
    assert_refused("PPM", b"P6 1048577 1 255\n", beyond);
    for size in [[1_000_000_000, 1], [40_000, 40_000], [0x7fff_ffff; 2]] {
        assert_refused("PNG", &png::claiming(size), beyond);
    }
    let ppm = ["1000000000 1", "40000 40000", "4294967295 4294967295"];
    let ppm = ppm.map(|size| format!("P6 {size} 255\n").into_bytes());
    let hdr = ["-Y 1000000000 +X 1", "-Y 4294967295 +X 4294967295"].map(hdr::claiming);
    for file in ppm.into_iter().chain(hdr) {
        let problem = refusal(&file);
        assert!(problem.contains("too many") || problem.contains("too large"), "{problem}");
    }
}
