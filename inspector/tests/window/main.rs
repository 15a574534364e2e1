//! The inspector as a user operates it, in a window that exists only in memory.

#[macro_use]
extern crate testkit;

mod arguments;
mod beside;
mod choosing;
mod comparing;
mod explaining;
mod judging;
mod layers;
mod looking;
mod mistaken;
mod noise;
mod rays;
mod rays_from;
mod renderer;
mod room;
mod sampling;
mod scenes;
mod second_look;
mod space;
mod states;
mod staying;
mod support;
mod tree;
mod undoing;
mod unfinished;
