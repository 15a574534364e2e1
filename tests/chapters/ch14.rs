//! Chapter 14: lights and materials.
