//! The wireframe: the edges of triangles (Suffern, ch. 30).

use super::{Chooser, Color, Made, Paint, Specification, TexturePoint, made};
use crate::kinds::{self, Resources};
use crate::math::{Width, exact_cross};
use crate::rgb::Rgb;
use crate::shapes::Facet;

/// Lines along the edges of the triangles of a mesh. Shapes without triangles have the colour
/// `color` everywhere. The lines belong to the triangles: instances of the mesh transform them,
/// texture instances do not.
#[kind]
pub struct Wireframe {
    /// The full width of a line, half of it on each side of the edge, in the unit of the mesh; not
    /// negative.
    pub line_width: Width,
    /// The colour of the lines.
    #[default(Rgb::BLACK.into())]
    pub line_color: Paint,
    /// The colour between the lines.
    #[default(kinds::white())]
    pub color: Paint,
}

#[derive(Debug)]
struct WireframeTexture {
    line_width: f64,
    line_color: Color,
    color: Color,
}

impl Specification for Wireframe {
    fn make(&self, resources: &mut Resources) -> Made {
        made(WireframeTexture {
            line_width: self.line_width,
            line_color: self.line_color.build("line_color", resources)?,
            color: self.color.build("color", resources)?,
        })
    }
}

impl Chooser for WireframeTexture {
    fn chosen(&self, at: &TexturePoint<'_>) -> &Color {
        let on_line = |facet: &Facet| edge_distance(facet) < 0.5 * self.line_width;
        if at.facet().as_ref().is_some_and(on_line) { &self.line_color } else { &self.color }
    }
}

/// The distance of the point from the nearest edge. The distance from the edge opposite a corner is
/// the barycentric coordinate of the corner times the height of the triangle: twice the area over
/// the edge's length.
fn edge_distance(facet: &Facet) -> f64 {
    let ([a, b, c], [beta, gamma]) = (facet.corners, facet.barycentric);
    let weights = [1.0 - beta - gamma, beta, gamma];
    let twice_area = exact_cross(a, b, c).length();
    let lengths = [b.distance(c), c.distance(a), a.distance(b)];
    let distances = [0, 1, 2].map(|i: usize| weights[i] * twice_area / lengths[i]);
    distances.into_iter().fold(f64::INFINITY, f64::min)
}
