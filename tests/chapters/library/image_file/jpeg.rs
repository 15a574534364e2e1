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

/// The code of a block whose mean is so much more than that of the block before it. The mean is 1/8 of the DC
/// coefficient, here quantised by 8.
fn block(more: i32) -> String {
    let category = 32 - more.unsigned_abs().leading_zeros();
    let bits = if more < 0 { more + (1 << category) - 1 } else { more };
    let bits = match category {
        0 => String::new(),
        category => format!("{bits:0width$b}", width = category as usize),
    };
    format!("{category:04b}{bits}{END_OF_BLOCK}")
}

/// A grey image of blocks of 8 × 8 texels beside each other; with restart markers between them, or without.
fn grey_blocks(values: &[u8], restarts: bool) -> Vec<u8> {
    // 128 is added to each
    let means: Vec<i32> = values.iter().map(|value| i32::from(*value) - 128).collect();
    let scan: Vec<u8> = match restarts {
        // each begins anew, after the markers 0xffd0 … 0xffd7 in turn
        true => {
            let blocks = means.iter().enumerate();
            let marked = |(i, mean): (usize, &i32)| {
                let marker = [0xff, 0xd0 + ((i + 7) % 8) as u8];
                [if i == 0 { &[][..] } else { &marker }, &bytes_of(&block(*mean))].concat()
            };
            blocks.flat_map(marked).collect()
        }
        false => {
            let before = [0].into_iter().chain(means.iter().copied());
            bytes_of(
                &means
                    .iter()
                    .zip(before)
                    .map(|(mean, before)| block(mean - before))
                    .collect::<String>(),
            )
        }
    };
    // nine codes of four bits for the categories 0 … 8, of which none is all ones
    let dc = [&[0x00, 0, 0, 0, 9][..], &[0; 12], &[0, 1, 2, 3, 4, 5, 6, 7, 8]].concat();
    let ac = [&[0x10, 1][..], &[0; 15], &[0]].concat();
    let width = u16::try_from(8 * values.len()).expect("it is narrow").to_be_bytes();
    [
        vec![0xff, 0xd8],
        segment(0xdb, &[&[0][..], &[8; 64]].concat()),
        segment(0xc0, &[&[8, 0, 8][..], &width, &[1, 1, 0x11, 0]].concat()),
        segment(0xc4, &dc),
        segment(0xc4, &ac),
        if restarts { segment(0xdd, &[0, 1]) } else { Vec::new() },
        segment(0xda, &[1, 1, 0, 0, 63, 0]),
        scan,
        vec![0xff, 0xd9],
    ]
    .concat()
}

pub fn grey_block(value: u8) -> Vec<u8> {
    grey_blocks(&[value], false)
}

/// Law: blocks behind restart markers (ITU-T T.81, F.1.1.5) have the greys that they have without them. Oracle: the
/// greys, in more blocks than there are markers.
#[test]
fn restart_markers_change_nothing() {
    let values: Vec<u8> = (0..20).map(|i| (37 * i % 256) as u8).collect();
    let row: Vec<_> = values.iter().flat_map(|value| [grey(u32::from(*value), 255); 8]).collect();
    for restarts in [false, true] {
        assert_eq!(linear(&grey_blocks(&values, restarts)), row.repeat(8), "restarts: {restarts}");
    }
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

/// Law: a picture is turned as its EXIF orientation says: 3 is upside down, 6 a quarter to the right. Oracle: two blocks,
/// dark and bright, whose places are known.
#[test]
fn an_image_is_turned_as_its_exif_data_say() {
    let file = grey_blocks(&[50, 200], false);
    let turned = |orientation: u8| {
        // little-endian TIFF: one entry, of tag 0x0112, type SHORT, count 1
        let tiff = b"II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0";
        let exif = [&b"Exif\0\0"[..], tiff, &[orientation, 0, 0, 0], &[0; 4]].concat();
        let bytes = [&file[..2], &segment(0xe1, &exif), &file[2..]].concat();
        let texels = decode(&bytes, Some(Encoding::Linear), MAX).expect("it is right");
        let is_dark = |column, row| texels.color(column, row)[0] < 0.5;
        let (right, top) = (texels.width() - 1, texels.height() - 1);
        ([right + 1, top + 1], [[0, top], [right, 0]].map(|[column, row]| is_dark(column, row)))
    };
    assert_eq!(turned(1), ([16, 8], [true, false]));
    assert_eq!(turned(3), ([16, 8], [false, true]));
    assert_eq!(turned(6), ([8, 16], [true, false]));
    assert_eq!(turned(8), ([8, 16], [false, true]));
}

/// Law: forms that are not read are named, and are not called damaged. Oracle: the text.
#[test]
fn other_forms_are_refused() {
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
}

/// A file that claims to be as large as possible.
pub fn claiming() -> Vec<u8> {
    let mut huge = grey_block(1);
    let size = huge.windows(2).position(|w| w == [0xff, 0xc0]).expect("it is there") + 5;
    huge[size..size + 4].fill(0xff);
    huge
}
