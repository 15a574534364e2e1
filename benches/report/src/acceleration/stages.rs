//! The scenes of page 2, for any number of objects, and the rays of their pictures.

use std::ops::Range;
use std::sync::Arc;

use serde::Serialize;

use groundtruth::math::{Aabb, Frame, Pcg32, Point, Ray, Vector, atan2, power, sin};
use groundtruth::shapes::{
    Context, Cuboid as Boxed, Kind, Shape, Sphere, TessellatedSphere, TriangleMesh,
};

/// A kind of scene.
#[derive(Serialize)]
pub struct Stage {
    /// Its name.
    #[serde(rename = "stage")]
    pub name: &'static str,
    /// Its contents and purpose.
    pub about: &'static str,
    /// Builds approximately this number of objects from a seed.
    #[serde(skip)]
    pub objects: fn(u32, u64) -> Objects,
    /// The position of the camera, and half the width of the picture in the plane through the
    /// origin.
    #[serde(skip)]
    pub view: (Point, f64),
}

/// The objects of a scene.
#[derive(Debug, Default)]
pub struct Objects {
    /// The shapes.
    pub shapes: Vec<Arc<dyn Shape>>,
    /// The box of each.
    pub bounds: Vec<Aabb>,
    /// The groups of a scene made of groups: ranges of all shapes, in order.
    pub groups: Vec<Range<usize>>,
    /// If the shapes are the triangles of a mesh, that mesh: it has its own acceleration structure.
    pub mesh: Option<TriangleMesh>,
}

/// All scenes.
pub static STAGES: [Stage; 4] = [
    Stage {
        name: "uniform spheres",
        about: "Random spheres in a cube, whose total volume is always the same fraction of it \
                (figure 22.11): the best case for a regular grid.",
        objects: |n, seed| Objects::new(spheres(n, seed, 1.0)),
        view: (Point::new(0.0, 0.0, 20.0), 200.0 / 3600.0 * 20.0),
    },
    Stage {
        name: "teapot in a stadium",
        about: "The same spheres, two thousand times smaller, in the middle of a stadium of 64 large \
                boxes on a floor: the picture shows only the spheres. A grid over the whole scene has \
                them all in one cell.",
        objects: stadium,
        view: (Point::new(0.0, 0.01, 0.01), 200.0 / 3600.0 * 20.0 * TEAPOT),
    },
    Stage {
        name: "bumpy mesh",
        about: "A sphere of triangles with bumps of 15 %, similar to a scanned model.",
        objects: bumpy,
        view: (Point::new(0.5, 1.0, 4.0), 1.2),
    },
    Stage {
        name: "tessellated sphere",
        about: "A sphere of triangles (figure 23.1), long and thin ones at the poles.",
        objects: |n, _| of_mesh(sphere_mesh(n)),
        view: (Point::new(0.5, 1.0, 4.0), 1.2),
    },
];

/// Half the size of the teapot in the stadium.
const TEAPOT: f64 = 0.0005;

impl Stage {
    /// The rays of a picture of `side` × `side` pixels, row by row.
    pub fn rays(&self, side: u32) -> Vec<Ray> {
        let (eye, half_width) = self.view;
        let back = eye.to_vector();
        let Some(frame) = Frame::looking(back, Vector::Y) else { return Vec::new() };
        let film = |i: u32| half_width * (2.0 * (f64::from(i) + 0.5) / f64::from(side) - 1.0);
        let ray = |i: u32| {
            let local = Vector::new(film(i % side), -film(i / side), -back.length());
            Ray::new(eye, frame.to_world(local))
        };
        (0..side * side).map(ray).collect()
    }
}

impl Objects {
    fn new(kinds: impl IntoIterator<Item = Kind>) -> Self {
        let mut context = Context::default();
        let build = |kind: Kind| kind.build(&mut context).expect("the stages' shapes are valid");
        let shapes: Vec<Arc<dyn Shape>> = kinds.into_iter().map(build).collect();
        let bounds = shapes.iter().map(|shape| shape.bounds()).collect();
        Self { shapes, bounds, groups: Vec::new(), mesh: None }
    }

    /// The number of objects or triangles.
    pub fn count(&self) -> usize {
        self.shapes.len()
    }
}

/// `n` spheres in `[−half, half]³` with the total volume `0.1 half³`.
fn spheres(n: u32, seed: u64, half: f64) -> impl Iterator<Item = Kind> {
    let volume = 0.1 / f64::from(n);
    let radius = half * power(0.75 * volume / std::f64::consts::PI, 1.0 / 3.0);
    let mut random = Pcg32::new(seed, 22);
    (0..n).map(move |_| {
        let mut x = || half * (2.0 * random.uniform() - 1.0);
        Sphere { center: Point::new(x(), x(), x()), radius, inward: false }.into()
    })
}

fn stadium(n: u32, seed: u64) -> Objects {
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
    let mut objects = Objects::new(teapot.chain((0..64).map(seat)).chain([floor.into()]));
    let n = n as usize;
    objects.groups = std::iter::once(0..n).chain((n..n + 65).map(|i| i..i + 1)).collect();
    objects
}

fn of_mesh(mesh: TriangleMesh) -> Objects {
    let corners = |t: &[u32; 3]| t.map(|vertex| mesh.vertices()[vertex as usize]);
    let triangle = |t| groundtruth::shapes::Triangle { vertices: corners(t), normals: None }.into();
    let mut objects = Objects::new(mesh.triangles().iter().map(triangle));
    objects.mesh = Some(mesh);
    objects
}

/// Approximately n triangles: `4 v (v − 1)`.
fn sphere_mesh(n: u32) -> TriangleMesh {
    let vertical = (0.5 + 0.5 * (f64::from(n) + 1.0).sqrt()) as u32;
    TessellatedSphere::new(2 * vertical, vertical, false).mesh()
}

fn bumpy(n: u32, _: u64) -> Objects {
    let round = sphere_mesh(n);
    let moved = |p: &Point| {
        let [x, y, z] = p.to_array();
        let (phi, theta) = (atan2(x, z), atan2((x * x + z * z).sqrt(), y));
        p.scaled(1.0 + 0.1 * sin(9.0 * phi) * sin(7.0 * theta) + 0.05 * sin(31.0 * theta))
    };
    let vertices = round.vertices().iter().map(moved).collect();
    of_mesh(TriangleMesh::new(vertices, round.triangles().to_vec()))
}
