//! Forms that real files have: what has one meaning loads, with a note on what was ignored.

use ::exr::prelude::{
    AnyChannel, AnyChannels, Encoding as ExrEncoding, FlatSamples, Image, IntegerBounds, Layer,
    LayerAttributes, Vec2, WritableImage,
};
use formats::images::decode_layer;

use super::*;

fn samples(channel: usize, texels: usize) -> FlatSamples {
    FlatSamples::F32((0..texels).map(|i| (10 * channel + i) as f32).collect())
}

/// An EXR file of these channels; the i-th has the values 10 i, 10 i + 1, … in the file's order of names.
fn exr_of(names: &[&str], size: [usize; 2], at: [i32; 2], display: [usize; 2]) -> Vec<u8> {
    let mut names = names.to_vec();
    names.sort_unstable();
    let channel = |(i, name): (usize, &&str)| AnyChannel::new(*name, samples(i, size[0] * size[1]));
    let channels = AnyChannels::sort(names.iter().enumerate().map(channel).collect());
    let attributes = LayerAttributes { layer_position: Vec2(at[0], at[1]), ..Default::default() };
    let layer = Layer::new((size[0], size[1]), attributes, ExrEncoding::UNCOMPRESSED, channels);
    let mut image = Image::from_layer(layer);
    image.attributes.display_window = IntegerBounds::new(Vec2(0, 0), Vec2(display[0], display[1]));
    let mut bytes = std::io::Cursor::new(Vec::new());
    image.write().non_parallel().to_buffered(&mut bytes).expect("it is right");
    bytes.into_inner()
}

pub fn exr_named(names: &[&str]) -> Vec<u8> {
    exr_of(names, [1, 1], [0, 0], [1, 1])
}

fn notes(bytes: &[u8]) -> String {
    decode(bytes, None, MAX).expect("it is right").notes().join("; ")
}

/// Law: the only set of R, G and B is taken, whatever its prefix, and one channel Y is grey; of several
/// sets the error lists all, and each can be chosen. Oracle: the values, which differ in every channel.
#[test]
fn layers_are_chosen_by_name() {
    for prefix in ["", "left.", "ViewLayer.Combined."] {
        let names = ["R", "G", "B", "A"].map(|c| format!("{prefix}{c}"));
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        assert_eq!(linear(&exr_named(&names)), [[30.0, 20.0, 10.0]], "{prefix}");
    }
    assert_eq!(linear(&exr_named(&["A", "Y"])), [[10.0; 3]]);
    let two = exr_named(&["a.R", "a.G", "a.B", "b.c.R", "b.c.G", "b.c.B"]);
    let problem = refusal(&two);
    assert!(problem.contains("\"a\", \"b.c\""), "{problem}");
    for (layer, expected) in [("a", [20.0, 10.0, 0.0]), ("b.c", [50.0, 40.0, 30.0])] {
        let texels = decode_layer(&two, None, Some(layer), MAX).expect("it is there");
        assert_eq!(rows(&texels), [expected]);
    }
    let problem =
        decode_layer(&two, None, Some("c"), MAX).map(|_| ()).expect_err("it is not there");
    assert!(problem.contains("no layer `c`") && problem.contains("\"b.c\""), "{problem}");
    for chroma in [&["Y", "RY", "BY"][..], &["l.Y", "l.RY", "l.BY"]] {
        assert_refused("chroma", &exr_named(chroma), "not supported");
    }
    assert_refused("depth", &exr_named(&["Z"]), "it has Z");
}

/// Law: a data window is placed in its display window, black around it; what is outside is ignored with a
/// note. Oracle: the place of every texel, worked out here.
#[test]
fn data_windows_are_placed_in_the_display_window() {
    for at in [[0, 0], [1, 2], [-1, 0], [2, -1], [3, 3]] {
        let (size, display) = ([2_i32, 3], [4_i32, 5]);
        let file = exr_of(&["Y"], size.map(|n| n as usize), at, display.map(|n| n as usize));
        let mut expected = vec![[0.0; 3]; 20];
        let mut outside = 0;
        for i in 0..6 {
            let [x, y] = [at[0] + i % 2, at[1] + i / 2];
            if (0..4).contains(&x) && (0..5).contains(&y) {
                expected[(4 * y + x) as usize] = [f64::from(i); 3];
            } else {
                outside += 1;
            }
        }
        assert_eq!(linear(&file), expected, "{at:?}");
        let note = notes(&file);
        let right = format!("{outside} texels outside its display window");
        assert!(if outside == 0 { note.is_empty() } else { note.contains(&right) }, "{note}");
    }
}

/// Law: a permuted table of offsets gives the same image; a repeated entry is refused. Oracle: the image of
/// the unchanged file.
#[test]
fn repeated_offsets_are_refused_and_permuted_ones_load() {
    let file = exr_of(&["Y"], [2, 3], [0, 0], [2, 3]);
    let whole = linear(&file);
    // three blocks of number, size and one line of two samples, behind their offsets
    let table = file.len() - 3 * (8 + 8) - 3 * 8;
    let entry = |i: usize| &file[table + 8 * i..table + 8 * i + 8];
    for order in (0..27).map(|i| [i / 9, i / 3 % 3, i % 3]) {
        let entries = order.map(entry).concat();
        let bytes = [&file[..table], &entries, &file[table + 24..]].concat();
        if [0, 1, 2].iter().all(|i| order.contains(i)) {
            assert_eq!(linear(&bytes), whole, "{order:?}");
        } else {
            assert_refused("repeated", &bytes, "damaged");
        }
    }
}

/// Law: a PFM file has its rows from the bottom up, in the byte order that the sign of its scale says;
/// negative values become 0, with a note. Oracle: the values.
#[test]
fn pfm_files_load() {
    let values = [0.5_f32, 1.0, -0.25, 4.0, 1e10, 0.0];
    for little in [true, false] {
        let raster: Vec<u8> = values
            .iter()
            .flat_map(|v| if little { v.to_le_bytes() } else { v.to_be_bytes() })
            .collect();
        let header = if little { "PF\n1 2\n-1.0\n" } else { "PF 1 2 1\n" };
        let file = [header.as_bytes(), &raster].concat();
        let top = [4.0, f64::from(1e10_f32), 0.0];
        assert_eq!(linear(&file), [top, [0.5, 1.0, 0.0]]);
        assert!(notes(&file).contains("1 value below 0, -0.25"), "{}", notes(&file));
    }
}

/// Law: the raster of a PFM file begins one byte after its scale, also if that raster's first byte is white space, or all
/// bytes of its first sample are. Oracle: the sample's bits.
#[test]
fn a_first_sample_of_white_space_belongs_to_the_raster() {
    for space in *b" \n\t\r\x0b\x0c" {
        for first in [[space, 0, 0, 0x3f], [space, 0, 0x80, 0x3f], [space; 4]] {
            let rest = 0.5_f32.to_le_bytes();
            let file = [&b"PF\n1 1\n-1.0\n"[..], &first, &rest, &rest].concat();
            let expected = [f64::from(f32::from_le_bytes(first)), 0.5, 0.5];
            assert_eq!(linear(&file), [expected], "{first:?}");
        }
    }
}
