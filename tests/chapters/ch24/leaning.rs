//! Mirrors whose normals are not those of the true surface.

use testkit::properties::*;

use super::{BACKGROUND, mirror, path};
use crate::prelude::*;
use crate::support::stage::{at_angle, recorded};

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
