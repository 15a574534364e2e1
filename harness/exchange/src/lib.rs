//! Scenes in other words: [`mod@describe`] puts a scene into words and numbers, [`export`] writes it for other renderers,
//! [`framing`] finds a camera that sees everything, and [`reference`](mod@reference) says what a scene file can say.

pub mod describe;
pub mod export;
pub mod framing;
pub mod reference;
