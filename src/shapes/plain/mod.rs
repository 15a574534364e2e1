//! Surfaces of one equation (Suffern, ch. 3 and 19).

// shared by the kinds
pub mod rim;
pub mod spherical_rectangle;

pub mod algebraic;
pub mod annulus;
pub mod cone;
pub mod cuboid;
pub mod cut_face;
pub mod disk;
pub mod open_cylinder;
pub mod paraboloid;
pub mod plane;
pub mod rectangle;
pub mod sphere;
pub mod torus;
pub mod triangle;
