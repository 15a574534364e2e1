//! Chapter 23: triangle meshes.

use super::List;
use super::parts::*;
use crate::cameras::{Pinhole, Viewpoint};
use crate::math::Point;
use crate::scene::{Image, Scene};
use crate::shapes::TessellatedSphere;

pub const SCENES: List =
    &[("ch23/flat-sphere", || tessellated(false)), ("ch23/smooth-sphere", || tessellated(true))];

fn tessellated(smooth: bool) -> Scene {
    let lens = Pinhole { distance: 4000.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(10.0, 12.0, 18.0), Point::ORIGIN, lens);
    let image = Image { samples: 16, ..Image::new(400, 400) };
    let about = match smooth {
        false => "figure 23.1: a sphere of 10 × 5 steps, flat: every triangle shows",
        true => "as figure 23.1, smooth: shaded as a sphere, but the outline is still a polygon",
    };
    let mut scene = Scene::new(about, image, camera);
    scene.lights.push(ambient(0.25));
    scene.lights.push(directional("sun", vector(20.0, 25.0, -4.0), 1.0));
    scene.lights.push(directional("lamp", vector(10.0, 12.0, 18.0), 2.0));
    let shape = TessellatedSphere { horizontal: 10, vertical: 5, radius: 1.0, smooth };
    let (object, material) = object("sphere", shape, matte(0.25, 0.75, rgb(0.1, 0.5, 1.0)));
    scene.objects.push(object);
    scene.materials.push(material);
    scene
}
