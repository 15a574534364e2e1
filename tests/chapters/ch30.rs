//! Chapter 30: procedural textures.
