//! POV-Ray: meshes, and shapes made of many.

use exchange::export::pov;
use groundtruth::cameras::{Orthographic, Pinhole, Viewpoint};
use groundtruth::lights::Ambient;
use groundtruth::materials::Matte;
use groundtruth::math::{Point, Ray, Span, Step, Vector};
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Image, Light, Material, Object, Scene};
use groundtruth::shapes::{
    Compound, Instance, Kind, Lattice, Mesh, Part, RandomSpheres, Sphere, TessellatedSphere,
    Triangle,
};
use groundtruth::textures::RandomColors;
use groundtruth::world::World;

use super::parsed::{Statement, said};
use super::pov::{askew, near_all, outside_is_front, vector};

fn sphere(radius: f64) -> Sphere {
    Sphere { center: Point::ORIGIN, radius, inward: false }
}

fn moved(x: f64, y: f64, z: f64) -> Vec<Step> {
    vec![Step::Translate(Vector::new(x, y, z))]
}

/// A scene of one red object, seen askew.
fn of(shape: impl Into<Kind>) -> Scene {
    let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
    scene.objects.push(Object::new("it", "red", shape));
    scene
}

/// The corners of the triangles of a union.
fn triangles(union: &Statement) -> Vec<[Vector; 3]> {
    let all = union.words.iter().filter(|(word, _)| word == "triangle");
    all.map(|(_, corners)| [0, 1, 2].map(|i| vector(&corners[i]))).collect()
}

/// Law: a mesh is its triangles where ours are, with the front where our normal is: POV-Ray's is (v0 − v1) × (v2 − v1), of
/// the corners that are written, also under a reflection. Oracle: our hit of the built scene through the middle of each.
#[test]
fn meshes_are_their_triangles() {
    let corners = [[0.0, 0.0, 0.0], [2.0, 0.5, 0.0], [0.5, 1.5, 1.0], [0.25, 0.5, 3.0]];
    let faces = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
    let mesh = Mesh::of_lists(corners.map(Point::from).to_vec(), faces);
    let mirrored = vec![Step::Scale(Vector::new(-1.0, 1.0, 2.0)), Step::RotateZ(40.0)];
    let shapes: [(Kind, usize); 3] = [
        (mesh.clone().into(), 4),
        (Instance::new(mesh, mirrored.clone()).into(), 4),
        (Instance::new(TessellatedSphere::new(5, 3, false), mirrored).into(), 20),
    ];
    for (shape, count) in shapes {
        let scene = of(shape);
        let (world, parsed) = (World::build(&scene).expect("it is valid"), said(&scene));
        let union = parsed.one("union");
        let triangles = triangles(union);
        assert_eq!(triangles.len(), count);
        for [a, b, c] in triangles {
            let theirs = (a - b).cross(c - b);
            let along = theirs.unit().expect("not zero");
            let centre = Point::ORIGIN + (a + b + c) / 3.0;
            let ray = Ray::new(centre + 0.01 * along, -along);
            let hit = world.hit(&ray, Span::AHEAD).expect("it is there");
            near_all(&hit.surface.point.to_array(), centre.to_array());
            assert_eq!(outside_is_front(union), hit.surface.normal.dot(theirs) > 0.0);
        }
    }
}

/// Law: interpolated normals are refused, each with the way to leave them out.
#[test]
fn interpolated_normals_are_refused() {
    let triangle = Triangle {
        vertices: [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point::from),
        normals: Some([Vector::Z, Vector::new(0.1, 0.0, 1.0), Vector::Z]),
    };
    let shapes: [Kind; 2] = [triangle.into(), TessellatedSphere::new(5, 3, true).into()];
    for shape in shapes {
        let all = pov::write("smooth", &of(shape), "".as_ref()).expect_err("it cannot be said");
        assert_eq!(all.len(), 1);
        assert!(all[0].path.starts_with("objects[0] \"it\": shape."), "{}", all[0].path);
        assert!(all[0].problem.contains("--without smooth"), "{}", all[0].problem);
    }
}

/// Law: the copies of a lattice stand at multiples of its spacing, moved as a whole. Oracle: the numbers by hand.
#[test]
fn lattices_are_their_copies() {
    let lattice = Lattice {
        counts: [2, 1, 3],
        spacing: Vector::new(3.0, 5.0, 4.0),
        of: Box::new(sphere(1.0).into()),
        accel: None,
    };
    let parsed = said(&of(Instance::new(lattice, moved(0.0, 0.0, 100.0))));
    let translation = |it: &&Statement| it.of("matrix")[0][9..].to_vec();
    let mut found: Vec<Vec<f64>> = parsed.all("sphere").iter().map(translation).collect();
    found.sort_by(|a, b| a.partial_cmp(b).expect("no NaN"));
    let places = [0.0, 3.0].into_iter().flat_map(|x| [100.0, 104.0, 108.0].map(|z| [x, 0.0, z]));
    assert_eq!(found, places.map(|place| place.to_vec()).collect::<Vec<_>>());
}

/// Law: random spheres are all written, where ours are. Oracle: our hit from each centre, at its radius.
#[test]
fn random_spheres_are_spheres() {
    let scene = of(RandomSpheres { count: 7, radius: 0.01, half_side: 1.0, seed: 4, accel: None });
    let (world, parsed) = (World::build(&scene).expect("it is valid"), said(&scene));
    let spheres = parsed.all("sphere");
    assert_eq!(spheres.len(), 7);
    for it in spheres {
        let (centre, radius) = (Point::ORIGIN + vector(&it.values[0]), it.values[1][0]);
        let hit = world.hit(&Ray::new(centre, Vector::X), Span::AHEAD).expect("it is there");
        assert!((hit.t / radius - 1.0).abs() < 1e-9, "{} instead of {radius}", hit.t);
    }
}

/// Law: each shape of an object has its random colour, on both sides. Oracle: our picture of three spheres in ambient light, a
/// pixel each.
#[test]
fn random_colors_are_ours() {
    let eye = Viewpoint::new(
        Point::new(4.0, 0.0, 9.0),
        Point::new(4.0, 0.0, 0.0),
        Orthographic { zoom: 1.0 },
    );
    let mut image = Image::new(3, 1);
    image.pixel_size = 4.0;
    let mut scene = Scene::new("three spheres", image, eye);
    scene.lights.push(Light::new("everywhere", Ambient { ls: 1.0, color: Rgb::WHITE }));
    let cd = RandomColors { seed: 3 }.into();
    let matte = Matte { ka: 1.0.into(), kd: 0.5.into(), cd };
    scene.materials.push(Material { two_sided: true, ..Material::new("many", matte) });
    let lattice = Lattice {
        counts: [2, 1, 1],
        spacing: Vector::new(4.0, 1.0, 1.0),
        of: Box::new(sphere(1.0).into()),
        accel: None,
    };
    let last = Instance::new(sphere(1.0), moved(8.0, 0.0, 0.0));
    let parts = vec![Part::new(lattice), Part::new(last)];
    scene.objects.push(Object::new("three", "many", Compound { accel: None, parts }));
    let (world, parsed) = (World::build(&scene).expect("it is valid"), said(&scene));
    for (pixel, it) in (0..3).zip(parsed.all("sphere")) {
        let ours = render::pixel(&world, [pixel, 0]).to_array();
        assert!(ours.iter().any(|channel| *channel > 0.0), "it is seen");
        let pigments: Vec<_> = it.words.iter().filter(|(word, _)| word == "rgb").collect();
        assert_eq!(pigments.len(), 2, "a side each");
        pigments.iter().for_each(|(_, rgb)| near_all(&rgb[0], ours));
    }
}

/// Law: more shapes than a text can hold are refused, not written. Oracle: their number, 10¹⁶.
#[test]
fn too_many_shapes_are_refused() {
    let mut shape: Kind = sphere(1.0).into();
    for _ in 0..8 {
        let spacing = Vector::new(3.0, 1.0, 3.0);
        shape = Lattice { counts: [10, 1, 10], spacing, of: Box::new(shape), accel: None }.into();
    }
    let all = pov::write("many", &of(shape), "".as_ref()).expect_err("it cannot be said");
    assert_eq!(all.len(), 1);
    assert_eq!(all[0].path, "objects[0] \"it\": shape.lattice");
    assert!(all[0].problem.contains("10000000000000000 shapes"), "{}", all[0].problem);
}
