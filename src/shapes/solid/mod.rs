//! Solids of a few parts (Suffern, ch. 19 and 28).

// shared by the kinds
pub mod boundaries;
pub mod spherical_cap;

pub mod concave_lens;
pub mod fish_bowl;
pub mod flat_rimmed_bowl;
pub mod glass_of_water;
pub mod round_rimmed_bowl;
pub mod solid_cone;
pub mod solid_cylinder;
pub mod thick_ring;
