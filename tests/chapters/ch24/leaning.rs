//! Mirrors whose normals are not those of the true surface.

use super::{BACKGROUND, mirror, path};
use crate::prelude::*;
use crate::support::stage::recorded;

/// Law: a mirror whose normals at its corners lean anywhere reflects about the interpolated normal where that faces the viewer and the
/// mirrored ray leaves the surface, and otherwise about the true one. Oracle: the mirror direction about that normal, at
/// 2,000 normals and viewers.
#[test]
fn a_mirror_whose_normals_lean_reflects_to_its_viewers_side() {
    let mut draw = Draw::new(2411);
    let mut about_flat = 0;
    for case in 0..2_000 {
        let mut scene = deep_stage(BACKGROUND, 1);
        let [normal, to_eye] = [draw.direction(), draw.direction()].map(Vector::from);
        let [normal, to_eye] = [normal, to_eye].map(|v| if v.y() < 0.0 { -v } else { v });
        let vertices = [(-9.0, -9.0), (0.0, 18.0), (9.0, -9.0)].map(|(x, z)| Point::new(x, 0.0, z));
        put(&mut scene, Triangle { vertices, normals: Some([normal; 3]) }, mirror(1.0, Rgb::WHITE));
        let tree = recorded(&built(&scene), Point::ORIGIN + to_eye, -to_eye);
        let Some(hit) = &tree.root().hit else { continue };
        let [_, after] = path(&tree)[..] else {
            panic!(
                "case {case}: rays: found {:?}, expected the camera's and a mirrored one",
                path(&tree)
            )
        };
        let mirrored = |n: Vector| 2.0 * to_eye.dot(n) * n - to_eye;
        let (flat, normal) = (Vector::from(hit.normal), Vector::from(hit.shading_normal));
        let side = to_eye.dot(flat).signum();
        let stays = side * to_eye.dot(normal) > 0.0 && side * mirrored(normal).dot(flat) > 0.0;
        let expected = mirrored(if stays { normal } else { flat });
        about_flat += usize::from(!stays);
        if mirrored(normal).dot(flat).abs() > 1e-9 && to_eye.dot(normal).abs() > 1e-9 {
            near!(after, expected, 64.0 * U, "case {case}: normal {normal:?}, viewer {to_eye:?}");
        }
    }
    above!(about_flat, 400);
}
