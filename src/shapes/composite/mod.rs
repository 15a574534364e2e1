//! Shapes made of shapes: compounds, instances, lattices (Suffern, ch. 19, 21, 22).

// shared by the kinds
pub mod assembly;
pub mod part_path;

pub mod compound;
pub mod instance;
pub mod lattice;
pub mod random_spheres;
