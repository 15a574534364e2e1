//! The crops of a page: what is shown of a region, and which pixel is framed.

use std::io::Cursor;

use groundtruth::film::Film;
use image::RgbImage;
use pictures::compare::{Picture, page};
use text::told::Told;

use super::compared;
use crate::verbs::{equal, near};

/// The bytes of a text in base 64.
fn decoded(text: &str) -> Vec<u8> {
    let digit = |c: u8| match c {
        b'A'..=b'Z' => c - b'A',
        b'a'..=b'z' => c - b'a' + 26,
        b'0'..=b'9' => c - b'0' + 52,
        b'+' => 62,
        _ => 63,
    };
    let four = |four: &[u8]| {
        let bits = four
            .iter()
            .filter(|c| **c != b'=')
            .fold(0_u32, |bits, c| bits << 6 | u32::from(digit(*c)));
        let digits = four.iter().filter(|c| **c != b'=').count();
        let bits = bits << (6 * (4 - digits));
        bits.to_be_bytes()[1..digits].to_vec()
    };
    text.as_bytes().chunks(4).flat_map(four).collect()
}

/// The crops with a frame: the picture, and left, top, width and height of the frame in parts of it.
fn crops(html: &str) -> Vec<(RgbImage, [f64; 4])> {
    let frames = html.split("<i style=\"").skip(1);
    let before = html.split("<i style=\"");
    let of = |(before, frame): (&str, &str)| {
        let data = before.rsplit_once("base64,").expect("a picture").1.split('"').next();
        let bytes = decoded(data.expect("its end"));
        let picture = image::load(Cursor::new(bytes), image::ImageFormat::Png).expect("a picture");
        let style = frame.split('"').next().expect("its end");
        let part = |name: &str| -> f64 {
            let value = style.split(';').find_map(|it| it.strip_prefix(name)).expect(name);
            value.trim_end_matches('%').parse::<f64>().expect("a number") / 100.0
        };
        (picture.into_rgb8(), ["left:", "top:", "width:", "height:"].map(part))
    };
    before.zip(frames).map(of).collect()
}

/// Law: a crop shows the region and four pixels around it, of those inside the picture and at most sixteen from the worst one;
/// the worst pixel is framed in both pictures. Oracle: the pixels counted one by one, and the only one that is white.
#[test]
fn crops_show_the_region_and_frame_its_worst_pixel() {
    let size @ [width, height] = [60_u32, 44];
    for ([x, y, w, h], worst) in [
        ([10, 10, 3, 2], [11, 11]),
        ([0, 0, 1, 1], [0, 0]),
        ([59, 43, 1, 1], [59, 43]),
        ([0, 5, 60, 1], [30, 5]),
        ([7, 0, 1, 44], [7, 43]),
        ([20, 20, 25, 20], [44, 20]),
        ([55, 40, 5, 4], [56, 42]),
    ] {
        let ours = Picture::of_film(&Film::new(width, height));
        let mut theirs = ours.clone();
        for row in y..y + h {
            (x..x + w).for_each(|column| theirs.values[(row * width + column) as usize] = [0.5; 3]);
        }
        theirs.values[ours.index(worst)] = [1.0; 3];
        let comparison = compared(&ours, &theirs);
        let told = Told { verdict: String::new(), details: String::new(), next: String::new() };
        let html = page(&comparison, &told, ["A", "B"], [&ours, &theirs], &|_| Vec::new());
        let crops = crops(&html);
        equal("framed crops", crops.len(), 2);
        let what = format!("{w}x{h} at {x},{y} of {size:?}");
        // how many columns, or rows, are shown
        let shown = |start: u32, length: u32, worst: u32, side: u32| -> Vec<u32> {
            let is_near = |at: &u32| at + 4 >= start && *at < start + length + 4;
            (0..side).filter(|at| is_near(at) && at.abs_diff(worst) <= 16).collect()
        };
        let columns = shown(x, w, worst[0], width);
        let rows = shown(y, h, worst[1], height);
        for (index, (crop, [left, top, across, down])) in crops.iter().enumerate() {
            let size = [crop.width(), crop.height()];
            equal(format!("{what}: crop {index}"), size, [columns.len() as u32, rows.len() as u32]);
            near(format!("{what}: width of the frame"), across * f64::from(size[0]), 1.0, 1e-9);
            near(format!("{what}: height of the frame"), down * f64::from(size[1]), 1.0, 1e-9);
            let at = [left * f64::from(size[0]), top * f64::from(size[1])];
            for (axis, all) in [&columns, &rows].into_iter().enumerate() {
                let place = all.iter().position(|it| *it == worst[axis]).expect("it is shown");
                near(
                    format!("{what}: place of the frame, axis {axis}"),
                    at[axis],
                    place as f64,
                    1e-6,
                );
            }
            let framed = crop.get_pixel(at[0].round() as u32, at[1].round() as u32).0;
            equal(format!("{what}: framed pixel"), framed, [[0; 3], [255; 3]][index]);
        }
    }
}
