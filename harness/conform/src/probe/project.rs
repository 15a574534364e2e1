//! Where a camera sees a point.

use serde::{Deserialize, Serialize};

use super::camera_ray::Picture;
use super::numbers::Real;
use groundtruth::cameras::{Eye, Side, Viewpoint};
use groundtruth::invalid::{Invalid, finite_point};
use groundtruth::math::Point;
use groundtruth::render;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Project {
    camera: Viewpoint,
    image: Picture,
    point: Point,
}

#[derive(Serialize)]
#[serde(untagged)]
pub enum Projection {
    /// Of a camera with one eye.
    One(Option<Projected>),
    /// Of a stereo pair.
    Two { left: Option<Projected>, right: Option<Projected> },
}

#[derive(Serialize)]
pub struct Projected {
    /// On the view plane.
    film: [Real; 2],
    /// In pixels from the top left corner of the image.
    image: [Real; 2],
}

impl super::Question for Project {
    type Answer = Projection;

    fn answer(&self) -> Result<Projection, Invalid> {
        let (image, view) = self.image.built(&self.camera)?;
        let point = finite_point("point", self.point)?;
        let seen = |eye: &Eye| {
            let film = eye.project(point)?;
            let image = render::image_point(&image, film);
            Some(Projected { film: film.map(Real), image: image.map(Real) })
        };
        Ok(match view.stereo() {
            None => Projection::One(seen(view.eye(Side::Left))),
            Some(_) => {
                let [left, right] = [Side::Left, Side::Right].map(|side| seen(view.eye(side)));
                Projection::Two { left, right }
            }
        })
    }
}
