//! A film of a layer's values as a file: its values, or its colours.

use std::io;

use groundtruth::film::{self, Film, Format, Provenance, Tone};
use groundtruth::rgb::Rgb;
use groundtruth::world::World;

use crate::colors::{Colors, Scale};
use crate::films::encode_layer;
use crate::layer::Layer;

/// What is said of a file name that no layer is written to.
pub const NO_FILE: &str =
    "a layer is written as .exr (its values), .png or .ppm (in false colours)";

/// The values of a film of a layer; `None` where nothing is hit.
pub fn values(layer: &Layer, film: &Film) -> impl Iterator<Item = Option<Rgb>> {
    film.pixels().iter().map(|&value| layer.from_film(value))
}

/// The bytes of a file with a film of a layer: its values as EXR, its colours in other formats; radiance is shown in a tone.
///
/// # Errors
/// A format that has no layers, or a name that EXR cannot say.
pub fn encode_film(
    layer: &Layer,
    film: &Film,
    format: Format,
    (world, tone): (&World, Tone),
    made: &Provenance,
) -> io::Result<Vec<u8>> {
    match format {
        Format::Exr => encode_layer(layer, film, world, made),
        Format::Pfm => Err(io::Error::other(NO_FILE)),
        _ if layer.kind().scale == Scale::Radiance => film::encode(film, &tone, format, made),
        _ => {
            let colors = Colors::of(layer, values(layer, film).flatten(), world, tone);
            film::encode(&in_colors(layer, film, &colors), &Tone::SCREEN, format, made)
        }
    }
}

/// A film that [`Tone::SCREEN`] shows in these colours.
fn in_colors(layer: &Layer, film: &Film, colors: &Colors) -> Film {
    let mut shown = Film::new(film.width(), film.height());
    let all = (0..film.height()).flat_map(|y| (0..film.width()).map(move |x| [x, y]));
    for at in all {
        let bytes = colors.color(layer.from_film(film.get(at)));
        let color = Rgb::from(bytes.map(|byte| f64::from(byte) / 255.0));
        shown.set(at, color.powc(Tone::SCREEN.gamma));
    }
    shown
}
