//! Chapter 12: stereoscopy.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |

mod geometry;
mod pictures;
