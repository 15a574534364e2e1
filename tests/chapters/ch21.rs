//! Chapter 21: transforming objects.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |

mod beveled;
mod bevels;
mod hard;
mod instances;
mod leaving;
mod local;
mod nested;
mod stones;
