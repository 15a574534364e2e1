//! Chapter 18: area lights.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |

mod draws;
mod errors;
mod far;
mod flush;
mod irradiance;
mod jittered;
mod lamps;
mod penumbra;
mod polygon;
mod sky;
mod sphere;

use groundtruth::shapes::Sampling;

use crate::support::lamps::*;
use crate::support::stage::*;
