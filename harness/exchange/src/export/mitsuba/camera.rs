//! The camera, the film and the sampler.

use groundtruth::cameras::{Kind, Side};
use groundtruth::math::{atan2, to_degrees};
use groundtruth::rgb::Rgb;

use super::Writer;
use super::paths::is_noiseless;
use super::text::{boolean, float, integer, matrix, plugin, rows, word};
use crate::export::{How, kinds};

/// Rays begin and end at these parts of the distance from the eye to the point looked at.
const CLIPPED: [f64; 2] = [1e-5, 1e7];

impl Writer<'_> {
    /// How the camera is exported, and the sensor.
    ///
    /// Mitsuba's camera looks along its +z, with y up and therefore x to the left. Ours looks along −w, with v up and u to
    /// the right. So its axes are −u, v, −w.
    ///
    /// - `perspective`: `fov` is the angle over the width: 2 atan(width / (2 · zoom · d)).
    /// - `thinlens`: the same, with `aperture_radius` R and `focus_distance` f, which is measured along the axis too.
    /// - `orthographic`: the width is from −1 to 1 along its x; so x and y are scaled by width / (2 · zoom).
    pub(super) fn sensor(&mut self) -> (How, String) {
        let view = self.view();
        let camera = &self.scene.camera;
        if !camera.medium.absorption.is_black() {
            self.refuse("camera.medium", "Mitsuba's camera is in a clear medium");
        }
        let film = self.scene.image.plane();
        let angle = |distance: f64, zoom: f64| {
            let fov = 2.0 * to_degrees(atan2(0.5 * film.width, zoom * distance));
            vec![float("fov", fov), word("fov_axis", "x")]
        };
        let (kind, scale, mut inner) = match &camera.lens {
            Kind::Pinhole(it) => ("perspective", 1.0, angle(it.distance, it.zoom)),
            Kind::ThinLens(it) if it.lens_radius == 0.0 => {
                ("perspective", 1.0, angle(it.distance, it.zoom))
            }
            Kind::ThinLens(it) => {
                let mut inner = angle(it.distance, it.zoom);
                inner.push(float("aperture_radius", it.lens_radius));
                inner.push(float("focus_distance", it.focal_distance));
                ("thinlens", 1.0, inner)
            }
            Kind::Orthographic(it) => ("orthographic", 0.5 * film.width / it.zoom, Vec::new()),
            lens => {
                let how = self.no_counterpart(format!("camera.lens.{}", kinds::tag(lens)), "");
                return (how, String::new());
            }
        };
        let Some(view) = view else { return (How::Exact(""), String::new()) };
        let (frame, eye) = (view.frame(), view.eye(Side::Left).position());
        let axes = [-scale * frame.u, scale * frame.v, -frame.w];
        let size = (camera.eye - camera.look_at).length();
        let [near, far] = CLIPPED.map(|part| part * size);
        inner.extend([float("near_clip", near), float("far_clip", far)]);
        inner.push(matrix("to_world", rows(axes, eye)));
        inner.extend([self.film(), self.sampler()]);
        (How::Exact(""), plugin("sensor", kind, &inner))
    }

    /// The mean of the samples of each pixel, as radiance in single precision.
    fn film(&self) -> String {
        let image = &self.scene.image;
        let inner = [
            integer("width", image.width),
            integer("height", image.height),
            word("pixel_format", "rgb"),
            word("component_format", "float32"),
            plugin("rfilter", "box", &[]),
        ];
        plugin("film", "hdrfilm", &inner)
    }

    /// One sample is at the centre of its pixel, if nothing else is random.
    fn sampler(&self) -> String {
        let samples = self.scene.image.samples;
        let count = integer("sample_count", samples);
        match samples {
            1 if is_noiseless(self.scene) => {
                plugin("sampler", "stratified", &[count, boolean("jitter", false)])
            }
            1 => plugin("sampler", "independent", &[count]),
            _ => plugin("sampler", "multijitter", &[count]),
        }
    }

    /// A colour of light at the scene's exposure.
    pub(super) fn exposed(&self, color: Rgb) -> Rgb {
        self.scene.camera.exposure_time * color
    }
}
