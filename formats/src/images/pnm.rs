//! PPM, PGM and PBM (Netpbm's `ppm(5)`, `pgm(5)`, `pbm(5)`): P1 to P6, the format of the book.

use std::io::{Cursor, Read};

use image::codecs::pnm::{GraymapHeader, PixmapHeader, PnmDecoder, PnmHeader};

use super::{Problem, Transfer, after_the_end, check_size, damaged, integers, samples};
use crate::images::Texels;

/// Samples are divided by maxval. The decoder would round them to 8 or 16 bits and hide samples
/// above maxval, so it gets a header whose maxval needs no scaling.
pub fn decode(bytes: &[u8], transfer: Transfer, max_texels: u64) -> Result<Texels, Problem> {
    let bytes = without_comments(bytes);
    let (raster, header) = PnmDecoder::new(Cursor::new(&bytes[..])).map_err(damaged)?.into_inner();
    check_size([header.width(), header.height()].map(u64::from), max_texels)?;
    let raster = &bytes[raster.position() as usize..];
    let raster = match raster_bytes(bytes[1], &header) {
        Some(expected) if raster.len() != expected => behind_comments(raster, expected),
        _ => raster,
    };
    let (unscaled, largest) = unscaled(header);
    let mut start = Vec::new();
    unscaled.write(&mut start).expect("nothing fails that is written to memory");
    let mut reader = Cursor::new(start).chain(raster);
    let image = samples(PnmDecoder::new(&mut reader).map_err(damaged)?)?;
    let mut left = Vec::new();
    reader.read_to_end(&mut left).expect("nothing fails that is read from memory");
    let texels = integers(image, largest, transfer)?;
    Ok(texels.with_notes(after_the_end(left.trim_ascii())))
}

/// The same file without comments, which the decoder does not accept everywhere: from `#` to the end of
/// the line, in the header, and in all of a file whose samples are text. In a binary file a comment may
/// stand directly after the last number of the header; for one behind white space see
/// [`behind_comments`].
fn without_comments(bytes: &[u8]) -> Vec<u8> {
    let (mut rest, mut kept) = (bytes, Vec::with_capacity(bytes.len()));
    let is_text = matches!(bytes[1], b'1'..=b'3');
    let numbers = if bytes[1] == b'4' { 3 } else { 4 };
    let mut words = 0;
    while let Some((&byte, after)) = rest.split_first() {
        let word_ends = kept.last().is_some_and(|last: &u8| !last.is_ascii_whitespace());
        let is_space = byte.is_ascii_whitespace() || byte == b'#';
        words += u32::from(is_space && word_ends);
        rest = after;
        if byte == b'#' {
            let end = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
            rest = &rest[end.map_or(rest.len(), |end| end + 1)..];
            kept.push(b'\n');
        } else {
            kept.push(byte);
        }
        if is_space && words == numbers && !is_text {
            kept.extend(rest);
            break;
        }
    }
    kept
}

/// The length of binary samples.
fn raster_bytes(format: u8, header: &PnmHeader) -> Option<usize> {
    let (width, height) = (header.width() as usize, header.height() as usize);
    let sample = if header.maximal_sample() < 256 { 1 } else { 2 };
    match format {
        b'4' => Some(width.div_ceil(8) * height),
        b'5' => Some(width * height * sample),
        b'6' => Some(3 * width * height * sample),
        _ => None,
    }
}

/// Without the lines of comments that some programs write before binary samples. A `#` there may be a
/// sample as well: it begins a comment only if exactly the samples follow.
fn behind_comments(raster: &[u8], expected: usize) -> &[u8] {
    let mut rest = raster;
    while rest.len() > expected && rest.first() == Some(&b'#') {
        let Some(end) = rest.iter().position(|byte| *byte == b'\n') else { break };
        rest = &rest[end + 1..];
    }
    if rest.len() == expected { rest } else { raster }
}

/// The same header with the largest maxval of the same number of bytes, and the sample that means
/// 1.
fn unscaled(header: PnmHeader) -> (PnmHeader, u16) {
    let full = |maxval: u32| if maxval <= 255 { 255 } else { u32::from(u16::MAX) };
    if let Some(&PixmapHeader { encoding, height, width, maxval }) = header.as_pixmap() {
        let header = PixmapHeader { encoding, height, width, maxval: full(maxval) };
        return (header.into(), maxval as u16);
    }
    if let Some(&GraymapHeader { encoding, height, width, maxwhite }) = header.as_graymap() {
        let header = GraymapHeader { encoding, height, width, maxwhite: full(maxwhite) };
        return (header.into(), maxwhite as u16);
    }
    // bits become 0 and 255
    (header, 255)
}
