//! JPEG (ITU-T T.81): baseline and progressive, grey and colour.

use std::io::Cursor;

use image::ImageDecoder;
use image::codecs::jpeg::JpegDecoder;

use super::{Problem, Transfer, after_the_end, check_size, damaged, integers, samples};
use crate::images::Texels;

/// The decoder fills what is missing with grey, so the segments are checked first.
pub fn decode(bytes: &[u8], transfer: Transfer, max_texels: u64) -> Result<Texels, Problem> {
    let after = after_last_segment(bytes)?;
    let whole = &bytes[..bytes.len() - after.len()];
    let decoder = JpegDecoder::new(Cursor::new(whole)).map_err(damaged)?;
    let (width, height) = decoder.dimensions();
    check_size([width, height].map(u64::from), max_texels)?;
    Ok(integers(samples(decoder)?, 255, transfer)?.with_notes(after_the_end(after)))
}

/// By how much compression may change the mean of a block of 16 × 16 pixels, in steps of 1/255: the mean of 8 × 8 values
/// is an eighth of their first coefficient, which is wrong by half of its step at most, and a channel is the sum of the
/// luminance and at most 1.772 times a chrominance (ITU-T T.81, A.3.3; JFIF 1.02). Two steps are for what is clamped and
/// rounded.
pub fn loss(bytes: &[u8]) -> f64 {
    const START_OF_SCAN: u8 = 0xda;
    const TABLES: u8 = 0xdb;
    let (mut rest, mut largest) = (bytes.get(2..).unwrap_or_default(), 1.0_f64);
    while let [0xff, marker, high, low, ..] = *rest
        && marker != START_OF_SCAN
    {
        let length = usize::from(u16::from_be_bytes([high, low]));
        let mut tables = rest.get(4..2 + length).unwrap_or_default();
        while let (TABLES, [kind, first, second, ..]) = (marker, tables) {
            let (step, length) = match kind >> 4 {
                0 => (u16::from(*first), 65),
                _ => (u16::from_be_bytes([*first, *second]), 129),
            };
            largest = largest.max(step.into());
            tables = tables.get(length..).unwrap_or_default();
        }
        rest = rest.get(2 + length..).unwrap_or_default();
    }
    2.0 + (1.0 + 1.772) * largest / 16.0
}

/// The bytes after the end marker; fails if a segment is incomplete, or there is no end.
fn after_last_segment(bytes: &[u8]) -> Result<&[u8], Problem> {
    const START_OF_SCAN: u8 = 0xda;
    const END: u8 = 0xd9;
    let ends = || "the file ends before its last segment; it is damaged".to_owned();
    let mut rest = &bytes[2..]; // after the start marker
    loop {
        let at = rest.iter().position(|byte| *byte != 0xff).ok_or_else(ends)?;
        let (marker, after) = rest[at..].split_first().ok_or_else(ends)?;
        if at == 0 {
            return Err("a segment does not begin with a marker; it is damaged".to_owned());
        }
        match *marker {
            END => return Ok(after),
            0x01 | 0xd0..=0xd7 => rest = after, // markers without a segment
            marker => {
                if let 0xc3 | 0xc5..=0xc7 | 0xc9..=0xcb | 0xcd..=0xcf = marker {
                    return Err("lossless, hierarchical and arithmetic JPEG are not supported; \
                                convert it to a baseline or progressive one"
                        .to_owned());
                }
                let length = after.first_chunk().map(|length| u16::from_be_bytes(*length));
                let length = usize::from(length.ok_or_else(ends)?);
                let (segment, after) = after.split_at_checked(length).ok_or_else(ends)?;
                if let 0xc0..=0xc2 = marker
                    && segment.get(7) == Some(&4)
                {
                    return Err("JPEG with four channels (CMYK) is not supported; convert it to \
                                RGB"
                    .to_owned());
                }
                rest = if marker == START_OF_SCAN { after_scan(after) } else { after };
            }
        }
    }
}

/// What follows the coded data of a scan: in them 0xff is followed by 0 or is a restart marker.
fn after_scan(data: &[u8]) -> &[u8] {
    let is_marker = |pair: &[u8]| pair[0] == 0xff && !matches!(pair[1], 0 | 0xd0..=0xd7 | 0xff);
    let end = data.windows(2).position(is_marker);
    &data[end.unwrap_or(data.len())..]
}
