//! Numbers, matrices and parameters in scene files of pbrt-v4.

use groundtruth::math::Transform;
use groundtruth::rgb::Rgb;

use crate::export::number;

/// Numbers as the value of a parameter.
pub fn list(numbers: impl IntoIterator<Item = f64>) -> String {
    let numbers: Vec<String> = numbers.into_iter().map(number).collect();
    format!("[ {} ]", numbers.join(" "))
}

/// A parameter of numbers: its type and name, and its values.
pub fn parameter(name: &str, numbers: impl IntoIterator<Item = f64>) -> String {
    format!("\"{name}\" {}", list(numbers))
}

/// A parameter of a colour.
pub fn rgb(name: &str, color: Rgb) -> String {
    parameter(&format!("rgb {name}"), color.to_array())
}

/// The statement that sets the current transformation to a map from an object to the world.
///
/// pbrt's matrices stand before column vectors, as ours, and are listed column by column.
pub fn transform(map: &Transform) -> String {
    let rows = map.rows();
    let column = |j: usize| rows.map(|row| row[j]).into_iter().chain([f64::from(u8::from(j == 3))]);
    format!("Transform {}", list((0..4).flat_map(column)))
}

/// Whether a map moves nothing.
pub fn is_identity(map: &Transform) -> bool {
    *map.rows().as_flattened() == *Transform::IDENTITY.rows().as_flattened()
}
