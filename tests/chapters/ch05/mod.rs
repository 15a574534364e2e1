//! Chapter 5: sampling techniques.
