//! What the chapter's tests share: cameras with a given film, and their rays and projections.

use groundtruth::cameras::{
    CylindricalPanorama, Fisheye, Kind, SphericalPanorama, View, ViewPlane,
};

use crate::prelude::*;

/// A film that is not square, and whose sides are not powers of two.
pub const FILM: ViewPlane = ViewPlane { width: 6.0, height: 5.0 };

/// A view from the origin, with u, v, w along x, y, z.
pub fn on_film(lens: impl Into<Kind>, film: ViewPlane) -> View {
    let view = Viewpoint::new(Point::ORIGIN, Point::new(0.0, 0.0, -1.0), lens);
    view.build(film).expect("a valid view")
}

pub fn fisheye(fov: f64) -> View {
    on_film(Fisheye { fov, rectangular: false }, FILM)
}

pub fn rectangular(fov: f64) -> View {
    on_film(Fisheye { fov, rectangular: true }, FILM)
}

pub fn spherical(horizontal_fov: f64, vertical_fov: f64) -> View {
    on_film(SphericalPanorama { horizontal_fov, vertical_fov }, FILM)
}

pub fn cylindrical(horizontal_fov: f64, vertical_fov: f64) -> View {
    on_film(CylindricalPanorama { horizontal_fov, vertical_fov }, FILM)
}

/// The direction at normalised coordinates, from −1 to 1 over the film.
pub fn looking(view: &View, [xn, yn]: [f64; 2]) -> Option<Vector> {
    let film = [0.5 * xn * FILM.width, 0.5 * yn * FILM.height];
    Some(view.eyes()[0].ray(film, [0.0; 2])?.direction)
}
