//! The inspector as a person uses it, in a window that is not there.

mod arguments;
mod explaining;
mod looking;
mod renderer;
mod sampling;
mod scenes;
mod support;
mod tree;
