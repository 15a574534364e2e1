//! Mistakes of cameras (Suffern, ch. 3, 9–12).

use std::path::Path;
use std::sync::Arc;

use groundtruth::cameras::{Camera, Kind, Viewing};
use groundtruth::kinds::Custom;
use groundtruth::math::{Point, Vector};
use groundtruth::scene::Scene;

use super::changed;
use crate::mistakes::{Mistake, known};

pub(super) const ALL: &[Mistake] = &[
    Mistake::scene(&known::PIXEL_CORNER, pixel_corner),
    Mistake::scene(&known::SUB_CELL_CORNER, sub_cell_corner),
    Mistake::scene(&known::NO_ASPECT, no_aspect),
    Mistake::scene(&known::ROLL_REVERSED, |scene, _| {
        changed(scene, |scene| {
            scene.camera.roll = -scene.camera.roll;
            scene.camera.roll != 0.0
        })
    }),
    Mistake::scene(&known::NO_EXPOSURE_TIME, |scene, _| {
        changed(scene, |scene| std::mem::replace(&mut scene.camera.exposure_time, 1.0) != 1.0)
    }),
    Mistake::scene(&known::NOT_FOCUSED, |scene, _| {
        changed(scene, |scene| match &mut scene.camera.lens {
            Kind::ThinLens(lens) => {
                std::mem::replace(&mut lens.focal_distance, lens.distance) != lens.distance
            }
            _ => false,
        })
    }),
    Mistake::scene(&known::LENS_RADIUS_DOUBLED, |scene, _| {
        changed(scene, |scene| match &mut scene.camera.lens {
            Kind::ThinLens(lens) => {
                lens.lens_radius *= 2.0;
                lens.lens_radius > 0.0
            }
            _ => false,
        })
    }),
    Mistake::scene(&known::HALF_FIELD_OF_VIEW, |scene, _| with_field_of_view(scene, 0.5)),
    Mistake::scene(&known::WHOLE_FIELD_OF_VIEW, |scene, _| with_field_of_view(scene, 2.0)),
    Mistake::scene(&known::FISHEYE_WITHOUT_CIRCLE, |scene, _| {
        changed(scene, |scene| match &mut scene.camera.lens {
            Kind::Fisheye(lens) => !std::mem::replace(&mut lens.rectangular, true),
            _ => false,
        })
    }),
    Mistake::scene(&known::EYES_EXCHANGED, |scene, _| {
        changed(scene, |scene| {
            let Some(stereo) = &mut scene.camera.stereo else { return false };
            stereo.viewing = match stereo.viewing {
                Viewing::Parallel => Viewing::Transverse,
                Viewing::Transverse => Viewing::Parallel,
            };
            true
        })
    }),
];

/// A camera whose film points are first scaled and then moved.
#[derive(Debug)]
struct OtherFilm {
    camera: Arc<dyn Camera>,
    scale: [f64; 2],
    shift: [f64; 2],
}

impl Camera for OtherFilm {
    fn ray(&self, film: [f64; 2], lens: [f64; 2]) -> Option<(Point, Vector)> {
        let at = |i: usize| self.scale[i] * film[i] + self.shift[i];
        self.camera.ray([at(0), at(1)], lens)
    }

    fn has_lens(&self) -> bool {
        self.camera.has_lens()
    }

    fn project(&self, point: Point) -> Option<[f64; 2]> {
        let film = self.camera.project(point)?;
        let back = |i: usize| (film[i] - self.shift[i]) / self.scale[i];
        Some([back(0), back(1)])
    }

    fn window_shift(&self, eye_shift: f64) -> f64 {
        self.camera.window_shift(eye_shift)
    }
}

/// The scene seen by its camera with another film.
fn with_film(scene: &Scene, scale: [f64; 2], shift: [f64; 2]) -> Option<Scene> {
    let camera = scene.camera.lens.build(&mut scene.image.plane()).ok()?;
    changed(scene, |scene| {
        scene.camera.lens = Kind::Custom(Custom(Arc::new(OtherFilm { camera, scale, shift })));
        true
    })
}

fn pixel_corner(scene: &Scene, _: &Path) -> Option<Scene> {
    with_film(scene, [1.0; 2], [-0.5 * scene.image.pixel_size; 2])
}

/// Of a single sample the cell is the pixel, which is another mistake.
fn sub_cell_corner(scene: &Scene, _: &Path) -> Option<Scene> {
    let cells = f64::from(scene.image.samples).sqrt().ceil();
    let shift = -0.5 * scene.image.pixel_size / cells;
    (cells > 1.0).then(|| with_film(scene, [1.0; 2], [shift; 2]))?
}

fn no_aspect(scene: &Scene, _: &Path) -> Option<Scene> {
    let [width, height] = [scene.image.width, scene.image.height].map(f64::from);
    if width == height {
        return None;
    }
    with_film(scene, [1.0, width / height], [0.0; 2])
}

fn with_field_of_view(scene: &Scene, factor: f64) -> Option<Scene> {
    changed(scene, |scene| {
        match &mut scene.camera.lens {
            Kind::Fisheye(lens) => lens.fov *= factor,
            Kind::SphericalPanorama(lens) => {
                lens.horizontal_fov *= factor;
                lens.vertical_fov *= factor;
            }
            Kind::CylindricalPanorama(lens) => {
                lens.horizontal_fov *= factor;
                lens.vertical_fov *= factor;
            }
            _ => return false,
        }
        true
    })
}
