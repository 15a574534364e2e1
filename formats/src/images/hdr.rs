//! Radiance HDR (Ward, "Real Pixels", *Graphics Gems II*, 1991): three mantissas and one exponent,
//! `m · 2^(e − 136)`.

use std::io::Read;

use image::DynamicImage;
use image::codecs::hdr::{HdrDecoder, HdrMetadata};

use super::{Problem, after_the_end, check_size, damaged, samples};
use crate::images::Texels;

/// The radiance is divided by the factors of the header (EXPOSURE and COLORCORR), as the format
/// requires.
pub fn decode(bytes: &[u8], max_texels: u64) -> Result<Texels, Problem> {
    let rest = after_signature(bytes)?;
    let whole = || USUAL_SIGNATURE.chain(rest);
    let mut raster = whole();
    let header = HdrDecoder::new(&mut raster).map_err(damaged)?.metadata();
    check_size([header.width, header.height].map(u64::from), max_texels)?;
    let mut all = Vec::new();
    raster.read_to_end(&mut all).expect("nothing fails that is read from memory");
    let after = check_scanlines(&all, header.width, header.height)?;
    let factor = factors(&header)?;
    let image = samples(HdrDecoder::new(whole()).map_err(damaged)?)?;
    let DynamicImage::ImageRgb32F(image) = image else {
        return Err("it holds something else than three numbers a texel".to_owned());
    };
    let color = |c: [f32; 3]| std::array::from_fn(|i| (f64::from(c[i]) / factor[i]) as f32);
    let colors = image.pixels().map(|pixel| color(pixel.0)).collect();
    Ok(Texels::new(header.width, header.height, colors).with_notes(after_the_end(after)))
}

/// The signature that the decoder accepts; `#?RGBE` is valid, too.
const USUAL_SIGNATURE: &[u8] = b"#?RADIANCE";

fn after_signature(bytes: &[u8]) -> Result<&[u8], Problem> {
    let rest = [USUAL_SIGNATURE, b"#?RGBE"].iter().find_map(|s| bytes.strip_prefix(*s));
    let problem = "it begins neither with #?RADIANCE nor with #?RGBE; it is damaged";
    rest.ok_or_else(|| problem.to_owned())
}

/// The factors by which the radiance of each channel was multiplied.
fn factors(header: &HdrMetadata) -> Result<[f64; 3], Problem> {
    let exposure = f64::from(header.exposure.unwrap_or(1.0));
    let (r, g, b) = header.color_correction.unwrap_or((1.0, 1.0, 1.0));
    let factors = [r, g, b].map(|c| exposure * f64::from(c));
    if factors.iter().all(|f| f.is_finite() && *f > 0.0) {
        return Ok(factors);
    }
    Err(format!("EXPOSURE and COLORCORR multiply by {factors:?}; these are finite and positive"))
}

/// Checks the lengths of the scanlines; returns the bytes after them. (The decoder ignores the
/// length that a scanline declares, and overflows with too many consecutive run lengths.)
fn check_scanlines(raster: &[u8], width: u32, height: u32) -> Result<&[u8], Problem> {
    let mut rest = raster;
    for row in 0..height {
        let in_row = |problem: &str| format!("row {row} from the top, from 0: {problem}");
        let after = if let [2, 2, high @ 0..128, low, ..] = rest {
            if u32::from(*high) << 8 | u32::from(*low) != width {
                return Err(in_row("its length is not the width in the header; it is damaged"));
            }
            (0..4).try_fold(&rest[4..], |rest, _| component(rest, width))
        } else {
            old_scanline(rest, width)
        };
        let damaged = "it ends early, or has more texels than the header says; it is damaged";
        rest = after.ok_or_else(|| in_row(damaged))?;
    }
    Ok(rest)
}

/// Skips one component of a scanline: runs (128 + length, value) and literals (length, values).
fn component(mut rest: &[u8], width: u32) -> Option<&[u8]> {
    let mut length = 0;
    while length < width {
        let (&count, after) = rest.split_first()?;
        let (texels, bytes) = if count > 128 { (count - 128, 1) } else { (count, count) };
        rest = after.split_at_checked(bytes.into())?.1;
        length += u32::from(texels);
    }
    (length == width).then_some(rest)
}

/// Skips a scanline of the old form: texels, and repetitions (1, 1, 1, length) of the previous
/// texel; the length of each consecutive repetition counts 256 times as much as that before.
fn old_scanline(mut rest: &[u8], width: u32) -> Option<&[u8]> {
    let mut length = 0;
    let mut shift = 0;
    while length < u64::from(width) {
        let (texel, after) = rest.split_at_checked(4)?;
        rest = after;
        match texel {
            [1, 1, 1, run] if length > 0 && shift < 32 => {
                length += u64::from(*run) << shift;
                shift += 8;
            }
            [1, 1, 1, _] => return None,
            _ => (length, shift) = (length + 1, 0),
        }
    }
    (length == u64::from(width)).then_some(rest)
}
