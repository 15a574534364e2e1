//! The harness of Groundtruth: what judges the tracer, and what others ask it.
//!
//! [`compare`] holds two pictures against each other, [`verdict`] judges a picture with noise, [`mistakes`] renders the
//! pictures of known mistakes, [`verify`] holds what checks pictures, statistics and intersections, [`conform`] and
//! [`probe`] ask and answer questions, [`mod@describe`] puts a scene into words, [`export`] writes it for other renderers,
//! [`report`] measures what to choose, [`sums`] adds replicas exactly, [`framing`] finds cameras that see everything,
//! [`mod@reference`] says what a scene file can say. The binary `groundtruth` is the command line of all of it.

pub mod compare;
pub mod conform;
pub mod describe;
pub mod export;
pub mod framing;
mod html;
pub mod mistakes;
mod percent;
mod pixel;
pub mod probe;
mod provenance;
pub mod reference;
pub mod report;
pub mod shell;
pub mod sums;
pub mod verdict;
pub mod verify;
mod xml;

pub use pixel::parse_pixel;
pub use provenance::provenance;
