//! Another program's picture compared with ours: its file, its layers over our picture, its bar, and the verdict on it.

pub mod bar;
pub mod judgement;
pub mod layer;
pub mod mistake;
pub mod opening;
pub mod theirs;
