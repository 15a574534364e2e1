//! Chapter 22: acceleration.
//!
//! Equality with the list, lattices and random spheres, and the cost of a
//! search. The laws of cells, and of the walk through them, are beside the grid.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | setting up the grid | planes, which have no bounds, are kept outside the cells of a compound, at any level, and are hit as in a list | `everywhere::planes_in_grids_are_hit_as_in_lists` |
//! | grid traversal | on random spheres of many sizes in a cube, some of which overlap, grid and tree give the same answers as the list: the same object at the same distance, bit for bit | `equal::acceleration_equals_the_list_on_random_spheres` |
//! |  | a hit on an object that covers many cells does not hide a nearer hit in a later cell: a hit counts only if `t` is below that of the next cell | `everywhere::a_hit_far_beyond_a_cell_does_not_hide_nearer_ones` |
//! |  | rays that start on the boundary of a grid, on its corners and edges, in its last cell, or along its outer faces with zeros of either sign, find what a list finds | `everywhere::rays_that_start_on_the_boundary_of_a_grid_equal_the_list` |
//! |  | grid and tree equal the list among touching boxes, for rays along their faces and edges, from inside and through corners | `equal::acceleration_equals_the_list_along_faces_and_edges_of_boxes` |
//! |  | grid and tree equal the list when everything lies in one plane, for rays across it and in it; and with infinite planes among the objects, some of them that same plane | `equal::acceleration_equals_the_list_on_flat_scenes_and_among_planes` |
//! | fig. 22.11, random spheres | the same seed gives the same centres, another seed gives others, and a larger count begins with the same ones | `lattices::a_seed_determines_the_centres_of_random_spheres` |
//! |  | centres are uniform in the cube `[−half_side, half_side]³`: none is outside, and each octant has its share within five standard deviations | `lattices::centres_of_random_spheres_fill_the_cube` |
//! |  | random spheres are the compound of their list, whichever method searches them: `t`, normals and points, bit for bit, and the leaf is the sphere's number | `lattices::random_spheres_equal_a_compound_of_spheres` |
//! | rendering times | a ray past small spheres passes as many cells as it crosses planes, so that steps and tests grow like `n^(1/3)`; the list tests all | `steps::a_grid_takes_as_many_steps_as_planes_are_crossed` |
//! |  | in the book's scene, where the spheres fill the same share of the cube however many they are, steps grow more slowly than `n^0.3`, because rays end sooner, and few spheres are tested | `steps::steps_grow_slowly_in_the_books_scene` |
//! | nested grids and grids of transformed objects | nested compounds, lattices, meshes, random spheres and instances of all of them have the same hits, leaves, surfaces and shadows by list, grid and tree | `everywhere::nested_grids_and_grids_of_instances_equal_the_list` |
//! |  | in a lattice of lattices of 10¹⁶ balls the ball aimed at is found, with its leaf number and the distance to it | `lattices::a_ball_among_ten_to_the_sixteenth_is_found` |
//! | the number of cells | a thousand objects in a cube have 20 or 21 cells on each axis, and any number of them about eight for each (invariant 3) | `cells::cells_are_as_many_as_the_book_says` |
//! |  | a slab has fewer cells across it, in proportion | `cells::cells_are_cubes_in_slabs` |
//! | traversal of a grid | a walk passes each cell that the ray crosses, none twice, each beside the one before, and onward; from outside, from inside, along walls and through corners | `cells::a_walk_passes_the_cells_that_the_ray_crosses` |
//!
//! Beyond the book: 2 in `cells`, 1 in `equal`, 1 in `lattices`, 2 in `stadium`.

mod cells;
mod equal;
mod everywhere;
mod lattices;
mod searched;
mod stadium;
mod steps;
