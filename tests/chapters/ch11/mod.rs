//! Chapter 11: nonlinear projections.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |

mod directions;
mod fisheye;
mod panoramas;
mod views;
