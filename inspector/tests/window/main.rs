//! The inspector as a person uses it, in a window that is not there.

mod arguments;
mod choosing;
mod explaining;
mod looking;
mod noise;
mod renderer;
mod room;
mod sampling;
mod scenes;
mod staying;
mod support;
mod tree;
mod unfinished;
