//! Radiance in whole scenes: for what each chapter adds to a picture, a family of its own (Suffern, ch. 3 to 31), so
//! that what a program lacks hides nothing else.

mod estimate;
mod naming;

pub use estimate::mean_agrees;
pub use naming::NAMER;
