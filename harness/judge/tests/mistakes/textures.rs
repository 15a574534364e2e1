//! Mistakes of textures, on a floor seen straight from above: columns run along −x, rows along −z.

use groundtruth::film::Film;
use groundtruth::images::{Drawn, Picture};
use groundtruth::lights::Ambient;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::scene::build::*;
use groundtruth::textures::{Checker3d, Filtering, Image, Mapping, Paint};

use super::stage::*;

/// The side of the picture in pixels.
const SIDE: u32 = 40;

/// A floor of this colour, of which the square −1 … 1 is seen.
fn floor(paint: impl Into<Paint>) -> Scene {
    let mut scene = plane(matte(1.0, 0.0, paint), 0.0);
    light(&mut scene, Ambient { ls: 1.0, color: Rgb::WHITE });
    scene.image.resize(SIDE, SIDE);
    scene.image.pixel_size = 2.0 / f64::from(SIDE);
    scene
}

/// A picture whose pixel at each position is that of another there.
fn moved(film: &Film, from: impl Fn([u32; 2]) -> [u32; 2]) -> Film {
    let mut moved = Film::new(SIDE, SIDE);
    for at in (0..SIDE).flat_map(|x| (0..SIDE).map(move |y| [x, y])) {
        moved.set(at, film.get(from(at)));
    }
    moved
}

/// A name, and where a pixel of a picture of this side is taken from.
type Order = (&'static str, fn([u32; 2], u32) -> [u32; 2]);

/// Law: an image on a square, with u along z and v along x, is mirrored, upside down or turned with its texture
/// coordinates. Oracle: the pixels of our picture in another order.
#[test]
fn images_in_other_orders() {
    let drawn = Drawn { picture: Picture::Country, width: 64, height: 64 };
    let scene = floor(Image::of_drawn(drawn, Some(Mapping::Square)));
    let ours = ours(&scene);
    let last = SIDE - 1;
    let orders: [Order; 2] = [
        ("texture-mirrored", |[x, y], last| [x, last - y]),
        ("texture-upside-down", |[x, y], last| [last - x, y]),
    ];
    for (name, order) in orders {
        let expected = moved(&ours, |at| order(at, last));
        let wrong = with(name, &scene);
        assert!(share_of_differences(&wrong, &ours) > 0.05, "{name} changes little");
        // a texel's border may fall on a pixel's centre
        assert!(share_of_differences(&wrong, &expected) < 0.06, "{name}");
    }
    let turned = with("texture-turned", &scene);
    let quarters = [moved(&ours, |[x, y]| [y, last - x]), moved(&ours, |[x, y]| [last - y, x])];
    assert!(quarters.iter().any(|it| share_of_differences(&turned, it) < 0.06));
}

/// Law: bilinear interpolation for the nearest texel and back. Oracle: the texture that says so.
#[test]
fn other_filtering() {
    let drawn = Drawn { picture: Picture::Country, width: 16, height: 16 };
    let image = Image::of_drawn(drawn, Some(Mapping::Square));
    let nearest = floor(image.clone());
    let bilinear = floor(Image { filtering: Filtering::Bilinear, ..image });
    assert_eq!(bits(&with("texture-bilinear", &nearest)), bits(&ours(&bilinear)));
    assert_eq!(bits(&with("texture-nearest", &bilinear)), bits(&ours(&nearest)));
}

/// Law: a checker with exchanged colours, moved by half a cell, or of other cells. Oracle: the parity of the cells, by
/// integers, away from the borders.
#[test]
fn checkers() {
    let size = 0.3;
    let colors = [Rgb::WHITE, Rgb::grey(0.25)];
    let scene = floor(Checker3d { size, color1: colors[0].into(), color2: colors[1].into() });
    let parity = |x: f64, size: f64| (x / size).floor() as i64;
    let expected = |odd: bool, size: f64, shift: f64| {
        let mut film = Film::new(SIDE, SIDE);
        for at in (0..SIDE).flat_map(|x| (0..SIDE).map(move |y| [x, y])) {
            let [x, z] = at.map(|i| 1.0 - (f64::from(i) + 0.5) * 2.0 / f64::from(SIDE));
            // y = 0 lies just below the border of a cell
            let cells = [x - shift, -1e-9 - shift, z - shift].map(|x| parity(x, size));
            let is_odd = (cells.iter().sum::<i64>() % 2 != 0) != odd;
            film.set(at, colors[usize::from(is_odd)]);
        }
        film
    };
    let apart = |film: &Film, expected: &Film| share_of_differences(film, expected);
    assert!(apart(&ours(&scene), &expected(false, size, 0.0)) < 0.01);
    let exchanged = with("texture-colours-exchanged", &scene);
    assert!(apart(&exchanged, &expected(true, size, 0.0)) < 0.01);
    assert!(apart(&with("texture-offset", &scene), &expected(false, size, 0.5 * size)) < 0.01);
    assert!(apart(&with("texture-size-doubled", &scene), &expected(false, 2.0 * size, 0.0)) < 0.01);
    assert!(apart(&with("texture-size-halved", &scene), &expected(false, 0.5 * size, 0.0)) < 0.01);
}
