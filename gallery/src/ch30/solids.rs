//! Solid textures.

use super::{lit, show};
use groundtruth::math::{Axis, Point, Step, Vector, cos, sin};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::scene::build::*;
use groundtruth::shapes::{
    Compound, Kind, Materials, Mesh, PartSphere, Rectangle, SolidCone, SolidCylinder,
};
use groundtruth::textures::{Checker3d, Kind as Texture, Paint, Stripes, TextureInstance};

/// The radius of the sphere that is cut out of the cube.
const CUT: f64 = 1.5;

/// The box from −1 to 1 without the sphere of radius 1.5 about its corner (1, 1, 1).
fn cut_cube_shape() -> Kind {
    let corner = point(1.0, 1.0, 1.0);
    let hollow = PartSphere {
        center: corner,
        radius: CUT,
        phi: [180.0, 270.0],
        theta: [90.0, 180.0],
        inward: true,
    };
    let far = point(-1.0, -1.0, -1.0);
    let [x, y, z] = [2.0 * Vector::X, 2.0 * Vector::Y, 2.0 * Vector::Z];
    let whole = [(z, y), (x, z), (y, x)].map(|(a, b)| Rectangle { corner: far, a, b }.into());
    let parts = whole.into_iter().chain([cut_faces().into(), hollow.into()]);
    Compound::of(parts.collect::<Vec<Kind>>()).into()
}

/// The faces x = 1, y = 1 and z = 1: squares without a quarter of a disk about (1, 1, 1), each a
/// fan of triangles about its opposite corner.
fn cut_faces() -> Mesh {
    /// With this number, chords are at most 0.0001 inside the circle.
    const CHORDS: u32 = 64;
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for axis in 0..3 {
        // (a, b) are the next two axes in cyclic order: counter-clockwise from outside
        let on_face = |a: f64, b: f64| {
            let mut p = [1.0; 3];
            (p[(axis + 1) % 3], p[(axis + 2) % 3]) = (a, b);
            Point::from(p)
        };
        let first = vertices.len() as u32;
        vertices.extend([on_face(-1.0, -1.0), on_face(1.0, -1.0)]);
        vertices.extend((0..=CHORDS).map(|i| {
            let angle = f64::from(i) / f64::from(CHORDS) * std::f64::consts::FRAC_PI_2;
            on_face(1.0 - CUT * sin(angle), 1.0 - CUT * cos(angle))
        }));
        vertices.push(on_face(-1.0, 1.0));
        let last = vertices.len() as u32 - 1;
        triangles.extend((first + 1..last).map(|i| [first, i, i + 1]));
    }
    Mesh::of_lists(vertices, triangles)
}

/// The camera of figure 30.1.
fn of_cut_cube(about: &str) -> Scene {
    lit(pinhole(about, [600, 600], [point(6.0, 8.0, 12.0), point(0.0, -0.1, 0.0)], 2850.0))
}

/// Figure 30.1, with stripes; the lights and the tilt of the stripes are ours.
pub fn cut_cube() -> Scene {
    let mut scene =
        of_cut_cube("figure 30.1: stripes continue from the faces of a cube into its hollow");
    let stripes = Stripes {
        axis: Axis::Y,
        size: 0.2,
        color1: rgb(0.9, 0.7, 0.4).into(),
        color2: rgb(0.5, 0.25, 0.1).into(),
    };
    let tilted = TextureInstance::new(stripes, vec![Step::RotateX(25.0), Step::RotateZ(-20.0)]);
    show(&mut scene, "cut cube", cut_cube_shape(), tilted);
    scene
}

/// Figures 30.2 and 30.4; sizes, colours and lights are ours.
pub fn row() -> Scene {
    let about =
        "figures 30.2 and 30.4: a solid checker cut by a sphere, cylinder, cone, box and plane";
    let view = [point(100.0, 100.0, 300.0), point(0.0, 1.0, 0.0)];
    let mut scene = lit(pinhole(about, [880, 300], view, 12_000.0));
    let paint = |color2: Rgb| checker3d(1.0, Rgb::WHITE, color2);
    // perpendicular to the view direction
    let along = vector(3.0, 0.0, -1.0).unit().expect("not zero");
    let materials = Materials::new;
    let cylinder = SolidCylinder { y0: -1.5, y1: 1.5, radius: 1.5, materials: materials() };
    let cone = SolidCone { height: 3.5, radius: 1.75, materials: materials() };
    let block = boxed(point(-1.5, -1.5, -1.5), point(1.5, 1.5, 1.5));
    let solids: [(&str, Kind, f64, Rgb); 4] = [
        ("sphere", sphere(Point::ORIGIN, 1.75).into(), 1.75, rgb(0.8, 0.2, 0.1)),
        ("cylinder", cylinder.into(), 1.5, rgb(0.1, 0.5, 0.1)),
        ("cone", cone.into(), 0.0, rgb(0.1, 0.3, 0.8)),
        ("box", block.into(), 1.5, rgb(0.8, 0.5, 0.1)),
    ];
    for (i, (name, shape, lift, color2)) in (0..).zip(solids) {
        let by = (5.0 * f64::from(i) - 7.5) * along + lift * Vector::Y;
        show(&mut scene, name, moved(shape, by), paint(color2));
    }
    let grey = checker3d(1.0, grey(0.9), grey(0.4));
    show(&mut scene, "plane", ground(0.0), grey);
    scene
}

/// The checker of figure 30.11.
pub fn checker() -> Checker3d {
    let [color1, color2] = [Rgb::WHITE, rgb(0.8, 0.25, 0.1)].map(Paint::from);
    Checker3d { size: 0.3, color1, color2 }
}

/// A texture half as long along x.
pub fn halved_along_x(texture: impl Into<Texture>) -> Paint {
    let halve = Step::Scale(vector(0.5, 1.0, 1.0));
    TextureInstance::new(texture.into(), vec![halve]).into()
}

/// Figure 30.11: a box with this texture, twice as long along x. Camera and lights are ours.
pub fn stretched(about: &str, paint: Paint) -> Scene {
    let view = [point(4.0, 5.0, 10.0), Point::ORIGIN];
    let mut scene = lit(pinhole(about, [600, 400], view, 1500.0));
    let block = boxed(point(-0.9, -0.9, -0.9), point(0.9, 0.9, 0.9));
    let long = transformed(block, vec![Step::Scale(vector(2.0, 1.0, 1.0))]);
    show(&mut scene, "box", long, paint);
    scene
}
