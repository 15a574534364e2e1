//! Cameras that see everything.

use exchange::framing::*;
use groundtruth::math::{Point, Vector, cos_degrees, sin_degrees};
use groundtruth::scene::Scene;
use groundtruth::scene::build::*;
use groundtruth::world::World;

/// A scene with one box, and a picture of this many pixels.
fn scene(min: Point, max: Point, size: [u32; 2], back: Vector) -> Scene {
    let mut scene = pinhole("x", size, [Point::ORIGIN + back, Point::ORIGIN], 3.0);
    add(&mut scene, "box", boxed(min, max), matte(0.0, 0.5, grey(0.5)));
    scene
}

/// Law: from every direction, for small and for large boxes near and far from the origin, all corners are inside
/// the picture, and the box does not look small: its sphere spans more than nine tenths of the shorter side.
/// Oracle: the corners divided by their depth, by hand.
#[test]
fn every_corner_of_the_box_is_in_the_picture() {
    let backs = [[0.0, 0.0, 1.0], [3.0, 1.0, -2.0], [-1.0, 5.0, 0.2], [1.0, 0.0, 0.0]];
    let boxes = [
        ([-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]),
        ([1e3, 2e3, -5e3], [1.1e3, 2.01e3, -4.99e3]),
        ([-3e-7, 0.0, 0.0], [2e-7, 1e-9, 4e-7]),
        ([-4e9, -1e9, 7.0], [5e9, 1e9, 8e9]),
    ];
    for (min, max) in boxes.map(|(min, max)| (Point::from(min), Point::from(max))) {
        for back in backs.map(|[x, y, z]| vector(x, y, z)) {
            for size in [[40, 30], [10, 70]] {
                let scene = scene(min, max, size, back);
                let world = World::build(&scene).unwrap();
                let bounds = bounds(&world).unwrap();
                let camera = camera(&scene, &bounds);
                let forward =
                    (camera.look_at - camera.eye) / (camera.look_at - camera.eye).length();
                let right = forward.cross(camera.up);
                let right = right / right.length();
                let (up, plane) = (right.cross(forward), scene.image.plane());
                let distance = 2.0 * plane.width.max(plane.height);
                for corner in 0..8 {
                    let pick = |i: usize| if corner >> i & 1 == 0 { min } else { max };
                    let corner = Point::new(pick(0).x(), pick(1).y(), pick(2).z());
                    let to = corner - camera.eye;
                    let on_plane = |axis: Vector| distance * to.dot(axis) / to.dot(forward);
                    assert!(2.0 * on_plane(right).abs() <= plane.width, "{bounds:?} {back:?}");
                    assert!(2.0 * on_plane(up).abs() <= plane.height, "{bounds:?} {back:?}");
                }
                let radius = 0.5 * (max - min).length();
                let seen = 2.0 * distance * radius / (camera.look_at - camera.eye).length();
                assert!(seen > 0.9 * plane.width.min(plane.height), "{seen}");
            }
        }
    }
}

/// Law: the box of a scene is around the boxes of all objects with an end, wherever the widest of them stands in the
/// list. Oracle: the least and largest coordinates of five boxes, in every order that begins elsewhere.
#[test]
fn the_box_of_a_scene_is_around_all_objects() {
    let mut boxes: Vec<([f64; 3], [f64; 3])> = vec![
        ([-9.0, 0.0, 0.0], [-8.0, 1.0, 1.0]),
        ([7.0, 0.0, 0.0], [8.0, 1.0, 1.0]),
        ([0.0, -6.0, 0.0], [1.0, 5.0, 1.0]),
        ([0.0, 0.0, -4.0], [1.0, 1.0, 0.0]),
        ([0.0, 0.0, 2.0], [1.0, 1.0, 3.0]),
    ];
    for turn in 0..5 {
        let mut scene = pinhole("x", [4, 3], [Point::new(0.0, 0.0, 50.0), Point::ORIGIN], 3.0);
        for (index, (min, max)) in boxes.iter().enumerate() {
            let shape = boxed(Point::from(*min), Point::from(*max));
            add(&mut scene, &format!("box {index}"), shape, matte(0.0, 0.5, grey(0.5)));
        }
        add(&mut scene, "floor", ground(-50.0), matte(0.0, 0.5, grey(0.5)));
        let world = World::build(&scene).expect("valid");
        let found = bounds(&world).expect("there are boxes");
        let found = (found.min.to_array(), found.max.to_array());
        let expected = ([-9.0, -6.0, -4.0], [8.0, 5.0, 3.0]);
        assert_eq!(found, expected, "the box around five, turned by {turn}");
        boxes.rotate_left(1);
    }
}

/// Law: a mesh without normals is smooth unless its edges are seen, and the scene says which. Oracle: a cube of 8 vertices,
/// whose 12 edges are seen and 6 diagonals are not; the sides of a prism of 32, of which none is.
#[test]
fn a_mesh_without_normals_is_flat_where_its_edges_are_seen() {
    let cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
                f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    let corner = |i: u32, y: u32| {
        let degrees = 11.25 * f64::from(i);
        format!("v {} {y} {}\n", cos_degrees(degrees), sin_degrees(degrees))
    };
    let vertices: String = (0..32).flat_map(|i| [corner(i, 0), corner(i, 1)]).collect();
    let side = |i: u32| {
        let [a, b] = [i, (i + 1) % 32].map(|i| 2 * i + 1);
        format!("f {a} {} {} {b}\n", a + 1, b + 1)
    };
    let prism = vertices + &(0..32).map(side).collect::<String>();
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("edges.obj");
    for (mesh, smooth, said) in [
        (
            cube,
            false,
            "it has no normals, so it is flat: 12 of its 18 inner edges turn by more than 45 degrees",
        ),
        (
            &prism,
            true,
            "it has no normals, so it is smooth: 0 of its 64 inner edges turn by more than 45 degrees",
        ),
    ] {
        std::fs::write(&file, mesh).expect("written");
        let (scene, _) = scene_of_mesh(&file).expect("it is a mesh");
        assert!(scene.about.ends_with(said), "{}", scene.about);
        let text = scenefile::to_toml(&scene).expect("plain");
        assert_eq!(text.contains("smooth = true"), smooth, "{text}");
    }
}
