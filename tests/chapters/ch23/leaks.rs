//! Leaks: gaps between triangles that do not compute their common edge in the same way.

use crate::pictures::studio::{bits, built};
use crate::prelude::*;

/// Law: the background shines through the book's triangles along their edges, and nowhere through the
/// library's. Oracle: the outline of the umbrella in the picture, a regular octagon.
#[test]
fn the_textbooks_triangles_leak_at_their_edges() {
    /// In a picture of 97 × 97 pixels.
    const MANY: usize = 20;
    const SIDE: u32 = 97;
    let [book, robust] = ["ch23/leaks", "ch23/leaks-cured"].map(|name| {
        let world = built(&small(name, SIDE, SIDE, 1));
        let picture = render::render(&world);
        let background = bits(picture.get([0, 0]));
        // the distance of the octagon's corners from the centre, in pixels of this picture: 118 of 257
        let radius = 118.0 / 257.0 * f64::from(SIDE);
        let leaks = pixels(SIDE, SIDE).filter(|&pixel| {
            let [x, y] = pixel.map(|i| f64::from(i) - f64::from(SIDE / 2));
            let angle = to_degrees(atan2(y, x)).rem_euclid(45.0) - 22.5;
            let to_side = radius * cos_degrees(22.5) - (x * x + y * y).sqrt() * cos_degrees(angle);
            // without the pixels at the sides of the octagon
            to_side > 1.0 && bits(picture.get(pixel)) == background
        });
        leaks.count()
    });
    assert!(book > MANY, "{book} leaks");
    assert_eq!(robust, 0);
}
