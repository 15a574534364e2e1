//! The scenes of page 2, for any number of objects, and the rays of their pictures.

use std::ops::Range;
use std::sync::Arc;

use crate::math::{Aabb, Frame, Pcg32, Point, Ray, Vector, atan2, power, sin};
use crate::shapes::{Box as Boxed, Context, Kind, Shape, Sphere, TessellatedSphere, TriangleMesh};

/// A kind of scene.
pub struct Stage {
    pub name: &'static str,
    /// What it is made of, and why it is here.
    pub about: &'static str,
    /// About so many objects, under a seed.
    pub things: fn(u32, u64) -> Things,
    /// Where the camera is.
    pub eye: Point,
    /// Half the width of the picture where it goes through the origin.
    pub half_width: f64,
}

/// What is searched.
#[derive(Debug, Default)]
pub struct Things {
    pub shapes: Vec<Arc<dyn Shape>>,
    pub bounds: Vec<Aabb>,
    /// What belongs together, in a scene made of groups: all shapes, in order.
    pub groups: Vec<Range<usize>>,
    /// If the shapes are the triangles of a mesh, that mesh: it has a search of its own.
    pub mesh: Option<TriangleMesh>,
}

pub const STAGES: &[Stage] = &[
    Stage {
        name: "uniform spheres",
        about: "Spheres at random in a cube, whose volumes together are always the same part of it \
                (figure 22.11): what a regular grid is made for.",
        things: uniform,
        eye: Point::new(0.0, 0.0, 20.0),
        half_width: 200.0 / 3600.0 * 20.0,
    },
    Stage {
        name: "teapot in a stadium",
        about: "The same spheres, two thousand times smaller, in the middle of a stadium of 64 large \
                boxes on a floor: the picture shows the spheres alone. One cell of a grid over the \
                whole holds them all.",
        things: stadium,
        eye: Point::new(0.0, 0.01, 0.01),
        half_width: 200.0 / 3600.0 * 20.0 * TEAPOT,
    },
    Stage {
        name: "bumpy mesh",
        about: "A sphere of triangles with bumps of 15 %, about as uneven as a scanned model.",
        things: bumpy,
        eye: Point::new(0.5, 1.0, 4.0),
        half_width: 1.2,
    },
    Stage {
        name: "tessellated sphere",
        about: "A smooth sphere of triangles (figure 23.1): long thin ones at the poles.",
        things: tessellated,
        eye: Point::new(0.5, 1.0, 4.0),
        half_width: 1.2,
    },
];

/// Half the size of the teapot in the stadium.
const TEAPOT: f64 = 0.0005;

impl Stage {
    /// The rays of a picture with so many pixels along each side, row by row.
    pub fn rays(&self, side: u32) -> Vec<Ray> {
        let back = self.eye.to_vector();
        let Some(frame) = Frame::looking(back, Vector::Y) else { return Vec::new() };
        let place = |i: u32| self.half_width * (2.0 * (f64::from(i) + 0.5) / f64::from(side) - 1.0);
        let ray = |i: u32| {
            let local = Vector::new(place(i % side), -place(i / side), -back.length());
            Ray::new(self.eye, frame.to_world(local))
        };
        (0..side * side).map(ray).collect()
    }
}

impl Things {
    fn new(kinds: impl IntoIterator<Item = Kind>) -> Self {
        let mut context = Context::default();
        let build = |kind: Kind| kind.build(&mut context).expect("the stages' shapes are valid");
        let shapes: Vec<Arc<dyn Shape>> = kinds.into_iter().map(build).collect();
        let bounds = shapes.iter().map(|shape| shape.bounds()).collect();
        Self { shapes, bounds, groups: Vec::new(), mesh: None }
    }

    /// How many objects or triangles there are.
    pub fn count(&self) -> usize {
        self.shapes.len()
    }
}

/// Spheres in `[−half, half]³`, each of volume `0.1/n` of an eighth of it.
fn spheres(n: u32, seed: u64, half: f64) -> impl Iterator<Item = Kind> {
    let volume = 0.1 / f64::from(n);
    let radius = half * power(0.75 * volume / std::f64::consts::PI, 1.0 / 3.0);
    let mut random = Pcg32::new(seed, 22);
    (0..n).map(move |_| {
        let mut x = || half * (2.0 * random.uniform() - 1.0);
        Sphere { center: Point::new(x(), x(), x()), radius, inward: false }.into()
    })
}

fn uniform(n: u32, seed: u64) -> Things {
    Things::new(spheres(n, seed, 1.0))
}

fn stadium(n: u32, seed: u64) -> Things {
    let seat = |i: u32| {
        let along = 12.5 * f64::from(i % 17) - 100.0;
        let [x, z] = match i / 17 {
            0 => [along, -100.0],
            1 => [along, 100.0],
            2 => [-100.0, along],
            _ => [100.0, along],
        };
        let corner = Point::new(x, -1.0, z);
        Boxed { min: corner, max: corner + Vector::new(8.0, 20.0, 8.0) }.into()
    };
    let floor =
        Boxed { min: Point::new(-110.0, -2.0, -110.0), max: Point::new(110.0, -1.0, 110.0) };
    let teapot = spheres(n, seed, TEAPOT);
    let mut things = Things::new(teapot.chain((0..64).map(seat)).chain([floor.into()]));
    let n = n as usize;
    things.groups = std::iter::once(0..n).chain((n..n + 65).map(|i| i..i + 1)).collect();
    things
}

fn of_mesh(mesh: TriangleMesh) -> Things {
    let corners = |t: &[u32; 3]| t.map(|vertex| mesh.vertices()[vertex as usize]);
    let triangle = |t| crate::shapes::Triangle { vertices: corners(t), normals: None }.into();
    let mut things = Things::new(mesh.triangles().iter().map(triangle));
    things.mesh = Some(mesh);
    things
}

/// About n triangles: `4 v (v − 1)`.
fn sphere_mesh(n: u32) -> TriangleMesh {
    let vertical = (0.5 + 0.5 * (f64::from(n) + 1.0).sqrt()) as u32;
    TessellatedSphere::new(2 * vertical, vertical, false).mesh()
}

fn tessellated(n: u32, _: u64) -> Things {
    of_mesh(sphere_mesh(n))
}

fn bumpy(n: u32, _: u64) -> Things {
    let round = sphere_mesh(n);
    let moved = |p: &Point| {
        let [x, y, z] = p.to_array();
        let (phi, theta) = (atan2(x, z), atan2((x * x + z * z).sqrt(), y));
        p.scaled(1.0 + 0.1 * sin(9.0 * phi) * sin(7.0 * theta) + 0.05 * sin(31.0 * theta))
    };
    let vertices = round.vertices().iter().map(moved).collect();
    of_mesh(TriangleMesh::new(vertices, round.triangles().to_vec()))
}
