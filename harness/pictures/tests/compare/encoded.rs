//! PNG files that say which transfer function they have.

use std::path::Path;

use groundtruth::film::Film;
use groundtruth::math::power;
use groundtruth::rgb::Rgb;
use pictures::compare::{Picture, Transfer};

use super::compared;
use crate::verbs::{equal, near};

/// Radiance from 0 to 1, in steps that no integer of 8 bits falls on.
fn radiance() -> Film {
    let mut film = Film::new(64, 16);
    for index in 0..1024 {
        let grey = f64::from(index) / 1023.0;
        film.set([index % 64, index / 64], Rgb::new(grey, 1.0 - grey, grey * grey));
    }
    film
}

fn gamma(x: f64) -> f64 {
    power(x, 1.0 / 2.2)
}

/// IEC 61966-2-1.
pub fn srgb(x: f64) -> f64 {
    if x <= 0.0031308 { 12.92 * x } else { 1.055 * power(x, 1.0 / 2.4) - 0.055 }
}

/// A chunk of a PNG file: the length, kind and data, and the checksum of both.
fn chunk(kind: &str, data: &[u8]) -> Vec<u8> {
    let body = [kind.as_bytes(), data].concat();
    let [length, sum] = [data.len() as u32, crc32fast::hash(&body)].map(u32::to_be_bytes);
    [&length[..], &body, &sum].concat()
}

/// The radiance in 8 bits, encoded by a function, in a file with these chunks after its header.
fn file(folder: &Path, encode: fn(f64) -> f64, chunks: &[Vec<u8>]) -> std::path::PathBuf {
    let film = radiance();
    let byte = |x: f64| (255.0 * encode(x)).round() as u8;
    let bytes = film.pixels().iter().flat_map(|pixel| pixel.to_array().map(byte)).collect();
    let picture = image::RgbImage::from_raw(64, 16, bytes).expect("three bytes a pixel");
    let path = folder.join("encoded.png");
    picture.save(&path).expect("written");
    let mut bytes = std::fs::read(&path).expect("it is there");
    bytes.splice(33..33, chunks.concat());
    std::fs::write(&path, bytes).expect("written");
    path
}

/// Law: a picture equals its radiance if it is encoded as its file says, by gAMA or sRGB, of which sRGB counts; not if
/// the file says nothing, another thing, or a thing that is not read (a profile), which is said. Oracle: the transfer
/// functions by hand; W3C, *Portable Network Graphics*, for chunks and their order.
#[test]
fn png_files_are_decoded_as_they_say() {
    let folder = tempfile::tempdir().expect("a folder");
    let ours = Picture::of_film(&radiance());
    let gama = |power: u32| chunk("gAMA", &power.to_be_bytes());
    let srgb_chunk = || chunk("sRGB", &[0]);
    // a profile of no bytes: a name, the method, and an empty zlib stream
    let stream = [0x78, 1, 1, 0, 0, 0xff, 0xff, 0, 0, 0, 1];
    let profile = || chunk("iCCP", &[&b"p\0\0"[..], &stream].concat());
    let video = || chunk("cICP", &[1, 8, 0, 1]);
    let (yes, no) = (true, false);
    type Case = (fn(f64) -> f64, Vec<Vec<u8>>, Option<Transfer>, bool, &'static str);
    let cases: [Case; 12] = [
        (
            gamma,
            vec![gama(45455)],
            Some(Transfer::Gamma(2.2)),
            yes,
            "is gamma 2.2, as the file says",
        ),
        (|x| x, vec![gama(100_000)], Some(Transfer::Linear), yes, "is linear, as the file says"),
        (srgb, vec![srgb_chunk()], Some(Transfer::Srgb), yes, "is sRGB, as the file says"),
        (srgb, vec![gama(45455), srgb_chunk()], Some(Transfer::Srgb), yes, "is sRGB"),
        (srgb, vec![], None, yes, ""),
        (srgb, vec![gama(0)], None, yes, ""),
        (gamma, vec![], None, no, ""),
        (|x| x, vec![gama(45455)], Some(Transfer::Gamma(2.2)), no, "is gamma 2.2"),
        (srgb, vec![gama(45455)], Some(Transfer::Gamma(2.2)), no, "is gamma 2.2"),
        (srgb, vec![profile(), gama(100_000)], None, yes, "in a chunk iCCP, which is not read"),
        (srgb, vec![video(), srgb_chunk()], None, yes, "in a chunk cICP, which is not read"),
        (gamma, vec![gama(55556)], Some(Transfer::Gamma(1.8)), no, "is gamma 1.8"),
    ];
    for (encode, chunks, stated, is_same, note) in cases {
        let theirs = Picture::read(&file(folder.path(), encode, &chunks), None).expect("a picture");
        assert_eq!(
            (theirs.stated, compared(&ours, &theirs).is_same()),
            (stated, is_same),
            "{note}"
        );
        assert_eq!(theirs.notes.len(), usize::from(!note.is_empty()), "{:?}", theirs.notes);
        assert!(theirs.notes.iter().all(|found| found.contains(note)), "{:?}", theirs.notes);
    }
    let path = file(folder.path(), gamma, &[gama(100_000)]);
    let theirs = Picture::read(&path, Some(Transfer::Gamma(2.2))).expect("a picture");
    assert!(compared(&ours, &theirs).is_same(), "the user's word counts");
    assert_eq!(theirs.notes, ["it says linear; --encoding counts"]);
}

/// Law: primaries that are not those of sRGB are noted. Oracle: those of ITU-R BT.709, which are the same, and BT.2020.
#[test]
fn other_primaries_are_noted() {
    let folder = tempfile::tempdir().expect("a folder");
    let primaries = |numbers: [u32; 8]| chunk("cHRM", &numbers.map(u32::to_be_bytes).concat());
    for (numbers, count) in [
        ([31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000], 0),
        ([31270, 32900, 70800, 29200, 17000, 79700, 13100, 4600], 1),
    ] {
        let picture = Picture::read(&file(folder.path(), srgb, &[primaries(numbers)]), None);
        let notes = picture.expect("a picture").notes;
        assert_eq!(notes.iter().filter(|note| note.contains("cHRM")).count(), count, "{notes:?}");
    }
}

/// Law: a gamma that no display has is refused, by the chunk's name and its value, unless the user says how the values are
/// encoded; so is one that the user says. Oracle: the chunk that was written.
#[test]
fn gammas_that_no_display_has_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    for (power, gamma) in [(1_u32, "100000"), (9_999, "10.001"), (1_000_010, "0.099999")] {
        let path = file(folder.path(), srgb, &[chunk("gAMA", &power.to_be_bytes())]);
        let error = Picture::read(&path, None).expect_err("no display has it").to_string();
        assert!(error.contains(&format!("its chunk gAMA says gamma {gamma}")), "{error}");
        assert!(Picture::read(&path, Some(Transfer::Srgb)).is_ok());
    }
    for power in [10_000_u32, 1_000_000] {
        let path = file(folder.path(), srgb, &[chunk("gAMA", &power.to_be_bytes())]);
        assert!(Picture::read(&path, None).is_ok(), "{power}");
    }
    for said in ["gamma=100000", "gamma=0.05", "gamma=0", "gamma=-2", "gamma=nan", "gamma=inf"] {
        let error = said.parse::<Transfer>().expect_err("no display has it");
        assert!(error.contains("from 0.1 to 10"), "{error}");
    }
    assert_eq!("gamma=2.2".parse(), Ok(Transfer::Gamma(2.2)));
}

/// Law: a picture in a file of 16 bits has steps of 1/255 if all its values are integers of 8 bits, and else of 1/65535. There
/// is no note if the user states the encoding that the file states. Oracle: values on both sides of an integer of 8 bits.
#[test]
fn files_of_16_bits_are_told_by_their_values() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("bits.png");
    for (odd, largest) in
        [(257 * 40, 255.0), (257 * 40 + 1, 65_535.0), (257 * 40 - 1, 65_535.0), (1, 65_535.0)]
    {
        let values = [0_u16, 257, 65_535, odd, 257 * 100, 257 * 7];
        let picture = image::ImageBuffer::<image::Rgb<u16>, _>::from_raw(2, 1, values.to_vec());
        picture.expect("three values a pixel").save(&path).expect("written");
        let read = Picture::read(&path, None).expect("a picture");
        near(format!("{odd}: steps to 1"), read.step.map_or(0.0, f64::recip), largest, 1e-6);
    }
    let path = file(folder.path(), srgb, &[chunk("sRGB", &[0])]);
    let said = Picture::read(&path, Some(Transfer::Srgb)).expect("a picture");
    equal("notes", said.notes, Vec::<String>::new());
}
