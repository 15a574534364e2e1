//! Chapter 31: noise-based textures.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |

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
