//! Vertex normals of meshes: which side is outside, and which normals shading uses where a file has none.

use crate::prelude::*;

type Triangles = Vec<[u32; 3]>;

fn mesh(vertices: &[Point], triangles: &Triangles, normals: &[Vector]) -> Mesh {
    let normals = (!normals.is_empty()).then(|| normals.to_vec());
    Mesh { normals, smooth: true, ..Mesh::of_lists(vertices.to_vec(), triangles.clone()) }
}

fn saved(folder: &Path, name: &str, bytes: &[u8]) -> Mesh {
    let file = folder.join(name);
    std::fs::write(&file, bytes).expect("writable");
    Mesh { smooth: true, ..Mesh::of_file(file) }
}

fn turned(triangles: &Triangles) -> Triangles {
    triangles.iter().map(|&[a, b, c]| [a, c, b]).collect()
}

/// A solid of revolution about the y axis, wound outward. `profile` lists its radii and heights, from
/// the highest point, which is on the axis, down to the rim of a flat base.
fn revolved(around: u32, profile: &[[f64; 2]]) -> (Vec<Point>, Triangles) {
    let mut vertices = vec![Point::new(0.0, profile[0][1], 0.0)];
    for &[radius, y] in &profile[1..] {
        vertices.extend((0..around).map(|i| {
            let degrees = 360.0 * f64::from(i) / f64::from(around);
            Point::new(radius * sin_degrees(degrees), y, radius * cos_degrees(degrees))
        }));
    }
    let rings = profile.len() as u32 - 1;
    let at = |ring: u32, i: u32| 1 + ring * around + i % around;
    let mut triangles = Triangles::new();
    for i in 0..around {
        triangles.push([0, at(0, i), at(0, i + 1)]);
        for ring in 1..rings {
            let [a, b] = [at(ring - 1, i), at(ring - 1, i + 1)];
            let [c, d] = [at(ring, i), at(ring, i + 1)];
            triangles.extend([[a, c, b], [b, c, d]]);
        }
    }
    let base = |i| at(rings - 1, i);
    triangles.extend((1..around - 1).map(|i| [base(0), base(i + 1), base(i)]));
    (vertices, triangles)
}

/// Convex solids around the origin, most of them with an edge so sharp that a normal there is on the
/// other side of one of the faces.
fn solids() -> Vec<(Vec<Point>, Triangles)> {
    let mut solids = Vec::new();
    for height in [0.2, 0.5, 1.0, 3.0] {
        let (top, base) = (0.6 * height, -0.4 * height);
        for around in [3, 4, 16] {
            solids.push(revolved(around, &[[0.0, top], [1.0, base]])); // a cone
        }
        let lens = [[0.0, top], [0.6, 0.4 * height], [0.9, -0.1 * height], [1.0, base]];
        solids.push(revolved(32, &lens));
    }
    solids
}

/// The area of a triangle, along its normal.
fn area(vertices: &[Point], triangle: &[u32; 3]) -> Vector {
    let [a, b, c] = triangle.map(|vertex| vertices[vertex as usize]);
    0.5 * (b - a).cross(c - a)
}

/// Vertex normals as programs write them: means of the face normals, all with the same weight or
/// weighted by area.
fn means(vertices: &[Point], triangles: &Triangles, by_area: bool) -> Vec<Vector> {
    let mut sums = vec![Vector::ZERO; vertices.len()];
    for triangle in triangles {
        let area = area(vertices, triangle);
        let share = if by_area { area } else { area.unit().expect("an area") };
        triangle.iter().for_each(|&vertex| sums[vertex as usize] += share);
    }
    sums
}

/// Point, normal and shading normal where rays towards the origin, which is inside, first hit a mesh.
fn looks(mesh: &Mesh) -> Vec<[Vector; 3]> {
    let shape = shape_of(mesh.clone());
    let mut draw = Draw::new(2331);
    let look = |_| {
        let away = Vector::from(draw.direction());
        let ray = Ray::new(Point::ORIGIN + 5.0 * away, -away);
        let surface = shape.surface(&ray, &shape.hit(&ray, Span::AHEAD).expect("aimed inside"));
        [surface.point.to_vector(), surface.normal.into(), surface.shading.into()]
    };
    (0..200).map(look).collect()
}

/// Law: the vertex normals of a mesh decide which side of a solid is outside, however its triangles are
/// wound, flat and smooth, also where edges are so sharp that some normals are on the other side of a
/// face. `reverse_normals` turns all of them around. Oracle: the origin, which is inside.
#[test]
fn vertex_normals_of_a_file_say_what_is_outside() {
    let mut sharp = 0;
    for (vertices, triangles) in solids() {
        for (by_area, out) in [(false, 1.0), (true, 1.0), (false, -1.0), (true, -1.0)] {
            let normals = means(&vertices, &triangles, by_area);
            sharp += usize::from(triangles.iter().any(|triangle| {
                let sum = triangle.iter().fold(Vector::ZERO, |sum, &v| sum + normals[v as usize]);
                area(&vertices, triangle).dot(sum) < 0.0
            }));
            let normals: Vec<_> = normals.into_iter().map(|normal| out * normal).collect();
            for triangles in [triangles.clone(), turned(&triangles)] {
                let mesh = mesh(&vertices, &triangles, &normals);
                for (smooth, reverse_normals) in [(false, false), (true, false), (true, true)] {
                    let side = if reverse_normals { -out } else { out };
                    for [point, normal, shading] in
                        looks(&Mesh { smooth, reverse_normals, ..mesh.clone() })
                    {
                        assert!(side * normal.dot(point) > 0.0, "{normal:?} at {point:?}");
                        assert!(normal.dot(shading) > 0.0, "{shading:?} beside {normal:?}");
                    }
                }
            }
        }
    }
    assert!(sharp > 10, "{sharp}");
}

/// Law: where a file's triangles are wound both ways, the larger area decides which side is outside, not
/// the larger number of triangles. Oracle: a large triangle and 40 small ones, wound against each other;
/// all vertex normals point up.
#[test]
fn most_of_the_area_says_what_is_outside() {
    for large_is_wound_up in [true, false] {
        let mut vertices: Vec<Point> =
            [[-1.0, -1.0], [3.0, -1.0], [-1.0, 3.0]].map(|[x, y]| Point::new(x, y, 0.0)).into();
        let mut triangles = vec![[0, 1, 2]];
        for i in 0..40 {
            let (x, first) = (5.0 + f64::from(i), vertices.len() as u32);
            let corners = [[x, 0.0], [x, 0.1], [x + 0.1, 0.0]];
            vertices.extend(corners.map(|[x, y]| Point::new(x, y, 0.0)));
            triangles.push([first, first + 1, first + 2]);
        }
        if !large_is_wound_up {
            triangles = turned(&triangles);
        }
        let normals = vec![Vector::Z; vertices.len()];
        let mesh = mesh(&vertices, &triangles, &normals);
        let shape = shape_of(mesh);
        let normal_at = |x: f64, y: f64| {
            let ray = Ray::new(Point::new(x, y, 2.0), -Vector::Z);
            let hit = shape.hit(&ray, Span::AHEAD).expect("aimed at a triangle");
            Vector::from(shape.surface(&ray, &hit).normal)
        };
        let found = [normal_at(0.0, 0.0), normal_at(5.02, 0.02)];
        let expected = [Vector::Z, -Vector::Z];
        assert_eq!(found, expected, "normals of large and small; wound up: {large_is_wound_up}");
    }
}

/// Law: a vertex whose normal in the file is the zero vector has the mean of the normals of its faces.
/// Oracle: the file without normals, bit for bit; and a file in which one vertex has a normal that is
/// not the mean.
#[test]
fn a_normal_of_zero_in_a_file_is_the_mean() {
    let (vertices, triangles) = &solids()[3];
    let seen = |normals: &[Vector]| looks(&mesh(vertices, triangles, normals));
    assert_eq!(seen(&vec![Vector::ZERO; vertices.len()]), seen(&[]));
    let mut one = vec![Vector::ZERO; vertices.len()];
    one[0] = Vector::new(0.6, 0.8, 0.0);
    let means = seen(&[]);
    for ([point, _, shading], [_, normal, mean]) in seen(&one).into_iter().zip(means) {
        let is_near = point.y() > 0.4 * 0.2 && normal.y() > 0.0; // of the first ring or above
        assert_eq!(shading != mean, is_near, "{shading:?} at {point:?}");
    }
}

/// The corners of a cube, as lines of an OBJ file.
fn corners_of_a_cube() -> String {
    let corner = |i: usize| {
        let [x, y, z] = [1, 2, 4].map(|bit| if i & bit == 0 { -1 } else { 1 });
        format!("v {x} {y} {z}\n")
    };
    (0..8).map(corner).collect()
}

/// Law: the faces of an OBJ file are smooth at a position that they share, also if their texture
/// coordinates differ there, or if only some corners of the file have a normal. Oracle: the file without
/// both, bit for bit.
#[test]
fn texture_coordinates_and_some_normals_make_no_crease() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut points = corners_of_a_cube();
    points += "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 1 0\n";
    let faces =
        [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]];
    let cube = |corner: &dyn Fn(usize, usize, u32) -> String| {
        let face = |(i, face): (usize, &[u32; 4])| {
            let corners = (0..4).map(|j| format!(" {}", corner(i, j, face[j])));
            format!("f{}\n", corners.collect::<String>())
        };
        let text = points.clone() + &faces.iter().enumerate().map(face).collect::<String>();
        looks(&saved(folder.path(), "cube.obj", text.as_bytes()))
    };
    let plain = cube(&|_, _, v| format!("{v}"));
    assert_eq!(cube(&|_, j, v| format!("{v}/{}", j + 1)), plain);
    // the fourth face is the top
    let flat_top = cube(&|i, _, v| if i == 3 { format!("{v}//1") } else { format!("{v}") });
    let mut tops = 0;
    for (with, without) in flat_top.into_iter().zip(plain) {
        let is_top = with[1] == Vector::Y;
        assert_eq!(with[2], if is_top { Vector::Y } else { without[2] });
        tops += u32::from(is_top);
    }
    assert!((10..190).contains(&tops), "{tops}");
}

/// Law: a face of the file counts once in the means of its vertices, however many triangles it is split
/// into. Oracle: a cube's corners by hand.
#[test]
fn a_polygon_counts_once_in_means() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut cube = corners_of_a_cube();
    cube += "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    let mesh = saved(folder.path(), "cube.obj", cube.as_bytes());
    for [point, _, shading] in looks(&mesh) {
        // corners have (±1, ±1, ±1)/√3; between them coordinates are means of these
        let near = point.to_array().iter().all(|x| x.abs() > 0.9);
        let along = shading.dot(point) / point.length();
        assert!(!near || along > 0.99, "{shading:?} at {point:?}");
    }
}
