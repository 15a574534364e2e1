//! Skies by image: their radiance, and the directions that are sampled from them.

use std::path::PathBuf;

use groundtruth::background::{Background, Directions, Dome, Image, ImageSky, Sky};
use groundtruth::cameras::{self, Fisheye, SphericalPanorama, ViewPlane};
use groundtruth::film::{self, Tone};
use groundtruth::kinds::Resources;
use groundtruth::textures::{Filtering, Mapping};
use statistics::chi_square::goodness_of_fit;

use crate::prelude::*;

pub const DOMES: [Dome; 4] =
    [Dome::Spherical, Dome::Hemispherical, Dome::LightProbe, Dome::Panoramic];
pub const FILTERINGS: [Filtering; 2] = [Filtering::Nearest, Filtering::Bilinear];

/// Columns and rows of most skies here: few, so that each is hit often.
pub const SIZE: [u32; 2] = [12, 8];

/// Writes an image by the colours of its texels, rows counted from the bottom.
pub fn written(name: &str, [width, height]: [u32; 2], color: impl Fn([u32; 2]) -> Rgb) -> PathBuf {
    let mut picture = Film::new(width, height);
    for row in 0..height {
        for column in 0..width {
            picture.set([column, height - 1 - row], color([column, row]));
        }
    }
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("ch29-{name}.exr"));
    film::write(&picture, &Tone::PLAIN, &path).expect("the folder can be written to");
    path
}

/// Values from 0 to 3 with a bright texel and black ones among them, exact in single precision.
pub fn ragged([column, row]: [u32; 2]) -> Rgb {
    let mut random = Pcg32::new(29, u64::from(1000 * row + column));
    let mut channel = || f64::from(random.below(13)) / 4.0;
    match [column, row] {
        [3, 5] => Rgb::new(60.0, 50.0, 30.0),
        _ if (column + row) % 3 == 0 => Rgb::BLACK,
        _ => Rgb::new(channel(), channel(), channel()),
    }
}

pub fn image(name: &str, dome: Dome, filtering: Filtering) -> Image {
    Image { filtering, ..Image::of_file(written(name, SIZE, ragged), dome) }
}

/// The sky of an image, built.
pub fn sky(image: &Image) -> Arc<ImageSky> {
    let built = Background::from(image.clone()).build(&mut Resources::default());
    match built.expect("it is valid") {
        Sky::Image(sky) => sky,
        other => panic!("{other:?} is no image"),
    }
}

/// Midpoints of equal parts of the sphere, in rings about the axis (1, 2, 3), which is no axis of any
/// mapping; and their solid angle.
pub fn all_around(rings: u32) -> (impl Iterator<Item = Vector>, f64) {
    let axis = Normal::new(Vector::new(1.0, 2.0, 3.0)).expect("not zero");
    let frame = groundtruth::math::Frame::around(axis);
    let parts = 2 * rings;
    let direction = move |i: u32| {
        let z = (2.0 * f64::from(i / parts) + 1.0) / f64::from(rings) - 1.0;
        let phi = TAU * (f64::from(i % parts) + 0.5) / f64::from(parts);
        let r = (1.0 - z * z).sqrt();
        frame.to_world(Vector::new(r * cos(phi), r * sin(phi), z))
    };
    ((0..rings * parts).map(direction), 4.0 * PI / f64::from(rings * parts))
}

fn random_direction(random: &mut Pcg32) -> Vector {
    groundtruth::math::maps::sphere([random.uniform(), random.uniform()])
}

/// The texel of the nearest look-up in a direction, computed independently.
pub fn texel(dome: Dome, direction: Vector) -> Option<[u32; 2]> {
    if dome == Dome::Hemispherical && direction.y() < 0.0 {
        return None;
    }
    let [u, v] = Mapping::from(dome).uv(Point::ORIGIN + direction);
    let index = |x: f64, count: u32| ((x * f64::from(count)) as u32).min(count - 1);
    Some([index(u, SIZE[0]), index(v, SIZE[1])])
}

/// Law: the colour seen in a direction is that of its texel, times `ls`; below the horizon of a hemispherical
/// sky it is black. Oracle: the texel by the book's mapping.
/// Book: fig. 29.27, a sky by an image.
#[test]
fn each_direction_shows_its_texel() {
    for dome in DOMES {
        let sky = sky(&Image { ls: 0.5, ..image("seen", dome, Filtering::Nearest) });
        let mut random = Pcg32::new(29, 1);
        for _ in 0..2000 {
            let direction = random_direction(&mut random);
            let expected = texel(dome, direction).map_or(Rgb::BLACK, |at| 0.5 * ragged(at));
            let ray = 3.0 * direction;
            assert_eq!(sky.radiance(ray), expected, "{dome:?} towards {direction:?}");
        }
    }
}

/// Law: the directions in each texel are as frequent as the density says, and the density integrates to the share
/// of the draws that give a direction: χ² over the texels, and over what gives none. Oracle: the integral of the
/// density over each texel's directions, by the midpoint rule over the sphere.
#[test]
fn directions_follow_the_density() {
    const DRAWS: u64 = 40_000;
    for (dome, filtering) in DOMES.into_iter().flat_map(|it| FILTERINGS.map(|by| (it, by))) {
        let directions = Directions::new(&sky(&image("chi", dome, filtering)));
        let texels = (SIZE[0] * SIZE[1]) as usize;
        let index = |w: Vector| texel(dome, w).map(|[c, r]| (r * SIZE[0] + c) as usize);
        let mut expected = vec![0.0; texels + 1];
        let (all, part) = all_around(500);
        for w in all {
            expected[index(w).unwrap_or(texels)] += DRAWS as f64 * part * directions.pdf(w);
        }
        // the density jumps at the borders of texels; the error of the rule is a share of the points there
        let whole: f64 = expected.iter().sum();
        let is_round = matches!(dome, Dome::LightProbe | Dome::Panoramic);
        if is_round {
            expected[texels] = DRAWS as f64 - whole;
        } else {
            near!(whole, DRAWS as f64, 4e-3 * DRAWS as f64, "{dome:?}");
            expected.iter_mut().for_each(|e| *e *= DRAWS as f64 / whole);
        }
        let mut observed = vec![0_u64; texels + 1];
        let mut random = Pcg32::new(29, 5);
        for _ in 0..DRAWS {
            let drawn = directions.sample([random.uniform(), random.uniform()]);
            observed[drawn.map_or(texels, |w| index(w).expect("it is in the sky"))] += 1;
        }
        let p = goodness_of_fit(&observed, &expected);
        assert!(p > sidak(1e-4, 8), "{dome:?}, {filtering:?}: p = {p:e}");
    }
}

/// Law: towards the poles and the rim all values are finite; a black sky gives no directions. Oracle: the definitions.
#[test]
fn poles_rims_and_black_skies_are_harmless() {
    let black = written("black", SIZE, |_| Rgb::BLACK);
    let axes = [Vector::X, Vector::Y, Vector::Z].map(|axis| [axis, -axis]);
    for dome in DOMES {
        let sky_at = sky(&image("ends", dome, Filtering::Bilinear));
        let directions = Directions::new(&sky_at);
        for &w in axes.as_flattened() {
            let (pdf, seen) = (directions.pdf(w), sky_at.radiance(w).max());
            assert!(
                pdf.is_finite() && pdf >= 0.0 && seen.is_finite(),
                "{dome:?} towards {w:?}: {pdf}, {seen}"
            );
        }
        let black = Directions::new(&sky(&Image::of_file(&black, dome)));
        assert!([0.0, 0.5, 0.9].iter().all(|&u| black.sample([u, u]).is_none()), "{dome:?}");
        assert_eq!(black.pdf(Vector::X), 0.0);
    }
}

/// Law: a sky turned by ψ shows towards `R_y(ψ) w` what the sky shows towards w, with the same density.
/// Oracle: the same turn of an object; the points lie inside texels, so that rounding does not matter.
#[test]
fn skies_turn_as_objects_do() {
    /// The turn rounds the direction; near a pole the relative change of the density is that rounding over
    /// the distance.
    const ROUNDING: f64 = 1e-9;
    for (dome, degrees) in DOMES.into_iter().flat_map(|d| [90.0, 77.0, -200.0].map(|a| (d, a))) {
        let plain = image("turned", dome, Filtering::Nearest);
        let turned = sky(&Image { rotate_y: degrees, ..plain.clone() });
        let plain = sky(&plain);
        let turn = Transform::from_steps(&[Step::RotateY(degrees)]).expect("a turn");
        let pdfs = [&plain, &turned].map(Directions::new);
        for row in 0..SIZE[1] {
            for column in 0..SIZE[0] {
                let [u, v] = [0, 1]
                    .map(|axis| (f64::from([column, row][axis]) + 0.4) / f64::from(SIZE[axis]));
                let Some(w) = dome.direction([u, v]) else { continue };
                let there = turn.vector(w);
                assert_eq!(turned.radiance(there), plain.radiance(w), "{dome:?}, {degrees}°");
                let [before, after] = [pdfs[0].pdf(w), pdfs[1].pdf(there)];
                let close = (before - after).abs() <= ROUNDING * before;
                assert!(close, "{dome:?}, {degrees}°: density {before} becomes {after}");
            }
        }
    }
}

/// Law: a sky of one colour is that colour, bit for bit, whatever its mapping and filtering. Oracle: the
/// colour.
#[test]
fn a_sky_of_one_colour_is_the_colour() {
    // exact in single precision
    let color = Rgb::new(0.75, 0.625, 1.5);
    let file = written("even", SIZE, |_| color);
    for dome in DOMES {
        for filtering in FILTERINGS {
            let image = Image { filtering, rotate_y: 20.0, ..Image::of_file(&file, dome) };
            let sky = sky(&image);
            let mut random = Pcg32::new(29, 8);
            for _ in 0..1000 {
                let mut w = random_direction(&mut random);
                if dome == Dome::Hemispherical {
                    w = Vector::new(w.x(), w.y().abs(), w.z());
                }
                let seen = Sky::Image(Arc::clone(&sky)).radiance(&Ray::new(Point::ORIGIN, w));
                assert_eq!(seen, color, "{dome:?}, {filtering:?} towards {w:?}");
            }
        }
    }
}

/// Law: a camera that maps directions as an image does shows that image: a fisheye of 360° shows a panoramic light probe as
/// it is along −z, and a light probe mirrored along +z; a panorama of 360° × 180° a spherical map mirrored. Oracle: the
/// image, pixel by pixel.
/// Book: fig. 29.16, a light probe seen by a fisheye of 360°.
#[test]
fn a_fisheye_all_around_shows_the_image_of_a_light_probe() {
    let fisheye = cameras::Kind::from(Fisheye { fov: 360.0, rectangular: false });
    let panorama = SphericalPanorama { horizontal_fov: 360.0, vertical_fov: 180.0 };
    for (dome, lens, ahead, is_mirrored) in [
        (Dome::Panoramic, fisheye.clone(), -1.0, false),
        (Dome::LightProbe, fisheye, 1.0, true),
        (Dome::Spherical, panorama.into(), -1.0, true),
    ] {
        let sky = sky(&image("all-around", dome, Filtering::Nearest));
        let view = Viewpoint::new(Point::ORIGIN, Point::new(0.0, 0.0, ahead), lens);
        let view = view.build(ViewPlane { width: 12.0, height: 8.0 }).expect("a valid view");
        for [column, row] in (0..12 * 8).map(|i| [i % 12, i / 12]) {
            let film = [f64::from(column) - 5.5, f64::from(row) - 3.5];
            let Some(ray) = view.eyes()[0].ray(film, [0.0; 2]) else { continue };
            let there = if is_mirrored { 11 - column } else { column };
            assert_eq!(sky.radiance(ray.direction), ragged([there, row]), "{dome:?}, {column}");
        }
    }
}
