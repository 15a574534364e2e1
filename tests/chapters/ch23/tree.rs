//! The parts of the tree over a mesh: blocks of eight triangles, nodes of sixteen boxes, the space of both.

mod blocks;
mod nodes;
mod space;
