//! Chapter 3: bare-bones ray tracing.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |

mod film;
mod hits;
mod picture;
