//! The camera.

use groundtruth::cameras::{Kind, Side};
use groundtruth::materials::Medium;
use groundtruth::math::{Frame, Point, Vector, cos_degrees, sin_degrees};

use super::Writer;
use super::text::{number, vector};
use crate::export::{How, kinds};

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
    ///
    /// With angles in place of lengths, for x and y again from −1/2 to 1/2:
    ///
    /// - fisheye: the angle from `direction` is r · angle / 2, with r the length of (2x |right|, 2y |up|); nothing is seen
    ///   where r > 1. Ours is r · fov / 2 where r ≤ 1; of a rectangular one, where that angle is at most 180°: so `angle` is
    ///   360 and the lengths are fov / 360.
    /// - spherical: `direction` turned about `right` by −y · V, then about `up` by x · H, by the right-hand rule. Because
    ///   u × v = w, while POV-Ray's right × up is its direction, −u and −v turn it as ours is.
    /// - cylinder 1: sin(x · angle) right + y |up| up + cos(x · angle) direction, of unit axes. Ours has
    ///   2y tan(vertical_fov / 2) in place of y |up|.
    pub(super) fn camera(&mut self) -> How {
        let view = self.view();
        let camera = &self.scene.camera;
        if camera.medium != Medium::default() {
            self.refuse("camera.medium", "POV-Ray's camera is in air");
        }
        let film = self.scene.image.plane();
        let flat = |zoom: f64| [film.width / zoom, film.height / zoom];
        // the lengths of the axes along −w, u and v
        let (word, direction, [right, up]) = match &camera.lens {
            Kind::Pinhole(it) => ("perspective".to_owned(), it.distance, flat(it.zoom)),
            Kind::Orthographic(it) => ("orthographic".to_owned(), 1.0, flat(it.zoom)),
            Kind::Fisheye(it) => {
                let (length, fov) = match it.rectangular {
                    true => (it.fov / 360.0, 360.0),
                    false => (1.0, it.fov),
                };
                (format!("fisheye angle {}", number(fov)), 1.0, [length, length])
            }
            Kind::SphericalPanorama(it) => {
                let [across, along] = [it.horizontal_fov, it.vertical_fov].map(number);
                // −u and −v: see above
                (format!("spherical angle {across}, {along}"), 1.0, [-1.0, -1.0])
            }
            Kind::CylindricalPanorama(it) => {
                let half = 0.5 * it.vertical_fov;
                let height = 2.0 * sin_degrees(half) / cos_degrees(half);
                let word = format!("cylinder 1 angle {}", number(it.horizontal_fov));
                (word, 1.0, [1.0, height])
            }
            lens => {
                return self.no_counterpart(format!("camera.lens.{}", kinds::tag(lens)), "");
            }
        };
        if let Some(view) = view {
            let Frame { u, v, w } = *view.frame();
            let axes = [-direction * w, right * u, up * v];
            self.line(&described(&word, view.eye(Side::Left).position(), axes));
        }
        How::Exact("")
    }
}

fn described(word: &str, eye: Point, axes: [Vector; 3]) -> String {
    let [direction, right, up] = axes.map(|axis| vector(axis.to_array()));
    let location = vector(eye.to_array());
    format!(
        "camera {{\n  {word}\n  location {location}\n  direction {direction}\n  right {right}\n  up {up}\n}}"
    )
}
