//! Chapter 10: depth of field.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |

mod blur;
mod rays;
