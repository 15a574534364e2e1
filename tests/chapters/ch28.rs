//! Chapter 28: realistic transparency.
