//! Pictures on a terminal.

use std::fmt::Write;

use groundtruth::film::{Film, Tone};
use groundtruth::rgb::Rgb;

/// A picture as text for a terminal with 24-bit colours, at most so many characters wide. Each character is two
/// pixels, one above the other: the upper half block in the colour of one on the colour of the other.
pub fn blocks(film: &Film, tone: &Tone, columns: u32) -> String {
    let film = shrunk(film, film.width().div_ceil(columns));
    let color = |at: [u32; 2]| {
        let [r, g, b] = tone.to_bytes(film.get(at));
        format!("{r};{g};{b}")
    };
    let mut text = String::new();
    for y in (0..film.height()).step_by(2) {
        for x in 0..film.width() {
            let _ = match y + 1 < film.height() {
                true => write!(text, "\x1b[38;2;{};48;2;{}m▀", color([x, y]), color([x, y + 1])),
                false => write!(text, "\x1b[0;38;2;{}m▀", color([x, y])),
            };
        }
        text += "\x1b[0m\n";
    }
    text
}

/// The picture with the mean of so many rows and columns in each pixel; the rest at the right and below is left out.
fn shrunk(film: &Film, by: u32) -> Film {
    let mut small = Film::new((film.width() / by).max(1), (film.height() / by).max(1));
    for y in 0..small.height() {
        for x in 0..small.width() {
            let [columns, rows] = [(x, film.width()), (y, film.height())]
                .map(|(first, end)| first * by..end.min((first + 1) * by));
            let all = rows.flat_map(|y| columns.clone().map(move |x| [x, y]));
            let (sum, count) =
                all.fold((Rgb::BLACK, 0.0), |(sum, n), at| (sum + film.get(at), n + 1.0));
            small.set([x, y], sum / count);
        }
    }
    small
}
