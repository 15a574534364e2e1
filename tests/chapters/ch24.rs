//! Chapter 24: mirror reflection.
