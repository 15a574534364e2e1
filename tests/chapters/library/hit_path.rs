//! The path of a hit: the nested shapes that contain it, and the part of the innermost shape that is hit.

use formats::meshes::write_ply;
use groundtruth::shapes::{Face, Level, Part, PartPath, RandomSpheres};
use serde_json::json;

use crate::prelude::*;

/// A few hundred rounding errors of `t` below 100, in transformations of moderate condition number.
const ROUNDING: f64 = 1e-11;

/// A file with a strip of triangles around the origin; some triangles have area zero.
fn strip(folder: &std::path::Path) -> (Kind, MeshData) {
    let mut data = MeshData::default();
    for i in 0..12_u32 {
        let (x, y) = (0.25 * f64::from(i / 2) - 0.6, 0.8 * f64::from(i % 2) - 0.4);
        data.vertices.push([x, y, 0.1 * f64::from(i % 3)]);
    }
    for i in 0..10 {
        data.triangles.push([i, i + 1, i + 2]);
        if i % 3 == 0 {
            data.triangles.push([i, i + 1, i]);
        }
    }
    let file = folder.join("strip.ply");
    let bytes = write_ply(&data, Encoding::LittleEndian);
    std::fs::write(&file, bytes).expect("written");
    let mesh = Mesh::of_file(file);
    (mesh.into(), data)
}

/// A shape of about size 1 around the origin, made of nested shapes down to this depth.
fn nesting(depth: u32, strip: &Kind, draw: &mut Draw) -> Kind {
    let choice = if depth == 0 { draw.below(4) } else { 4 + draw.below(3) };
    match choice {
        0 => strip.clone(),
        1 => Sphere { center: draw.point(0.3), radius: 0.5, inward: false }.into(),
        2 => Cuboid { min: Point::new(-0.5, -0.4, -0.6), max: Point::new(0.3, 0.5, 0.4) }.into(),
        3 => RandomSpheres { count: 9, radius: 0.2, half_side: 0.8, seed: 4, accel: None }.into(),
        4 => {
            let steps = vec![
                Step::RotateAbout {
                    point: draw.point(0.5),
                    direction: draw.direction().into(),
                    degrees: draw.between(-180.0, 180.0),
                },
                Step::Scale(Vector::new(0.9, draw.between(0.5, 1.2), -0.8)),
                Step::Translate(draw.vector(0.3)),
            ];
            Instance::new(nesting(depth - 1, strip, draw), steps).into()
        }
        5 => {
            let of = Box::new(nesting(depth - 1, strip, draw));
            let spacing = Vector::new(1.1, -1.3, 0.9);
            Lattice { of, counts: [2, 3, 2], spacing, accel: None }.into()
        }
        _ => {
            let part = |i: u32| {
                let to = Step::Translate(Vector::new(1.3 * f64::from(i) - 1.3, 0.2, 0.0));
                let name = if i == 1 { "middle".to_owned() } else { String::new() };
                let shape = nesting(depth - 1, strip, draw);
                Part { name, ..Part::new(Instance::new(shape, vec![to])) }
            };
            Compound { accel: None, parts: (0..3).map(part).collect() }.into()
        }
    }
}

/// The innermost shape that a path names, found in the scene's data, and all its transformations.
fn named(kind: &Kind, levels: &[Level], strip: &MeshData) -> (Kind, Vec<Step>) {
    let inner = |kind: &Kind, then: Vec<Step>| {
        let (found, mut steps) = named(kind, &levels[1..], strip);
        steps.extend(then);
        (found, steps)
    };
    match (kind, levels.first()) {
        (Kind::Instance(instance), Some(Level::Instance {})) => {
            inner(&instance.of, instance.transform.clone())
        }
        (Kind::Compound(compound), Some(Level::Part { index, name })) => {
            let part = &compound.parts[*index as usize];
            assert_eq!(&part.name, name);
            inner(&part.shape, Vec::new())
        }
        (Kind::Lattice(lattice), Some(Level::Copy(copy))) => {
            let [i, j, k] = copy.map(f64::from);
            let [x, y, z] = lattice.spacing.to_array();
            inner(&lattice.of, vec![Step::Translate(Vector::new(i * x, j * y, k * z))])
        }
        (Kind::RandomSpheres(data), Some(Level::Sphere(number))) => {
            (data.spheres()[*number as usize].clone().into(), Vec::new())
        }
        (Kind::Mesh(_), Some(Level::Triangle(number))) => {
            let corners = strip.triangles[*number as usize].map(|v| strip.vertices[v as usize]);
            (Triangle { vertices: corners.map(Point::from), normals: None }.into(), Vec::new())
        }
        (Kind::Cuboid(block), Some(Level::Face(face))) => (rectangle(block, *face), Vec::new()),
        (Kind::Sphere(_), None) => (kind.clone(), Vec::new()),
        (kind, level) => panic!("{level:?} of {kind:?}"),
    }
}

fn rectangle(block: &Cuboid, face: Face) -> Kind {
    let sides = block.max - block.min;
    let [x, y, z] = [sides.x() * Vector::X, sides.y() * Vector::Y, sides.z() * Vector::Z];
    let (corner, a, b) = match face {
        Face::MinX => (block.min, y, z),
        Face::MaxX => (block.max, -y, -z),
        Face::MinY => (block.min, x, z),
        Face::MaxY => (block.max, -x, -z),
        Face::MinZ => (block.min, x, y),
        Face::MaxZ => (block.max, -x, -y),
    };
    Rectangle { corner, a, b }.into()
}

/// A ray from outside through a random point near the shapes.
fn ray(draw: &mut Draw) -> Ray {
    let to = draw.point(1.5);
    let from = to + 8.0 * Vector::from(draw.direction());
    Ray::new(from, to - from)
}

fn agrees(kind: &Kind, path: &PartPath, at: &Candidate, ray: &Ray, strip: &MeshData) {
    let (innermost, steps) = named(kind, path.levels(), strip);
    let whole = Transform::from_steps(&steps).expect("invertible");
    let shape = innermost.build(&mut Context::default()).expect("valid");
    let alone = shape.roots(&whole.ray_back(ray), Span::AHEAD);
    let nearest = alone.iter().map(|other| (other.t - at.t).abs()).fold(f64::INFINITY, f64::min);
    assert!(nearest <= ROUNDING, "{path}: {} is not among {alone:?}", at.t);
}

/// Law: the path of a hit names the innermost shape, which is hit at the same `t` when it is alone. This
/// holds for nearest hits and all hits of random nestings of instances, compounds, lattices, meshes, spheres
/// and boxes. Oracle: the shape looked up in the scene's data by the path, under one transformation composed
/// by hand; a triangle is found by its index in the file's own list, which has some of area zero.
#[test]
fn the_innermost_part_that_a_path_names_is_hit_at_the_same_distance() {
    let folder = tempfile::tempdir().expect("a folder");
    let (strip, data) = strip(folder.path());
    let mut draw = Draw::new(2147);
    let mut ends = [0; 4];
    for case in 0..240 {
        let kind = nesting(case % 4, &strip, &mut draw);
        let shape = kind.build(&mut Context::default()).expect("valid");
        for _ in 0..40 {
            let ray = ray(&mut draw);
            let Some(at) = shape.hit(&ray, Span::AHEAD) else { continue };
            for at in shape.roots(&ray, Span::AHEAD).iter().chain([&at]) {
                let path = shape.path(at);
                agrees(&kind, &path, at, &ray, &data);
                ends[match path.levels().last() {
                    Some(Level::Triangle(_)) => 0,
                    Some(Level::Sphere(_)) => 1,
                    Some(Level::Face(_)) => 2,
                    _ => 3,
                }] += 1;
            }
        }
    }
    assert!(ends.iter().all(|&count| count > 500), "every kind of part is hit: {ends:?}");
}

/// Law: the triangle number of a hit on a tessellated sphere is the index in the sphere's mesh.
/// Oracle: the triangle of the three vertices contains the point.
#[test]
fn a_tessellated_sphere_counts_as_its_mesh() {
    let data = TessellatedSphere::new(7, 5, true);
    let mesh = data.mesh();
    let shape = Kind::from(data).build(&mut Context::default()).expect("valid");
    let mut draw = Draw::new(2150);
    for _ in 0..500 {
        let ray = Ray::new(Point::ORIGIN, draw.direction().into());
        let at = shape.hit(&ray, Span::AHEAD).expect("from inside");
        let number = shape.path(&at).triangle().expect("a triangle");
        let [a, b, c] =
            mesh.triangles()[number as usize].map(|v| mesh.vertices()[v as usize].to_vector());
        // the coordinates of the point in the basis of the corners are all positive
        let (p, volume) = (at.t * ray.direction, a.dot(b.cross(c)));
        let shares = [p.dot(b.cross(c)), p.dot(c.cross(a)), p.dot(a.cross(b))].map(|v| v / volume);
        assert!(shares.iter().all(|&share| share > -ROUNDING), "{shares:?}");
        assert!((shares.iter().sum::<f64>() - 1.0).abs() < ROUNDING, "{shares:?}");
    }
}

/// Law: a hit of a world gives the path inside the object's shape; solids made of parts name them; a
/// path is written in plain words and as JSON. Oracle: a scene whose paths are known by construction.
#[test]
fn a_hit_of_a_world_tells_its_path_in_words_and_as_json() {
    let scene: Scene = toml::from_str(
        r#"
        camera = { eye = [0, 0, 9], lens = { pinhole = { distance = 1 } } }
        image = { width = 2, height = 2 }
        materials = [{ name = "m", recipe = { matte = { cd = 1 } } }]
        [[objects]]
        name = "can"
        material = "m"
        shape = { solid_cylinder = { y0 = 0, y1 = 1, radius = 1 } }
        [[objects]]
        name = "rows"
        material = "m"
        [objects.shape.compound]
        parts = [
            { shape = { sphere = { center = [20, 0, 0], radius = 1 } } },
            { name = "lid", shape = { instance = { transform = [{ translate = [0, 0, 5] }], of = {
                lattice = { counts = [2, 3, 4], spacing = [3, 3, 3], of = {
                    box = { min = [10, 0, 0], max = [11, 1, 1] } } } } } } },
        ]
        "#,
    )
    .expect("a scene");
    let world = World::build(&scene).expect("valid");
    let path = |from: [f64; 3], direction: Vector| {
        let hit = world.hit(&Ray::new(from.into(), direction), Span::AHEAD).expect("a hit");
        hit.path()
    };
    let top = path([0.1, 3.0, 0.2], -Vector::Y);
    let name = |level: &Level| match level {
        Level::Part { name, .. } => name.clone(),
        _ => String::new(),
    };
    assert_eq!(top.levels().iter().map(name).collect::<Vec<_>>(), ["top"]);
    let ball = path([20.0, 9.0, 0.0], -Vector::Y);
    assert_eq!(ball.to_string(), "part 0 of a compound");
    assert_eq!(serde_json::to_value(&ball).expect("JSON"), json!([{"part": {"index": 0}}]));
    let block = path([13.5, 99.0, 14.5], -Vector::Y);
    assert_eq!(
        block.to_string(),
        "part 1 (lid), instance, copy [1, 2, 3] of a lattice, face of greatest y"
    );
    let expected = json!([
        {"part": {"index": 1, "name": "lid"}}, {"instance": {}}, {"copy": [1, 2, 3]}, {"face": "max_y"}
    ]);
    assert_eq!(serde_json::to_value(&block).expect("JSON"), expected);
}
