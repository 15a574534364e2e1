//! PNG (W3C, *Portable Network Graphics*): 1 to 16 bits; grey, colour or palette; interlaced or not.

use std::io::Cursor;

use image::codecs::png::PngDecoder;

use super::{Encoding, Problem, check_size, damaged, integers, limits, samples};
use crate::images::Texels;

/// Samples of fewer than 8 bits come spread to 8, exactly: `255/(2ⁿ − 1)` is whole. Colour profiles are
/// left out.
pub fn decode(
    bytes: &[u8],
    encoding: Option<Encoding>,
    most_texels: u64,
) -> Result<Texels, Problem> {
    let size = checked_chunks(bytes)?;
    check_size(size.map(u64::from), most_texels)?;
    let [width, height] = size.map(u64::from);
    // four channels of two bytes
    let decoder = PngDecoder::with_limits(Cursor::new(bytes), limits(8 * width * height));
    let image = samples(decoder.map_err(damaged)?)?;
    let is_8_bit = image.color().bytes_per_pixel() == image.color().channel_count();
    integers(image, if is_8_bit { 255 } else { u16::MAX }, encoding)
}

/// Width and height, if every chunk up to the last is whole and has its checksum. (The decoder skips
/// damaged chunks that it does not need, and stops at the last texel.)
fn checked_chunks(bytes: &[u8]) -> Result<[u32; 2], Problem> {
    /// After the signature: length, type, width and height of the first chunk.
    const HEADER: std::ops::Range<usize> = 8..24;
    let ends = || "the file ends before its last chunk; it is damaged".to_owned();
    let mut header = bytes.get(HEADER).ok_or_else(ends)?;
    if !header.starts_with(b"\0\0\0\rIHDR") {
        return Err("a PNG file begins with its header (IHDR); this one is damaged".to_owned());
    }
    header = &header[8..];
    let number = |bytes: &[u8]| bytes.iter().fold(0, |n: u32, byte| n << 8 | u32::from(*byte));
    let size = [number(&header[..4]), number(&header[4..])];
    let mut rest = &bytes[8..];
    loop {
        let (length, chunk) = rest.split_at_checked(4).ok_or_else(ends)?;
        let length = number(length) as usize;
        // type and data, then the checksum of both
        let (data, after) = chunk.split_at_checked(length.saturating_add(4)).ok_or_else(ends)?;
        let (sum, after) = after.split_at_checked(4).ok_or_else(ends)?;
        let kind = String::from_utf8_lossy(&data[..4]);
        if crc32fast::hash(data) != number(sum) {
            return Err(format!("the chunk `{kind}` has a wrong checksum (CRC); it is damaged"));
        }
        if kind == "IEND" {
            return Ok(size);
        }
        rest = after;
    }
}
