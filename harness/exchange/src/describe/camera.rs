//! The camera in numbers: its axes, its film, and the ray of a film point as a formula.

use serde_json::Value;

use groundtruth::cameras::{Kind, Side, View};
use groundtruth::scene::Scene;
use groundtruth::world::World;

use super::tables::table;
use super::values::{Values, row, shown};

/// The section of the camera.
pub fn write(to: &mut Values, scene: &Scene, world: &World, data: &Value) {
    to.page.heading("Camera");
    to.page.blank();
    to.fields(0, table("Camera"), &data["camera"]);
    axes(to, &world.view);
    film(to, scene);
    rays(to, scene, &world.view);
    if !scene.camera.medium.absorption.is_black() {
        to.page.say("The camera is in an absorbing medium: see Light along a ray.");
    }
}

fn axes(to: &mut Values, view: &View) {
    to.page.say(
        "These settings give the following axes in the world, each of length 1 and perpendicular to the \
         others: u to the right of the picture, v up, w backwards, so that the view direction is -w.",
    );
    to.page.blank();
    let frame = view.frame();
    for (name, axis) in [("u", frame.u), ("v", frame.v), ("w", frame.w)] {
        to.page.line(0, &format!("{name} = {}", row(axis.to_array())));
    }
}

/// Where a pixel lies on the film.
fn film(to: &mut Values, scene: &Scene) {
    let image = &scene.image;
    let (plane, size) = (image.plane(), shown(image.pixel_size));
    let [half_width, half_height] = [image.width, image.height].map(|n| shown(0.5 * f64::from(n)));
    to.page.say(&format!(
        "The film (the book's view plane) is {} wide and {} high. A film point (x, y) is measured from \
         its centre, in the unit of the scene: x along u, y along v. The pixel in column c and row r, \
         both counted from 0 at the top left, is the square of side {size} from \
         x = {size} (c - {half_width}) and y = {size} ({half_height} - r - 1) to \
         x = {size} (c - {half_width} + 1) and y = {size} ({half_height} - r). \
         (The book counts rows from below.)",
        shown(plane.width),
        shown(plane.height),
    ));
    if let Some(stereo) = &scene.camera.stereo {
        let [left, right] = stereo.first_columns(image.width);
        to.page.say(&format!(
            "This is a stereo pair: c counts the columns of one eye's image, of {} columns. In the whole \
             picture the image of the left eye begins at column {left}, that of the right eye at column \
             {right}; between them are {} black columns.",
            image.width, stereo.gap
        ));
    }
}

/// The ray of a film point.
fn rays(to: &mut Values, scene: &Scene, view: &View) {
    let lens = &scene.camera.lens;
    match scene.camera.stereo {
        None => {
            let position = view.eye(Side::Left).position().to_array();
            to.page.say(&format!("The rays start at e = {}.", row(position)));
        }
        Some(_) => eyes(to, scene, view),
    }
    to.page.say(&formula(lens, scene));
    if let Some(angle) = field_of_view(lens, scene) {
        to.page.say(&format!(
            "From the left to the right edge the field of view is about {angle:.4} degrees."
        ));
    }
}

/// The two eyes of a stereo pair: where they are, and how far their film points are shifted.
fn eyes(to: &mut Values, scene: &Scene, view: &View) {
    let [left, right] = [Side::Left, Side::Right].map(|side| view.eye(side).position());
    let half = 0.5 * left.distance(right);
    let shift = zoom(&scene.camera.lens).map_or(0.0, |zoom| zoom * half);
    to.page.say(&format!(
        "The rays of the left eye start at e = {}, those of the right eye at e = {}. In the formula below \
         add {} to the x of the left eye's film points, and subtract it from the x of the right eye's{}.",
        row(left.to_array()),
        row(right.to_array()),
        shown(shift),
        if shift == 0.0 { "" } else { ", so that both eyes look through the same window" }
    ));
}

/// The magnification of a camera that has a view plane.
fn zoom(lens: &Kind) -> Option<f64> {
    match lens {
        Kind::Orthographic(it) => Some(it.zoom),
        Kind::Pinhole(it) => Some(it.zoom),
        Kind::ThinLens(it) => Some(it.zoom),
        _ => None,
    }
}

fn field_of_view(lens: &Kind, scene: &Scene) -> Option<f64> {
    let distance = match lens {
        Kind::Pinhole(it) => it.distance,
        Kind::ThinLens(it) => it.distance,
        _ => return None,
    };
    let half = 0.5 * scene.image.plane().width / (zoom(lens)? * distance);
    Some(2.0 * groundtruth::math::to_degrees(groundtruth::math::atan2(half, 1.0)))
}

/// Origin and direction of the ray of a film point.
fn formula(lens: &Kind, scene: &Scene) -> String {
    let plane = scene.image.plane();
    let normalised = format!(
        "With xn = x / {} and yn = y / {}, which are from -1 to 1 across the film,",
        shown(0.5 * plane.width),
        shown(0.5 * plane.height)
    );
    match lens {
        Kind::Orthographic(it) => format!(
            "The ray of (x, y) has the origin e + (x / {0}) u + (y / {0}) v and the direction -w.",
            shown(it.zoom)
        ),
        Kind::Pinhole(it) => format!(
            "The ray of (x, y) has the origin e and the direction (x / {0}) u + (y / {0}) v - {1} w, \
             normalised.",
            shown(it.zoom),
            shown(it.distance)
        ),
        Kind::ThinLens(it) => format!(
            "The lens is the disk of radius {radius} about e in the directions u and v. The ray of \
             (x, y) from the point e + lx u + ly v of the lens goes to the point \
             e + g ((x / {zoom}) u + (y / {zoom}) v - {distance} w) with g = {focal} / {distance}, which is in \
             focus. A pixel is the mean over all points of the lens, uniform in area.",
            radius = shown(it.lens_radius),
            zoom = shown(it.zoom),
            distance = shown(it.distance),
            focal = shown(it.focal_distance)
        ),
        Kind::Fisheye(it) => format!(
            "{normalised} r = √(xn² + yn²), and ψ = {} r degrees, the ray of (x, y) has the origin e and \
             the direction sin ψ (xn/r) u + sin ψ (yn/r) v - cos ψ w. {} is black.",
            shown(0.5 * it.fov),
            if it.rectangular { "What is at ψ > 180" } else { "What is at r > 1" }
        ),
        Kind::SphericalPanorama(it) => format!(
            "{normalised} λ = {} xn degrees and ψ = {} yn degrees, the ray of (x, y) has the origin e and \
             the direction cos ψ sin λ u + sin ψ v - cos ψ cos λ w.",
            shown(0.5 * it.horizontal_fov),
            shown(0.5 * it.vertical_fov)
        ),
        Kind::CylindricalPanorama(it) => format!(
            "{normalised} λ = {} xn degrees and a = tan({} degrees), the ray of (x, y) has the origin e \
             and the direction sin λ u + yn a v - cos λ w.",
            shown(0.5 * it.horizontal_fov),
            shown(0.5 * it.vertical_fov)
        ),
        _ => "The ray of (x, y) follows from the settings above.".to_owned(),
    }
}
