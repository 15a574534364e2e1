//! Chapter 22: acceleration: equality with the list, lattices and random spheres, and what a search
//! costs. Laws of cells and walks stand with the grid.

mod chaos;
mod equal;
mod everywhere;
mod hard;
mod lattices;
mod leaving;
mod searched;
mod stadium;
mod steps;
