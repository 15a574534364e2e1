//! Checkers on curved and on flat shapes: cells, lines, seams and poles.

use groundtruth::textures::{
    ConeChecker, CylinderChecker, DiskChecker, Lines, RectangleChecker, SphereChecker,
    SphereTextures,
};

use super::*;
use crate::prelude::*;

/// The least distance of a point from a border, as a share of a checker, at which rounding of angles does not
/// matter.
const CLEAR: f64 = 1e-9;

fn lines([horizontal, vertical]: [f64; 2]) -> Lines {
    Lines { horizontal, vertical, color: LINE.into() }
}

/// A point of a unit sphere.
fn on_sphere(phi: f64, theta: f64) -> Point {
    Point::new(sin(theta) * sin(phi), cos(theta), sin(theta) * cos(phi))
}

/// The generic shapes that have checkers.
#[derive(Clone, Copy, Debug)]
enum Generic {
    Sphere,
    Cylinder,
    Cone,
    Disk,
    Rectangle,
}

use Generic::{Cone, Cylinder, Disk, Rectangle, Sphere};

const ALL: [Generic; 5] = [Sphere, Cylinder, Cone, Disk, Rectangle];

impl Generic {
    /// The checker with so many columns and rows, on a shape of size `unit`.
    fn checker(self, [columns, rows]: [u32; 2], unit: f64, widths: [f64; 2]) -> Texture {
        let (color1, color2, lines) = (ONE.into(), TWO.into(), lines(widths));
        let (num_horizontal, num_vertical) = (columns, rows);
        match self {
            Sphere => SphereChecker { num_horizontal, num_vertical, color1, color2, lines }.into(),
            Cylinder => {
                CylinderChecker { unit, num_horizontal, num_vertical, color1, color2, lines }.into()
            }
            Cone => {
                ConeChecker { unit, num_horizontal, num_vertical, color1, color2, lines }.into()
            }
            Disk => {
                let (num_angular, num_radial) = (columns, rows);
                DiskChecker { unit, num_angular, num_radial, color1, color2, lines }.into()
            }
            Rectangle => {
                RectangleChecker { unit, num_horizontal, num_vertical, color1, color2, lines }
                    .into()
            }
        }
    }

    /// The point at shares s and t of the columns and rows, from 0 to 1 on the generic shape: the
    /// parametrisation that the texture inverts.
    fn point(self, s: f64, t: f64) -> Point {
        let phi = TAU * s;
        let around = |rho: f64, y: f64| Point::new(rho * sin(phi), y, rho * cos(phi));
        match self {
            Sphere => on_sphere(phi, PI * t),
            Cylinder => around(1.0, 2.0 * t - 1.0),
            Cone => around(1.0 - t, 2.0 * t),
            Disk => around(t, 0.0),
            Rectangle => Point::new(2.0 * s - 1.0, 0.0, 2.0 * t - 1.0),
        }
    }

    /// The rows that may be tested, of n on the generic shape: cylinders and rectangles continue in both
    /// directions.
    fn rows(self, n: u32) -> std::ops::Range<i64> {
        match self {
            Cylinder | Rectangle => -30..30,
            Sphere | Disk | Cone => 0..i64::from(n),
        }
    }
}

proptest! {
    #![proptest_config(laws())]

    /// Law: at a share s of column i and t of row j a checker shows the line if s or t is within half the
    /// line's width of 0 or 1 (vertical lines border columns, horizontal ones rows), and else the first
    /// colour if i + j is even; also in negative rows, and for any unit. Oracle: the parametrisation of each
    /// shape, which gives the point for i, j, s and t with sines and cosines.
    /// Book: two-dimensional checkers with outlines.
    #[test]
    fn checkers_show_cells_and_lines(
        which in 0..5_usize,
        (columns, rows) in (1..30_u32, 1..30_u32),
        (i, j) in (any::<prop::sample::Index>(), any::<prop::sample::Index>()),
        (s, t) in (0.0..1.0_f64, 0.0..1.0_f64),
        widths in prop_oneof![Just([0.0; 2]), [0.0..1.0_f64, 0.0..1.0_f64]],
        unit in prop_oneof![Just(1.0), 1e-3..1e3_f64],
    ) {
        let generic = ALL[which];
        let range = generic.rows(rows);
        let j = range.start + j.index((range.end - range.start) as usize) as i64;
        let i = i.index(columns as usize) as i64;
        let [half_h, half_v] = widths.map(|width| 0.5 * width);
        let to_border = |x: f64| x.min(1.0 - x);
        let clear = |x: f64, half: f64| to_border(x) > CLEAR && (to_border(x) - half).abs() > CLEAR;
        prop_assume!(clear(s, half_v) && clear(t, half_h));
        let expected = match to_border(s) < half_v || to_border(t) < half_h {
            true => LINE,
            false if (i + j) % 2 == 0 => ONE,
            false => TWO,
        };
        let share = |i: i64, s: f64, n: u32| (i as f64 + s) / f64::from(n);
        let point = generic.point(share(i, s, columns), share(j, t, rows));
        let found = at(&generic.checker([columns, rows], unit, widths), point.scaled(unit));
        prop_assert!(
            found == expected,
            "{generic:?} of {columns} × {rows}, cell {i}, {j} at {s}, {t}: {found:?}, expected {expected:?}"
        );
    }

    /// Law: a checker of a sphere is the same on spheres of all sizes, that of a disk or a rectangle at all
    /// heights, and that of a cylinder or a cone at all radii. Oracle: the colour at the original point.
    #[test]
    fn what_does_not_matter_does_not_matter(
        (s, t) in (0.0..1.0_f64, 0.0..1.0_f64),
        k in -100.0..100.0_f64,
    ) {
        let clear = |x: f64| (0.01..0.99).contains(&(12.0 * x).rem_euclid(1.0));
        prop_assume!(clear(s) && clear(t));
        let factor = groundtruth::math::power(2.0, k.abs() / 4.0);
        for generic in ALL {
            let checker = generic.checker([12, 12], 1.0, [0.01; 2]);
            let p = generic.point(s, t);
            let moved = match generic {
                Sphere => p.scaled(factor),
                Cylinder => Point::new(factor * p.x(), p.y(), factor * p.z()),
                Cone => Point::new(factor * p.x(), p.y(), factor * p.z()),
                Disk | Rectangle => p.with(1, k),
            };
            prop_assert_eq!(at(&checker, moved), at(&checker, p), "{:?}", generic);
        }
    }

    /// Law: of the textures of a sphere, the checker in column i and row j has number `j n_h + i`, modulo the
    /// length of the list; lines lie over all. Oracle: the parametrisation of the sphere.
    /// Book: exercise 30.4, textures and materials for each checker of a sphere.
    #[test]
    fn each_checker_of_a_sphere_has_its_texture(
        (columns, rows) in (1..12_u32, 1..12_u32),
        length in any::<prop::sample::Index>(),
        (i, j) in (any::<prop::sample::Index>(), any::<prop::sample::Index>()),
        (s, t) in (0.01..0.99_f64, 0.01..0.99_f64),
    ) {
        let length = 1 + length.index((columns * rows) as usize);
        let (i, j) = (i.index(columns as usize), j.index(rows as usize));
        let texture = numbered([columns, rows], length, [0.1, 0.3]);
        let share = |i: usize, s: f64, n: u32| (i as f64 + s) / f64::from(n);
        let p = Sphere.point(share(i, s, columns), share(j, t, rows));
        let on_line = !(0.15..0.85).contains(&s) || !(0.05..0.95).contains(&t);
        prop_assume!([s - 0.15, s - 0.85, t - 0.05, t - 0.95].iter().all(|x| x.abs() > CLEAR));
        let turn = (j * columns as usize + i) % length;
        let expected = if on_line { LINE } else { Rgb::grey(turn as f64 / 1024.0) };
        prop_assert_eq!(at(&texture, p), expected, "column {}, row {}, {} textures", i, j, length);
    }
}

/// Textures of a sphere in greys that encode their number.
fn numbered([num_horizontal, num_vertical]: [u32; 2], length: usize, widths: [f64; 2]) -> Texture {
    let textures = (0..length).map(|n| Rgb::grey(n as f64 / 1024.0).into()).collect();
    SphereTextures { num_horizontal, num_vertical, textures, lines: lines(widths) }.into()
}

/// Law: a point just before the seam is in the last column, however close it is, and the poles are in the
/// first and the last row: no point belongs to a checker that does not exist. Oracle: one grey for each
/// checker, read back.
/// Book: two-dimensional checkers with outlines.
#[test]
fn seam_and_poles_belong_to_checkers_that_are_there() {
    for columns in 1..25_u32 {
        for rows in 1..12_u32 {
            let number = (columns * rows) as usize;
            let texture = numbered([columns, rows], number, [0.0; 2]);
            let cell = |p: Point| (1024.0 * at(&texture, p).r) as u32;
            let equator = |x: f64, z: f64| cell(Point::new(x, 0.3, z)) % columns;
            for beside in [1e-300, 1e-20, 1e-17, 3e-16, 1e-12] {
                assert_eq!(
                    equator(-beside, 1.0),
                    columns - 1,
                    "{columns} columns, {beside} before +z"
                );
                assert_eq!(equator(beside, 1.0), 0, "{columns} columns, {beside} past +z");
            }
            assert_eq!(equator(0.0, 1.0), 0, "the +z axis is in the first of {columns} columns");
            for tilt in [0.0, 1e-300, -1e-17, 1e-9] {
                let [north, south] =
                    [1.0, -1.0].map(|y| cell(Point::new(tilt, y, -tilt)) / columns);
                assert_eq!([north, south], [0, rows - 1], "poles of {rows} rows, tilt {tilt}");
            }
        }
    }
    // a line covers the poles, a vertical one the seam on both sides
    let outlined = Sphere.checker([20, 10], 1.0, [0.1, 0.1]);
    for p in
        [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [1e-9, 0.3, 1.0], [-1e-9, 0.3, 1.0], [0.0, 0.3, 1.0]]
    {
        assert_eq!(at(&outlined, Point::from(p)), LINE, "{p:?}");
    }
}

/// Law: with the defaults a checker of a sphere, cylinder, cone, disk or rectangle has the book's 20
/// checkers in one direction and 10 in the other; white and half grey, without lines. Oracle: changes of
/// colour counted along a circle and a meridian, or along both sides.
/// Book: two-dimensional checkers with outlines.
#[test]
fn the_defaults_are_the_books() {
    let defaults: [Texture; 5] = [
        SphereChecker::default().into(),
        CylinderChecker::default().into(),
        ConeChecker::default().into(),
        DiskChecker::default().into(),
        RectangleChecker::default().into(),
    ];
    for (generic, texture) in ALL.into_iter().zip(defaults) {
        let changes = |point: &dyn Fn(f64) -> Point| {
            let colors: Vec<Rgb> =
                (0..500).map(|i| at(&texture, point((f64::from(i) + 0.5) / 500.0))).collect();
            assert!(
                colors.iter().all(|&c| [Rgb::WHITE, Rgb::grey(0.5)].contains(&c)),
                "{colors:?}"
            );
            colors.windows(2).filter(|pair| pair[0] != pair[1]).count()
        };
        assert_eq!(changes(&|s| generic.point(s, 0.63)), 19, "{generic:?}: borders of columns");
        assert_eq!(changes(&|t| generic.point(0.63, t)), 9, "{generic:?}: borders of rows");
        assert_eq!(at(&texture, generic.point(0.02, 0.03)), Rgb::WHITE, "{generic:?}: first");
    }
}

/// Law: around an object of an even number of columns the colours alternate, the seam included; of an odd number one pair
/// of equal neighbours is left, at the seam. Oracle: counting changes of colour.
/// Book: two-dimensional checkers with outlines.
#[test]
fn an_odd_number_of_columns_leaves_two_equal_neighbours_at_the_seam() {
    for (generic, n) in
        [Sphere, Cylinder, Cone, Disk].map(|it| (1..25).map(move |n| (it, n))).into_iter().flatten()
    {
        let checker = generic.checker([n, 7], 1.0, [0.0; 2]);
        let middle =
            |i: u32| at(&checker, generic.point((f64::from(i % n) + 0.5) / f64::from(n), 0.6));
        let changes: Vec<u32> = (0..n).filter(|&i| middle(i) != middle(i + 1)).collect();
        assert_eq!(changes, (0..n - n % 2).collect::<Vec<_>>(), "{generic:?}: {n} columns");
    }
}
