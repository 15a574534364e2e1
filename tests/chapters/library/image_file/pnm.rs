//! PPM, PGM and PBM.

use super::*;

/// Law: a sample is `v/maxval`, for any maxval, one byte up to 255 and two above, binary or as text.
/// Oracle: the quotient.
#[test]
fn samples_are_divided_by_maxval() {
    for maxval in [1_u32, 3, 100, 254, 255, 256, 1000, 65_534, 65_535] {
        let values = [0, 1, maxval / 2, maxval - 1, maxval, maxval / 3];
        let expected: Vec<_> =
            values.chunks(3).map(|c| [0, 1, 2].map(|i| grey(c[i], maxval)[0])).collect();
        let text = values.map(|v| v.to_string()).join(" ");
        let text = format!("P3\n2 1\n{maxval}\n{text}\n");
        assert_eq!(linear(text.as_bytes()), expected, "text, maxval {maxval}");
        let size = if maxval < 256 { 1 } else { 2 };
        let samples = values.iter().flat_map(|v| v.to_be_bytes()[4 - size..].to_vec());
        let mut binary = format!("P6\n2 1\n{maxval}\n").into_bytes();
        binary.extend(samples);
        assert_eq!(linear(&binary), expected, "binary, maxval {maxval}");
    }
}

/// Law: rows come from the top, columns from the left; greys and bits (1 is black) are kept, rows of bits
/// are padded to bytes. Oracle: the formats' definitions.
#[test]
fn greys_and_bits_load() {
    let four = [0, 50, 100, 200].map(|v| grey(v, 200));
    assert_eq!(linear(b"P2 2 2 200 0 50 100 200"), four);
    assert_eq!(linear(b"P5 2 2 200\n\x00\x32\x64\xc8"), four);
    let texels = decode(b"P2 2 2 200 0 50 100 200", Some(Encoding::Linear), MAX).expect("right");
    assert_eq!(texels.color(1, 0).map(f64::from), grey(200, 200), "bottom right");
    let bits = [1, 0, 1, 0, 0, 1].map(|v| grey(v, 1));
    assert_eq!(linear(b"P1 3 2 0 1 0 1 1 0"), bits);
    assert_eq!(linear(b"P1 3 2\n010\n110\n"), bits);
    assert_eq!(linear(b"P4 3 2\n\x5f\xdf"), bits, "the five bits after a row do not count");
}

/// Law: comments and any white space are allowed between the numbers of a header. Oracle: the same image
/// without them.
#[test]
fn comments_in_headers_are_skipped() {
    let plain = linear(b"P6 1 2 255\n\x01\x02\x03\x04\x05\x06");
    for header in [
        "P6\n# made by hand\n1 2\n255\n",
        "P6 #a\n1 #b\n2\n# c 7 7 7\n\n255\n",
        "P6\t1\r\n2 \n 255 ",
        "P6 1 2 255# the largest value\n",
    ] {
        let bytes = [header.as_bytes(), b"\x01\x02\x03\x04\x05\x06"].concat();
        assert_eq!(linear(&bytes), plain, "{header:?}");
    }
}

/// Law: lines of comments between the header and binary samples are skipped if exactly the samples follow
/// them; else a `#` is a sample. Oracle: the same image without them.
#[test]
fn comments_before_binary_samples_are_told_apart_by_the_length() {
    for samples in [
        b"\x01\x02\x03\x04\x05\x06\x07\x08\x09\x0b\x0c\x0d",
        b"#1\n#2\n#3\n#4\n",
        b"#\x02\x03#\n\n#\x02\x03#\n\n",
    ] {
        let of = |comments: &[u8]| [&b"P6 2 2 255\n"[..], comments, samples].concat();
        let plain = linear(&of(b""));
        assert_eq!(plain[0][0], grey(u32::from(samples[0]), 255)[0]);
        for comments in [&b"# c\n"[..], b"#\n# second\n"] {
            assert_eq!(linear(&of(comments)), plain, "{}", comments.escape_ascii());
        }
        let longer = [&of(b"# c\n")[..], b"x"].concat();
        let header = b"P6 2 2 255\n".len();
        assert_eq!(linear(&longer), linear(&longer[..header + 12]), "`#` is a sample");
    }
    for (header, samples) in [
        ("P4 9 3", &b"\x5f\x80\xdf\x00\x11\x80"[..]),
        ("P5 2 3 255", b"#\x01\x02\x03\x04\n"),
        ("P5 2 3 300", b"\x01\x00\x00#\x01\x01\x01\x02\x00\n\x00#"),
        ("P6 2 2 300", &[0, 1].repeat(12)),
    ] {
        let of =
            |comment: &str| linear(&[format!("{header}\n{comment}").as_bytes(), samples].concat());
        assert_eq!(of("# c\n"), of(""), "{header} with a comment");
    }
}

/// Law: too few samples, samples above maxval, maxval 0 or above 65535, and sizes of 0 are refused. Oracle: the text.
#[test]
fn wrong_numbers_are_refused() {
    assert_refused("text", b"P3 1 1 100 1 101 3", "found a sample of 101");
    assert_refused("binary", b"P6 1 1 100\n\x01\x65\x03", "found a sample of 101");
    assert_refused("two bytes", b"P5 1 1 300\n\x01\x2d", "found a sample of 301");
    assert_refused("0", b"P6 1 1 0\n\x01\x65\x03", "MAXVAL is zero");
    assert_refused("65536", b"P6 1 1 65536\n\x01\x65\x03", "MAXVAL exceeds");
    assert_refused("no columns", b"P6 0 1 255\n", "0 × 1 texels; an image has at least one");
    assert_refused("a letter", b"P3 1 1 255 a b c", "damaged");
    assert_refused("few", b"P3 1 1 255 1 2", "damaged");
    assert_refused("cut", b"P6 2 2 255\nabcdefghijk", "the file ends before its last texel");
    assert_eq!(linear(b"P3 1 1 255 1 2 3 \n\n").len(), 1, "white space may follow");
}
