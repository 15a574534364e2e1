//! Chapter 4: antialiasing.
