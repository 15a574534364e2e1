//! Files on the disk: what is read is bounded, and written pictures can be read.

use std::fs::File;
use std::io::Write;
use std::path::PathBuf;

use formats::images::{Encoding, read};
use groundtruth::film::{self, OutOfGamut, Tone};

use super::*;
use crate::prelude::*;

fn folder() -> tempfile::TempDir {
    tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).expect("the folder can be made")
}

fn problem(path: &Path) -> String {
    read(path, None, None, MAX).map(drop).expect_err("it is no image").problem
}

/// Law: a file of 1 TiB is refused by its first bytes, or by its size; neither it nor an endless device is
/// read. Oracle: the text, and that the test ends.
#[test]
fn endless_and_huge_files_are_refused_at_once() {
    let folder = folder();
    for (start, because) in [
        (&b""[..], "its first bytes are not those"),
        (b"P6 1 1 255\nabc", "1099511627776 bytes are too many"),
        (b"\x89PNG\r\n\x1a\n", "1099511627776 bytes are too many"),
    ] {
        let path = folder.path().join("huge");
        let mut file = File::create(&path).expect("it can be made");
        file.write_all(start).expect("it can be written");
        // it takes no space on the disk
        file.set_len(1 << 40).expect("it can be sparse");
        assert!(problem(&path).contains(because), "{}", problem(&path));
    }
    #[cfg(unix)]
    {
        let link = folder.path().join("endless.png");
        std::os::unix::fs::symlink("/dev/zero", &link).expect("it can be linked");
        assert_eq!(problem(&link), "not a file");
    }
}

/// Law: PPM has the bytes of PNG, PFM the numbers of EXR; read back, the pictures are equal, and linear
/// ones are those that were written, in single precision. Oracle: the other format, and the numbers.
#[test]
fn written_pictures_are_read_back() {
    let folder = folder();
    let value = |x: u32, y: u32| Rgb::new(f64::from(x) / 3.0, f64::from(y) / 2.0, 0.1);
    let mut picture = Film::new(3, 2);
    let places = (0..6).map(|i| [i % 3, i / 3]);
    places.clone().for_each(|[x, y]| picture.set([x, y], value(x, y)));
    let tone = Tone { exposure: 0.9, gamma: 2.2, out_of_gamut: OutOfGamut::MaxToOne };
    let written = |name: &str, encoding: Option<Encoding>, notes: &[&str]| {
        let path: PathBuf = folder.path().join(name);
        film::write(&picture, &tone, &path).expect("the folder can be written to");
        let texels = read(&path, encoding, None, MAX).expect("it was written here");
        assert_eq!([texels.width(), texels.height()], [3, 2]);
        assert_eq!(texels.notes(), notes);
        rows(&texels)
    };
    let (linear, note) = (Some(Encoding::Linear), "it says gamma 2.2; `encoding` counts");
    assert_eq!(written("a.ppm", linear, &[]), written("a.png", linear, &[note]));
    let exact: Vec<_> =
        places.map(|[x, y]| value(x, y).to_array().map(|c| f64::from(c as f32))).collect();
    assert_eq!(written("a.pfm", None, &[]), exact);
    assert_eq!(written("a.exr", None, &[]), exact);
    // the chunk gAMA (PNG, section 11.3.2) comes after the header: 100000 / 2.2
    let png = std::fs::read(folder.path().join("a.png")).expect("written");
    let gamma = [&4_u32.to_be_bytes()[..], b"gAMA", &45_455_u32.to_be_bytes()].concat();
    assert_eq!(png[33..45], gamma);
}
