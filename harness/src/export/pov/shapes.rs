//! The shapes of POV-Ray for the leaves of the objects.

use groundtruth::math::{Normal, Point, Transform, Vector};
use groundtruth::shapes::{Kind, Plane, Rectangle, Triangle};

use super::Writer;
use super::lights::FAR;
use super::materials::is_patterned;
use super::text::{matrix, number, vector};
use crate::export::Leaf;
use crate::export::leaves::Leaves;

/// Which way the normal of a shape in POV-Ray points.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Sense {
    /// As ours.
    Same,
    /// The other way.
    Opposite,
}

impl Sense {
    fn of(is_opposite: bool) -> Self {
        if is_opposite { Self::Opposite } else { Self::Same }
    }
}

impl Writer<'_> {
    /// All objects, in leaves.
    pub(super) fn objects(&mut self, leaves: &Leaves<'_>) {
        leaves.all.iter().for_each(|leaf| self.shape(leaf));
        self.unsayable.extend_from_slice(&leaves.unsayable);
    }

    fn shape(&mut self, at: &Leaf) {
        match &at.shape {
            Kind::Plane(plane) => self.plane(plane, at),
            Kind::Sphere(it) => {
                let words = format!("{}, {}", vector(it.center.to_array()), number(it.radius));
                self.leaf("sphere", &words, Sense::of(it.inward), at);
            }
            Kind::Cuboid(it) => {
                let [min, max] = [it.min, it.max].map(|corner| vector(corner.to_array()));
                self.leaf("box", &format!("{min}, {max}"), Sense::Same, at);
            }
            Kind::Triangle(triangle) => self.triangle(triangle, at),
            Kind::Rectangle(rectangle) => self.rectangle(rectangle, at),
            Kind::Disk(it) => self.disc(it.center, it.normal, [0.0, it.radius], at),
            Kind::Annulus(it) => {
                self.disc(it.center, it.normal, [it.inner_radius, it.outer_radius], at);
            }
            Kind::OpenCylinder(it) => {
                let words = format!(
                    "<0, {}, 0>, <0, {}, 0>, {} open",
                    number(it.y0),
                    number(it.y1),
                    number(it.radius)
                );
                self.leaf("cylinder", &words, Sense::of(it.inward), at);
            }
            Kind::Cone(it) => {
                let words = format!(
                    "<0, 0, 0>, {}, <0, {}, 0>, 0 open",
                    number(it.radius),
                    number(it.height)
                );
                self.leaf("cone", &words, Sense::of(it.inward), at);
            }
            // Sturm sequences find the roots of the quartic more accurately than its solution by radicals
            Kind::Torus(it) => {
                let words =
                    format!("{}, {} sturm", number(it.swept_radius), number(it.tube_radius));
                self.leaf("torus", &words, Sense::of(it.inward), at);
            }
            // x² + z² − (r²/h) y = 0 up to y = h; the gradient points outward, as our normal
            Kind::Paraboloid(it) => {
                let slope = number(-it.radius * it.radius / it.height);
                let height = number(it.height);
                let words = format!(
                    "<1, 0, 1>, <0, 0, 0>, <0, {slope}, 0>, 0 clipped_by {{ plane {{ <0, 1, 0>, {height} }} }}"
                );
                self.leaf("quadric", &words, Sense::of(it.inward), at);
            }
            _ => self.refuse(&at.path, "no counterpart"),
        }
    }

    /// One shape of POV-Ray, with the texture of each side: `interior_texture` is that of the side which the normal
    /// points away from.
    fn leaf(&mut self, word: &str, words: &str, sense: Sense, at: &Leaf) {
        if let Some(far) = farthest(words, &at.map) {
            let problem = format!(
                "found a coordinate or length of {far}; POV-Ray sees up to 10⁷, so 10⁶ is the most"
            );
            return self.refuse(&at.path, problem);
        }
        let material = at.material;
        let (out, inside) = match sense {
            Sense::Same => ("front", "back"),
            Sense::Opposite => ("back", "front"),
        };
        let dark = match at.casts_shadows && self.scene.materials[material].casts_shadows {
            true => "",
            false => " no_shadow",
        };
        let map = matrix(&at.map);
        // a modifier transforms only what stands before it: the texture has a matrix of its own
        let texture = match is_patterned(&self.scene.materials[material]) {
            true => matrix(&at.texture),
            false => String::new(),
        };
        self.line(&format!(
            "{word} {{ {words}{map} texture {{ {out}_{material}{texture} }} \
             interior_texture {{ {inside}_{material}{texture} }}{dark} }}"
        ));
    }

    /// `plane { n, d }` has the points with `n·p = d` for a unit n: so `d = n·point`.
    fn plane(&mut self, plane: &Plane, at: &Leaf) {
        let Some(normal) = Normal::new(plane.normal) else { return };
        let distance = normal.dot(plane.point.to_vector());
        let words = format!("{}, {}", vector(normal.to_array()), number(distance));
        self.leaf("plane", &words, Sense::Same, at);
    }

    fn disc(&mut self, center: Point, normal: Vector, [inner, outer]: [f64; 2], at: &Leaf) {
        let [center, normal] = [center.to_array(), normal.to_array()].map(vector);
        let words = format!("{center}, {normal}, {}, {}", number(outer), number(inner));
        self.leaf("disc", &words, Sense::Same, at);
    }

    /// The corners are transformed here: POV-Ray would compute the normal again after it had reordered them. Its normal
    /// is `(v0 − v1) × (v2 − v1)`, which is opposite to ours, `(v1 − v0) × (v2 − v0)`; ours turns with the surface, so
    /// that a reflection keeps its side, and that of the transformed corners changes it.
    ///
    /// The normals of a smooth triangle have the sense of ours, and theirs decides which side is seen.
    fn triangle(&mut self, triangle: &Triangle, at: &Leaf) {
        let corners = triangle.vertices.map(|corner| vector(at.map.point(corner).to_array()));
        let in_world = Leaf { map: Transform::IDENTITY, ..at.clone() };
        let Some(normals) = triangle.normals else {
            let sense = Sense::of(at.map.determinant() > 0.0);
            return self.leaf("triangle", &corners.join(", "), sense, &in_world);
        };
        let normals = normals.map(|normal| {
            let moved = Normal::new(normal).map(|normal| at.map.covector(normal));
            vector(moved.and_then(Vector::unit).unwrap_or(normal).to_array())
        });
        let pairs: Vec<String> = corners
            .iter()
            .zip(&normals)
            .map(|(corner, normal)| format!("{corner}, {normal}"))
            .collect();
        self.leaf("smooth_triangle", &pairs.join(", "), Sense::Same, &in_world);
    }

    /// Two triangles with the normal `a × b`.
    fn rectangle(&mut self, Rectangle { corner, a, b }: &Rectangle, at: &Leaf) {
        let far = *corner + *a + *b;
        for vertices in [[*corner, *corner + *a, far], [*corner, far, *corner + *b]] {
            self.triangle(&Triangle { vertices, normals: None }, at);
        }
    }
}

/// A number of these words, or a coordinate of the origin after a map, that is too large for POV-Ray: it ignores hits
/// farther than 10⁷ from a ray's origin (`MAX_DISTANCE`), and the plane of parallel lights is at [`FAR`].
fn farthest(words: &str, map: &Transform) -> Option<f64> {
    let origin = map.point(Point::ORIGIN).to_array();
    let numbers = words.split([' ', ',', '<', '>']).filter_map(|word| word.parse::<f64>().ok());
    numbers.chain(origin).find(|number| number.abs() > FAR)
}
