//! PNG (W3C, *Portable Network Graphics*): 1 to 16 bits; grey, colour or palette; also interlaced.

use std::io::{Cursor, Read};

use flate2::read::ZlibDecoder;
use image::codecs::png::PngDecoder;
use png::{ColorType, Decoder, Reader};

use super::{
    Curve, Problem, Transfer, after_the_end, check_size, damaged, integers, limits, samples,
};
use crate::images::Texels;

/// The decoder scales samples of fewer than 8 bits to 8, exactly: `255/(2ⁿ − 1)` is an integer.
pub fn decode(bytes: &[u8], transfer: Transfer, max_texels: u64) -> Result<Texels, Problem> {
    let (chunks, after) = checked_chunks(bytes)?;
    check_palette_length(&chunks)?;
    let bytes = &bytes[..bytes.len() - after.len()];
    let [width, height] = size(&chunks)?.map(u64::from);
    check_size([width, height], max_texels)?;
    // four channels of two bytes
    let decoder = PngDecoder::with_limits(Cursor::new(bytes), limits(8 * width * height));
    let image = samples(decoder.map_err(damaged)?)?;
    check_data(bytes, &chunks).map_err(|e| format!("it is damaged: {e}"))?;
    let is_8_bit = image.color().bytes_per_pixel() == image.color().channel_count();
    let texels = integers(image, if is_8_bit { 255 } else { u16::MAX }, transfer)?;
    Ok(texels.with_notes(after_the_end(after)))
}

/// What a file says of its transfer function, and a note on primaries that are not those of sRGB.
///
/// Source: W3C, *Portable Network Graphics* (third edition), 4.3: the first of cICP, iCCP, sRGB and gAMA counts.
pub fn curve(bytes: &[u8]) -> Result<(Option<Curve>, Option<String>), Problem> {
    let (chunks, _) = checked_chunks(bytes)?;
    let before_data = || chunks.iter().take_while(|chunk| chunk.kind != b"IDAT");
    let find = |kind: &[u8; 4]| before_data().find(|chunk| chunk.kind == kind);
    let gamma = || match find(b"gAMA")?.data {
        &[a, b, c, d] => {
            gamma_of(u32::from_be_bytes([a, b, c, d])).map(Transfer::of_gamma).map(Curve::Is)
        }
        _ => None,
    };
    let curve = if find(b"cICP").is_some() {
        Some(Curve::Unread("cICP"))
    } else if find(b"iCCP").is_some() {
        Some(Curve::Unread("iCCP"))
    } else if find(b"sRGB").is_some() {
        Some(Curve::Is(Transfer::Srgb))
    } else {
        gamma()
    };
    let has_others = find(b"cHRM").is_some_and(|chunk| chunk.data != srgb_primaries());
    let counts = matches!(curve, None | Some(Curve::Is(Transfer::Linear | Transfer::Gamma(_))));
    let note = "its primaries (cHRM) are not those of sRGB; they are ignored";
    Ok((curve, (has_others && counts).then(|| note.to_owned())))
}

/// The white point and the primaries of sRGB, as a cHRM chunk has them.
fn srgb_primaries() -> Vec<u8> {
    let numbers = [31270_u32, 32900, 64000, 33000, 30000, 60000, 15000, 6000];
    numbers.into_iter().flat_map(u32::to_be_bytes).collect()
}

/// The gamma whose reciprocal, in units of 1/100000, is rounded to this integer; the one with the fewest digits, as
/// 2.2 for 45455. `None` for 0, which means nothing.
fn gamma_of(power: u32) -> Option<f64> {
    let exact = (power > 0).then(|| 1e5 / f64::from(power))?;
    let scales = std::iter::successors(Some(1.0), |scale| Some(10.0 * scale)).take(10);
    let rounded = scales.map(|scale: f64| (exact * scale).round() / scale);
    let is_written_so = |gamma: &f64| (1e5 / gamma).round() == f64::from(power);
    Some(rounded.into_iter().find(is_written_so).unwrap_or(exact))
}

struct Chunk<'a> {
    kind: &'a [u8],
    data: &'a [u8],
}

/// All chunks, and the bytes after them; fails if one is incomplete or has a wrong checksum. (The decoder skips damaged
/// chunks that it does not need, and stops at the last texel.)
fn checked_chunks(bytes: &[u8]) -> Result<(Vec<Chunk<'_>>, &[u8]), Problem> {
    let ends = || "the file ends before its last chunk; it is damaged".to_owned();
    let mut chunks: Vec<Chunk<'_>> = Vec::new();
    let mut rest = bytes.get(8..).ok_or_else(ends)?; // after the signature
    while chunks.last().is_none_or(|last| last.kind != b"IEND") {
        let (length, chunk) = rest.split_first_chunk().ok_or_else(ends)?;
        let length = u32::from_be_bytes(*length) as usize;
        // kind and data, then the checksum of both
        let (chunk, after) = chunk.split_at_checked(length.saturating_add(4)).ok_or_else(ends)?;
        let (sum, after) = after.split_first_chunk().ok_or_else(ends)?;
        let (kind, data) = chunk.split_at(4);
        if crc32fast::hash(chunk) != u32::from_be_bytes(*sum) {
            let kind = String::from_utf8_lossy(kind);
            return Err(format!("the chunk `{kind}` has a wrong checksum (CRC); it is damaged"));
        }
        chunks.push(Chunk { kind, data });
        rest = after;
    }
    Ok((chunks, rest))
}

/// Fails unless each palette has 1 to 256 colours of three bytes. (The decoder panics.)
fn check_palette_length(chunks: &[Chunk<'_>]) -> Result<(), Problem> {
    let is_right = |bytes: usize| bytes.is_multiple_of(3) && (3..=768).contains(&bytes);
    let mut palettes = chunks.iter().filter(|chunk| chunk.kind == b"PLTE");
    match palettes.find(|palette| !is_right(palette.data.len())) {
        Some(palette) => Err(format!(
            "its palette (PLTE) has {} bytes; right are 3 for each of 1 to 256 colors; it is damaged",
            palette.data.len()
        )),
        None => Ok(()),
    }
}

/// Width and height, from the first chunk.
fn size(chunks: &[Chunk<'_>]) -> Result<[u32; 2], Problem> {
    match (chunks[0].kind, chunks[0].data) {
        (b"IHDR", &[a, b, c, d, e, f, g, h, ..]) => {
            Ok([u32::from_be_bytes([a, b, c, d]), u32::from_be_bytes([e, f, g, h])])
        }
        _ => Err("a PNG file begins with its header (IHDR); this one is damaged".to_owned()),
    }
}

/// Checks what the decoder does not check: it stops at the last texel, ignores the checksum of the
/// data, and reads samples beyond the palette as black.
fn check_data(bytes: &[u8], chunks: &[Chunk<'_>]) -> Result<(), Problem> {
    let reader = || Decoder::new(Cursor::new(bytes)).read_info().map_err(|e| e.to_string());
    let data = chunks.iter().filter(|chunk| chunk.kind == b"IDAT");
    let data: Vec<u8> = data.flat_map(|chunk| chunk.data).copied().collect();
    check_length(&data, row_bytes(reader()?)?)?;
    check_palette(reader()?)
}

/// The number of bytes of all rows, interlaced or not, each with one byte for its filter type.
fn row_bytes(mut reader: Reader<Cursor<&[u8]>>) -> Result<u64, Problem> {
    let mut bytes = 0;
    while let Some(row) = reader.next_row().map_err(|e| e.to_string())? {
        bytes += 1 + row.data().len() as u64;
    }
    Ok(bytes)
}

/// Fails if the decompressed data have another length or a wrong checksum (Adler-32).
fn check_length(data: &[u8], expected: u64) -> Result<(), Problem> {
    let mut inflated = ZlibDecoder::new(data).take(expected + 1);
    let found = std::io::copy(&mut inflated, &mut std::io::sink());
    match found.map_err(|e| format!("its data have a wrong checksum, or no end ({e})"))? {
        found if found == expected => Ok(()),
        _ => Err(format!("its data go on after the last row, of {expected} bytes in all")),
    }
}

fn check_palette(mut reader: Reader<Cursor<&[u8]>>) -> Result<(), Problem> {
    let info = reader.info();
    let (ColorType::Indexed, Some(palette)) = (info.color_type, &info.palette) else {
        return Ok(());
    };
    let (entries, width, bits) = (palette.len() / 3, info.width as usize, info.bit_depth as usize);
    let row_length = info.raw_row_length() - 1; // without the filter's byte
    let mut packed = vec![0; row_length * info.height as usize];
    reader.next_frame(&mut packed).map_err(|e| e.to_string())?;
    for (y, row) in packed.chunks(row_length).enumerate() {
        for x in 0..width {
            let index = row[x * bits / 8] << (x * bits % 8) >> (8 - bits);
            if usize::from(index) >= entries {
                return Err(format!(
                    "the texel in column {x}, row {y}, both from 0, has color {index} of a palette of \
                     {entries}"
                ));
            }
        }
    }
    Ok(())
}
