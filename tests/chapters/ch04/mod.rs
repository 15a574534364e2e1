//! Chapter 4: antialiasing.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |

mod edges;
mod filters;
mod pixel;
mod sinusoid;
mod variance;
