//! Chapter 12: stereoscopy.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | the positions of the eyes | the eyes are at `eye ∓ x u` with `x = r tan(β/2)`, r being the distance of the point looked at | `geometry::the_eyes_are_side_by_side` |
//! |  | without separation both images are the same, bit for bit, as that of one eye; with separation they differ | `pictures::no_separation_gives_two_equal_images` |
//! |  | of a scene that is its own mirror image in the plane between the eyes, the right image is the left one mirrored | `pictures::a_symmetric_scene_has_mirrored_images` |
//! | parallax | the parallax of a point at the depth z is `x_L − x_R = 2x (d/z − 1)` on the film (over the size of a pixel, in pixels), times the zoom; positive in front of the view plane, negative behind it, `−2x` at infinity; both eyes see the point in the same row | `geometry::parallax` |
//! |  | points of the view plane, at the depth d, have no parallax, whatever the zoom: both eyes look through one window | `geometry::both_eyes_look_through_one_window` |
//! | parallel and transverse viewing | the picture is `2 w + gap` by h; the columns of the gap are black and cast no ray, under a white background; the others belong to the eyes | `pictures::the_gap_is_black` |
//! |  | the transverse picture is the parallel one with its halves swapped: the eyes themselves stay as they are | `pictures::transverse_swaps_the_halves` |
//! | stereo with other cameras | for cameras without a window only the eye moves: both eyes have the same direction at each film point, from two positions | `geometry::others_only_move_the_eye` |
//! |  | the image of an eye is that of a camera at its position, with the same samples: for cameras without a window, to 1e-9 | `pictures::each_image_is_that_of_a_camera_in_its_place` |
//!
//! Beyond the book: 1 in `geometry`, 2 in `pictures`.

mod geometry;
mod pictures;
