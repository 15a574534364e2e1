//! What holds for the whole description, and how radiance becomes a picture.

use serde_json::Value;

use groundtruth::scene::Scene;
use groundtruth::world::World;

use super::tables::{table, tag};
use super::texts::{filled, text};
use super::values::{DescribedValues, shown};

/// The section of the conventions.
pub fn conventions(to: &mut DescribedValues) {
    to.page.heading("Conventions");
    to.page.tell("conventions");
}

/// The section of the picture.
pub fn write(to: &mut DescribedValues, scene: &Scene, world: &World, data: &Value) {
    to.page.heading("Picture");
    to.page.blank();
    to.fields(0, table("Image"), &data["image"]);
    samples(to, scene, world, data);
    let exposure = scene.camera.exposure_time;
    if exposure != 1.0 {
        to.page.fill("exposure", &[("exposure", shown(exposure))]);
    }
    to.page.tell("radiance files");
    display(to, scene, data);
}

/// The samples of a pixel, and what a pixel is of them.
fn samples(to: &mut DescribedValues, scene: &Scene, world: &World, data: &Value) {
    let count = world.samples_per_pixel();
    let pattern = match &scene.image.sampler {
        None if count == 1 => return to.page.tell("samples: one"),
        None => "samples: left out",
        Some(sampler) if is_fixed(sampler) => "samples: fixed",
        Some(_) => "samples: other",
    };
    // a pixel is the same for any number of samples
    let pixel = match tag(&data["image"]["filter"]) {
        "box" => "pixel: box",
        _ => "pixel: filter",
    };
    let values = [("count", count.to_string()), ("pattern", text(pattern)), ("pixel", text(pixel))];
    to.page.fill("samples: several", &values);
}

/// Whether all draws of a sampler are the same points.
fn is_fixed(sampler: &groundtruth::samplers::Kind) -> bool {
    use groundtruth::samplers::Kind;
    match sampler {
        Kind::Regular(_) => true,
        Kind::Hammersley(it) => !it.shifted,
        _ => false,
    }
}

/// How a PNG or PPM file shows radiance.
fn display(to: &mut DescribedValues, scene: &Scene, data: &Value) {
    let rule = text(&format!("out of gamut: {}", tag(&data["image"]["out_of_gamut"])));
    let gamma = match scene.image.gamma {
        1.0 => text("gamma: none"),
        gamma => filled("gamma: some", &[("gamma", shown(gamma))]),
    };
    to.page.fill("display files", &[("rule", rule), ("gamma", gamma)]);
}
