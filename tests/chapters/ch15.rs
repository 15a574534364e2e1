//! Chapter 15: specular reflection.
