//! The camera in numbers: its axes, its film, and the ray of a film point as a formula.

use serde_json::Value;

use groundtruth::cameras::{Kind, Side, View};
use groundtruth::scene::Scene;
use groundtruth::world::World;

use super::tables::{table, tag};
use super::texts::{filled, find, text};
use super::values::{DescribedValues, row, shown};

/// The section of the camera.
pub fn write(to: &mut DescribedValues, scene: &Scene, world: &World, data: &Value) {
    to.page.heading("Camera");
    to.page.blank();
    to.fields(0, table("Camera"), &data["camera"]);
    axes(to, &world.view);
    film(to, scene);
    rays(to, scene, &world.view, data);
    if !scene.camera.medium.absorption.is_black() {
        to.page.tell("camera in a medium");
    }
}

fn axes(to: &mut DescribedValues, view: &View) {
    to.page.tell("axes");
    to.page.blank();
    let frame = view.frame();
    for (name, axis) in [("u", frame.u), ("v", frame.v), ("w", frame.w)] {
        to.page.line(0, &format!("{name} = {}", row(axis.to_array())));
    }
}

/// Where a pixel lies on the film.
fn film(to: &mut DescribedValues, scene: &Scene) {
    let image = &scene.image;
    let plane = image.plane();
    let [half_width, half_height] = [image.width, image.height].map(|n| shown(0.5 * f64::from(n)));
    let values = [
        ("film width", shown(plane.width)),
        ("film height", shown(plane.height)),
        ("size", shown(image.pixel_size)),
        ("half width", half_width),
        ("half height", half_height),
    ];
    to.page.fill("film", &values);
    if let Some(stereo) = &scene.camera.stereo {
        let [left, right] = stereo.first_columns(image.width);
        let values =
            [("columns", image.width), ("left", left), ("right", right), ("gap", stereo.gap)];
        to.page.fill("stereo columns", &values.map(|(name, value)| (name, value.to_string())));
    }
}

/// The ray of a film point.
fn rays(to: &mut DescribedValues, scene: &Scene, view: &View, data: &Value) {
    match scene.camera.stereo {
        None => {
            let position = view.eye(Side::Left).position().to_array();
            to.page.fill("one eye", &[("eye", row(position))]);
        }
        Some(_) => eyes(to, scene, view),
    }
    formula(to, scene, &data["camera"]["lens"]);
    if let Some(angle) = field_of_view(scene) {
        to.page.fill("field of view", &[("angle", format!("{angle:.4}"))]);
    }
}

/// The two eyes of a stereo pair: where they are, and how far their film points are shifted.
fn eyes(to: &mut DescribedValues, scene: &Scene, view: &View) {
    let [left, right] = [Side::Left, Side::Right].map(|side| view.eye(side).position());
    let half = 0.5 * left.distance(right);
    let shift = zoom(&scene.camera.lens).map_or(0.0, |zoom| zoom * half);
    let window = if shift == 0.0 { String::new() } else { text("same window") };
    let values = [
        ("left", row(left.to_array())),
        ("right", row(right.to_array())),
        ("shift", shown(shift)),
        ("window", window),
    ];
    to.page.fill("two eyes", &values);
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

fn field_of_view(scene: &Scene) -> Option<f64> {
    let lens = &scene.camera.lens;
    let distance = match lens {
        Kind::Pinhole(it) => it.distance,
        Kind::ThinLens(it) => it.distance,
        _ => return None,
    };
    let half = 0.5 * scene.image.plane().width / (zoom(lens)? * distance);
    Some(2.0 * groundtruth::math::to_degrees(groundtruth::math::atan2(half, 1.0)))
}

/// Origin and direction of the ray of a film point, from the fields of the lens and their halves.
fn formula(to: &mut DescribedValues, scene: &Scene, lens: &Value) {
    let plane = scene.image.plane();
    let sizes =
        [("half width", shown(0.5 * plane.width)), ("half height", shown(0.5 * plane.height))];
    let rim = if lens["fisheye"]["rectangular"] == true { "ψ > 180" } else { "r > 1" };
    let mut values = vec![
        ("normalised".to_owned(), filled("film coordinates", &sizes)),
        ("rim".to_owned(), rim.to_owned()),
    ];
    let kind = tag(lens);
    for (name, value) in lens[kind].as_object().into_iter().flatten() {
        if let Some(value) = value.as_f64() {
            values.push((name.clone(), shown(value)));
            values.push((format!("half {name}"), shown(0.5 * value)));
        }
    }
    let section = format!("rays: {kind}");
    to.page.fill(if find(&section).is_some() { &section } else { "rays: other" }, &values);
}
