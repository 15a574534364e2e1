//! What all that judges pictures shares: [`compare`] holds two pictures against each other, [`sums`] adds replicas
//! exactly, [`running`] runs another renderer with a time limit; [`told`] is the form in which verdicts are said; and text for
//! [`html`], [`xml`], the [`shell`] and readers.

pub mod compare;
pub mod digits;
pub mod html;
pub mod percent;
mod pixel;
mod provenance;
pub mod running;
pub mod shell;
pub mod sums;
pub mod told;
pub mod xml;

pub use pixel::parse_pixel;
pub use provenance::provenance;
