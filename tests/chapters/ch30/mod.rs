//! Chapter 30: procedural textures.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | listing 30.2, the solid checker | the solid checker has two colours, by the parity of the cell; the cell at the origin has the first | `the_solid_checker_shows_the_parity_of_its_cell` |
//! |  | along an axis from −10 to 10 every run of one colour of the solid checker is one size long: none is doubled at the origin | `runs_of_colour_are_one_size_long_on_both_sides_of_the_origin` |
//! |  | the plane y = 0, which lies on borders of the solid checker, has no speckle: each square is of one colour, and so are the faces of a box on borders | `a_plane_on_the_borders_of_the_checker_has_no_speckle` |
//! |  | each face of a box whose sides lie on borders of the solid checker is a clean checker | `faces_of_a_box_on_borders_have_no_speckle` |
//! | two-dimensional checkers with outlines | the plane checker shows line, first or second colour by the distance to the nearest border and the parity of the square; y does not matter | `the_plane_checker_has_squares_and_lines` |
//! |  | at a share s of column i and t of row j a checker shows the line if s or t is within half the line's width of 0 or 1 (vertical lines border columns, horizontal ones rows), and else the first colour if i + j is even; also in negative rows, and for any unit | `checkers::checkers_show_cells_and_lines` |
//! |  | a point just before the seam is in the last column, however close it is, and the poles are in the first and the last row: no point belongs to a checker that does not exist | `checkers::seam_and_poles_belong_to_checkers_that_are_there` |
//! |  | with the defaults a checker of a sphere, cylinder, cone, disk or rectangle has the book's 20 checkers in one direction and 10 in the other; white and half grey, without lines | `checkers::the_defaults_are_the_books` |
//! |  | around an object of an even number of columns the colours alternate, the seam included; of an odd number one pair of equal neighbours is left, at the seam | `checkers::an_odd_number_of_columns_leaves_two_equal_neighbours_at_the_seam` |
//! | exercise 30.4, textures and materials for each checker of a sphere | of the textures of a sphere, the checker in column i and row j has number `j n_h + i`, modulo the length of the list; lines lie over all | `checkers::each_checker_of_a_sphere_has_its_texture` |
//! |  | where the checker in column i and row j is seen, a ball looks like one of that checker's material alone, which has number `j n_h + i`, modulo the length of the list; bit for bit, with lights, mirrors and textures, and on an instance | `materials::each_checker_of_a_sphere_has_its_material` |
//! | intrinsic transformations: texture instances | without steps, or with steps that do nothing, a texture instance is the texture itself, bit for bit | `instances::an_identical_instance_is_the_texture` |
//! |  | a texture instance of f has `g(p) = f(M⁻¹ p)`: scaled by s, f(p/s) component-wise; moved by t, f(p − t); turned and sheared likewise | `instances::each_step_is_undone` |
//! |  | the step of a texture instance that is applied last is outermost, whether the steps are in one list or in nested instances | `instances::the_last_step_is_outermost` |
//! | extrinsic transformations: textures of instances | an instance carries its texture with it: it looks like the plain shape seen by an eye that is moved back | `an_instance_carries_its_texture` |
//! |  | an object with `transform_texture = false` moves through its texture, which stays fixed in the world: the texture is evaluated at the world point, whatever the object's transformation is; inside another instance it stays fixed in that one's coordinates | `instances::a_texture_stays_in_the_world_while_the_object_moves` |
//! | fig. 30.11, a stretched box with an unstretched checker | a box stretched twofold along x, with its texture halved along x, has the checker of an unstretched one | `instances::a_texture_instance_undoes_the_stretch_of_its_object` |
//!
//! Beyond the book: 1 in this file, 1 in `checkers`, 1 in `instances`, 1 in `lamps`, 3 in `layers`, 2 in `materials`, 2 in `wires`.

mod checkers;
mod instances;
mod lamps;
mod layers;
mod materials;
mod wires;

use groundtruth::kinds::Resources;
use groundtruth::render::pixel;
use groundtruth::textures::{Checker3d, Kind as Texture, PlaneChecker};
use testkit::properties::*;

use crate::prelude::*;
use crate::support::stage::*;

const ONE: Rgb = Rgb::new(1.0, 0.75, 0.5);
const TWO: Rgb = Rgb::new(0.0, 0.25, 0.5);
const LINE: Rgb = Rgb::new(0.0, 1.0, 0.0);

/// The checker's offset, as a fraction of its size: nearer to a border than this, the colour of the
/// neighbouring cell is correct.
const OFFSET: f64 = 2e-4;

fn solid(size: f64) -> Texture {
    Checker3d { size, color1: ONE.into(), color2: TWO.into() }.into()
}

fn flat(size: f64, outline_width: f64) -> Texture {
    PlaneChecker {
        size,
        color1: ONE.into(),
        color2: TWO.into(),
        outline_width,
        outline_color: LINE.into(),
    }
    .into()
}

/// The colour at a local point; the position in the world must not matter.
fn at(texture: &Texture, local: Point) -> Rgb {
    let surface = Surface { local, ..Surface::new(Point::new(7.7, 8.8, 9.9), 0.0, Normal::Y) };
    texture
        .build(&mut Resources::default())
        .expect("the texture is valid")
        .color(&TexturePoint::new(&surface))
}

fn other(color: Rgb) -> Rgb {
    if color == ONE { TWO } else { ONE }
}

/// Whether each coordinate, in checkers, is farther from all borders than the offset.
fn clear_of_borders(p: Point, size: f64) -> bool {
    p.to_array().into_iter().all(|x| {
        let fraction = (x / size).rem_euclid(1.0);
        (OFFSET..1.0 - OFFSET).contains(&fraction)
    })
}

/// Whether the cell of a point is even: the number of borders between it and the first cell, crossed
/// one by one.
fn even(coordinates: &[f64], size: f64) -> bool {
    let crossed = |x: f64| {
        let mut borders = 0_u32;
        let mut edge = if x < 0.0 { 0.0 } else { size };
        while if x < 0.0 { x < edge } else { x >= edge } {
            borders += 1;
            edge += if x < 0.0 { -size } else { size };
        }
        borders
    };
    coordinates.iter().map(|&x| crossed(x)).sum::<u32>().is_multiple_of(2)
}

fn painted(scene: &mut Scene, shape: impl Into<Kind>, texture: Texture) {
    put(scene, shape, Matte { ka: 1.0.into(), kd: 0.0.into(), cd: Paint::from(texture) });
}

/// A stage in ambient light of strength 1: pictures show the texture's colour itself.
fn gallery() -> Scene {
    let mut scene = stage(Rgb::BLACK);
    shine(&mut scene, Ambient { ls: 1.0, color: Rgb::WHITE });
    scene
}

proptest! {
    #![proptest_config(laws())]

    /// Law: the solid checker has two colours, by the parity of the cell; the cell at the origin has the
    /// first. Oracle: borders counted one by one outward, so negative cells are like the others.
    /// Book: listing 30.2, the solid checker.
    #[test]
    fn the_solid_checker_shows_the_parity_of_its_cell(p in point(10.0), size in 0.1..3.0_f64) {
        prop_assume!(clear_of_borders(p, size));
        let expected = if even(&p.to_array(), size) { ONE } else { TWO };
        prop_assert_eq!(at(&solid(size), p), expected);
    }

    /// Law: the plane checker shows line, first or second colour by the distance to the nearest border
    /// and the parity of the square; y does not matter. Oracle: borders counted one by one, and the
    /// distance to the nearest multiple of the size.
    /// Book: two-dimensional checkers with outlines.
    #[test]
    fn the_plane_checker_has_squares_and_lines(
        p in point(10.0),
        size in 0.1..3.0_f64,
        share in 0.0..1.0_f64,
    ) {
        let width = share * size;
        let from_border = |x: f64| (x - size * (x / size).round()).abs();
        let nearest = from_border(p.x()).min(from_border(p.z()));
        prop_assume!((nearest - 0.5 * width).abs() > 1e-9 && nearest > 1e-9);
        let expected = match nearest < 0.5 * width {
            true => LINE,
            false if even(&[p.x(), p.z()], size) => ONE,
            false => TWO,
        };
        let texture = flat(size, width);
        prop_assert_eq!(at(&texture, p), expected);
        prop_assert_eq!(at(&texture, p.with(1, 123.0)), expected);
        // the mirror image of a line is a line; that of a square has the other colour
        let mirrored = if expected == LINE { LINE } else { other(expected) };
        prop_assert_eq!(at(&texture, p.with(0, -p.x())), mirrored);
    }

    /// Law: an instance carries its texture with it: it looks like the plain shape seen by an eye that is
    /// moved back. Oracle: rotation, scaling and shift applied by hand (ch. 30: textures are evaluated in the
    /// innermost coordinates).
    /// Book: extrinsic transformations: textures of instances.
    #[test]
    fn an_instance_carries_its_texture(eye in unit(), target in point(0.5), by in point(3.0)) {
        let turned = |v: Vector| Vector::new(v.z(), v.y(), -v.x());
        let mut scene = gallery();
        let ball = Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
        painted(&mut scene, ball, solid(0.3));
        let from = Point::ORIGIN + 3.0 * eye;
        let plain = look(&built(&scene), from, target - from);
        let transform = vec![
            Step::RotateY(90.0),
            Step::Scale(Vector::new(2.0, 2.0, 2.0)),
            Step::Translate(by.to_vector()),
        ];
        let nested = Instance::new(scene.objects[0].shape.clone(), transform);
        scene.objects[0].shape = nested.into();
        let outer = |p: Point| by + 2.0 * turned(p.to_vector());
        let seen = look(&built(&scene), outer(from), outer(target) - outer(from));
        prop_assert!(seen == plain, "{seen:?} {plain:?}");
    }

    /// Law: ambient and diffuse light use the same colour of a texture. Oracle: the plain colours.
    #[test]
    fn a_texture_colours_each_term(p in point(5.0)) {
        let seen = |cd: Paint| {
            let mut scene = gallery();
            let floor = Plane { point: Point::ORIGIN, normal: Vector::Y };
            put(&mut scene, floor, Matte { ka: 0.5.into(), kd: 0.5.into(), cd });
            let sun = groundtruth::lights::Directional {
                ls: 2.0, color: Rgb::new(1.0, 0.5, 0.25), direction: Vector::new(1.0, 1.0, 0.0),
            };
            shine(&mut scene, sun);
            look(&built(&scene), p.with(1, 1.0), -Vector::Y)
        };
        let textured = seen(Paint::from(solid(1.0)));
        let expected = if at(&solid(1.0), p.with(1, 0.0)) == ONE { ONE } else { TWO };
        prop_assert_eq!(textured, seen(expected.into()));
    }
}

/// Law: along an axis from −10 to 10 every run of one colour of the solid checker is one size long: none
/// is doubled at the origin. Oracle: the changes, found by scanning.
/// Book: listing 30.2, the solid checker.
#[test]
fn runs_of_colour_are_one_size_long_on_both_sides_of_the_origin() {
    // the plane checker does not depend on y
    let in_space = &[0, 1, 2][..];
    for (texture, size, axes) in [
        (solid(0.75), 0.75, in_space),
        (flat(0.75, 0.0), 0.75, &[0, 2]),
        (solid(1.0), 1.0, in_space),
    ] {
        for &axis in axes {
            let line = |i: i32| Point::new(0.3, 0.3, 0.3).with(axis, f64::from(i) / 256.0);
            let changes: Vec<i32> = (-2560..2560)
                .filter(|&i| at(&texture, line(i)) != at(&texture, line(i + 1)))
                .collect();
            assert!(changes.len() >= 19, "{changes:?}");
            for pair in changes.windows(2) {
                // borders are on the grid of the scan; the offset moves each by the same sliver
                assert_eq!(f64::from(pair[1] - pair[0]) / 256.0, size);
            }
        }
    }
}

/// Law: the plane y = 0, which lies on borders of the solid checker, has no speckle: each square is of
/// one colour, and so are the faces of a box on borders. Oracle: the squares' parity, in each pixel of
/// pictures from straight above and at an angle.
/// Book: listing 30.2, the solid checker.
#[test]
fn a_plane_on_the_borders_of_the_checker_has_no_speckle() {
    for eye in [Point::new(0.0, 10.0, 0.0), Point::new(3.0, 7.0, 5.0)] {
        let mut scene = gallery();
        painted(&mut scene, Plane { point: Point::ORIGIN, normal: Vector::Y }, solid(1.0));
        scene.camera.eye = eye;
        (scene.image.width, scene.image.height, scene.image.pixel_size) = (120, 120, 0.0501);
        let world = built(&scene);
        // y = 0 is beneath the first layer: the other colour throughout
        let (mut seen, mut checked) = ([0; 2], 0);
        for i in 0..120 * 120 {
            let (ray, _) = camera_ray(&world, [i % 120, i / 120], 0);
            let p = ray.at(-ray.origin.y() / ray.direction.y());
            if clear_of_borders(p.with(1, 0.5), 1.0) {
                let expected = if even(&[p.x(), p.z()], 1.0) { TWO } else { ONE };
                assert_eq!(pixel(&world, [i % 120, i / 120]), expected, "{p:?}");
                seen[usize::from(expected == ONE)] += 1;
                checked += 1;
            }
        }
        assert!(checked > 14_000 && seen[0] > 5000 && seen[1] > 5000, "{seen:?}");
    }
}

/// Law: each face of a box whose sides lie on borders of the solid checker is a clean checker. Oracle: in
/// each square of a face all points seen have one colour, and its neighbour the other.
/// Book: listing 30.2, the solid checker.
#[test]
fn faces_of_a_box_on_borders_have_no_speckle() {
    let mut scene = gallery();
    let block = Cuboid { min: Point::new(-1.0, -1.0, -1.0), max: Point::new(1.0, 1.0, 1.0) };
    painted(&mut scene, block, solid(0.5));
    let (world, mut random) = (built(&scene), Pcg32::new(30, 1));
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            let across = |p: Point| [p.along((axis + 1) % 3), p.along((axis + 2) % 3)];
            let mut first = None;
            for _ in 0..500 {
                let mut c = || 2.0 * random.uniform() - 1.0;
                let (spot, lean) = (Point::new(c(), c(), c()).with(axis, side), [c(), c(), c()]);
                let eye = (spot + Vector::from(lean)).with(axis, 3.0 * side);
                if !across(spot)
                    .into_iter()
                    .all(|x| (OFFSET..1.0 - OFFSET).contains(&(2.0 * x).rem_euclid(1.0)))
                {
                    continue;
                }
                let seen = look(&world, eye, spot - eye);
                let of_even = if even(&across(spot), 0.5) { seen } else { other(seen) };
                assert_eq!(*first.get_or_insert(of_even), of_even, "{spot:?}");
            }
        }
    }
}
