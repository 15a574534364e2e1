//! Metamorphic laws on whole pictures.
