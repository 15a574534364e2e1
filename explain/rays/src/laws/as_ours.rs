use groundtruth::render::Renderer;
use rayon::prelude::*;

use super::LawReport;
use crate::log::Purpose;
use crate::replay::{Part, Parting, parting};
use crate::traced::Traced;

/// The most camera rays that are traced.
const MOST: usize = 500;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let Some(world) = traced.scene_world() else { return };
    let partings = partings(traced, world);
    asked.rays = partings.len();
    let parted = partings.into_iter().filter_map(|it| it.1);
    for Parting { ray, words, .. } in parted.filter(|it| it.what != Part::End) {
        asked.find::<0>(ray, words, []);
    }
}

/// Camera rays of the log, all or evenly chosen ones, each with where it parts from a program's.
pub fn partings(traced: &Traced, program: &impl Renderer) -> Vec<(usize, Option<Parting>)> {
    let roots: Vec<usize> = camera_rays(traced).collect();
    let step = roots.len().div_ceil(MOST).max(1);
    let roots: Vec<usize> = roots.into_iter().step_by(step).collect();
    roots.into_par_iter().map(|root| (root, parting(traced, root, program))).collect()
}

/// The rays of the camera: those that nobody sent and that say nothing else.
pub fn camera_rays(traced: &Traced) -> impl Iterator<Item = usize> {
    let is_camera = |&index: &usize| {
        traced.parents[index].is_none()
            && traced.ray(index).kind.as_ref().is_none_or(|kind| *kind == Purpose::Camera)
    };
    (0..traced.log.rays.len()).filter(is_camera)
}
