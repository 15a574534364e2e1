//! Chapter 11: nonlinear projections.

use super::List;
use super::sets::{Canyon, canyon, city};
use groundtruth::cameras::{
    CylindricalPanorama, Fisheye, Kind as Lens, SphericalPanorama, Viewpoint,
};
use groundtruth::math::Point;
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Scene};

pub const SCENES: List = &[
    ("ch11/fisheye-120", || fisheye("figure 11.7a: a canyon of boxes, fisheye of 120°", 120.0)),
    ("ch11/fisheye-180", || fisheye("figure 11.7b: a canyon of boxes, fisheye of 180°", 180.0)),
    ("ch11/fisheye-360", || fisheye("figure 11.7c: all directions, fisheye of 360°", 360.0)),
    ("ch11/fisheye-rectangular", || {
        let mut scene = fisheye("the fisheye of 180° with the corners outside the circle", 180.0);
        scene.camera.lens = Fisheye { fov: 180.0, rectangular: true }.into();
        scene
    }),
    ("ch11/fisheye-wide", || {
        let about = "a fisheye of 150° in a picture of 3 to 2: an ellipse, as the book's x and y each reach 1";
        let mut scene = fisheye(about, 150.0);
        scene.image = Image { samples: 16, ..Image::new(600, 400) };
        scene
    }),
    ("ch11/city", || {
        let about = "figure 11.11: the city in a panorama of 84° by 56°";
        panorama(about, [600, 400], FROM_OUTSIDE, [84.0, 56.0])
    }),
    ("ch11/city-180", || {
        let about = "figure 11.12a: from inside the city, 180° by 120°";
        panorama(about, [600, 400], FROM_INSIDE, [180.0, 120.0])
    }),
    ("ch11/city-360", || {
        let about = "figure 11.12b: from inside the city, 360° by 180°";
        panorama(about, [800, 400], FROM_INSIDE, [360.0, 180.0])
    }),
    ("ch11/city-cylindrical", || {
        let about = "a cylindrical panorama of 360° inside the city: vertical lines are straight";
        let lens = CylindricalPanorama { horizontal_fov: 360.0, vertical_fov: 90.0 };
        city_through(about, [800, 255], FROM_INSIDE, lens.into())
    }),
];

/// Figures 11.7.
fn fisheye(about: &str, fov: f64) -> Scene {
    let (eye, look_at) = (point(250.0, 300.0, 150.0), point(-20.0, 300.0, -110.0));
    let camera = Viewpoint::new(eye, look_at, Fisheye { fov, rectangular: false });
    let image = Image { samples: 16, ..Image::new(400, 400) };
    let mut scene = Scene::new(about, image, camera);
    scene.background = rgb(0.6, 0.75, 0.95).into();
    canyon(&mut scene, &Canyon { right: 500.0, tallest: 850.0 });
    scene
}

/// The eye, and the point that it looks at.
type View = [[f64; 3]; 2];
const FROM_OUTSIDE: View = [[100.0, 100.0, 50.0], [0.0, -10.0, 0.0]];
const FROM_INSIDE: View = [[10.0, 15.0, 13.0], [34.0, 15.0, 0.0]];

fn panorama(about: &str, size: [u32; 2], view: View, [horizontal, vertical]: [f64; 2]) -> Scene {
    let lens = SphericalPanorama { horizontal_fov: horizontal, vertical_fov: vertical };
    city_through(about, size, view, lens.into())
}

fn city_through(about: &str, [width, height]: [u32; 2], view: View, lens: Lens) -> Scene {
    let [eye, look_at] = view.map(Point::from);
    let image = Image { samples: 16, ..Image::new(width, height) };
    let mut scene = Scene::new(about, image, Viewpoint::new(eye, look_at, lens));
    scene.background = rgb(0.6, 0.75, 0.95).into();
    city(&mut scene, ambient(0.5));
    scene
}
