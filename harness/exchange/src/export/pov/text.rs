//! Numbers and vectors in the scene language of POV-Ray.

use groundtruth::math::Transform;
use groundtruth::rgb::Rgb;

pub(super) use crate::export::number;

/// A point or a vector.
pub fn vector(numbers: [f64; 3]) -> String {
    format!("<{}>", numbers.map(number).join(", "))
}

/// A colour, without the word `rgb`.
pub fn rgb(color: Rgb) -> String {
    vector(color.to_array())
}

/// A map as a modifier of an object; nothing for the identity.
///
/// POV-Ray multiplies row vectors from the left, `(x, y, z, 1) M`, and lists the rows of M: the images of the three
/// axes, then that of the origin. These are the columns of our matrix, which stands before column vectors.
pub fn matrix(map: &Transform) -> String {
    if *map.rows().as_flattened() == *Transform::IDENTITY.rows().as_flattened() {
        return String::new();
    }
    let rows = map.rows();
    let column = |j: usize| rows.map(|row| number(row[j])).join(", ");
    format!(" matrix <{}>", [0, 1, 2, 3].map(column).join(", "))
}
