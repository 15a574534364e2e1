//! Chapter 21: transforming objects.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | ray tracing transformed objects | an instance of a sphere is the analytic ellipsoid `\|A⁻¹(p − b)\| = 1`: every hit lies on it, and a line hits it exactly when the quadratic has roots | `instances::an_instance_of_a_sphere_is_the_analytic_ellipsoid` |
//! |  | `t` is the same in world space and in object space: a rotated and moved sphere is hit at the `t` of the moved sphere, whatever the length of the direction | `instances::an_instance_keeps_t` |
//! | transforming normals | the normal of a sphere stretched by (1, 2, 1), where it was at 45°, tilts to (2, 1)/√5, away from the stretch | `instances::normals_tilt_by_the_inverse_transpose` |
//! |  | of an object mirrored in an axis the outward normals stay outward, and hits are mirror images | `instances::a_reflection_keeps_outward_normals_outward` |
//! | 21.4, instances | every hit lies in the padded bounds of the instance | `instances::the_bounds_of_an_instance_contain_its_hits` |
//! |  | a million copies share one mesh | `local::a_million_copies_hold_one_mesh` |
//! | the texture of an instance | the local point is in the space of the innermost shape, where textures are evaluated: the forward map takes it to the hit point | `instances::the_local_point_stays_in_object_space` |
//! |  | with and without `transform_texture` only the local point differs, and that by `M⁻¹` exactly | `local::untransformed_textures_differ_by_the_map_of_the_local_point_alone` |
//! |  | of two nested instances an inner `transform_texture = false` undoes the inner map alone: the texture still moves with the outer one; an outer one undoes both | `local::a_nested_instance_undoes_its_own_map_alone` |
//! | nested objects and their materials | an instance of an instance is the instance of the product | `instances::an_instance_of_an_instance_is_the_instance_of_the_product` |
//! |  | a material of a compound applies to all its parts, but a part's own material has priority; a part without any material leaves the choice to the scene | `nested::the_innermost_of_three_materials_wins` |
//! | 21.5, beveled objects | a beveled box, cylinder, ring or wedge is closed; its inside is what is at most the bevel away from the solid that is smaller by the bevel on each side | `beveled::a_beveled_solid_is_what_is_within_the_bevel_of_a_smaller_one` |
//! |  | every point of the surface of a beveled solid is as far from the smaller solid as the bevel | `beveled::points_of_a_beveled_solid_are_at_the_bevel_from_the_smaller_one` |
//! |  | volumes of beveled solids are those of the closed forms, and so tend to the plain solids' as the square of the bevel | `beveled::the_volume_of_a_beveled_solid_is_known_and_tends_to_the_plain_one` |
//! | fig. 21.11, the rosette and the archway | the rings of a rosette have 10, 12, 15, 18, 24 and 36 wedges | `stones::the_rings_of_a_rosette_have_the_books_numbers_of_wedges` |
//! |  | an archway has the given number of blocks in each column and of wedges over them, and fills the box of its width, height and depth from the ground up | `stones::an_archway_has_its_blocks_and_wedges_in_its_box` |
//! |  | a rosette and an archway are closed and lie inside the plain rings, columns and arch; they fill these except for grooves and joints | `stones::stones_fill_the_plain_solid_but_for_grooves_and_joints` |
//! | fig. 21.12, scaled bevels | scaling after beveling distorts the bevel: a cylinder that is beveled and then stretched is not the stretched cylinder beveled, though both have the same bounding box | `beveled::stretching_a_beveled_cylinder_stretches_its_bevel` |
//! | fig. 21.13, a beveled cylinder that is a sphere | a beveled cylinder whose bevel is its radius and half its height is a sphere, here the unit sphere | `beveled::the_cylinder_of_figure_21_13_is_a_unit_sphere` |
//!
//! Beyond the book: 2 in `beveled`, 5 in `hard`, 3 in `instances`, 4 in `leaving`, 1 in `local`, 3 in `nested`, 5 in `stones`.

mod beveled;
mod bevels;
mod hard;
mod instances;
mod leaving;
mod local;
mod nested;
mod stones;
