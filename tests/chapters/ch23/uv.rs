//! Texture coordinates of meshes, where the file has them.

use formats::meshes::write_ply;

use crate::prelude::*;

/// A bumpy sheet over `[0, 4]²` in x and z, whose u and v are affine in them.
fn sheet(with_uvs: bool, draw: &mut Draw) -> MeshData {
    let mut data = MeshData::default();
    let mut uvs = Vec::new();
    for i in 0..25_u32 {
        let (x, z) = (f64::from(i % 5), f64::from(i / 5));
        data.vertices.push([x, draw.between(-0.2, 0.2), z]);
        uvs.push(uv_at(x, z));
    }
    for i in (0..20).filter(|i| i % 5 != 4) {
        data.triangles.extend([[i, i + 5, i + 1], [i + 1, i + 5, i + 6]]);
    }
    data.uvs = with_uvs.then_some(uvs);
    data
}

fn uv_at(x: f64, z: f64) -> [f64; 2] {
    [0.25 * x + 0.125 * z, 1.0 - 0.5 * z + 0.0625 * x]
}

/// Law: if u and v of the vertices are affine functions of their position, u and v of a hit are the same
/// functions; also through instances, compounds and lattices. Other meshes and other shapes have no u and
/// v. Oracle: the affine functions of the hit's point, moved back by hand.
/// Book: meshes with texture coordinates.
#[test]
fn texture_coordinates_are_interpolated_where_the_file_has_them() {
    /// Twenty roundings of coordinates up to 4 and of coefficients up to 1.
    const ROUNDING: f64 = 20.0 * 4.0 * U;
    let mut draw = Draw::new(2329);
    let folder = tempfile::tempdir().expect("a folder");
    let mesh = |with_uvs: bool, draw: &mut Draw| {
        let file = folder.path().join(format!("{with_uvs}.ply"));
        let bytes = write_ply(&sheet(with_uvs, draw), Encoding::LittleEndian);
        std::fs::write(&file, bytes).expect("written");
        Kind::from(Mesh { smooth: true, ..Mesh::of_file(file) })
    };
    let plain = mesh(true, &mut draw);
    let up = vec![Step::Translate(Vector::new(0.0, 2.0, 0.0))];
    let moved = Kind::from(Instance::new(plain.clone(), up));
    let row = Kind::from(Lattice {
        of: Box::new(plain.clone()),
        counts: [2, 1, 1],
        spacing: Vector::new(8.0, 0.0, 0.0),
        accel: None,
    });
    let ball = groundtruth::shapes::Sphere {
        center: Point::new(0.0, -20.0, 0.0),
        radius: 9.0,
        inward: false,
    };
    let among = Kind::from(Compound::of([Kind::from(ball.clone()), plain.clone()]));
    let without = mesh(false, &mut draw);
    for (name, kind, offset) in [
        ("mesh", plain, 0.0),
        ("instance", moved, 0.0),
        ("lattice", row, 8.0),
        ("compound", among, 0.0),
        ("without", without, 0.0),
    ] {
        let shape = kind.build(&mut Context::default()).expect("valid");
        for _ in 0..500 {
            let (x, z) = (draw.between(0.1, 3.9), draw.between(0.1, 3.9));
            let ray = Ray::new(Point::new(x + offset, 5.0, z), -Vector::Y);
            let at = shape.hit(&ray, Span::AHEAD).expect("above the sheet");
            let expected = (name != "without").then(|| uv_at(x, z));
            let found = shape.facet(&at, Vector::ZERO).and_then(|facet| facet.uv());
            assert_eq!(found.is_some(), expected.is_some(), "{name}");
            for (a, b) in found.into_iter().flatten().zip(expected.into_iter().flatten()) {
                assert!((a - b).abs() <= ROUNDING, "{name}: {found:?}, not {expected:?}");
            }
        }
    }
    let ball = Kind::from(ball).build(&mut Context::default()).expect("valid");
    assert_eq!(ball.facet(&Candidate::at(1.0), Vector::ZERO), None);
}
