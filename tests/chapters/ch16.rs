//! Chapter 16: shadows.
