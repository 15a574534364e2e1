//! What all that judges pictures shares: [`compare`] holds two pictures against each other, [`sums`] adds replicas
//! exactly, and [`running`] runs another program with a time limit.

pub mod compare;
mod pixel;
mod provenance;
pub mod running;
pub mod sums;

pub use pixel::parse_pixel;
pub use provenance::provenance;
