//! Chapter 9: a practical viewing system.
