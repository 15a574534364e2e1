//! Chapter 29: images as textures and as skies.

mod sky;
