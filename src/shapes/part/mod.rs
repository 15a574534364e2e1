//! Part objects: surfaces cut by angles (Suffern, ch. 19).

// shared by the kinds
pub mod angles;

pub mod part_annulus;
pub mod part_cylinder;
pub mod part_sphere;
pub mod part_torus;
