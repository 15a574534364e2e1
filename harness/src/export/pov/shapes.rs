//! The objects, each taken apart into shapes of POV-Ray.

use groundtruth::math::{Normal, Point, Transform, Vector};
use groundtruth::scene::Object;
use groundtruth::shapes::{Instance, Kind, Plane, Rectangle, Triangle, transform_of};

use super::Writer;
use super::lights::FAR;
use super::materials::is_patterned;
use super::text::{matrix, number, vector};
use crate::export::parts::{Part, parts};
use crate::export::{item, kinds};

/// Where a shape stands, and what it is made of.
#[derive(Clone)]
struct Setting {
    /// Its place in the scene.
    path: String,
    /// From its coordinates to the world's.
    map: Transform,
    /// From the coordinates in which its texture is looked up to the world's.
    texture: Transform,
    /// Whether an instance around it keeps its texture where it is: then instances in it do not move it.
    is_still: bool,
    /// The index of its material.
    material: usize,
    /// Whether the object casts shadows; its material may not.
    casts_shadows: bool,
}

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
    /// All objects that are part of the scene.
    pub(super) fn objects(&mut self) {
        for (index, object) in self.scene.objects.iter().enumerate().filter(|(_, it)| it.enabled) {
            self.object(index, object);
        }
    }

    fn object(&mut self, index: usize, object: &Object) {
        let path = item("objects", index, &object.name);
        let Some(material) = self.material(&path, &object.material) else { return };
        let path = format!("{path}: shape");
        let (map, texture) = (Transform::IDENTITY, Transform::IDENTITY);
        let casts_shadows = object.casts_shadows;
        let at = Setting { path, map, texture, is_still: false, material, casts_shadows };
        self.shape(&object.shape, &at);
    }

    /// The index of a material.
    fn material(&mut self, path: &str, name: &str) -> Option<usize> {
        let index = self.scene.materials.iter().position(|material| material.name == name);
        match index {
            Some(index) if !self.materials.contains(&index) => self.materials.push(index),
            Some(_) => {}
            None => self.refuse(path, format!("no material \"{name}\"")),
        }
        index
    }

    fn shape(&mut self, kind: &Kind, at: &Setting) {
        let at = &Setting { path: format!("{}.{}", at.path, kinds::tag(kind)), ..at.clone() };
        match kind {
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
            Kind::Instance(instance) => self.instance(instance, at),
            Kind::Compound(_)
            | Kind::SolidCylinder(_)
            | Kind::SolidCone(_)
            | Kind::ThickRing(_) => {
                self.parts(parts(kind).unwrap_or_default(), at);
            }
            _ => self.refuse(&at.path, "no counterpart"),
        }
    }

    /// One shape of POV-Ray, with the texture of each side: `interior_texture` is that of the side which the normal
    /// points away from.
    fn leaf(&mut self, word: &str, words: &str, sense: Sense, at: &Setting) {
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
    fn plane(&mut self, plane: &Plane, at: &Setting) {
        let Some(normal) = Normal::new(plane.normal) else { return };
        let distance = normal.dot(plane.point.to_vector());
        let words = format!("{}, {}", vector(normal.to_array()), number(distance));
        self.leaf("plane", &words, Sense::Same, at);
    }

    fn disc(&mut self, center: Point, normal: Vector, [inner, outer]: [f64; 2], at: &Setting) {
        let [center, normal] = [center.to_array(), normal.to_array()].map(vector);
        let words = format!("{center}, {normal}, {}, {}", number(outer), number(inner));
        self.leaf("disc", &words, Sense::Same, at);
    }

    /// The corners are transformed here: POV-Ray would compute the normal again after it had reordered them. Its normal
    /// is `(v0 − v1) × (v2 − v1)`, which is opposite to ours, `(v1 − v0) × (v2 − v0)`; ours turns with the surface, so
    /// that a reflection keeps its side, and that of the transformed corners changes it.
    ///
    /// The normals of a smooth triangle have the sense of ours, and theirs decides which side is seen.
    fn triangle(&mut self, triangle: &Triangle, at: &Setting) {
        let corners = triangle.vertices.map(|corner| vector(at.map.point(corner).to_array()));
        let in_world = Setting { map: Transform::IDENTITY, ..at.clone() };
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
    fn rectangle(&mut self, Rectangle { corner, a, b }: &Rectangle, at: &Setting) {
        let far = *corner + *a + *b;
        for vertices in [[*corner, *corner + *a, far], [*corner, far, *corner + *b]] {
            self.triangle(&Triangle { vertices, normals: None }, at);
        }
    }

    fn instance(&mut self, instance: &Instance, at: &Setting) {
        match transform_of("transform", &instance.transform) {
            Ok(map) => {
                let moves = instance.transform_texture && !at.is_still;
                let texture = if moves { at.texture.after(&map) } else { at.texture };
                let (path, map) = (format!("{}.of", at.path), at.map.after(&map));
                let is_still = !moves;
                self.shape(&instance.of, &Setting { path, map, texture, is_still, ..at.clone() });
            }
            Err(problem) => self.refuse(&at.path, problem.to_string()),
        }
    }

    /// The parts of a shape, each of a material of its own if it has one.
    fn parts(&mut self, parts: Vec<Part>, at: &Setting) {
        for Part { name, material, shape } in parts {
            let path = format!("{}.{name}", at.path);
            let material = match material {
                None => Some(at.material),
                Some(name) => self.material(&path, &name),
            };
            if let Some(material) = material {
                self.shape(&shape, &Setting { path, material, ..at.clone() });
            }
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
