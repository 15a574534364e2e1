//! Chapter 10: depth of field.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | the thin lens and its focal plane | rays start on the lens: a disk of radius R around the eye, perpendicular to w | `rays::rays_start_on_the_lens` |
//! |  | all rays of a film point meet in one point at the depth f along −w, at `(f/d) p`: the sharp surface is a plane, not a sphere | `rays::the_rays_of_a_film_point_meet_at_the_focal_distance` |
//! | the circle of confusion | the image of a point at the depth z is a disc on the view plane, of the diameter `2 R d \|z − f\|/(z f)` (times the zoom), around the point's projection | `rays::the_circle_of_confusion` |
//! |  | blur moves light and keeps its sum: an emitting disk gives the same total light, `π ρ² (d/z)²` film units, with any lens and focus | `blur::blur_keeps_the_light` |
//! | samples on the lens | samples are uniform over the lens: `E[r²] = R²/2`, `E[r⁴] = R⁴/3`, and the means of lx and ly are 0; over a lens of radius 0 there are none | `blur::lens_samples_are_uniform` |
//! |  | the samples of pixel and lens are independent; otherwise bands would appear: over all pixels, the position in the pixel does not correlate with the position on the lens, for patterns that are shuffled | `blur::pixel_and_lens_samples_are_paired_by_chance` |
//! | a lens of radius 0 | a lens of radius 0 is the pinhole of the same distance and zoom, bit for bit, wherever on the lens and wherever focused | `rays::a_lens_of_radius_0_is_the_pinhole` |
//! | figs. 10.9 and 10.10, three boxes in focus | the focal distances 50, 74 and 98 put the fronts of the three boxes in focus, one after the other: rays from different points of the lens meet there | `rays::each_focal_distance_of_the_book_is_that_of_a_box` |
//! | fig. 10.12, reflections in focus | a mirrored object is sharp where the whole path along −w, to the mirror and on, is the focal distance, not where the mirror is | `blur::a_mirrored_edge_is_sharp_at_the_length_of_the_whole_way` |

mod blur;
mod rays;
