//! Image files: any bytes give an error, or an image with finite and non-negative colours. The memory is in
//! proportion to the allowed number of texels. A PNG is also decoded with right checksums: with wrong ones,
//! as changed bytes have them, it is refused before the decoder sees it.

use formats::images::{Encoding, decode};

/// More texels than this are refused.
const MAX: u64 = 1 << 12;

/// What a PNG file begins with.
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

/// Decodes a file, and a PNG also with its checksums repaired.
pub fn run(data: &[u8]) {
    decode_twice(data);
    if data.starts_with(PNG) {
        decode_twice(&repaired(data));
    }
}

/// The same PNG with a right checksum (CRC-32) behind every whole chunk.
fn repaired(png: &[u8]) -> Vec<u8> {
    let mut png = png.to_vec();
    let mut rest = &mut png[PNG.len()..];
    while let Some((length, chunk)) = rest.split_first_chunk_mut() {
        // kind and data, then the checksum of both
        let length = (u32::from_be_bytes(*length) as usize).saturating_add(4);
        let Some((chunk, after)) = chunk.split_at_mut_checked(length) else { break };
        let Some((sum, after)) = after.split_first_chunk_mut() else { break };
        *sum = crc32fast::hash(chunk).to_be_bytes();
        rest = after;
    }
    png
}

/// Decodes a file of any format twice: with its default encoding and as linear values.
fn decode_twice(data: &[u8]) {
    let [default, linear] = [None, Some(Encoding::Linear)].map(|e| decode(data, e, MAX));
    let (Ok(default), Ok(linear)) = (&default, &linear) else {
        assert_eq!(default.is_ok(), linear.is_ok(), "only one encoding is accepted");
        return;
    };
    assert!(u64::from(linear.width()) * u64::from(linear.height()) <= MAX);
    for row in 0..linear.height() {
        for column in 0..linear.width() {
            for texels in [default, linear] {
                let color = texels.color(column, row).map(f64::from);
                assert!(color.iter().all(|c| c.is_finite() && *c >= 0.0), "{color:?}");
            }
        }
    }
}
