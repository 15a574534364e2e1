//! The ray of a camera for a place in a pixel.

use serde::{Deserialize, Serialize};

use super::numbers::{CLOSED, Real, Triple, in_square, triple};
use groundtruth::cameras::{Side, View, Viewpoint};
use groundtruth::invalid::Invalid;
use groundtruth::render;
use groundtruth::scene::Image;
use groundtruth::world;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CameraRay {
    camera: Viewpoint,
    image: Picture,
    /// Of a stereo pair.
    eye: Option<Side>,
    pixel: [u32; 2],
    #[serde(default = "middle")]
    place: [f64; 2],
    /// In the unit disk; its centre if left out.
    #[serde(default)]
    lens: [f64; 2],
}

/// A picture, as far as cameras need to know it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Picture {
    width: u32,
    height: u32,
    #[serde(default = "groundtruth::kinds::one")]
    pixel_size: f64,
}

impl Picture {
    /// The picture and a camera for it.
    pub(super) fn built(&self, camera: &Viewpoint) -> Result<(Image, View), Invalid> {
        let &Picture { width, height, pixel_size } = self;
        let image = Image { pixel_size, ..Image::new(width, height) };
        world::check_image(&image).map_err(|e| e.inside("image"))?;
        let view = camera.build(image.plane()).map_err(|e| e.inside("camera"))?;
        world::check_view(&view, &image)?;
        Ok((image, view))
    }
}

fn middle() -> [f64; 2] {
    [0.5; 2]
}

#[derive(Serialize)]
pub struct CameraRayAnswer {
    /// `None`, as the direction, where the camera sees nothing.
    origin: Option<Triple>,
    direction: Option<Triple>,
    /// The place on the view plane.
    film: [Real; 2],
}

impl super::Question for CameraRay {
    type Answer = CameraRayAnswer;

    fn answer(&self) -> Result<CameraRayAnswer, Invalid> {
        let (image, view) = self.image.built(&self.camera)?;
        inside(self.pixel, [image.width, image.height])?;
        let eye = match (self.eye, view.stereo()) {
            (None, Some(_)) => {
                return Err(Invalid::field("eye", "a stereo pair has two: left, right"));
            }
            (Some(_), None) => return Err(Invalid::field("eye", "goes with a stereo pair")),
            (side, _) => view.eye(side.unwrap_or(Side::Left)),
        };
        let place = in_square("place", self.place, CLOSED)?;
        let film = render::film_point(&image, self.pixel, place);
        let [x, y] = self.lens;
        let on_the_lens = x * x + y * y <= 1.0;
        if !on_the_lens {
            let problem = format!("found {:?}, which is outside the unit disk", self.lens);
            return Err(Invalid::field("lens", problem));
        }
        let ray = eye.ray(film, self.lens);
        let origin = ray.map(|ray| triple(ray.origin));
        let direction = ray.map(|ray| triple(ray.direction));
        Ok(CameraRayAnswer { origin, direction, film: film.map(Real) })
    }
}

/// Refuses a pixel outside a picture of this size.
pub(super) fn inside([x, y]: [u32; 2], [width, height]: [u32; 2]) -> Result<(), Invalid> {
    if x < width && y < height {
        return Ok(());
    }
    let problem = format!("found [{x}, {y}], which is outside the picture of {width} × {height}");
    Err(Invalid::field("pixel", problem))
}
