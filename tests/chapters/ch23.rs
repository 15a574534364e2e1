//! Chapter 23: triangle meshes.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | fig. 23.1, tessellated spheres | a sphere tessellated in h steps around and v steps along has `2 h (v − 1)` triangles: 6 for 3×2, 8 for 4×2, 9800 for 100×50 | `meshes::a_tessellated_sphere_has_2h_times_v_minus_1_triangles` |
//! |  | the area of a tessellated sphere is below 4π and nears it as the square of the steps | `meshes::the_area_of_a_tessellated_sphere_nears_four_pi_quadratically` |
//! |  | normals of a tessellated sphere point outward, flat and smooth | `meshes::normals_of_a_tessellated_sphere_point_outward` |
//! | the mesh and its triangles | for each triangle the search structure needs as much memory whether vertices are shared or not, and whether they have normals and texture coordinates or not; it does not grow faster than the number of triangles | `meshes::memory_for_each_triangle_does_not_depend_on_vertices` |
//! |  | a mesh is its triangles: the same hits and normals as loose ones, the nearest of them first, bit for bit | `meshes::a_mesh_equals_its_loose_triangles` |
//! |  | in a closed mesh every edge is passed once in each direction, and vertices minus edges plus faces of a ball are two, bumpy or not | `meshes::every_edge_of_a_closed_mesh_is_passed_once_each_way` |
//! |  | rays from outside cross a closed mesh an even number of times | `meshes::rays_from_outside_cross_a_closed_mesh_evenly` |
//! |  | triangles of area zero change no hit, no mean normal and no count of triangles | `meshes::triangles_of_area_zero_change_nothing` |
//! | PLY files | the three encodings of PLY give the same mesh, and the same hits and shading normals, bit for bit, with the file's normals and with mean ones | `files::the_three_encodings_of_ply_give_the_same_hits` |
//! | normals at the vertices | a vertex normal is the mean of the normals of its faces, each counted once; (0, 1, 0) where that is zero or no face touches it | `meshes::vertex_normals_are_the_mean_of_the_adjacent_faces` |
//! | smooth shading | shading uses the normal `(1 − β − γ) n₀ + β n₁ + γ n₂` of the unit normals, geometry stays flat | `smooth::a_smooth_triangle_is_a_smooth_mesh_of_one_triangle` |
//! |  | smooth shading changes the shading normal and nothing else | `meshes::flat_and_smooth_meshes_have_the_same_hits` |
//! |  | interpolated normals of a tessellated sphere differ from the sphere's own by less than the square of the angle of an edge | `meshes::smooth_normals_of_a_sphere_are_nearly_its_own` |
//! |  | near the outline of a smooth mesh, where the interpolated normal may face away from the viewer though the triangle does not, a matte or glossy surface is as bright as that normal says, as in the book, whose BRDFs do not test on which side of it the viewer is | `smooth::the_outline_of_a_smooth_mesh_is_shaded_as_the_rest` |
//! | reversed normals | reversing a mesh negates every normal and keeps every distance; reversing it twice changes nothing | `meshes::reversing_twice_changes_nothing` |
//! | meshes with texture coordinates | if u and v of the vertices are affine functions of their position, u and v of a hit are the same functions; also through instances, compounds and lattices | `uv::texture_coordinates_are_interpolated_where_the_file_has_them` |
//!
//! Beyond the book: 1 in `files`, 1 in `leaks`, 1 in `lists`, 2 in `meshes`, 5 in `outside`, 1 in `smooth`, 1 in `blocks`, 2 in `nodes`, 2 in `space`, 3 in `watertight`.

mod files;
mod leaks;
mod lists;
mod meshes;
mod outside;
mod smooth;
mod tree;
mod uv;
mod watertight;
