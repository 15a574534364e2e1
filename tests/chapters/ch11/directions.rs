//! Laws that hold for the fisheye and both panoramas.

use groundtruth::cameras::{
    CylindricalPanorama, Fisheye, Kind, SphericalPanorama, View, ViewPlane,
};
use testkit::properties::*;

use super::views::{FILM, cylindrical, fisheye, looking, on_film, spherical};
use crate::prelude::*;

/// The solid angle of a small square of the normalised film, by the cross product of two sides, divided by
/// its area.
fn density(view: &View, [xn, yn]: [f64; 2]) -> f64 {
    const H: f64 = 1e-4;
    let at = |dx: f64, dy: f64| looking(view, [xn + dx, yn + dy]).expect("seen");
    let (a, b) = (at(H, 0.0) - at(-H, 0.0), at(0.0, H) - at(0.0, -H));
    a.cross(b).length() / (4.0 * H * H)
}

/// Central differences leave an error of h²/6 times the third derivatives, which here are at most π³ times
/// the first ones.
const DIFFERENCE: f64 = 1e-6;

fn all(fov: f64) -> [Kind; 3] {
    let (horizontal_fov, vertical_fov) = (fov, 0.5 * fov);
    [
        Fisheye { fov, rectangular: true }.into(),
        SphericalPanorama { horizontal_fov, vertical_fov }.into(),
        CylindricalPanorama { horizontal_fov, vertical_fov }.into(),
    ]
}

proptest! {
    #![proptest_config(laws())]

    /// Law: the solid angle per film area is proportional to `sin ψ/ψ` for the fisheye, `cos ψ` for the
    /// spherical and `cos³ψ` for the cylindrical panorama; in the centre it is the product of the half
    /// angles. Oracle: differences of directions.
    /// Book: fields of view, whatever the size of the window.
    #[test]
    fn film_covers_the_solid_angle_of_its_projection(
        fov in 10.0..300.0_f64, v in 10.0..170.0_f64, xn in -0.6..0.6_f64, yn in -0.6..0.6_f64,
    ) {
        let (lambda_max, psi_max) = (to_radians(0.5 * fov), to_radians(0.5 * v));
        let psi = lambda_max * (xn * xn + yn * yn).sqrt();
        prop_assume!(psi > 0.01);
        let expected = lambda_max * lambda_max * sin(psi) / psi;
        let found = density(&fisheye(fov), [xn, yn]);
        prop_assert!(
            (found - expected).abs() < DIFFERENCE * lambda_max * lambda_max,
            "{found} {expected}"
        );
        let psi = psi_max * yn;
        let expected = lambda_max * psi_max * cos(psi);
        let found = density(&spherical(fov, v), [xn, yn]);
        near!(found, expected, DIFFERENCE * lambda_max * psi_max);
        let height = groundtruth::math::tan(psi_max);
        let cos_psi = 1.0 / (1.0 + yn * yn * height * height).sqrt();
        let expected = lambda_max * height * cos_psi * cos_psi * cos_psi;
        let found = density(&cylindrical(fov, v), [xn, yn]);
        let third = 1.0 + height * height;
        near!(found, expected, DIFFERENCE * third * lambda_max * height);
    }

    /// Law: with a small field of view fisheye and panoramas are pinhole cameras of the distance `width/(2
    /// λ_max)`: the difference falls with the cube of the angle. Oracle: the pinhole; at the rim it is 1/3 of
    /// the cube.
    /// Book: fields of view, whatever the size of the window.
    #[test]
    fn a_small_field_of_view_is_a_pinholes(
        exponent in -7.0..-1.0_f64,
        xn in -0.7..0.7_f64,
        yn in -0.7..0.7_f64,
    ) {
        let square = ViewPlane { width: 6.0, height: 6.0 };
        let fov = groundtruth::math::exp(exponent * std::f64::consts::LN_10);
        let lambda_max = to_radians(0.5 * fov);
        let pinhole = on_film(Pinhole { distance: 3.0 / lambda_max, zoom: 1.0 }, square);
        let film = [3.0 * xn, 3.0 * yn];
        let expected = pinhole.eyes()[0].ray(film, [0.0; 2]).expect("seen").direction;
        let [fisheye, _, _] = all(fov);
        let (h, v) = (fov, fov);
        let spherical = SphericalPanorama { horizontal_fov: h, vertical_fov: v }.into();
        let cylindrical = CylindricalPanorama { horizontal_fov: h, vertical_fov: v }.into();
        for lens in [fisheye, spherical, cylindrical] {
            let d = on_film(lens, square).eyes()[0].ray(film, [0.0; 2]).expect("seen").direction;
            let off = (d - expected).length();
            let cube = lambda_max * lambda_max * lambda_max;
            prop_assert!(off < cube + 4.0 * f64::EPSILON, "{off:e} of {cube:e}");
            // and small components have the same relative error
            near!(
                d.x(),
                expected.x(),
                (lambda_max * lambda_max + 1e-15) * d.x().abs() + cube * 1e-300
            );
        }
    }

    /// Law: the picture does not depend on the size or number of the pixels, only on the normalised film
    /// point. Oracle: a film of another size; for powers of two bit for bit.
    /// Book: fields of view, whatever the size of the window.
    #[test]
    fn pictures_do_not_depend_on_the_pixel_size(
        fov in 1.0..360.0_f64,
        xn in -0.7..0.7_f64,
        yn in -0.7..0.7_f64,
    ) {
        let other = ViewPlane { width: 7.3, height: 0.31 };
        let twice = ViewPlane { width: 2.0 * FILM.width, height: 8.0 * FILM.height };
        let at = |lens: &Kind, film: ViewPlane| {
            let view = on_film(lens.clone(), film);
            let ray = view.eyes()[0].ray([0.5 * xn * film.width, 0.5 * yn * film.height], [0.0; 2]);
            ray.map(|ray| ray.direction)
        };
        for lens in all(fov) {
            let (a, b) = (at(&lens, FILM), at(&lens, other));
            prop_assert_eq!(at(&lens, twice), a);
            if let (Some(a), Some(b)) = (a, b) {
                near!(a, b, 16.0 * f64::EPSILON);
            }
        }
    }
}
