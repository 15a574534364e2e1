//! Chapter 8: perspective viewing.
