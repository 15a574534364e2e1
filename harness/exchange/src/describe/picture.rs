//! What holds for the whole description, and how radiance becomes a picture.

use serde_json::Value;

use groundtruth::film::OutOfGamut;
use groundtruth::filters;
use groundtruth::scene::Scene;
use groundtruth::world::World;

use super::tables::table;
use super::values::{Values, shown};

/// The section of the conventions.
pub fn conventions(to: &mut Values) {
    to.page.heading("Conventions");
    to.page.say(
        "This text says everything that is needed to build the scene in another renderer. A line such as \
         `radius = 2` is a setting; the section Words at the end says what each setting means. A setting that a \
         word lists as one that may be left out, and that is not listed where the word is used, is left out there.",
    );
    to.page.say(
        "Coordinates are right-handed: with x to the right and y up, z points towards you. Points and vectors are \
         [x, y, z]. All lengths, those of the film included, are in one unit, the unit of the scene. Angles \
         are in degrees.",
    );
    to.page.say(
        "Colours are [red, green, blue] and linear: twice the number is twice the light. One number is a grey. \
         They are multiplied channel by channel; no colour space is implied. Reflectances are shares from 0 to 1; \
         radiance has no upper bound and no physical unit.",
    );
}

/// The section of the picture.
pub fn write(to: &mut Values, scene: &Scene, world: &World, data: &Value) {
    to.page.heading("Picture");
    to.page.blank();
    to.fields(0, table("Image"), &data["image"]);
    to.page.say(&samples(scene, world));
    let exposure = scene.camera.exposure_time;
    if exposure != 1.0 {
        to.page.say(&format!(
            "That value times the exposure_time {} of the camera is the pixel.",
            shown(exposure)
        ));
    }
    to.page.say(
        "Picture files in EXR or PFM keep the pixels as they are: linear radiance in single precision.",
    );
    to.page.say(&display(scene));
}

/// The samples of a pixel, and what a pixel is of them.
fn samples(scene: &Scene, world: &World) -> String {
    let count = world.samples_per_pixel();
    let pattern = match &scene.image.sampler {
        None if count == 1 => {
            return "There is one sample in each pixel, at its centre (and at the centre of the lens, if the camera \
                    has one): a pixel is the radiance of that one ray. Other random choices, such as the points of area \
                    lights, are not at a centre: with them the picture is noisy."
                .to_owned();
        }
        None => {
            "multi-jittered as in the book. The pattern changes the noise of the picture only: the expected \
                 value of a pixel is the same for any pattern that covers the pixel evenly."
        }
        Some(sampler) if is_fixed(sampler) => {
            "at the points of this pattern, which are the same in every pixel: the picture depends on the pattern. \
             Points of a lens are those points of the unit square after the concentric map to the disk (Shirley & \
             Chiu 1997); which of them belongs to which sample of the pixel is random, and so for lights."
        }
        Some(_) => {
            "in this pattern. The pattern changes the noise of the picture only: the expected value of a \
                    pixel is the same for any pattern that covers the pixel evenly."
        }
    };
    format!("There are {count} samples in each pixel, {pattern} {}", filter(&scene.image.filter))
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

/// What a pixel is, for any number of samples.
fn filter(filter: &filters::Kind) -> &'static str {
    match filter {
        filters::Kind::Box(_) => "A pixel is the mean of the radiance over its square.",
        _ => {
            "A pixel is the integral over the film of the radiance times w(dx) w(dy), where dx and dy are the \
             distances from the centre of the pixel in pixels, and w is the function of `filter`, scaled so that \
             its integral is 1."
        }
    }
}

/// How a PNG or PPM file shows radiance.
fn display(scene: &Scene) -> String {
    let image = &scene.image;
    let rule = match image.out_of_gamut {
        OutOfGamut::MaxToOne => "a colour with a channel above 1 is divided by its largest channel",
        OutOfGamut::ClampToColor => "a colour with a channel above 1 becomes red, [1, 0, 0]",
    };
    let gamma = match image.gamma {
        1.0 => "no gamma is applied (the file stores linear values, although most programs show it as sRGB)".to_owned(),
        gamma => format!("then each channel is raised to the power 1/{}", shown(gamma)),
    };
    format!(
        "Picture files in PNG or PPM are for display: {rule}; {gamma}; then 255 times the channel, rounded to \
         the nearest whole number, is stored."
    )
}
