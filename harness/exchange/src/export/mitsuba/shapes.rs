//! The shapes of Mitsuba for the leaves of the objects.

use formats::meshes::{Encoding, MeshData, write_ply};
use groundtruth::cameras;
use groundtruth::math::{Frame, Normal, Point, Transform, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::shapes::{Cuboid, Disk, Kind, OpenCylinder, Sphere, TriangleMesh};

use super::Look;
use super::Writer;
use super::materials::Diffuse;
use super::text::{boolean, float, matrix, plugin, point, rgb, rows, word};
use crate::export::leaves::Leaves;
use crate::export::{How, Leaf};

/// The largest coordinate of an object: Mitsuba computes in single precision.
const FAR: f64 = 1e6;

/// What must hold of a mesh.
const IN_A_FILE: &str = "flat, in a file beside the scene";

impl Writer<'_> {
    /// All objects, in leaves.
    pub(super) fn shapes(&mut self, leaves: &Leaves<'_>) -> String {
        let mut all = Vec::new();
        for (index, leaf) in leaves.all.iter().enumerate() {
            let middle = leaf.map.point(Point::ORIGIN).to_vector().max_abs();
            let far = extent(&leaf.shape).max(middle);
            if far > FAR {
                let problem = format!(
                    "a coordinate or length of {far}; in single precision, 10⁶ is the most"
                );
                self.refuse(&leaf.path, problem);
                continue;
            }
            // without a look its material is refused already
            if let Some(look) = self.own.looks.get(&leaf.material).cloned() {
                all.extend(self.shape(&Placed { index, leaf, look: &look }).1);
            }
        }
        all.join("\n")
    }

    /// How a shape that is not taken apart is exported, and its elements.
    pub(super) fn shape(&mut self, at: &Placed<'_>) -> (How, Vec<String>) {
        match &at.leaf.shape {
            Kind::Plane(it) => {
                (How::Mesh("squares, up to far beyond the scene"), self.plane(it, at))
            }
            Kind::Sphere(it) => (How::Exact(""), self.sphere(it, at)),
            Kind::Cuboid(it) => (How::Exact(""), self.cuboid(it, at)),
            Kind::Triangle(it) => {
                let lists = (it.vertices.as_slice(), [[0, 1, 2]].as_slice());
                (How::Exact(IN_A_FILE), self.triangles(lists, it.normals.is_some(), at))
            }
            Kind::Rectangle(it) => {
                let face = Flat { corner: it.corner, a: it.a, b: it.b };
                let element = self.flat(&face.after(&at.leaf.map), at);
                (How::Exact(""), element.into_iter().collect())
            }
            Kind::Disk(it) => (How::Exact(""), self.disk(it, at)),
            Kind::OpenCylinder(it) => (How::Exact(""), self.cylinder(it, at)),
            Kind::TessellatedSphere(it) => {
                (How::Mesh("its triangles, flat"), self.mesh(&it.mesh(), at))
            }
            Kind::Mesh(it) => {
                let mesh = self.read_mesh(&at.leaf.path, it);
                (How::Exact(IN_A_FILE), mesh.map_or(Vec::new(), |mesh| self.mesh(&mesh, at)))
            }
            _ => (self.no_counterpart(&at.leaf.path, ""), Vec::new()),
        }
    }

    /// The radiance that a leaf sends out. An object that is a lamp is dark where its light is off.
    fn emission(&self, at: &Placed<'_>) -> Rgb {
        let lamp = self.lamp_of(at.leaf.object);
        let shines = lamp.is_none_or(|light| self.own.paths.lights.contains(&light));
        if shines { self.exposed(at.look.emission) } else { Rgb::BLACK }
    }

    /// A shape of this kind, with its material and its emission. `flips` turns its normal round.
    fn element(
        &mut self,
        kind: &str,
        mut inner: Vec<String>,
        flips: bool,
        at: &Placed<'_>,
    ) -> String {
        if flips {
            inner.push(boolean("flip_normals", true));
        }
        let emission = self.emission(at);
        if !emission.is_black() {
            inner.push(plugin("emitter", "area", &[rgb("radiance", emission)]));
        }
        match &at.look.diffuse {
            Diffuse::Plain(_) => inner.push(format!("<ref id=\"m{}\"/>", at.leaf.material)),
            // the texture of a face is written with it
            Diffuse::Textured(..) if kind == "rectangle" => {}
            Diffuse::Textured(..) if !self.own.paths.is_lit => {
                inner.push(at.look.bsdf("", self.own.paths.is_lit));
            }
            Diffuse::Textured(..) => {
                self.refuse(&at.leaf.path, "a checker on a surface that is not flat, or a disk");
            }
        }
        plugin("shape", kind, &inner)
    }

    /// A shape under a map that is no similarity: an instance.
    fn instance(
        &mut self,
        kind: &str,
        inner: Vec<String>,
        flips: bool,
        at: &Placed<'_>,
    ) -> Vec<String> {
        if !self.emission(at).is_black() {
            self.refuse(&at.leaf.path, "an instance of this shape does not shine there");
        }
        let id = format!("g{}", at.index);
        let shape = self.element(kind, inner, flips, at);
        let group = plugin("shape", "shapegroup", &[shape]);
        let map = matrix("to_world", at.leaf.map.rows());
        vec![
            group.replacen("<shape ", &format!("<shape id=\"{id}\" "), 1),
            plugin("shape", "instance", &[format!("<ref id=\"{id}\"/>"), map]),
        ]
    }

    /// A sphere, its normal outward.
    fn sphere(&mut self, it: &Sphere, at: &Placed<'_>) -> Vec<String> {
        let map = &at.leaf.map;
        let flips = self.seen_from_inside(it, at).unwrap_or(it.inward);
        if !map.is_similarity() {
            let inner = vec![point("center", it.center), float("radius", it.radius)];
            return self.instance("sphere", inner, flips, at);
        }
        let radius = it.radius * scale(map);
        let inner = vec![point("center", map.point(it.center)), float("radius", radius)];
        vec![self.element("sphere", inner, flips, at)]
    }

    /// A cylinder without ends, its normal outward.
    fn cylinder(&mut self, it: &OpenCylinder, at: &Placed<'_>) -> Vec<String> {
        self.refuse_two_sided_lamp(at);
        let map = &at.leaf.map;
        let ends = [("p0", it.y0), ("p1", it.y1)].map(|(name, y)| (name, Point::new(0.0, y, 0.0)));
        if !map.is_similarity() {
            let mut inner = ends.map(|(name, end)| point(name, end)).to_vec();
            inner.push(float("radius", it.radius));
            return self.instance("cylinder", inner, it.inward, at);
        }
        let mut inner = ends.map(|(name, end)| point(name, map.point(end))).to_vec();
        inner.push(float("radius", it.radius * scale(map)));
        vec![self.element("cylinder", inner, it.inward, at)]
    }

    /// A cube from −1 to 1 under a map; with a checker, its six faces.
    fn cuboid(&mut self, it: &Cuboid, at: &Placed<'_>) -> Vec<String> {
        if at.is_textured() {
            return faces(it)
                .iter()
                .flat_map(|face| self.flat(&face.after(&at.leaf.map), at))
                .collect();
        }
        self.refuse_two_sided_lamp(at);
        let half = 0.5 * (it.max - it.min);
        let [x, y, z] = half.to_array();
        // a cube is its own mirror image: the map must not turn its triangles round
        let x = if at.leaf.map.determinant() < 0.0 { -x } else { x };
        let axes = [x * Vector::X, y * Vector::Y, z * Vector::Z];
        let axes = axes.map(|axis| at.leaf.map.vector(axis));
        let map = matrix("to_world", rows(axes, at.leaf.map.point(it.min + half)));
        vec![self.element("cube", vec![map], false, at)]
    }

    /// `disk` is x² + y² ≤ 1 in z = 0, with the normal z.
    fn disk(&mut self, it: &Disk, at: &Placed<'_>) -> Vec<String> {
        let Some(normal) = Normal::new(it.normal) else { return Vec::new() };
        let (frame, map) = (Frame::around(normal), &at.leaf.map);
        let [u, v] = [frame.u, frame.v].map(|axis| map.vector(it.radius * axis));
        let Some(n) = map.covector(normal).unit() else { return Vec::new() };
        let flips = self.seen_from_behind(map.point(it.center), n, at).unwrap_or(false);
        let [u, v] = if u.cross(v).dot(n) < 0.0 { [v, u] } else { [u, v] };
        let map = matrix("to_world", rows([u, v, n], map.point(it.center)));
        vec![self.element("disk", vec![map], flips, at)]
    }

    pub(super) fn flat(&mut self, face: &Flat, at: &Placed<'_>) -> Option<String> {
        self.rectangle(face, face, at)
    }

    /// `rectangle` is from −1 to 1 on x and y, with the normal z; its texture coordinates are from 0 to 1. It has the texture
    /// of the face `painted`.
    pub(super) fn rectangle(
        &mut self,
        Flat { corner, a, b }: &Flat,
        painted: &Flat,
        at: &Placed<'_>,
    ) -> Option<String> {
        let n = a.cross(*b).unit()?;
        let flips = self.seen_from_behind(*corner, n, at).unwrap_or(false);
        let middle = *corner + 0.5 * (*a + *b);
        let mut inner = vec![matrix("to_world", rows([0.5 * *a, 0.5 * *b, n], middle))];
        if let (Diffuse::Textured(kd, kind), true) = (&at.look.diffuse, self.own.paths.is_lit) {
            let face = painted.mapped(&at.leaf.texture.inverse());
            let path = format!("{}: the texture of its material", at.leaf.path);
            let texture =
                self.texture(&path, kind, kd * at.look.factor(self.own.paths.is_lit), &face)?;
            inner.push(at.look.bsdf(&texture, self.own.paths.is_lit));
        } else if at.is_textured() {
            inner.push(at.look.bsdf("", self.own.paths.is_lit));
        }
        Some(self.element("rectangle", inner, flips, at))
    }

    /// Triangles in a file, in world coordinates. Mitsuba's `diffuse` is black where an interpolated normal is turned away
    /// from the viewer, ours where the true one is: so smooth ones are refused.
    fn triangles(
        &mut self,
        (corners, triangles): (&[Point], &[[u32; 3]]),
        is_smooth: bool,
        at: &Placed<'_>,
    ) -> Vec<String> {
        self.refuse_two_sided_lamp(at);
        if is_smooth {
            let problem = "interpolated normals, which differ at silhouettes; --without smooth makes it flat on both sides";
            self.refuse(&at.leaf.path, problem);
        }
        let name = format!("{}-{}.ply", self.own.stem, at.index);
        self.own.files.push((name.clone(), ply(corners, triangles, &at.leaf.map)));
        let inner = vec![word("filename", &name), boolean("face_normals", true)];
        vec![self.element("ply", inner, false, at)]
    }

    fn mesh(&mut self, mesh: &TriangleMesh, at: &Placed<'_>) -> Vec<String> {
        let lists = (mesh.vertices(), mesh.triangles());
        self.triangles(lists, mesh.normals().is_some(), at)
    }

    fn refuse_two_sided_lamp(&mut self, at: &Placed<'_>) {
        if at.is_two_sided_lamp() {
            self.refuse_lamp(at, ": there are no such lamps there");
        }
    }

    fn refuse_lamp(&mut self, at: &Placed<'_>, why: &str) {
        self.refuse(&at.leaf.path, format!("a lamp that shines on both sides{why}"));
    }

    /// Whether a two-sided lamp is seen from inside; the other side of a closed surface is never seen.
    fn seen_from_inside(&mut self, it: &Sphere, at: &Placed<'_>) -> Option<bool> {
        if !at.is_two_sided_lamp() {
            return None;
        }
        let (camera, map) = (&self.scene.camera, &at.leaf.map);
        let eye = map.inverse().point(camera.eye);
        let is_inside = eye.distance(it.center) < it.radius;
        let back = (camera.eye - camera.look_at).unit()?;
        let in_front = -back.dot(map.point(it.center) - camera.eye);
        let starts_apart = match camera.lens {
            cameras::Kind::Pinhole(_) => true,
            _ => map.is_similarity() && in_front.abs() > it.radius * scale(map),
        };
        if !starts_apart {
            self.refuse_lamp(at, ", and rays start inside and outside of it");
        }
        Some(is_inside)
    }

    /// Whether the camera sees a flat two-sided lamp from behind; nothing else may see it.
    fn seen_from_behind(&mut self, on: Point, normal: Vector, at: &Placed<'_>) -> Option<bool> {
        if !at.is_two_sided_lamp() {
            return None;
        }
        let camera = &self.scene.camera;
        let to_eye = match camera.lens {
            cameras::Kind::Pinhole(_) => camera.eye - on,
            _ => camera.eye - camera.look_at,
        };
        let has_lens = matches!(camera.lens, cameras::Kind::ThinLens(_));
        if has_lens || self.own.paths.edges > 1 {
            self.refuse_lamp(at, ", of which rays may see both");
        }
        Some(to_eye.dot(normal) < 0.0)
    }
}

/// A leaf with its look.
pub(super) struct Placed<'a> {
    pub index: usize,
    pub leaf: &'a Leaf,
    pub look: &'a Look,
}

impl Placed<'_> {
    pub(super) fn is_textured(&self) -> bool {
        matches!(self.look.diffuse, Diffuse::Textured(..))
    }

    fn is_two_sided_lamp(&self) -> bool {
        self.look.is_two_sided && !self.look.emission.is_black()
    }
}

/// A parallelogram of the points `corner + u a + v b` for u and v from 0 to 1; its normal is along `a × b`.
pub(super) struct Flat {
    pub corner: Point,
    pub a: Vector,
    pub b: Vector,
}

impl Flat {
    fn mapped(&self, map: &Transform) -> Self {
        Self { corner: map.point(self.corner), a: map.vector(self.a), b: map.vector(self.b) }
    }

    /// After a map; of a reflection the sides are exchanged, which keeps the front.
    fn after(&self, map: &Transform) -> Self {
        let Self { corner, a, b } = self.mapped(map);
        let [a, b] = if map.determinant() < 0.0 { [b, a] } else { [a, b] };
        Self { corner, a, b }
    }
}

/// The faces of a box, their normals outward.
fn faces(it: &Cuboid) -> Vec<Flat> {
    let [x, y, z] = (it.max - it.min).to_array();
    let (x, y, z) = (x * Vector::X, y * Vector::Y, z * Vector::Z);
    let [min, max] = [it.min, it.max];
    let near = [[y, x], [z, y], [x, z]].map(|[a, b]| Flat { corner: min, a, b });
    let far = [[x, y], [y, z], [z, x]].map(|[a, b]| Flat { corner: max, a: -a, b: -b });
    near.into_iter().chain(far).collect()
}

/// The triangles after a map, as a file. The front is the side from which the corners run counter-clockwise, there and here;
/// after a reflection they run the other way round.
fn ply(corners: &[Point], triangles: &[[u32; 3]], map: &Transform) -> Vec<u8> {
    let is_mirrored = map.determinant() < 0.0;
    let turned = |&[a, b, c]: &[u32; 3]| if is_mirrored { [a, c, b] } else { [a, b, c] };
    let mesh = MeshData {
        vertices: corners.iter().map(|corner| map.point(*corner).to_array()).collect(),
        triangles: triangles.iter().map(turned).collect(),
        ..MeshData::default()
    };
    write_ply(&mesh, Encoding::Ascii)
}

/// The largest number of a shape; of planes, which are cut off, and of other kinds 0.
fn extent(shape: &Kind) -> f64 {
    match shape {
        Kind::Sphere(it) => it.center.to_vector().max_abs().max(it.radius),
        Kind::Cuboid(it) => it.min.to_vector().max_abs().max(it.max.to_vector().max_abs()),
        Kind::Rectangle(it) => {
            it.corner.to_vector().max_abs().max(it.a.max_abs()).max(it.b.max_abs())
        }
        Kind::Disk(it) => it.center.to_vector().max_abs().max(it.radius),
        _ => 0.0,
    }
}

/// The factor of lengths of a similarity.
fn scale(map: &Transform) -> f64 {
    map.vector(Vector::X).length()
}
