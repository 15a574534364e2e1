//! Another program's picture held against ours: its file, its layers over our picture, and its bar.

pub mod bar;
pub mod layer;
pub mod theirs;
