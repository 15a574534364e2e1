//! Chapter 11: nonlinear projections.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | fisheye projections | the angle to the line of sight is r times half the field of view, to some roundings of the angle itself, however small; the angle around the line of sight is kept | `fisheye::angles_grow_evenly` |
//! |  | the rim of 180° looks along ±u and ±v, that of 360° straight back, exactly; the centre looks along −w | `fisheye::the_rim_sees_sideways_or_straight_back` |
//! |  | on a square film the camera has no preferred direction around its axis: rolled by 90° it gives the same rays at film points turned by 90°, to the bit | `fisheye::rolling_turns_the_disc` |
//! |  | the disc of a film that is not square is an ellipse that touches all four edges | `fisheye::the_disc_touches_all_edges` |
//! | the circle of a fisheye, and the rectangular fisheye | inside a sphere of light the circle is white and the corners are black; if rectangular, all is white | `fisheye::corners_are_black_or_not` |
//! |  | nothing is seen outside the circle; if rectangular, the corners extend as far as straight back, and no farther, as directions beyond would be seen twice | `fisheye::the_circle_ends_what_is_seen` |
//! |  | a pixel outside the circle casts no ray: it is black under any background | `fisheye::a_masked_pixel_casts_no_ray` |
//! | spherical panoramic projections | a spherical panorama looks along `cos ψ sin λ u + sin ψ v − cos ψ cos λ w` at `λ = xn λ_max`, `ψ = yn ψ_max` | `panoramas::spherical_panoramas_follow_the_book` |
//! |  | longitude and latitude grow evenly, each with its own field of view, to some roundings of the angles themselves, however small | `panoramas::longitude_and_latitude_grow_evenly` |
//! |  | the seam of 360°: both edges look straight back, exactly; the top row of 180° straight up, the bottom row straight down, at every x; right of the middle is u | `panoramas::seams_and_poles` |
//! | fields of view, whatever the size of the window | the picture does not depend on the size or number of the pixels, only on the normalised film point | `directions::pictures_do_not_depend_on_the_pixel_size` |
//! |  | with a small field of view fisheye and panoramas are pinhole cameras of the distance `width/(2 λ_max)`: the difference falls with the cube of the angle | `directions::a_small_field_of_view_is_a_pinholes` |
//! |  | the solid angle per film area is proportional to `sin ψ/ψ` for the fisheye, `cos ψ` for the spherical and `cos³ψ` for the cylindrical panorama; in the centre it is the product of the half angles | `directions::film_covers_the_solid_angle_of_its_projection` |
//!
//! Beyond the book: 1 in `fisheye`, 2 in `panoramas`.

mod directions;
mod fisheye;
mod panoramas;
mod views;
