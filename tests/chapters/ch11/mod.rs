//! Chapter 11: nonlinear projections.

mod directions;
mod fisheye;
mod panoramas;
mod views;
