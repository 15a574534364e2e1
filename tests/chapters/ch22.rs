//! Chapter 22: acceleration.
//!
//! Equality with the list, lattices and random spheres, and the cost of a
//! search. The laws of cells, and of the walk through them, are beside the grid.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |

mod chaos;
mod equal;
mod everywhere;
mod hard;
mod lattices;
mod leaving;
mod searched;
mod stadium;
mod steps;
