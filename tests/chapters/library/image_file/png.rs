//! PNG, written here: stored blocks, filter 0 (ISO/IEC 15948, RFC 1950, RFC 1951).

use super::{rows as rows_of, *};

/// The CRC of ISO 3309, bit by bit.
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| {
            if crc & 1 == 1 { crc >> 1 ^ 0xedb8_8320 } else { crc >> 1 }
        })
    })
}

fn chunk(kind: &[u8; 4], data: &[u8]) -> Vec<u8> {
    let all = [&kind[..], data].concat();
    [&(data.len() as u32).to_be_bytes()[..], &all, &crc(&all).to_be_bytes()].concat()
}

/// A zlib stream of one stored block.
fn zlib(data: &[u8]) -> Vec<u8> {
    let sum = |a: u32, b: u32| ((b % 65_521) << 16) | (a % 65_521);
    let (a, b) = data.iter().fold((1_u32, 0_u32), |(a, b), byte| {
        let a = (a + u32::from(*byte)) % 65_521;
        (a, (b + a) % 65_521)
    });
    let length = data.len() as u16;
    let head = [&b"\x78\x01\x01"[..], &length.to_le_bytes(), &(!length).to_le_bytes()].concat();
    [&head[..], data, &sum(a, b).to_be_bytes()].concat()
}

const GREY: u8 = 0;
const RGB: u8 = 2;
const PALETTE: u8 = 3;
const GREY_ALPHA: u8 = 4;
const RGBA: u8 = 6;

/// How a file begins.
const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

/// A file of this size and kind of samples, with chunks before the data and rows of packed samples.
fn png(size: [u32; 2], (depth, color): (u8, u8), extra: &[Vec<u8>], rows: &[&[u8]]) -> Vec<u8> {
    file(size, [depth, color, 0, 0, 0], extra, rows)
}

/// The same interlaced: the rows of the passes.
fn interlaced(
    size: [u32; 2],
    (depth, color): (u8, u8),
    extra: &[Vec<u8>],
    rows: &[&[u8]],
) -> Vec<u8> {
    file(size, [depth, color, 0, 0, 1], extra, rows)
}

fn file(size: [u32; 2], rest: [u8; 5], extra: &[Vec<u8>], rows: &[&[u8]]) -> Vec<u8> {
    let header = [size.map(u32::to_be_bytes).as_flattened(), &rest].concat();
    let data: Vec<u8> = rows.iter().flat_map(|row| [&[0], *row].concat()).collect();
    let (data, extra) = (chunk(b"IDAT", &zlib(&data)), extra.concat());
    [SIGNATURE, &chunk(b"IHDR", &header), &extra, &data, &chunk(b"IEND", b"")].concat()
}

/// One row of these packed samples.
fn row(width: u32, depth: u8, color: u8, samples: &[u8]) -> Vec<u8> {
    png([width, 1], (depth, color), &[], &[samples])
}

/// A picture of two rows, with a text.
pub fn whole() -> Vec<u8> {
    let text = chunk(b"tEXt", b"Comment\0by hand");
    png([3, 2], (8, GREY), &[text], &[&[1, 2, 3], &[4, 5, 6]])
}

/// A file that claims to have this size.
pub fn claiming(size: [u32; 2]) -> Vec<u8> {
    png(size, (16, RGBA), &[], &[])
}

/// Law: a grey sample of n bits is `v/(2ⁿ − 1)`. Oracle: the quotient, for every value of few bits.
#[test]
fn greys_of_any_depth_load() {
    let all = |max: u32| (0..=max).map(|v| grey(v, max)).collect::<Vec<_>>();
    assert_eq!(linear(&row(2, 1, GREY, &[0b0100_0000])), all(1));
    assert_eq!(linear(&row(4, 2, GREY, &[0b0001_1011])), all(3));
    let nibbles: Vec<u8> = (0..8).map(|i| ((2 * i) << 4) | (2 * i + 1)).collect();
    assert_eq!(linear(&row(16, 4, GREY, &nibbles)), all(15));
    let bytes: Vec<u8> = (0..=255).collect();
    assert_eq!(linear(&row(256, 8, GREY, &bytes)), all(255));
    let sixteen = [0_u16, 1, 255, 256, 40_000, 65_535];
    let samples: Vec<u8> = sixteen.iter().flat_map(|v| v.to_be_bytes()).collect();
    let expected: Vec<_> = sixteen.iter().map(|v| grey(u32::from(*v), 65_535)).collect();
    assert_eq!(linear(&row(6, 16, GREY, &samples)), expected);
}

/// Law: colours have three samples, and alpha, if there is one, is left out. Oracle: the samples.
#[test]
fn colors_load_and_alpha_is_left_out() {
    let of = |v: [u32; 3], max| v.map(|v| grey(v, max)[0]);
    let two = [of([10, 20, 30], 255), of([40, 50, 255], 255)];
    assert_eq!(linear(&row(2, 8, RGB, &[10, 20, 30, 40, 50, 255])), two);
    assert_eq!(linear(&row(2, 8, RGBA, &[10, 20, 30, 0, 40, 50, 255, 99])), two);
    assert_eq!(linear(&row(2, 8, GREY_ALPHA, &[7, 0, 9, 255])), [grey(7, 255), grey(9, 255)]);
    let wide = [0x12, 0x34, 0x56, 0x78, 0x9a, 0xbc];
    let expected = [of([0x1234, 0x5678, 0x9abc], 65_535)];
    assert_eq!(linear(&row(1, 16, RGB, &wide)), expected);
    assert_eq!(linear(&row(1, 16, RGBA, &[&wide[..], &[1, 2]].concat())), expected);
    assert_eq!(linear(&row(1, 16, GREY_ALPHA, &wide[..4])), [grey(0x1234, 65_535)]);
}

/// Law: a palette gives its colours, with or without transparency. Oracle: the entries.
#[test]
fn palettes_load() {
    let palette = chunk(b"PLTE", &[255, 0, 0, 0, 128, 0, 1, 2, 3]);
    let expected =
        [[1.0, 0.0, 0.0], [1, 2, 3].map(|v| grey(v, 255)[0]), [0.0, grey(128, 255)[0], 0.0]];
    let transparency = chunk(b"tRNS", &[0, 100]);
    for extra in [vec![palette.clone()], vec![palette, transparency]] {
        for (depth, samples) in [(8, &[0_u8, 2, 1][..]), (2, &[0b0010_0100]), (4, &[0x02, 0x10])] {
            let png = png([3, 1], (depth, PALETTE), &extra, &[samples]);
            assert_eq!(linear(&png), expected, "{depth} bits");
        }
    }
}

/// Law: an interlaced image (Adam7) is the same image. Oracle: the texels of the seven passes in 3 × 3
/// texels; only the passes 1, 4, 5, 6 and 7 have any.
#[test]
fn interlaced_images_load() {
    // 0 1 2
    // 3 4 5
    // 6 7 8
    let rows: [&[u8]; 6] = [&[0], &[2], &[6, 8], &[1], &[7], &[3, 4, 5]];
    let expected: Vec<_> = (0..9).map(|v| grey(v, 255)).collect();
    assert_eq!(linear(&interlaced([3, 3], (8, GREY), &[], &rows)), expected);
}

/// Law: a file with any single bit flipped is refused: every chunk has its checksum. Oracle: every bit; the text.
#[test]
fn every_damage_is_found() {
    let whole = whole();
    assert_eq!(linear(&whole).len(), 6);
    for (at, bit) in (0..whole.len()).flat_map(|at| (0..8).map(move |bit| (at, bit))) {
        let mut bytes = whole.clone();
        bytes[at] ^= 1 << bit;
        let problem = refusal(&bytes);
        let wrong = "the chunk `IDAT` has a wrong checksum (CRC)";
        assert!(at != whole.len() - 18 || problem.contains(wrong), "{problem}");
    }
    assert_refused("cut", &whole[..whole.len() - 12], "the file ends before its last chunk");
}

/// Law: a wrong checksum of the uncompressed data is refused, or none. Oracle: the text.
#[test]
fn damage_that_chunk_checksums_miss_is_refused() {
    let mut data = zlib(&[0, 1, 2, 3]);
    let file = |data: &[u8]| {
        let header = chunk(b"IHDR", &[0, 0, 0, 3, 0, 0, 0, 1, 8, GREY, 0, 0, 0]);
        [SIGNATURE, &header, &chunk(b"IDAT", data), &chunk(b"IEND", b"")].concat()
    };
    assert_eq!(linear(&file(&data)).len(), 3);
    *data.last_mut().expect("a checksum") ^= 1;
    assert_refused("checksum", &file(&data), "its data have a wrong checksum");
    data.pop();
    assert_refused("no end", &file(&data), "its data have a wrong checksum, or no end");
}

/// Law: samples beyond the palette are refused, with the position of the first; bits after the last sample
/// of a row mean nothing, interlaced or not. Oracle: a palette of two colours, and samples by hand.
#[test]
fn samples_beyond_the_palette_are_refused() {
    let palette = [chunk(b"PLTE", &[255, 0, 0, 0, 128, 0])];
    let (size, kind) = ([3, 2], (2, PALETTE));
    let (red, green) = ([1.0, 0.0, 0.0], [0.0, grey(128, 255)[0], 0.0]);
    let rows = png(size, kind, &palette, &[&[0b0001_0011], &[0b0100_0111]]);
    // passes 1, 4, 6 and 7
    let passes: [&[u8]; 4] = [&[0b0011_1111], &[0b0011_1111], &[0b0111_1111], &[0b0100_0111]];
    for file in [rows, interlaced(size, kind, &palette, &passes)] {
        assert_eq!(linear(&file), [red, green, red, green, red, green]);
    }
    let beyond = "the texel in column 1, row 1, both from 0, has color 2 of a palette of 2";
    let rows = png(size, kind, &palette, &[&[0b0001_0000], &[0b0110_0100]]);
    assert_refused("beyond", &rows, beyond);
    let passes: [&[u8]; 4] = [&[0], &[0], &[0], &[0b0010_0000]];
    assert_refused("interlaced", &interlaced(size, kind, &palette, &passes), beyond);
}

/// Law: with right checksums but too few rows or too many, a size of 0, or a palette whose length is no multiple
/// of 3 or that is empty, an image is refused. Oracle: the text.
#[test]
fn wrong_counts_are_refused() {
    let kind = (8, GREY);
    assert_refused("too few rows", &png([3, 2], kind, &[], &[&[1, 2, 3]]), "damaged");
    let more = "its data go on after the last row, of 4 bytes in all";
    assert_refused("too many rows", &png([3, 1], kind, &[], &[&[1, 2, 3], &[4, 5, 6]]), more);
    assert_refused("no columns", &png([0, 2], kind, &[], &[]), "0 × 2 texels");
    for length in [0, 1, 2, 4, 5, 767, 769, 771] {
        let palette = [chunk(b"PLTE", &vec![0; length])];
        let png = png([1, 1], (8, PALETTE), &palette, &[&[0]]);
        assert_refused("palette", &png, "its palette (PLTE) has");
    }
}

/// Law: a texture is decoded as its file says, unless the scene says it, and a note says which. Oracle: the
/// curves, by hand; PNG, 4.3: of the chunks, cICP and iCCP count before sRGB, and this before gAMA.
#[test]
fn a_texture_is_decoded_as_its_file_says() {
    let gama = |power: u32| chunk(b"gAMA", &power.to_be_bytes());
    let decoded = |extra: Vec<Vec<u8>>, encoding| {
        let texels = decode(&png([1, 1], (8, GREY), &extra, &[&[128]]), encoding, MAX)?;
        Ok::<_, String>((rows_of(&texels), texels.notes().join("; ")))
    };
    let value = 128.0 / 255.0;
    let srgb = power((value + 0.055) / 1.055, 2.4);
    let says = |what: &str| format!("the transfer function is {what}, as the file says");
    let profile = chunk(b"cICP", &[1, 8, 0, 1]);
    let unread = "the transfer function is in a chunk cICP, which is not read; `encoding` says it";
    for (extra, encoding, expected, note) in [
        (vec![], None, srgb, String::new()),
        (vec![gama(100_000)], None, value, says("linear")),
        (vec![gama(45_455)], None, power(value, 2.2), says("gamma 2.2")),
        (vec![gama(45_455), chunk(b"sRGB", &[0])], None, srgb, says("sRGB")),
        (vec![profile, gama(100_000)], None, srgb, unread.to_owned()),
        (
            vec![gama(100_000)],
            Some(Encoding::Srgb),
            srgb,
            "it says linear; `encoding` counts".to_owned(),
        ),
        (vec![gama(100_000)], Some(Encoding::Linear), value, String::new()),
    ] {
        let (found, said) = decoded(extra, encoding).expect("it is right");
        assert_eq!(said, note);
        assert!((found[0][0] - expected).abs() < 1e-6, "{} in place of {expected}", found[0][0]);
    }
    let problem = decoded(vec![gama(1)], None).expect_err("no display is so");
    assert!(problem.contains("gamma 100000, which no display has"), "{problem}");
}
