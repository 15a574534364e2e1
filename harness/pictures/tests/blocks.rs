//! Pictures on a terminal.

use groundtruth::film::{Film, Tone};
use groundtruth::rgb::Rgb;
use pictures::blocks;

use crate::verbs::equal;

/// Law: each character has the mean of its two pixels' rows and columns, the upper as its own colour, the lower as that
/// behind it; a last odd row has nothing behind it. Oracle: written by hand.
#[test]
fn a_character_is_two_pixels() {
    let mut film = Film::new(4, 6);
    for y in 0..6 {
        for x in 0..4 {
            // columns 0 and 1 have mean 0.2, columns 2 and 3 1; rows in pairs have red, green, blue
            let value = [0.0, 0.4, 1.0, 1.0][x as usize];
            let mut color = [0.0; 3];
            color[y as usize / 2] = value;
            film.set([x, y], Rgb::new(color[0], color[1], color[2]));
        }
    }
    let [first, second] = [
        "\x1b[38;2;51;0;0;48;2;0;51;0m▀\x1b[38;2;255;0;0;48;2;0;255;0m▀\x1b[0m\n",
        "\x1b[0;38;2;0;0;51m▀\x1b[0;38;2;0;0;255m▀\x1b[0m\n",
    ];
    assert_eq!(blocks(&film, &Tone::PLAIN, 2), format!("{first}{second}"));
}

/// Law: pictures of any size are shrunk to at most `columns` characters a line. Each half of a character is the mean of a square
/// block of pixels; incomplete blocks at the right and below are left out. Oracle: the means, pixel by pixel, of a pattern of
/// greys.
#[test]
fn pictures_of_any_size_are_shrunk_to_means() {
    for [width, height] in [[1, 1], [1, 6], [6, 1], [7, 5], [40, 3], [41, 30], [39, 80], [80, 81]] {
        for columns in [1, 2, 7, 40, 100] {
            let mut film = Film::new(width, height);
            let grey = |x: u32, y: u32| f64::from((x * 37 + y * 101) % 251) / 250.0;
            (0..height)
                .for_each(|y| (0..width).for_each(|x| film.set([x, y], Rgb::grey(grey(x, y)))));
            let by = (1..).find(|by| width <= by * columns).expect("some divisor is enough");
            let [across, down] = [width, height].map(|side| (side / by).max(1));
            let byte = |x: u32, y: u32| {
                let pixels = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
                let its: Vec<f64> = pixels
                    .filter(|at| [at[0] / by, at[1] / by] == [x, y])
                    .map(|at| grey(at[0], at[1]))
                    .collect();
                let mean = its.iter().sum::<f64>() / its.len() as f64;
                Tone::PLAIN.to_bytes(Rgb::grey(mean))[0].to_string()
            };
            let text = blocks(&film, &Tone::PLAIN, columns);
            let what = format!("{width} × {height} in {columns} columns");
            let lines: Vec<&str> = text.lines().collect();
            equal(format!("{what}: lines"), lines.len() as u32, down.div_ceil(2));
            for (line, y) in lines.into_iter().zip((0..).step_by(2)) {
                equal(format!("{what}: characters"), line.matches('▀').count() as u32, across);
                for (character, x) in line.split('▀').zip(0..across) {
                    // red of the upper pixel follows 38;2, of the lower one 48;2
                    let after = |mark: &str| {
                        character.split(mark).nth(1).and_then(|it| it.split(';').next())
                    };
                    let found = [after("38;2;"), after("48;2;")].map(|it| it.map(str::to_owned));
                    let lower = (y + 1 < down).then(|| byte(x, y + 1));
                    equal(format!("{what}: greys at {x}, {y}"), found, [Some(byte(x, y)), lower]);
                }
            }
        }
    }
}
