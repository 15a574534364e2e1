//! Chapter 22: regular grids.
