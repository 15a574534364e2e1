//! The path to the selected ray, projected into the picture.

use eframe::egui::{Color32, Pos2, Stroke, Ui, vec2};
use explain::RecordedRay;
use groundtruth::render;
use groundtruth::world::World;

use crate::explanation::tree::kind_color;
use crate::picture::display::{halo, ink};
use crate::picture::view::Placement;

/// A hit along the path: its position in the picture, in pixels from the top left corner, if it is in
/// view, and the colour of its ray.
pub type TrailPoint = (Option<[f64; 2]>, Color32);

/// The hits of the rays from the camera's to the ray of this number, in the image of the pixel's eye.
pub fn points(
    world: &World,
    pixel: [u32; 2],
    root: &RecordedRay,
    number: usize,
) -> Vec<TrailPoint> {
    let Some((eye, column)) = world.view.eye_of_column(pixel[0], world.image.width) else {
        return Vec::new();
    };
    let first_column = f64::from(pixel[0] - column);
    let trail_point = |ray: &&RecordedRay| {
        let point = ray.hit.as_ref()?.point;
        let position = eye.project(point).map(|film| {
            let [x, y] = render::image_point(&world.image, film);
            [first_column + x, y]
        });
        Some((position, kind_color(ray)))
    };
    root.path_to(number).iter().filter_map(trail_point).collect()
}

/// Draws lines between the hits, without those out of view.
pub fn paint(ui: &Ui, placement: &Placement, points: &[TrailPoint]) {
    let (painter, halo) = (ui.painter(), halo(ui.visuals()));
    let on_screen =
        |[x, y]: [f64; 2]| placement.corner + placement.scale * vec2(x as f32, y as f32);
    let visible: Vec<(Pos2, Color32)> = points
        .iter()
        .filter_map(|&(at, color)| at.map(|at| (on_screen(at), ink(ui.visuals(), color))))
        .collect();
    for pair in visible.windows(2) {
        for (width, color) in [(3.5, halo), (1.5, pair[1].1)] {
            painter.line_segment([pair[0].0, pair[1].0], Stroke::new(width, color));
        }
    }
    for (at, color) in visible {
        painter.circle(at, 3.5, color, Stroke::new(1.5, halo));
    }
}
