//! The scenes: emissive surfaces with images, so that only the look-up causes errors.

use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::images::{Drawn, Picture};
use groundtruth::materials::Emissive;
use groundtruth::math::{Point, Step, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::samplers::MultiJittered;
use groundtruth::scene::{self, Material, Object, Scene};
use groundtruth::shapes::{Instance, Kind as Shape, Plane, Sphere};
use groundtruth::textures::{Filtering, Image, Mapping, Wrap};
use serde::Serialize;

/// A scene of the page.
#[derive(Serialize)]
pub struct TextureScene {
    #[serde(rename = "scene")]
    pub name: &'static str,
    pub about: &'static str,
    /// The number of frames that are rendered.
    #[serde(skip)]
    pub moments: u32,
    /// A frame of the scene with this look-up, width in pixels and moment.
    #[serde(skip)]
    pub frame: fn(Filtering, u32, u32) -> Scene,
}

pub static SUBJECTS: [TextureScene; 2] = [
    TextureScene {
        name: "checker to the horizon",
        about: "A checker of 8 × 8 squares, an image of 64 × 64 texels, repeated to the horizon: texels \
                are larger than pixels in the foreground, and much smaller in the background.",
        moments: 1,
        frame: checker,
    },
    TextureScene {
        name: "turning globe",
        about: "A globe of 256 × 128 texels, rotated a little from frame to frame: errors are visible as \
                flicker in an animation.",
        moments: 4,
        frame: globe,
    },
];

/// A scene with one shape whose emission is an image.
fn emissive_image(
    size: [u32; 2],
    [eye, look_at]: [Point; 2],
    distance: f64,
    (shape, image): (Shape, Image),
) -> Scene {
    let mut picture = scene::Image::new(size[0], size[1]);
    picture.pixel_size = 1.0 / f64::from(size[0]);
    picture.sampler = Some(MultiJittered {}.into());
    let camera = Viewpoint::new(eye, look_at, Pinhole { distance, zoom: 1.0 });
    let mut scene = Scene::new("", picture, camera);
    scene.background = Rgb::BLACK.into();
    scene.materials.push(Material::new("image", Emissive::new(1.0, image)));
    scene.objects.push(Object::new("shape", "image", shape));
    scene
}

fn checker(filtering: Filtering, width: u32, _: u32) -> Scene {
    let drawn = Drawn { picture: Picture::Checker, width: 64, height: 64 };
    let image = Image {
        filtering,
        unit: 4.0,
        wrap_u: Some(Wrap::Repeat),
        wrap_v: Some(Wrap::Repeat),
        ..Image::of_drawn(drawn, Some(Mapping::Square))
    };
    let plane = Plane { point: Point::ORIGIN, normal: Vector::Y };
    let view = [Point::new(0.3, 1.0, 5.0), Point::new(0.0, 0.6, 0.0)];
    emissive_image([width, width * 2 / 3], view, 0.8, (plane.into(), image))
}

fn globe(filtering: Filtering, width: u32, moment: u32) -> Scene {
    let drawn = Drawn { picture: Picture::Globe, width: 256, height: 128 };
    let image = Image { filtering, ..Image::of_drawn(drawn, Some(Mapping::Spherical)) };
    let sphere = Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
    let turned = Instance::new(sphere, vec![Step::RotateY(40.0 + 3.0 * f64::from(moment))]);
    let view = [Point::new(0.0, 0.8, 4.0), Point::ORIGIN];
    emissive_image([width, width], view, 1.6, (turned.into(), image))
}
