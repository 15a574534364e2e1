//! POV-Ray: meshes, and shapes made of many.

use groundtruth::cameras::{Orthographic, Viewpoint};
use groundtruth::math::{Point, Vector};
use groundtruth::render;
use groundtruth::scene::build::{add, ambient, matte, moved, point, sphere, vector};
use groundtruth::scene::{Image, Scene};
use groundtruth::shapes::{
    Compound, Instance, Kind, Lattice, Mesh, Part, Rectangle, TessellatedSphere, Triangle,
};
use groundtruth::textures::RandomColors;
use groundtruth::world::World;

use super::fixtures::{are_fronts, askew, mirrored, narrow, near_all};
use super::texts::{Parts, each, vector_of};

fn ball(radius: f64) -> Kind {
    sphere(Point::ORIGIN, radius).into()
}

/// Law: triangles, the halves of a rectangle and those of a mesh are where ours are, with the front where our normal is:
/// POV-Ray's is (v0 − v1) × (v2 − v1), of the corners that are written, also under a reflection. Oracle: our hit of the
/// built scene through the middle of each.
#[test]
fn meshes_are_their_triangles() {
    let corners = [[0.0, 0.0, 0.0], [2.0, 0.5, 0.0], [0.5, 1.5, 1.0], [0.25, 0.5, 3.0]];
    let [a, b, c, _] = corners.map(Point::from);
    let triangle = Triangle { vertices: [a, b, c], normals: None };
    let wall = Rectangle { corner: Point::ORIGIN, a: 2.0 * Vector::X, b: 3.0 * Vector::Y };
    let faces = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
    let mesh = Mesh::of_lists(corners.map(Point::from).to_vec(), faces);
    let shapes: [(Kind, usize); 6] = [
        (triangle.clone().into(), 1),
        (Instance::new(triangle, mirrored()).into(), 1),
        (wall.into(), 2),
        (mesh.clone().into(), 4),
        (Instance::new(mesh, mirrored()).into(), 4),
        (Instance::new(TessellatedSphere::new(5, 3, false), mirrored()).into(), 20),
    ];
    for (shape, count) in shapes {
        let scene = askew(narrow(), shape);
        let parts = Parts::pov(&scene);
        let whole = parts.one(if count == 1 { "triangle" } else { "union" });
        // the first texture is that of the side its normal points to
        let outside_is_front = whole.find("front_0") < whole.find("back_0");
        let triangles = each(whole, "triangle");
        assert_eq!(triangles.len(), count);
        // POV-Ray's normal
        let theirs = |it: &Vec<f64>| [6, 3, 0].map(|i| vector_of(&it[i..]));
        let fronts = are_fronts(&scene, &triangles.iter().map(theirs).collect::<Vec<_>>());
        assert!(fronts.iter().all(|it| *it == outside_is_front), "fronts: {fronts:?}");
    }
}

/// Law: each shape of an object has its random colour, on both sides. Oracle: our picture of three spheres in ambient light, a
/// pixel each.
#[test]
fn random_colors_are_ours() {
    let eye =
        Viewpoint::new(point(4.0, 0.0, 9.0), point(4.0, 0.0, 0.0), Orthographic { zoom: 1.0 });
    let image = Image { pixel_size: 4.0, ..Image::new(3, 1) };
    let mut scene = Scene::new("three spheres", image, eye);
    scene.lights.push(ambient(1.0));
    let spacing = vector(4.0, 1.0, 1.0);
    let two = Lattice { counts: [2, 1, 1], spacing, of: Box::new(ball(1.0)), accel: None };
    let parts = vec![Part::new(two), Part::new(moved(ball(1.0), 8.0 * Vector::X))];
    let recipe = matte(1.0, 0.5, RandomColors { seed: 3 });
    add(&mut scene, "three", Compound { accel: None, parts }, recipe);
    scene.materials[0].two_sided = true;
    let (world, parts) = (World::build(&scene).expect("it is valid"), Parts::pov(&scene));
    for (pixel, it) in (0..3).zip(parts.all("sphere")) {
        let ours = render::pixel(&world, [pixel, 0]).to_array();
        assert!(ours.iter().any(|channel| *channel > 0.0), "it is seen");
        let pigments = each(it, "rgb");
        assert_eq!(pigments.len(), 2, "a side each");
        pigments.iter().for_each(|rgb| near_all(rgb, ours));
    }
}
