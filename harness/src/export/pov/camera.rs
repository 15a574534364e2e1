//! The camera.

use groundtruth::cameras::{Kind, Side};
use groundtruth::materials::Medium;
use groundtruth::math::{Point, Vector};

use super::Writer;
use super::text::vector;
use crate::export::kinds::{self, How};

impl Writer<'_> {
    /// The camera, by its axes.
    ///
    /// For the part `(x, y)` of the picture, each from −1/2 to 1/2, x to the right and y up, POV-Ray's ray has
    ///
    /// - perspective: the origin `location`, the direction `direction + x right + y up`;
    /// - orthographic: the origin `location + x right + y up`, the direction `direction`.
    ///
    /// Our ray of the film point `(X, Y) = (x width, y height)` has the direction `(X / zoom) u + (Y / zoom) v − d w`, or
    /// the same offset of its origin and the direction −w. So `right` is `(width / zoom) u` and `up` is
    /// `(height / zoom) v`. POV-Ray's own axes, `right x` with `direction z`, are left-handed, which is why scenes of
    /// right-handed coordinates have `right -x` there; u, v and w are written in full, so no sign is left to be changed.
    pub(super) fn camera(&mut self) {
        let camera = &self.scene.camera;
        if camera.stereo.is_some() {
            self.refuse("camera.stereo", "two images; export the scene without it");
        }
        if camera.medium != Medium::default() {
            self.refuse("camera.medium", "POV-Ray's camera is in air");
        }
        let (How::Exact, _) = kinds::pov_camera(&camera.lens) else {
            let lens = kinds::tag(&camera.lens);
            return self.refuse(format!("camera.lens.{lens}"), "no counterpart");
        };
        let film = self.scene.image.plane();
        let view = match camera.build(film) {
            Ok(view) => view,
            Err(problem) => return self.refuse("camera", problem.to_string()),
        };
        let (frame, eye) = (view.frame(), view.eye(Side::Left).position());
        let (word, direction, zoom) = match &camera.lens {
            Kind::Pinhole(it) => ("perspective", -it.distance * frame.w, it.zoom),
            Kind::Orthographic(it) => ("orthographic", -frame.w, it.zoom),
            _ => return,
        };
        let (right, up) = ((film.width / zoom) * frame.u, (film.height / zoom) * frame.v);
        self.line(&described(word, eye, [direction, right, up]));
    }
}

fn described(word: &str, eye: Point, axes: [Vector; 3]) -> String {
    let [direction, right, up] = axes.map(|axis| vector(axis.to_array()));
    let location = vector(eye.to_array());
    format!(
        "camera {{\n  {word}\n  location {location}\n  direction {direction}\n  right {right}\n  up {up}\n}}"
    )
}
