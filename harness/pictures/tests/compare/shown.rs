//! The crops of a page: what is shown of a region, and which pixel is framed.

use groundtruth::film::Film;
use pictures::compare::{Picture, page};
use text::told::Told;

use super::compared;
use crate::verbs::{equal, near};

/// Left, top, width and height of the frames, in parts of the crops that they are in.
fn frames(html: &str) -> Vec<[f64; 4]> {
    let of = |frame: &str| {
        let style = frame.split('"').next().expect("its end");
        let part = |name: &str| -> f64 {
            let value = style.split(';').find_map(|it| it.strip_prefix(name)).expect(name);
            value.trim_end_matches('%').parse::<f64>().expect("a number") / 100.0
        };
        ["left:", "top:", "width:", "height:"].map(part)
    };
    html.split("<i style=\"").skip(1).map(of).collect()
}

/// Law: a crop shows the region and four pixels around it, of those inside the picture and at most sixteen from the worst one;
/// the worst pixel is framed in both pictures. Oracle: the pixels counted one by one.
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
        // how many columns, or rows, are shown
        let shown = |start: u32, length: u32, worst: u32, side: u32| -> Vec<u32> {
            let is_near = |at: &u32| at + 4 >= start && *at < start + length + 4;
            (0..side).filter(|at| is_near(at) && at.abs_diff(worst) <= 16).collect()
        };
        let all = [shown(x, w, worst[0], width), shown(y, h, worst[1], height)];
        let frames = frames(&html);
        equal("framed crops", frames.len(), 2);
        for frame in frames {
            for (axis, all) in all.iter().enumerate() {
                let what = format!("{w}x{h} at {x},{y} of {size:?}, axis {axis}");
                let count = all.len() as f64;
                near(format!("{what}: size of the frame"), frame[2 + axis] * count, 1.0, 1e-9);
                let place = all.iter().position(|it| *it == worst[axis]).expect("it is shown");
                near(format!("{what}: its place"), frame[axis] * count, place as f64, 1e-6);
            }
        }
    }
}
