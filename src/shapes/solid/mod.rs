//! Solids: of a few parts (Suffern, ch. 19 and 28), with round edges, and compounds of them (ch.
//! 21).

// shared by the kinds
pub mod boundaries;
pub mod edges;
pub mod shoulder;
pub mod spherical_cap;
pub mod wedge_parts;

pub mod archway;
pub mod beveled_box;
pub mod beveled_cylinder;
pub mod beveled_ring;
pub mod beveled_wedge;
pub mod concave_lens;
pub mod fish_bowl;
pub mod flat_rimmed_bowl;
pub mod glass_of_water;
pub mod rosette;
pub mod round_rimmed_bowl;
pub mod solid_cone;
pub mod solid_cylinder;
pub mod thick_ring;
