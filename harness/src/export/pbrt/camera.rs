//! Camera, film and samples.

use groundtruth::cameras::{Kind, Side, View};
use groundtruth::filters;
use groundtruth::materials::Medium;
use groundtruth::math::{Frame, Point, Vector};

use super::text::{list, parameter};
use super::{Writer, kinds};
use crate::export::{How, kinds::tag};

/// The samples of a pixel, squared, are at least this many: each has four wavelengths, spread evenly over the visible ones.
const LEAST_SIDE: u32 = 8;

impl Writer<'_> {
    /// What stands before `WorldBegin`.
    pub(super) fn camera(&mut self) {
        let camera = &self.scene.camera;
        if camera.stereo.is_some() {
            self.refuse("camera.stereo", "two images; export the scene without it");
        }
        if camera.medium != Medium::default() {
            self.refuse("camera.medium", "pbrt's camera is in air");
        }
        if !matches!(self.scene.image.filter, filters::Kind::Box(_)) {
            self.refuse(
                "image.filter",
                "pbrt draws samples by the weight of its filters; only the box can be said",
            );
        }
        let (How::Exact, _) = kinds::camera(&camera.lens) else {
            let lens = tag(&camera.lens);
            return self.refuse(format!("camera.lens.{lens}"), "no counterpart");
        };
        match camera.build(self.scene.image.plane()) {
            Ok(view) => self.view(&view),
            Err(problem) => self.refuse("camera", problem.to_string()),
        }
        self.film();
    }

    /// The camera, by the map from the world to its own coordinates and by the part of the plane z = 1 that it sees.
    ///
    /// pbrt's ray through the part `(x, y)` of the picture, x to the right and y up, from 0 to 1, is in camera coordinates
    /// (x to the right, y up, z ahead: left-handed)
    ///
    /// - perspective of 90°: from the origin along `(X, Y, 1)`, `X = x0 + x (x1 − x0)`, `Y = y0 + y (y1 − y0)`, where
    ///   `screenwindow` is `[x0 x1 y0 y1]`;
    /// - orthographic: from `(X, Y, 0)` along `(0, 0, 1)`.
    ///
    /// Ours through the film point `(X, Y)`, from −width/2 to width/2, has the direction `X/zoom u + Y/zoom v − d w`, or
    /// the origin `X/zoom u + Y/zoom v` from the eye. With the axes u, v and −w the windows are
    /// `width / (2 zoom d)` and `width / (2 zoom)`.
    fn view(&mut self, view: &View) {
        let film = self.scene.image.plane();
        let (word, zoom, distance, lens) = match &self.scene.camera.lens {
            Kind::Pinhole(it) => ("perspective", it.zoom, it.distance, None),
            Kind::ThinLens(it) => {
                ("perspective", it.zoom, it.distance, Some([it.lens_radius, it.focal_distance]))
            }
            Kind::Orthographic(it) => ("orthographic", it.zoom, 1.0, None),
            _ => return,
        };
        let [x, y] = [film.width, film.height].map(|length| length / (2.0 * zoom * distance));
        self.line(&world_to_camera(view.frame(), view.eye(Side::Left).position()));
        let mut camera =
            format!("Camera \"{word}\" {}", parameter("float screenwindow", [-x, x, -y, y]));
        if word == "perspective" {
            camera += &format!(" {}", parameter("float fov", [90.0]));
        }
        if let Some([radius, focus]) = lens {
            camera += &format!(" {}", parameter("float lensradius", [radius]));
            camera += &format!(" {}", parameter("float focaldistance", [focus]));
        }
        self.line(&camera);
    }

    /// The film and its samples.
    ///
    /// The sensor `cie1931` of pbrt multiplies by iso · exposure time / 100, with an exposure time of 1. It gives the light
    /// of `"rgb L" [ r g b ]` the colour `(r, g, b)`: pbrt divides the standard illuminant, which it multiplies by the
    /// colour, by its own luminance.
    ///
    /// One sample is through the pixel's centre. Even numbers for the wavelengths, which need more than one, are no random
    /// numbers: without jitter they are the midpoints of equal parts.
    fn film(&mut self) {
        let image = &self.scene.image;
        let (width, height) = (f64::from(image.width), f64::from(image.height));
        let size =
            [parameter("integer xresolution", [width]), parameter("integer yresolution", [height])];
        let iso = parameter("float iso", [100.0 * self.scene.camera.exposure_time]);
        let film = format!("Film \"rgb\" {} {iso} \"bool savefp16\" [ false ]", size.join(" "));
        self.line(&film);
        self.line("PixelFilter \"box\" \"float xradius\" [ 0.5 ] \"float yradius\" [ 0.5 ]");
        let side = f64::from(image.samples).sqrt().ceil().max(LEAST_SIDE.into());
        let strata = [parameter("integer xsamples", [side]), parameter("integer ysamples", [side])];
        let jitter = if self.is_centred() { "false" } else { "true" };
        self.line(&format!(
            "Sampler \"stratified\" {} \"bool jitter\" [ {jitter} ]",
            strata.join(" ")
        ));
    }

    /// Whether every ray of the camera is through the centre of its pixel.
    pub(super) fn is_centred(&self) -> bool {
        let image = &self.scene.image;
        image.samples == 1 && image.sampler.is_none()
    }
}

/// The map from the world to the camera, whose rows are its axes.
fn world_to_camera(frame: &Frame, eye: Point) -> String {
    let axes = [frame.u, frame.v, -frame.w];
    let column = |axis: Vector| axes.map(|row| row.dot(axis)).into_iter().chain([0.0]);
    let shift = axes.map(|row| -row.dot(eye.to_vector())).into_iter().chain([1.0]);
    let columns = [Vector::X, Vector::Y, Vector::Z].into_iter().flat_map(column).chain(shift);
    format!("Transform {}", list(columns))
}
