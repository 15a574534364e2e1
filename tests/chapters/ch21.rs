//! Chapter 21: transforming objects.

mod hard;
mod instances;
mod leaving;
