//! Chapter 13: theoretical foundations.
