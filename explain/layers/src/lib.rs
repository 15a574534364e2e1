//! Pictures of what happens in each pixel.
//!
//! A [`Layer`] is a picture of one number or one colour: of the first hit of each pixel's centre sample (normal,
//! distance, object …), of the rays of all its samples (how many, how deep, their variance), or of a part of its sum (one
//! light, one lobe, one depth). [`KINDS`] lists them, [`Colors`] shows them, and [`LayerFilms`] writes all of them into
//! one file. All values are of the tracer's own search and of its recorder.

mod colors;
mod events;
mod films;
mod kinds;
mod layer;
mod shown;
mod terms;

pub use colors::{Color, Colors, LegendRow, NOT_A_NUMBER, NOTHING, Scale};
pub use events::{centre_sample, first_hit};
pub use films::LayerFilms;
pub use kinds::{Argument, KINDS, Kind};
pub use layer::{Layer, Part};
pub use shown::{NO_FILE, encode_film, values};
pub use terms::{Dividing, LightSource, TermKey, Terms};
