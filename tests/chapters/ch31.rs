//! Chapter 31: noise-based textures.

mod bump_cases;
mod bumps;
mod furnace;
mod leaning;
mod noise;
mod oracle;
mod statistics;
mod sums;
mod textures;
mod wood;
