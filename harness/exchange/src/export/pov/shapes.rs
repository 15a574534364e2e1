//! The shapes of POV-Ray for the leaves of the objects.

use groundtruth::math::{Normal, Point, Transform, Vector};
use groundtruth::shapes::{Kind, Plane, Rectangle, Triangle, TriangleMesh};

use super::Writer;
use super::lights::FAR;
use super::text::{matrix, number, vector};
use crate::export::leaves::{Leaves, MOST_SHAPES};
use crate::export::{How, Leaf};

/// The shape of POV-Ray that is the same solid or surface: its word, its numbers, and whether its normal is opposite to ours.
fn words(shape: &Kind) -> Option<(&'static str, String, bool)> {
    Some(match shape {
        Kind::Sphere(it) => {
            let words = format!("{}, {}", vector(it.center.to_array()), number(it.radius));
            ("sphere", words, it.inward)
        }
        Kind::Cuboid(it) => {
            let [min, max] = [it.min, it.max].map(|corner| vector(corner.to_array()));
            ("box", format!("{min}, {max}"), false)
        }
        Kind::OpenCylinder(it) => {
            let [y0, y1, radius] = [it.y0, it.y1, it.radius].map(number);
            let words = format!("<0, {y0}, 0>, <0, {y1}, 0>, {radius} open");
            ("cylinder", words, it.inward)
        }
        Kind::Cone(it) => {
            let [radius, height] = [it.radius, it.height].map(number);
            let words = format!("<0, 0, 0>, {radius}, <0, {height}, 0>, 0 open");
            ("cone", words, it.inward)
        }
        // Sturm sequences find the roots of the quartic more accurately than its solution by radicals
        Kind::Torus(it) => {
            let words = format!("{}, {} sturm", number(it.swept_radius), number(it.tube_radius));
            ("torus", words, it.inward)
        }
        // x² + z² − (r²/h) y = 0 up to y = h; the gradient points outward, as our normal
        Kind::Paraboloid(it) => {
            let slope = number(-it.radius * it.radius / it.height);
            let height = number(it.height);
            let words = format!(
                "<1, 0, 1>, <0, 0, 0>, <0, {slope}, 0>, 0 clipped_by {{ plane {{ <0, 1, 0>, {height} }} }}"
            );
            ("quadric", words, it.inward)
        }
        _ => return None,
    })
}

impl Writer<'_> {
    /// All objects, in leaves.
    pub(super) fn objects(&mut self, leaves: &Leaves<'_>) {
        for leaf in &leaves.all {
            self.shape(leaf);
        }
        self.unsupported.extend_from_slice(&leaves.unsupported);
    }

    /// One shape that is not taken apart.
    pub(super) fn shape(&mut self, at: &Leaf) -> How {
        if let Some((word, words, is_opposite)) = words(&at.shape) {
            self.leaf(word, &words, is_opposite, at);
            return How::Exact("");
        }
        match &at.shape {
            Kind::Plane(plane) => self.plane(plane, at),
            Kind::Triangle(triangle) => {
                self.triangle(triangle, at);
                return How::Exact("flat");
            }
            Kind::Rectangle(rectangle) => {
                self.rectangle(rectangle, at);
                return How::Mesh("two triangles");
            }
            Kind::Disk(it) => self.disc(it.center, it.normal, [0.0, it.radius], at),
            Kind::Annulus(it) => {
                self.disc(it.center, it.normal, [it.inner_radius, it.outer_radius], at);
            }
            Kind::TessellatedSphere(it) => {
                self.mesh(&it.mesh(), at);
                return How::Mesh("its triangles, flat");
            }
            Kind::Mesh(it) => {
                if let Some(mesh) = self.read_mesh(&at.path, it) {
                    self.mesh(&mesh, at);
                }
                return How::Mesh("its triangles, flat");
            }
            _ => return self.no_counterpart(&at.path, ""),
        }
        How::Exact("")
    }

    /// One shape of POV-Ray, with the texture of each side: `interior_texture` is that of the side which the normal
    /// points away from.
    fn leaf(&mut self, word: &str, words: &str, is_opposite: bool, at: &Leaf) {
        if let Some(far) = farthest(words, &at.map) {
            let problem = format!(
                "found a coordinate or length of {far}; POV-Ray sees up to 10⁷, so 10⁶ is the most"
            );
            return self.refuse(&at.path, problem);
        }
        let material = at.material;
        let (out, inside) = if is_opposite { ("back", "front") } else { ("front", "back") };
        let shape = format!("{word} {{ {words}{}", matrix(&at.map));
        if self.is_glass(material) {
            return self.add_to_body(shape, at);
        }
        let dark = if self.casts_shadows(at) { "" } else { " no_shadow" };
        let texture = self.dress(at);
        self.line(&format!(
            "{shape} texture {{ {out}_{material}{texture} }} \
             interior_texture {{ {inside}_{material}{texture} }}{dark} }}"
        ));
    }

    pub(super) fn casts_shadows(&self, at: &Leaf) -> bool {
        at.casts_shadows && self.scene.materials[at.material].casts_shadows
    }

    /// `plane { n, d }` has the points with `n·p = d` for a unit n: so `d = n·point`.
    fn plane(&mut self, plane: &Plane, at: &Leaf) {
        let Some(normal) = Normal::new(plane.normal) else { return };
        let distance = normal.dot(plane.point.to_vector());
        let words = format!("{}, {}", vector(normal.to_array()), number(distance));
        self.leaf("plane", &words, false, at);
    }

    fn disc(&mut self, center: Point, normal: Vector, [inner, outer]: [f64; 2], at: &Leaf) {
        let [center, normal] = [center.to_array(), normal.to_array()].map(vector);
        let words = format!("{center}, {normal}, {}, {}", number(outer), number(inner));
        self.leaf("disc", &words, false, at);
    }

    /// The triangles of a mesh, as a union: the coordinates of POV-Ray's own `mesh` are in single precision.
    ///
    /// The corners are transformed here: POV-Ray would compute the normal again after it had reordered them. Its normal
    /// is `(v0 − v1) × (v2 − v1)`, which is opposite to ours, `(v1 − v0) × (v2 − v0)`; ours turns with the surface, so
    /// that a reflection keeps its side, and that of the transformed corners changes it.
    ///
    /// Interpolated normals are refused: the side that POV-Ray sees is that of the interpolated normal, here it is that
    /// of the true one; and it interpolates after the transformation, we before.
    fn mesh(&mut self, mesh: &TriangleMesh, at: &Leaf) {
        if mesh.normals().is_some() {
            let problem = "the interpolated normal decides which side POV-Ray sees, here the true one does; \
                           --without smooth leaves it out";
            return self.refuse(&at.path, problem);
        }
        let before = self.own.triangles;
        self.own.triangles += mesh.triangles().len() as u64;
        if self.own.triangles > MOST_SHAPES {
            if before <= MOST_SHAPES {
                self.refuse(&at.path, format!("more than {MOST_SHAPES} triangles, the most"));
            }
            return;
        }
        let corner = |&corner: &Point| vector(at.map.point(corner).to_array());
        let corners: Vec<String> = mesh.vertices().iter().map(corner).collect();
        let triangles: Vec<String> = mesh
            .triangles()
            .iter()
            .map(|triangle| triangle.map(|i| corners[i as usize].as_str()).join(", "))
            .collect();
        let in_world = Leaf { map: Transform::IDENTITY, ..at.clone() };
        let is_opposite = at.map.determinant() > 0.0;
        match triangles.as_slice() {
            [one] => self.leaf("triangle", one, is_opposite, &in_world),
            all => {
                let all: String = all.iter().map(|it| format!("\n  triangle {{ {it} }}")).collect();
                self.leaf("union", &format!("{all}\n "), is_opposite, &in_world);
            }
        }
    }

    fn triangle(&mut self, Triangle { vertices, normals }: &Triangle, at: &Leaf) {
        let mesh = TriangleMesh::new(vertices.to_vec(), vec![[0, 1, 2]]);
        let normals: Vec<Normal> =
            normals.iter().flatten().filter_map(|&normal| Normal::new(normal)).collect();
        self.mesh(&if normals.is_empty() { mesh } else { mesh.with_normals(normals) }, at);
    }

    /// Two triangles with the normal `a × b`.
    fn rectangle(&mut self, Rectangle { corner, a, b }: &Rectangle, at: &Leaf) {
        let far = *corner + *a + *b;
        let vertices = vec![*corner, *corner + *a, far, *corner + *b];
        self.mesh(&TriangleMesh::new(vertices, vec![[0, 1, 2], [0, 2, 3]]), at);
    }
}

/// A number of these words, or a coordinate of the origin after a map, that is too large for POV-Ray: it ignores hits
/// farther than 10⁷ from a ray's origin (`MAX_DISTANCE`), and the plane of parallel lights is at [`FAR`].
fn farthest(words: &str, map: &Transform) -> Option<f64> {
    let origin = map.point(Point::ORIGIN).to_array();
    let numbers =
        words.split([' ', ',', '<', '>', '\n']).filter_map(|word| word.parse::<f64>().ok());
    numbers.chain(origin).find(|number| number.abs() > FAR)
}
