//! Chapter 21: transforming objects.

mod beveled;
mod bevels;
mod hard;
mod instances;
mod leaving;
mod local;
mod nested;
mod stones;
