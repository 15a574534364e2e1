//! Chapter 27: simple transparency.
