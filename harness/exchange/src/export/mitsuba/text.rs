//! Elements of the XML of Mitsuba.

use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;

use crate::export::number;
use text::xml;

/// An element of a plugin, such as a shape or an emitter, around others.
pub fn plugin(element: &str, kind: &str, inner: &[String]) -> String {
    let head = format!("<{element} type=\"{kind}\"");
    match inner.is_empty() {
        true => head + "/>",
        false => format!("{head}>{}</{element}>", inner.concat()),
    }
}

/// A named number.
pub fn float(name: &str, value: f64) -> String {
    format!("<float name=\"{name}\" value=\"{}\"/>", number(value))
}

/// A named count.
pub fn integer(name: &str, value: u32) -> String {
    format!("<integer name=\"{name}\" value=\"{value}\"/>")
}

/// A named word.
pub fn word(name: &str, value: &str) -> String {
    let value = xml::attribute(value);
    format!("<string name=\"{name}\" value=\"{value}\"/>")
}

/// A named choice.
pub fn boolean(name: &str, value: bool) -> String {
    format!("<boolean name=\"{name}\" value=\"{value}\"/>")
}

/// A named colour, linear.
pub fn rgb(name: &str, color: Rgb) -> String {
    format!("<rgb name=\"{name}\" value=\"{}\"/>", list(&color.to_array()))
}

/// A named point.
pub fn point(name: &str, point: Point) -> String {
    coordinates("point", name, point.to_array())
}

/// A named vector.
pub fn vector(name: &str, vector: Vector) -> String {
    coordinates("vector", name, vector.to_array())
}

fn coordinates(element: &str, name: &str, numbers: [f64; 3]) -> String {
    let [x, y, z] = numbers.map(number);
    format!("<{element} name=\"{name}\" x=\"{x}\" y=\"{y}\" z=\"{z}\"/>")
}

/// A named map, by the rows of its matrix for column vectors, as ours.
pub fn matrix(name: &str, rows: [[f64; 4]; 3]) -> String {
    let rows = rows.map(|row| list(&row)).join(" ");
    format!("<transform name=\"{name}\"><matrix value=\"{rows} 0 0 0 1\"/></transform>")
}

/// The rows of the map with these images of the axes and of the origin.
pub fn rows(axes: [Vector; 3], origin: Point) -> [[f64; 4]; 3] {
    let [x, y, z] = axes.map(Vector::to_array);
    let origin = origin.to_array();
    std::array::from_fn(|i| [x[i], y[i], z[i], origin[i]])
}

fn list(numbers: &[f64]) -> String {
    numbers.iter().map(|it| number(*it)).collect::<Vec<_>>().join(" ")
}

/// A named map of texture coordinates, by the two rows of its matrix.
pub fn matrix_of_uv(name: &str, [u, v]: [[f64; 3]; 2]) -> String {
    matrix(name, [[u[0], u[1], 0.0, u[2]], [v[0], v[1], 0.0, v[2]], [0.0, 0.0, 1.0, 0.0]])
}
