//! The outline of a smooth mesh, where the interpolated normal faces away from a viewer who sees the surface.

use super::tracers;
use crate::prelude::*;
use crate::support::replicas::assert_agree;

/// Law: the path tracers have one mean there, of a highlight too. Oracle: each other; Welch's t over 24
/// replicas.
#[test]
fn path_tracers_agree_on_a_highlight_whose_normal_faces_away() {
    let to_viewer = Vector::new(0.7, 1.1, 0.1);
    let [path_trace, global_trace, path] = tracers(3).map(|tracer| {
        let mut scene = Scene { tracer, ..crate::laws::scene("ch26/outline.toml") };
        let phong = Phong { ks: 0.4.into(), exponent: 2.0.into(), ..Phong::default() };
        scene.materials[0].recipe = phong.into();
        replicas(&scene, |world| view(world, Point::ORIGIN + to_viewer, -to_viewer).g)
    });
    for (name, other) in [("path_trace", path_trace), ("global_trace", global_trace)] {
        assert_agree(&format!("{name} and path"), &other, &path, 2);
        assert!(path.iter().all(|value| *value > 0.0), "black: {path:?}");
    }
}
