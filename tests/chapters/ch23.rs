//! Chapter 23: triangle meshes.
