//! Chapter 21: transforming objects.
