//! Mirrors whose normals are not those of the true surface.

use testkit::properties::*;

use super::{BACKGROUND, mirror, path};
use crate::prelude::*;
use crate::support::stage::{at_angle, recorded};

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

proptest! {
    #![proptest_config(laws())]

    /// Law: a smooth mesh reflects about its interpolated normal, and about the flat normal where the
    /// interpolated one would send the ray into the mesh. No ray goes inside, and every hit has a
    /// reflected ray. Oracle: the mirror directions about both normals.
    /// Book: figs. 24.30 to 24.32, reflective meshes.
    #[test]
    fn a_smooth_mirror_sends_no_ray_inside(
        to_eye in unit(),
        phi in 0.0..TAU,
        far in 0.4..0.95_f64,
    ) {
        let mut scene = deep_stage(BACKGROUND, 1);
        let mesh = TessellatedSphere::new(5, 4, true);
        put(&mut scene, mesh, mirror(1.0, Rgb::WHITE));
        // away from the centre of the sphere, where the view grazes
        let target = Point::ORIGIN + far * at_angle(to_eye, 0.0, phi);
        let eye = Point::ORIGIN + 3.0 * to_eye;
        let tree = recorded(&built(&scene), eye, target - eye);
        let Some(hit) = &tree.root().hit else { return Ok(()) };
        let before = tree.root().ray.direction;
        match path(&tree)[..] {
            [_, after, ..] => {
                above!(after.dot(hit.normal), 0.0);
                let n = Vector::from(hit.shading_normal);
                let into = (before - 2.0 * before.dot(n) * n).dot(hit.normal);
                // at the limit rounding decides
                if into.abs() > 16.0 * U {
                    let about = if into > 0.0 { hit.shading_normal } else { hit.normal };
                    let off = (after.cross(about) - before.cross(about)).length();
                    prop_assert!(off <= 16.0 * U, "{off} off the mirror direction, {into} inside");
                }
            }
            _ => prop_assert!(false, "no ray is reflected"),
        }
    }
}
