//! Chapter 21: transforming objects.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | ray tracing transformed objects | an instance of a sphere, mirrored too, is the analytic ellipsoid `\|A⁻¹(p − b)\| = 1`: every hit lies on it, its normal outward, and a line hits it exactly when the quadratic has roots, at its `t` | `instances::an_instance_of_a_sphere_is_the_analytic_ellipsoid` |
//! | transforming normals | the normal of a sphere stretched by (1, 2, 1), where it was at 45°, tilts to (2, 1)/√5, away from the stretch | `instances::normals_tilt_by_the_inverse_transpose` |
//! | 21.4, instances | a million copies share one mesh | `local::a_million_copies_hold_one_mesh` |
//! | the texture of an instance | with and without `transform_texture` only the local point differs, and that by `M⁻¹` exactly | `local::untransformed_textures_differ_by_the_map_of_the_local_point_alone` |
//! | nested objects and their materials | an instance of an instance is the instance of the product | `instances::an_instance_of_an_instance_is_the_instance_of_the_product` |
//! |  | nested compounds are their parts in one list: at equal distances the first leaf is hit, `t` and surface are the leaf's own, and of the materials around a part the innermost counts, or the scene's choice if there is none; it says whether the part casts a shadow | `nested::nested_compounds_equal_the_same_parts_in_one_list` |
//! | 21.5, beveled objects | a beveled box, cylinder, ring or wedge is closed; its inside is what is at most the bevel away from the solid that is smaller by the bevel on each side | `beveled::a_beveled_solid_is_what_is_within_the_bevel_of_a_smaller_one` |
//! | fig. 21.11, the rosette and the archway | the rings of a rosette have 10, 12, 15, 18, 24 and 36 wedges | `stones::the_rings_of_a_rosette_have_the_books_numbers_of_wedges` |
//! |  | an archway has the given number of blocks in each column and of wedges over them, and fills the box of its width, height and depth from the ground up | `stones::an_archway_has_its_blocks_and_wedges_in_its_box` |
//! |  | a rosette and an archway are closed and lie inside the plain rings, columns and arch; they fill these except for grooves and joints | `stones::stones_fill_the_plain_solid_but_for_grooves_and_joints` |
//! | fig. 21.12, scaled bevels | scaling after beveling distorts the bevel: a cylinder that is beveled and then stretched is not the stretched cylinder beveled, though both have the same bounding box | `beveled::stretching_a_beveled_cylinder_stretches_its_bevel` |
//! | fig. 21.13, a beveled cylinder that is a sphere | a beveled cylinder whose bevel is its radius and half its height is a sphere, here the unit sphere | `beveled::the_cylinder_of_figure_21_13_is_a_unit_sphere` |
//!
//! Beyond the book: 2 in `instances`, 1 in `nested`, 3 in `stones`.

mod beveled;
mod bevels;
mod instances;
mod local;
mod nested;
mod stones;
