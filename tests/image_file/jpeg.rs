//! JPEG (ITU-T T.81): files of one grey block, whose codes are written out here.

use super::*;

/// The code for the end of a block; the only one of the table for AC coefficients.
const END_OF_BLOCK: &str = "0";

fn segment(marker: u8, data: &[u8]) -> Vec<u8> {
    let length = u16::try_from(data.len() + 2).expect("it is short");
    [&[0xff, marker][..], &length.to_be_bytes(), data].concat()
}

/// The bits of a file's data, filled up with ones; behind 0xff stands a 0, so that it is no marker.
fn bytes_of(bits: &str) -> Vec<u8> {
    let padded = format!("{bits}{}", "1".repeat(bits.len().next_multiple_of(8) - bits.len()));
    let bytes = (0..padded.len() / 8).map(|i| &padded[8 * i..8 * i + 8]);
    let bytes = bytes.map(|byte| u8::from_str_radix(byte, 2).expect("eight bits"));
    bytes.flat_map(|byte| if byte == 0xff { vec![byte, 0] } else { vec![byte] }).collect()
}

/// A grey image of 8 × 8 texels of this value. The mean of a block is 1/8 of its DC coefficient, here
/// quantised by 8, and 128 is added to it.
fn grey_block(value: u8) -> Vec<u8> {
    let mean = i32::from(value) - 128;
    let category = 32 - mean.unsigned_abs().leading_zeros();
    let bits = if mean < 0 { mean + (1 << category) - 1 } else { mean };
    let bits = match category {
        0 => String::new(),
        category => format!("{bits:0width$b}", width = category as usize),
    };
    // nine codes of four bits for the categories 0 … 8, of which none is all ones
    let dc = [&[0x00, 0, 0, 0, 9][..], &[0; 12], &[0, 1, 2, 3, 4, 5, 6, 7, 8]].concat();
    let ac = [&[0x10, 1][..], &[0; 15], &[0]].concat();
    [
        vec![0xff, 0xd8],
        segment(0xdb, &[&[0][..], &[8; 64]].concat()),
        segment(0xc0, &[8, 0, 8, 0, 8, 1, 1, 0x11, 0]),
        segment(0xc4, &dc),
        segment(0xc4, &ac),
        segment(0xda, &[1, 1, 0, 0, 63, 0]),
        bytes_of(&format!("{category:04b}{bits}{END_OF_BLOCK}")),
        vec![0xff, 0xd9],
    ]
    .concat()
}

/// Law: a block of one grey has it in every texel, for each of the 256. Oracle: the standard's mean of a
/// block.
#[test]
fn a_grey_block_has_its_grey() {
    for value in 0..=255 {
        assert_eq!(linear(&grey_block(value)), [grey(u32::from(value), 255); 64], "{value}");
    }
}

/// Law: sRGB is the default. Oracle: PPM with the same sample.
#[test]
fn samples_are_srgb_like_those_of_ppm() {
    let ppm = decode(b"P5 1 1 255\n\x64", None, MAX).expect("it is right");
    let jpeg = decode(&grey_block(100), None, MAX).expect("it is right");
    assert_eq!(rows(&jpeg), [rows(&ppm)[0]; 64]);
}

/// Law: cut off anywhere, a file is refused; bytes behind it are ignored with a note. Oracle: every prefix.
#[test]
fn truncated_files_are_refused_and_longer_ones_load() {
    let file = grey_block(77);
    (0..file.len()).for_each(|length| drop(refusal(&file[..length])));
    let longer = [&file[..], b"more"].concat();
    let texels = decode(&longer, Some(Encoding::Linear), MAX).expect("it is whole");
    assert_eq!(rows(&texels), linear(&file));
    assert_eq!(texels.notes(), ["4 bytes after its end are ignored"]);
}

/// Law: forms that are not read are named, and are not called damaged; a huge size is refused by its header.
/// Oracle: the text.
#[test]
fn other_forms_and_huge_sizes_are_refused() {
    let frame = |marker: u8, channels: u8, size: [u8; 4]| {
        let frame = [&[8][..], &size, &[channels], &[1, 0x11, 0].repeat(channels.into())].concat();
        [&[0xff, 0xd8][..], &segment(marker, &frame), &[0xff, 0xd9]].concat()
    };
    for (file, because) in [
        (frame(0xc3, 1, [0, 8, 0, 8]), "lossless, hierarchical and arithmetic JPEG"),
        (frame(0xc9, 1, [0, 8, 0, 8]), "lossless, hierarchical and arithmetic JPEG"),
        (frame(0xc0, 4, [0, 8, 0, 8]), "four channels (CMYK)"),
    ] {
        assert_refused("form", &file, because);
        assert_refused("form", &file, "not supported");
        assert!(!refusal(&file).contains("damaged"));
    }
    let mut huge = grey_block(1);
    let size = huge.windows(2).position(|w| w == [0xff, 0xc0]).expect("it is there") + 5;
    huge[size..size + 4].fill(0xff);
    assert_refused("huge", &huge, "65535 × 65535 texels, with the images before it, are too many");
}
