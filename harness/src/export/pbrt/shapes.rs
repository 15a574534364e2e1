//! The objects, each taken apart into shapes of pbrt.

use groundtruth::math::{Frame, Normal, Point, Step, Transform, Vector};
use groundtruth::scene::Object;
use groundtruth::shapes::{
    Annulus, Disk, Instance, Kind, Lattice, OpenCylinder, PartAnnulus, PartCylinder, PartSphere,
    Plane, Sphere, transform_of,
};

use super::lights::Lamp;
use super::materials::Look;
use super::text::{is_identity, parameter, transform};
use super::textures::Reflectance;
use super::{Writer, kinds};
use crate::export::parts::{Part, copies, leaves, parts};
use crate::export::{How, item, kinds::tag};

/// A scene of more shapes is refused: its text would be of many megabytes.
const MOST_SHAPES: usize = 1_000_000;

/// pbrt computes in single precision, whose step is 1 here.
const FARTHEST: f64 = 1e7;

/// Where a shape stands, and what it is made of.
#[derive(Clone)]
pub(super) struct Setting {
    /// Its place in the scene.
    pub path: String,
    /// From its coordinates to the world's.
    pub map: Transform,
    /// From the coordinates in which its texture is looked up to the world's.
    pub texture: Transform,
    /// Whether an instance around it keeps its texture where it is: then instances in it do not move it.
    is_still: bool,
    /// The index of its material.
    pub material: usize,
    /// What the lights say of the object.
    lamp: Lamp,
    /// How many shapes of the object are before it.
    leaf: u64,
}

/// Which way the normal of a shape in pbrt points: it decides the side that shines.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Sense {
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

/// A shape of pbrt.
pub(super) struct Leaf<'a> {
    pub word: &'a str,
    /// Its parameters.
    pub words: &'a str,
    /// As how many shapes it counts.
    pub count: usize,
    pub sense: Sense,
    pub drawn: Drawn,
    /// Whether it may reach farther than coordinates can.
    pub is_far: bool,
}

impl<'a> Leaf<'a> {
    pub(super) fn new(word: &'a str, words: &'a str, sense: Sense, drawn: Drawn) -> Self {
        Self { word, words, count: 1, sense, drawn, is_far: false }
    }
}

/// Whether pbrt can draw points of a shape, which it does of those that shine.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Drawn {
    Everywhere,
    /// Where the map keeps angles.
    Similar,
    Nowhere,
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
        let (map, texture) = (Transform::IDENTITY, Transform::IDENTITY);
        let lamp = self.lamp(&object.name);
        let path = format!("{path}: shape");
        let at = Setting { path, map, texture, is_still: false, material, lamp, leaf: 0 };
        self.shape(&object.shape, &at);
    }

    /// The index of a material.
    fn material(&mut self, path: &str, name: &str) -> Option<usize> {
        let index = self.scene.materials.iter().position(|material| material.name == name);
        if index.is_none() {
            self.refuse(path, format!("no material \"{name}\""));
        }
        index
    }

    fn shape(&mut self, kind: &Kind, at: &Setting) {
        if self.shapes > MOST_SHAPES {
            return; // listed
        }
        let at = &Setting { path: format!("{}.{}", at.path, tag(kind)), ..at.clone() };
        match kind {
            Kind::Plane(plane) => self.plane(plane, at),
            Kind::Sphere(it) => self.sphere(it, at),
            Kind::PartSphere(it) => self.part_sphere(it, at),
            Kind::OpenCylinder(it) => self.cylinder(it, at),
            Kind::PartCylinder(it) => self.part_cylinder(it, at),
            Kind::Disk(Disk { center, normal, radius }) => {
                let words = parameter("float radius", [*radius]);
                self.disk(*center, *normal, &words, Drawn::Similar, at);
            }
            Kind::Annulus(Annulus { center, normal, inner_radius, outer_radius }) => {
                let words = rims(*inner_radius, *outer_radius);
                self.disk(*center, *normal, &words, Drawn::Nowhere, at);
            }
            Kind::PartAnnulus(it) => self.part_annulus(it, at),
            Kind::Cuboid(it) => self.cuboid(it, at),
            Kind::Triangle(it) => self.triangle(it, at),
            Kind::Rectangle(it) => self.rectangle(it, at),
            Kind::Mesh(it) => self.mesh_of_lists(it, at),
            Kind::TessellatedSphere(it) => self.mesh(&it.mesh(), at),
            Kind::Instance(instance) => self.instance(instance, at),
            Kind::Lattice(it) => self.lattice(it, at),
            kind => match parts(kind).filter(|_| kinds::shape(kind).0 != How::None) {
                Some(parts) => self.parts(parts, at),
                None => self.refuse(&at.path, "no counterpart"),
            },
        }
    }

    /// One shape of pbrt. The matrices of its texture and of itself stand between `AttributeBegin` and `AttributeEnd`.
    pub(super) fn leaf(&mut self, leaf: &Leaf<'_>, map: &Transform, at: &Setting) {
        let Leaf { word, words, count, sense, drawn, .. } = *leaf;
        let before = self.shapes;
        self.shapes += count;
        if self.shapes > MOST_SHAPES {
            if before <= MOST_SHAPES {
                self.refuse(&at.path, TOO_MANY);
            }
            return;
        }
        if let Some(far) = farthest(words, map).filter(|_| !leaf.is_far) {
            let problem = format!(
                "found a coordinate or length of {far}; pbrt computes in single precision, so 10⁷ is the most"
            );
            return self.refuse(&at.path, problem);
        }
        let Some(look) = self.look(at.material) else { return };
        self.line("AttributeBegin");
        self.dress(at.material, &look, &at.texture, at.leaf);
        self.shine(&look, drawn, map, at);
        if !is_identity(map) || matches!(look.reflectance, Reflectance::Checker { .. }) {
            self.line(&format!("  {}", transform(map)));
        }
        if sense == Sense::Opposite {
            self.line("  ReverseOrientation");
        }
        self.line(&format!("  Shape \"{word}\" {words}"));
        self.line("AttributeEnd");
    }

    /// The light of a surface that shines: in pbrt every one lights others.
    fn shine(&mut self, look: &Look, drawn: Drawn, map: &Transform, at: &Setting) {
        let Look { emission, two_sided, .. } = *look;
        if emission.is_black() || at.lamp == Lamp::Off {
            return;
        }
        if at.lamp == Lamp::Unsampled && !self.is_path() {
            let problem = "shines, but lights nothing here, as no area light names it; in pbrt it lights all that \
                           reflects; add an area light";
            self.unlit.push((at.path.clone(), problem));
        }
        if drawn == Drawn::Nowhere || drawn == Drawn::Similar && !map.is_similarity() {
            self.refuse(
                &at.path,
                "shines, but pbrt draws points of the whole shape, without its matrix",
            );
        }
        let material = &self.scene.materials[at.material].name;
        let path = format!("{}: shines as \"{}\"", at.path, groundtruth::printable::name(material));
        self.shines(&path, emission);
        let color = super::text::rgb("L", emission);
        self.line(&format!(
            "  AreaLightSource \"diffuse\" {color} \"bool twosided\" [ {two_sided} ]"
        ));
    }

    /// A sphere about its own origin: `zmin`, `zmax` and `phimax` are left out, as all of it is there.
    fn sphere(&mut self, it: &Sphere, at: &Setting) {
        let map = at.map.after(&moved(it.center));
        let words = parameter("float radius", [it.radius]);
        self.leaf(&Leaf::new("sphere", &words, Sense::of(it.inward), Drawn::Similar), &map, at);
    }

    /// θ from the axis y downward lies between two heights.
    fn part_sphere(&mut self, it: &PartSphere, at: &Setting) {
        let map = at.map.after(&moved(it.center)).after(&upright(it.phi[0]));
        let height = |degrees: f64| it.radius * groundtruth::math::cos_degrees(degrees);
        let [top, bottom] = it.theta.map(height);
        let words = [
            parameter("float radius", [it.radius]),
            parameter("float zmin", [bottom]),
            parameter("float zmax", [top]),
            parameter("float phimax", [width(it.phi)]),
        ];
        self.leaf(
            &Leaf::new("sphere", &words.join(" "), Sense::of(it.inward), Drawn::Nowhere),
            &map,
            at,
        );
    }

    fn cylinder(&mut self, it: &OpenCylinder, at: &Setting) {
        let words = tube(it.radius, it.y0, it.y1);
        let map = at.map.after(&upright(0.0));
        self.leaf(&Leaf::new("cylinder", &words, Sense::of(it.inward), Drawn::Similar), &map, at);
    }

    fn part_cylinder(&mut self, it: &PartCylinder, at: &Setting) {
        let phi = parameter("float phimax", [width(it.phi)]);
        let words = format!("{} {phi}", tube(it.radius, it.y0, it.y1));
        let map = at.map.after(&upright(it.phi[0]));
        self.leaf(&Leaf::new("cylinder", &words, Sense::of(it.inward), Drawn::Nowhere), &map, at);
    }

    /// A disk is in the plane z = 0, with its normal along z.
    fn disk(&mut self, center: Point, normal: Vector, words: &str, drawn: Drawn, at: &Setting) {
        let Some(normal) = Normal::new(normal) else { return };
        let map = at.map.after(&moved(center)).after(&facing(normal));
        self.leaf(&Leaf::new("disk", words, Sense::Same, drawn), &map, at);
    }

    fn part_annulus(&mut self, it: &PartAnnulus, at: &Setting) {
        let phi = parameter("float phimax", [width(it.phi)]);
        let words = format!("{} {phi}", rims(it.inner_radius, it.outer_radius));
        let map = at.map.after(&moved(it.center)).after(&upright(it.phi[0]));
        let sense = Sense::of(it.normal.y() < 0.0);
        self.leaf(&Leaf::new("disk", &words, sense, Drawn::Nowhere), &map, at);
    }

    /// The part of a plane that the camera sees, as a disk.
    fn plane(&mut self, plane: &Plane, at: &Setting) {
        let normal =
            Normal::new(plane.normal).and_then(|normal| Normal::new(at.map.covector(normal)));
        let Some(normal) = normal else { return };
        match self.seen_part(at.map.point(plane.point), normal) {
            Ok((center, radius)) => {
                let words = parameter("float radius", [radius]);
                let map = moved(center).after(&facing(normal));
                let disk = Leaf::new("disk", &words, Sense::Same, Drawn::Similar);
                self.leaf(&Leaf { is_far: true, ..disk }, &map, at);
            }
            Err(problem) => self.refuse(&at.path, problem),
        }
    }

    fn instance(&mut self, instance: &Instance, at: &Setting) {
        match transform_of("transform", &instance.transform) {
            Ok(map) => {
                let moves = instance.transform_texture && !at.is_still;
                let texture = if moves { at.texture.after(&map) } else { at.texture };
                let (path, map) = (format!("{}.of", at.path), at.map.after(&map));
                self.shape(
                    &instance.of,
                    &Setting { path, map, texture, is_still: !moves, ..at.clone() },
                );
            }
            Err(problem) => self.refuse(&at.path, problem.to_string()),
        }
    }

    fn lattice(&mut self, it: &Lattice, at: &Setting) {
        if leaves(&it.clone().into()) > MOST_SHAPES as u64 {
            self.shapes = MOST_SHAPES + 1;
            return self.refuse(&at.path, TOO_MANY);
        }
        self.parts(copies(it), at);
    }

    /// The parts of a shape, each of a material of its own if it has one.
    fn parts(&mut self, parts: Vec<Part>, at: &Setting) {
        let mut leaf = at.leaf;
        for Part { name, material, shape } in parts {
            let path = format!("{}.{name}", at.path);
            let material = match material {
                None => Some(at.material),
                Some(name) => self.material(&path, &name),
            };
            if let Some(material) = material {
                self.shape(&shape, &Setting { path, material, leaf, ..at.clone() });
            }
            leaf += leaves(&shape);
        }
    }
}

const TOO_MANY: &str = "more than 1,000,000 shapes are needed";

fn moved(center: Point) -> Transform {
    Transform::translation(center.to_vector())
}

/// From the coordinates of pbrt's quadrics, whose axis is z and whose azimuths are from x towards y, to ours, whose axis is
/// y and whose azimuths are from z towards x, begun at this azimuth.
fn upright(azimuth: f64) -> Transform {
    let [x, y, z] = [Vector::Z, Vector::X, Vector::Y];
    turned(azimuth).after(&with_axes([x, y, z]))
}

/// A turn about y: from z towards x.
fn turned(azimuth: f64) -> Transform {
    Transform::from_steps(&[Step::RotateY(azimuth)]).unwrap_or(Transform::IDENTITY)
}

/// A turn of z to a normal.
fn facing(normal: Normal) -> Transform {
    let Frame { u, v, w } = Frame::around(normal);
    with_axes([u, v, w])
}

/// The map of x, y and z to these vectors, which are orthonormal.
fn with_axes(axes: [Vector; 3]) -> Transform {
    let columns = axes.map(Vector::to_array);
    let row = |i: usize| [columns[0][i], columns[1][i], columns[2][i], 0.0];
    let matrix = Step::Matrix([row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]]);
    Transform::from_steps(&[matrix]).unwrap_or(Transform::IDENTITY)
}

fn rims(inner: f64, outer: f64) -> String {
    format!("{} {}", parameter("float radius", [outer]), parameter("float innerradius", [inner]))
}

fn tube(radius: f64, y0: f64, y1: f64) -> String {
    let ends = [parameter("float zmin", [y0]), parameter("float zmax", [y1])];
    format!("{} {}", parameter("float radius", [radius]), ends.join(" "))
}

/// The width of a range of azimuths, in degrees.
fn width([from, to]: [f64; 2]) -> f64 {
    let width = if to >= from { to - from } else { (to - from).rem_euclid(360.0) };
    width.min(360.0)
}

/// A number of these words, or a coordinate of the origin after a map, that is too large.
fn farthest(words: &str, map: &Transform) -> Option<f64> {
    let origin = map.point(Point::ORIGIN).to_array();
    let numbers = words.split(' ').filter_map(|word| word.parse::<f64>().ok());
    numbers.chain(origin).find(|number| number.abs() > FARTHEST)
}
