//! Chapter 20: affine transformations.
