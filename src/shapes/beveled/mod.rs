//! Solids with round edges, and compounds of them (Suffern, ch. 21).

// shared by the kinds
pub mod edges;
pub mod shoulder;
pub mod wedge_parts;

pub mod archway;
pub mod beveled_box;
pub mod beveled_cylinder;
pub mod beveled_ring;
pub mod beveled_wedge;
pub mod rosette;
