//! Chapter 22: acceleration: equality with the list, lattices and random spheres, and the cost of a
//! search. The laws of cells, and of the walk through them, are beside the grid.

mod chaos;
mod equal;
mod everywhere;
mod hard;
mod lattices;
mod leaving;
mod searched;
mod stadium;
mod steps;
