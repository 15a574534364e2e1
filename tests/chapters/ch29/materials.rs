//! Materials with images: pictures, the number of look-ups, and errors.

use groundtruth::materials::Kind;
use groundtruth::render::render;
use groundtruth::shapes::Sampling;
use groundtruth::textures::{Amount, Checker3d, Filtering, Image, Mapping};

use super::{by_uv, image_file, linear};
use crate::prelude::*;
use crate::support::asked::Counted;
use crate::support::lamps::share;
use crate::support::lamps::{LS, floor, hang, seen, up};

const UNIT: Sphere = Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };

/// The square of the plane z = 0 from −1 to 1, whose u and v run from 0 to `times`.
fn square(times: f64) -> Mesh {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let vertices = corners.map(|[x, y]| Point::new(x, y, 0.0)).into();
    let uvs = corners.map(|[x, y]| [x, y].map(|c| times * 0.5 * (c + 1.0))).into();
    Mesh { uvs: Some(uvs), ..Mesh::of_lists(vertices, vec![[0, 1, 2], [0, 2, 3]]) }
}

/// A lit sphere of this material in front of a checkered wall, which it may mirror.
fn lit(recipe: impl Into<Kind>) -> Scene {
    let mut scene = deep_stage(Rgb::new(0.1, 0.2, 0.3), 4);
    scene.image.width = 12;
    scene.image.height = 12;
    scene.image.pixel_size = 0.25;
    put(&mut scene, UNIT, recipe);
    let checker =
        Checker3d { size: 0.5, color1: Rgb::WHITE.into(), color2: Rgb::new(0.2, 0.5, 0.1).into() };
    let wall =
        Rectangle { corner: Point::new(-4.0, -4.0, -3.0), a: 8.0 * Vector::X, b: 8.0 * Vector::Y };
    let cd = Paint::from(checker);
    put(&mut scene, wall, Matte { ka: 0.5.into(), kd: 0.8.into(), cd });
    let (ls, color) = (1.5, Rgb::WHITE);
    shine(&mut scene, Ambient { ls, color });
    shine(&mut scene, Directional { ls, color, direction: Vector::new(1.0, 2.0, 3.0) });
    scene
}

/// Law: an image of one colour is the constant of that colour, bit for bit, in every field of every
/// material, nearest and bilinear. Oracle: the picture with the plain colour or number.
/// Book: spatially varying materials and lights.
#[test]
fn an_image_of_one_colour_is_the_constant() {
    let file = image_file([3, 2], |_, _| [0x9a57, 0x3111, 0x5bcd]);
    for filtering in [Filtering::Nearest, Filtering::Bilinear] {
        let image = Image { filtering, ..linear(&file, Some(Mapping::Spherical)) };
        let color = by_uv(&Image { mapping: None, ..image.clone() })([0.5, 0.5]);
        // a field's value, plain or as an image
        let paint = |textured| match textured {
            true => Paint::from(image.clone()),
            false => color.into(),
        };
        let number = |textured| match textured {
            true => Amount::from(image.clone()),
            false => color.r.into(),
        };
        let materials = |textured: bool| -> Vec<Kind> {
            let (color, number) = (|| paint(textured), || number(textured));
            let matte = || Matte { ka: number(), kd: number(), cd: color() };
            let phong = || Phong {
                ka: number(),
                kd: number(),
                cd: color(),
                ks: number(),
                cs: color(),
                exponent: number(),
            };
            let rule = groundtruth::lobes::GlossyRule::Book;
            vec![
                matte().into(),
                phong().into(),
                Emissive { ls: number(), ce: color(), matte: Some(matte()) }.into(),
                Reflective { phong: phong(), kr: number(), cr: color() }.into(),
                GlossyReflector {
                    phong: phong(),
                    kr: number(),
                    cr: color(),
                    exponent: number(),
                    rule,
                }
                .into(),
                Transparent { phong: phong(), kr: number(), cr: color(), kt: number(), eta: 1.5 }
                    .into(),
            ]
        };
        for (plain, textured) in materials(false).into_iter().zip(materials(true)) {
            let what = format!("{filtering:?}, {plain:?}");
            let [plain, textured] = [plain, textured].map(|it| render(&built(&lit(it))));
            assert!(plain.pixels() == textured.pixels(), "another picture with the image: {what}");
        }
    }
}

/// How often nine pixels ask a mesh for its texture coordinates.
fn asked(cd: impl Into<Paint>) -> u32 {
    let counted = Counted::new(square(1.0));
    let mut scene = stage(Rgb::BLACK);
    (scene.image.width, scene.image.height, scene.image.pixel_size) = (3, 3, 0.5);
    let custom = shapes::Kind::Custom(Custom(Arc::<Counted>::clone(&counted)));
    put(&mut scene, custom, Matte { ka: 1.0.into(), kd: 1.0.into(), cd: cd.into() });
    shine(&mut scene, Ambient { ls: 1.0, color: Rgb::WHITE });
    shine(&mut scene, Directional { ls: 1.0, color: Rgb::WHITE, direction: Vector::Z });
    render(&built(&scene));
    counted.asked()
}

/// Law: texture coordinates are computed only for an image that needs those of the surface, once for each
/// hit: not for a plain colour, a solid texture or a mapped image. Oracle: a count over nine pixels.
#[test]
fn only_an_image_without_mapping_asks_for_texture_coordinates() {
    let file = image_file([2, 2], |column, row| [column as u16, row as u16, 9]);
    assert_eq!(asked(Rgb::WHITE), 0, "plain");
    let checker = Checker3d { size: 1.0, color1: Rgb::WHITE.into(), color2: Rgb::BLACK.into() };
    assert_eq!(asked(checker), 0, "solid");
    assert_eq!(asked(linear(&file, Some(Mapping::Spherical))), 0, "mapped");
    assert_eq!(asked(linear(&file, None)), 9, "by the surface's own");
}

/// A texture alone, lit from all sides.
fn shown(shape: impl Into<shapes::Kind>, cd: impl Into<Paint>) -> World {
    let mut scene = stage(Rgb::BLACK);
    put(&mut scene, shape, Matte { ka: 1.0.into(), kd: 0.0.into(), cd: cd.into() });
    shine(&mut scene, Ambient { ls: 1.0, color: Rgb::WHITE });
    built(&scene)
}

/// Law: a mesh's texture coordinates are those given at its corners, and affine between. Oracle: the affine
/// function by hand, at 400 points of two triangles; the texel there by its number.
/// Book: texture coordinates of triangle meshes.
#[test]
fn an_image_lies_on_a_mesh_by_its_corners() {
    const N: u32 = 8;
    let file = image_file([N, N], |column, row| [column as u16, row as u16, 0]);
    let world = shown(square(1.0), linear(&file, None));
    for i in 0..400_u32 {
        let [x, y] = [i % 20, i / 20].map(|k| (f64::from(k) + 0.37) / 10.0 - 1.0);
        let color = look(&world, Point::new(x, y, 5.0), -Vector::Z);
        let expected = [x, y].map(|c| (f64::from(N) * 0.5 * (c + 1.0)) as u32);
        let found = [color.r, color.g].map(|c| (65535.0 * c).round() as u32);
        assert_eq!(found, expected, "column and row at ({x}, {y})");
    }
}

/// Law: turning a textured instance about y by a column's width shifts its image by a column; the texture
/// goes with the object. Oracle: the unturned picture, one column on.
/// Book: spatially varying materials and lights.
#[test]
fn a_turned_globe_shows_the_next_column() {
    const N: u32 = 24;
    let file = image_file([N, 1], |column, _| [column as u16, 0, 0]);
    let degrees = 360.0 / f64::from(N);
    let column_at = |turned: u32, longitude: u32| {
        let turn = vec![
            Step::Scale(Vector::new(2.0, 3.0, 2.0)),
            Step::RotateY(degrees * f64::from(turned)),
        ];
        let cd = linear(&file, Some(Mapping::Spherical));
        let world = shown(Instance::new(UNIT, turn), cd);
        let phi = degrees * (f64::from(longitude) + 0.5);
        let (sin, cos) =
            (groundtruth::math::sin(phi.to_radians()), groundtruth::math::cos(phi.to_radians()));
        let out = Vector::new(sin, 0.1, cos);
        let color = look(&world, Point::ORIGIN + 9.0 * out, -out);
        (65535.0 * color.r).round() as u32
    };
    for longitude in 0..N {
        assert_eq!(column_at(0, longitude), longitude, "unturned");
        assert_eq!(column_at(1, longitude), (longitude + N - 1) % N, "turned by one column");
        assert_eq!(column_at(7, longitude), (longitude + N - 7) % N, "turned by seven");
    }
}

/// Law: a lamp emits the colour of its image at the sampled point, by the coordinates of a mesh or by a
/// mapping, also in an instance. Oracle: Lambert's formula for each half of an image of two colours.
/// Book: spatially varying materials and lights.
#[test]
fn a_lamp_with_an_image_gives_the_light_of_its_parts() {
    const SAMPLES: u32 = 256;
    let colors = [[65535_u16, 6553, 0], [13107, 26214, 65535]];
    let file = image_file([2, 1], |column, _| colors[column as usize]);
    let [left, right] = colors.map(|c| Rgb::from(c.map(|c| f64::from(c) / 65535.0)));
    let spot = Point::new(0.8, 0.0, 0.1);
    let hung = vec![Step::RotateX(90.0), Step::Translate(Vector::new(0.0, 1.2, 0.0))];
    // u runs along x from −1 to 1
    let half = |from: f64, to: f64| {
        let corner = |x: f64, z: f64| Point::new(x, 1.2, z);
        share(
            spot,
            up(),
            &[corner(from, -1.0), corner(to, -1.0), corner(to, 1.0), corner(from, 1.0)],
        )
    };
    let expected = LS * (half(-1.0, 0.0) * left + half(0.0, 1.0) * right);
    let mapped =
        Rectangle { corner: Point::new(-1.0, 0.0, 1.0), a: -2.0 * Vector::Z, b: 2.0 * Vector::X };
    // the square mapping has u along z: a quarter turn takes that to x; then it is turned over
    let turned = vec![
        Step::RotateY(90.0),
        Step::Reflect(groundtruth::math::Axis::Y),
        Step::Translate(Vector::new(0.0, 1.2, 0.0)),
    ];
    let lamps: [(shapes::Kind, Option<Mapping>); 2] = [
        (Instance::new(square(1.0), hung).into(), None),
        (Instance::new(mapped, turned).into(), Some(Mapping::Square)),
    ];
    for (shape, mapping) in lamps {
        let mut scene = floor(up());
        let lamp = hang(&mut scene, shape, Some(Sampling::Area));
        scene.materials[lamp].two_sided = true;
        scene.materials[lamp].recipe = Emissive::new(LS, linear(&file, mapping)).into();
        let values = seen(&scene, SAMPLES, spot, up());
        assert_color(&format!("{mapping:?}"), &values, expected, 2, 0.02);
    }
}

/// Law: the explanation of a hit names each textured field with its colour, texel and coordinates, also those
/// of a base material and of an image within another texture. Oracle: the texel in the centre of the image,
/// by its column and row.
#[test]
fn the_explanation_shows_field_texel_and_colour() {
    let file = image_file([9, 5], |column, row| [column as u16, row as u16, 0]);
    let image = linear(&file, None);
    // the middle is in the cube (−1, −1, −1), which has the second colour
    let checker = Checker3d { size: 9.0, color1: Rgb::WHITE.into(), color2: image.clone().into() };
    let phong = Phong { kd: 0.5.into(), cd: checker.into(), ..Phong::default() };
    let mut scene = deep_stage(Rgb::BLACK, 2);
    put(&mut scene, square(1.0), Reflective { phong, kr: image.into(), cr: Rgb::WHITE.into() });
    let explained = explain::sample(&scene, &built(&scene), [0, 0], 0);
    let ray = explained.ray.expect("the camera's ray");
    let hit = ray.hit.as_ref().expect("the square is hit");
    let texel = hit.textures.iter().map(|it| {
        let texel = it.texel.expect("an image");
        (it.field.as_str(), [texel.column, texel.row], texel.uv, (65535.0 * it.color.r).round())
    });
    let expected = [("kr", [4, 2], [0.5; 2], 4.0), ("phong.cd", [4, 2], [0.5; 2], 4.0)];
    assert_eq!(texel.collect::<Vec<_>>(), expected);
}
