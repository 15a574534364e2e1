//! Chapter 3: bare-bones ray tracing.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | rays that hit nothing, and objects around the eye | a ray that hits nothing shows the background; spheres behind the eye, around it and cut by its plane show only what is in front of it (figure 3.4) | `picture::spheres_around_the_eye_show_what_is_in_front_of_it` |
//! | rays: p = o + t d | twice the direction is half the t, to the bit, for plane and sphere alike | `hits::t_is_in_units_of_the_direction` |
//! | 3.4.1, epsilon: t > ε | a ray that starts on the plane misses it, and one that leaves a sphere's or plane's hit on the outer side does not hit it again | `hits::a_ray_that_starts_on_a_surface_leaves_it` |
//! | rays and planes | the hit of a plane satisfies its equation, and is ahead exactly if the ray goes to the other side | `hits::a_plane_is_hit_where_its_equation_holds` |
//! |  | a ray parallel to a plane misses it, above, below, and in it (infinite t, and 0/0) | `hits::a_ray_parallel_to_a_plane_misses` |
//! | rays and spheres | the hit of a sphere is on it, at the distance t from the origin of a ray of unit direction; the normal is `(p − c)/r` | `hits::t_is_the_distance_to_a_point_of_the_sphere` |
//! |  | from inside, the far root is hit, with the outward normal: `n·d > 0`; from outside the near one, `n·d < 0`, and with the sphere behind, none | `hits::a_sphere_is_hit_from_inside_and_missed_behind` |
//! | colours: the operations of RGBColor | colours add, multiply and divide channel by channel; `powc` to a whole power is the product, and `average` the channels' mean | `film::colours_calculate_by_channels` |
//! | pixel points of an orthographic view | the pixel in column c and row r (counted up) looks from `(s (c − (w − 1)/2), s (r − (h − 1)/2), 100)` along −z, also where the number of pixels is odd | `picture::pixels_look_through_their_centers` |
//! |  | halving the pixel size and doubling the resolution keeps the framing: four fine pixels are the four regular samples of a coarse one | `picture::halving_the_pixels_leaves_the_framing` |
//! | fig. 3.18, a single sphere | the chapter's first scene has the book's 400 × 400 pixels of side ½; and a plane seen edge on does not appear | `picture::a_plane_seen_edge_on_is_not_there` |
//! |  | a sphere of radius 85 covers the pixels whose centres are in its disk, π 85² within the boundary, wherever it is along the view | `picture::a_sphere_covers_the_centers_within_its_disk` |
//! | the nearest of several objects | a pixel's normal, point and colour are those of the nearest object, whatever is tested after it | `picture::the_nearest_object_keeps_its_normal` |
//! |  | the order in which objects are added does not matter | `picture::the_order_of_objects_does_not_matter` |
//! | page one, 35 spheres | seen by parallel rays, 34 of the 35 spheres of page one are in the picture; the thirteenth is hidden by those in front of it | `picture::the_thirteenth_sphere_of_page_one_is_hidden` |
//! | showing a colour: the range, gamma, bytes | the colour (2, 1, 0) is shown as (1, ½, 0); where colours out of gamut are marked, one with a channel above 1 is shown red; ½ at gamma 2.2 is 0.7297 | `film::the_books_examples_are_shown_as_in_the_book` |
//! |  | max-to-one keeps the hue: the shares of the channels | `film::max_to_one_keeps_the_hue` |
//! |  | gamma is applied last, after the out-of-gamut rule; raising to γ undoes it: `(x^(1/γ))^γ = x` | `film::gamma_comes_last` |
//! |  | a channel becomes the nearest of 256 bytes, where the book truncates: 254.9 would be 254 | `film::bytes_are_the_nearest` |
//! | question 3.1, rays that touch a sphere | a tangent touches at the distance `√(\|o − c\|² − r²)` | `hits::a_tangent_touches_where_the_right_triangle_says` |
//!
//! Beyond the book: 1 in `film`, 2 in `picture`.

mod film;
mod hits;
mod picture;
