//! Mistakes of the film (Suffern, ch. 3, 4).

use std::path::Path;
use std::sync::Arc;

use groundtruth::cameras::{Camera, Kind};
use groundtruth::kinds::Custom;
use groundtruth::math::{Point, Vector};
use groundtruth::scene::Scene;

use crate::mistakes::Mistake;

pub(super) const ALL: &[Mistake] = &[
    Mistake::scene("pixel-corner", |scene, _| {
        with_film(scene, [1.0; 2], [-0.5 * scene.image.pixel_size; 2])
    }),
    Mistake::scene("sub-cell-corner", sub_cell_corner),
    Mistake::scene("no-aspect", no_aspect),
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

    fn project(&self, point: Point) -> Option<[f64; 2]> {
        let film = self.camera.project(point)?;
        let back = |i: usize| (film[i] - self.shift[i]) / self.scale[i];
        Some([back(0), back(1)])
    }

    as_in! { camera,
        fn has_lens(&self) -> bool;
        fn window_shift(&self, eye_shift: f64) -> f64;
    }
}

fn with_film(scene: &Scene, scale: [f64; 2], shift: [f64; 2]) -> Option<Scene> {
    let camera = scene.camera.lens.build(&mut scene.image.plane()).ok()?;
    let mut scene = scene.clone();
    scene.camera.lens = Kind::Custom(Custom(Arc::new(OtherFilm { camera, scale, shift })));
    Some(scene)
}

/// Of a single sample the cell is the pixel, which is another mistake.
fn sub_cell_corner(scene: &Scene, _: &Path) -> Option<Scene> {
    let cells = f64::from(scene.image.samples).sqrt().ceil();
    let shift = -0.5 * scene.image.pixel_size / cells;
    (cells > 1.0).then(|| with_film(scene, [1.0; 2], [shift; 2]))?
}

fn no_aspect(scene: &Scene, _: &Path) -> Option<Scene> {
    let [width, height] = [scene.image.width, scene.image.height].map(f64::from);
    (width != height).then(|| with_film(scene, [1.0, width / height], [0.0; 2]))?
}
