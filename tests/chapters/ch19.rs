//! Chapter 19: ray-object intersections.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | the hit functions of objects | on easy rays every kind has the same hits in the book's form as in the library's: the same distance, part and normal | `textbook::textbook_and_robust_agree_on_easy_rays` |
//! |  | hits within epsilon of a ray's origin do not count, for camera rays and for shadow rays | `textbook::epsilon_is_a_distance` |
//! |  | with the textbook's routine a ray leaves a surface from the hit point itself, `o + t d` | `textbook::rays_start_at_the_hit_point` |
//! |  | by the book's routines too, a shadow ray is blocked within a span exactly if a ray hits something there, for finite spans that end before, between and behind the hits, and for directions of length 10⁻³ to 10³, of which t is measured in lengths | `textbook::the_books_shadow_rays_hit_what_its_rays_hit` |
//! | listing 19.1, the bounding box | a ray may meet a box if it starts before the point where it leaves the box, and not if it starts beyond that, up to rounding | `bounding::a_ray_may_meet_a_box_up_to_where_it_leaves_it` |
//! |  | the test of a box is right for rays along an axis, in the plane of a face and beside it, with zeros of either sign; also for empty and infinite boxes | `bounding::zeros_and_infinite_boxes_are_handled` |
//! |  | the bounding box of a shape contains every hit, and that of an instance of it the hits of the instance | `shapes::bounds_contain_every_hit` |
//! | boxes, triangles, rectangles and disks | a box has the hits and the outward normals of its six rectangles, from outside and from inside | `shapes::a_box_equals_its_six_rectangles` |
//! |  | barycentric coordinates reproduce the hit, and lie in [0, 1] with a sum up to 1 | `shapes::barycentric_coordinates_reproduce_the_hit` |
//! |  | two triangles that share an edge leave no gap, whichever way they are wound | `shapes::two_triangles_that_share_an_edge_leave_no_gap` |
//! |  | a disk and a rectangle are hit inside their border and not outside | `shapes::disks_and_rectangles_end_at_their_borders` |
//! | spheres, cylinders and cones, convex and concave | a sphere, an open cylinder, a cone, a paraboloid and the quadrics of docs/book.md are hit where the quadratic of their equation has roots between their ends, the far one also where the near one is beyond an end; the normal is the gradient | `shapes::quadrics_are_hit_at_the_roots_between_their_ends` |
//! |  | a line parallel to a generator meets the cone once; a steep line meets this half once; a level line above the apex does not meet it | `shapes::rays_along_generators_and_down_the_axis_meet_a_cone_once` |
//! |  | convex and concave twins are hit at the same points, with opposite normals | `shapes::inward_twins_have_the_same_hits_and_opposite_normals` |
//! | tori and their quartic equation | every hit of a torus obeys the book's equation, `(x² + y² + z² − a² − b²)² = 4a² (b² − y²)`, and its normal is the gradient of it; a ray from outside crosses it an even number of times, one from inside the tube an odd number | `torus::hits_obey_the_quartic_and_normals_are_its_gradient` |
//! |  | the torus of radii 2 and 0.5 is met at t = 2.5, 3.5, 6.5 and 7.5 along x from x = −5, at 4.5 and 5.5 straight down from (0, 5, 2), and nowhere along its axis | `torus::a_torus_is_hit_where_arithmetic_says` |
//! |  | the plane of its centre circle cuts a torus in two circles; a plane through its axis cuts it in the circle of the tube | `torus::a_torus_is_two_circles_across_and_along` |
//! |  | rays through the hole of the torus of radii 0.9 and 0.1, on the axis and beside it, miss; a quartic solver finds false roots there | `torus::rays_through_the_hole_miss` |
//! |  | the roots of known quartics are found: 1, 2, 3 and 4; ±1 and ±2 of `x⁴ − 5x² + 4`; ±1 of `x⁴ − 1`; none of `x⁴ + 1` | `polynomials::the_textbook_quartics_have_their_roots` |
//! |  | all real roots of a polynomial are found and no others, unless a change of the coefficients by 16u changes their number, in intervals and on the whole line | `polynomials::every_root_of_an_interval_is_found` |
//! |  | from far away the book's quartic loses many hits of a torus and finds false ones; the library's routine does neither | `textbook::quartics_lose_the_roots_of_a_far_torus` |
//! |  | a root of multiplicity k is found as near to its value as rounding allows: within about u^(1/k) (numerics.md) | `polynomials::roots_that_meet_are_never_lost` |
//! | part objects | the ranges 350 to 360 and 0 to 10 meet at +z without a gap, each covers only its own side, and 350 to 10 covers both | `parts::ranges_meet_at_azimuth_zero` |
//! |  | a part of a sphere, cylinder, annulus or torus and its complement are the whole, bit for bit, also for rays aimed at the ends of the range, where both may have the hit | `parts::a_part_and_its_complement_are_the_whole` |
//! |  | a part has the hits of the whole whose azimuth, polar angle or angle around the tube, `atan2(y, √(x² + z²) − a)`, are in its ranges, which may pass through 360°: the far one, too, where the near one is missing | `parts::a_part_has_the_hits_whose_angles_are_in_its_ranges` |
//! | compound objects | a part that is named in `materials` has that material; every other part has the material of the whole solid (`None`) | `compound_parts::each_part_of_a_solid_has_its_material` |
//! |  | a thick ring and a solid cylinder are closed; the inside of the cylinder is where `y0 ≤ y ≤ y1` and `√(x² + z²) ≤ r`, that of the ring is between two such walls | `compounds::a_thick_ring_and_a_solid_cylinder_are_closed_and_obey_their_inequalities` |
//! |  | a solid cone is closed; its inside is where `0 ≤ y` and `√(x² + z²) ≤ r (1 − y/h)` | `compounds::a_solid_cone_is_closed_and_obeys_its_inequality` |
//! |  | a round-rimmed bowl is closed; its inside is between two spheres up to the cone of the opening, and in a tube whose centre circle is on that cone, half-way between the spheres | `compounds::a_round_rimmed_bowl_is_closed_and_ends_in_a_tube` |
//! |  | the rim of a round-rimmed bowl joins both spheres smoothly: at the seam points and normals agree | `compounds::the_rim_of_a_bowl_touches_both_spheres` |
//! |  | a concave lens is closed; its inside is a disk without two balls, of the radius `ρ = (d² + R²)/2d` if each hollow is d deep: 10.10947 for (4, 2, 0.35) | `compounds::a_concave_lens_is_a_disk_without_two_balls` |
//! |  | a cut face is the square of side `size` in the plane y = 0 without the disk `x² + z² < radius²` about its centre, and its normal is (0, 1, 0) | `compounds::a_cut_face_is_a_square_without_a_disk` |
//! | exercise 19.25, the flat-rimmed bowl | a flat-rimmed bowl is closed; its inside is between two spheres and below the plane of the rim, where the inner sphere opens at the given angle | `compounds::a_flat_rimmed_bowl_is_closed_and_lies_between_its_spheres_below_its_rim` |
//!
//! Beyond the book: 3 in `algebraic`, 1 in `bounding`, 1 in `compounds`, 1 in `parts`, 2 in `polynomials`, 1 in `refused`, 3 in `shadow_parts`, 1 in `textbook`, 1 in `torus`.

mod algebraic;
mod bounding;
mod compound_parts;
mod compounds;
mod parts;
mod polynomials;
mod refused;
mod shadow_parts;
mod shapes;
mod textbook;
mod torus;
