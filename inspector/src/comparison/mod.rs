//! Other pictures compared with ours: of files, of programs with a mistake, of the scene with a change, and of other
//! scenes; their layers over our picture, their bar, and the verdict on them.

pub mod bar;
pub mod entry;
pub mod judgement;
pub mod menu;
pub mod mistake;
pub mod opening;
pub mod others;
pub mod pixel_command;
pub mod pixels;
pub mod program;
pub mod recipe;
pub mod theirs;
