//! Pictures on a terminal.

use groundtruth::film::{Film, Tone};
use groundtruth::rgb::Rgb;
use pictures::blocks;

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
