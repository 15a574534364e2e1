//! The printed random numbers, and the drawn images.

use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};

use exchange::describe;
use groundtruth::images::{Drawn, Picture};
use groundtruth::kinds::Resources;
use groundtruth::math::{Normal, Point, Ray, Span, Vector, atan2, cos, power, sin};
use groundtruth::scene;
use groundtruth::shapes::{RandomSpheres, Surface};
use groundtruth::textures::{Image, Mapping, RandomColors, Specification, TexturePoint};
use groundtruth::world::World;

use super::formulas::{assert_says, line_of};
use super::truth::{V, add, dot, largest_difference, times};

/// The printed generator, written out here.
struct Generator(u64);

impl Generator {
    fn new(seed: u64) -> Self {
        let mut it = Self(0);
        it.step();
        it.0 = it.0.wrapping_add(seed);
        it.step();
        it
    }

    fn step(&mut self) -> u64 {
        let x = (((self.0 >> 18) ^ self.0) >> 27) as u32;
        let bits = x.rotate_right((self.0 >> 59) as u32);
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        u64::from(bits)
    }

    fn number(&mut self) -> f64 {
        let (a, b) = (self.step(), self.step());
        (((a << 32) | b) >> 11) as f64 / power(2.0, 53.0)
    }
}

/// The printed hash, written out here.
fn hash(words: &[u64]) -> u64 {
    let mix = |x: u64| {
        let z = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    };
    words.iter().fold(0, |h, word| mix(mix(h) ^ word))
}

/// Law: the printed generator places the random spheres. Oracle: the printed steps, written out here.
#[test]
fn the_printed_generator_places_the_spheres() {
    let text = line_of("ch22/thousand-spheres");
    for formula in [
        "half_side · [2 u1 - 1, 2 u2 - 1, 2 u3 - 1]",
        "state = 0 and one step, then state += seed and one step",
        "x = ((state >> 18) ^ state) >> 27 as 32 bits, rotated to the right by state >> 59; the new state is state · \
         6364136223846793005 + 1, modulo 2^64",
        "((a · 2^32 + b) >> 11) / 2^53",
    ] {
        assert_says(&text, formula);
    }
    let spheres = RandomSpheres { count: 20, radius: 0.1, half_side: 1.5, seed: 15, accel: None };
    let mut generator = Generator::new(15);
    for sphere in spheres.spheres() {
        let expected = [0; 3].map(|_| 1.5 * (2.0 * generator.number() - 1.0));
        assert_eq!(sphere.center.to_array(), expected);
    }
}

/// Spheres in a compound and in a lattice, in a row along x; the first of them is no sphere of the row.
const ROW: &str = r#"
image = { width = 1, height = 1 }
camera = { eye = [0, 0, 9], lens = { pinhole = { distance = 1 } } }
materials = [{ name = "m", recipe.matte = { ka = 1, cd = { random_colors = { seed = 7 } } } }]
[[objects]]
name = "row"
material = "m"
[objects.shape.compound]
parts = [
    { shape.box = { min = [-1, -1, -1], max = [1, 1, 1] } },
    { shape.lattice = { of.sphere = { center = [10, 0, 0], radius = 1 }, counts = [2, 2, 2], spacing = [10, 5, 40] } },
    { shape.sphere = { center = [30, 0, 0], radius = 1 } },
]
"#;

/// Law: the printed hash and numbering give the random colours. Oracle: the numbers of the shapes by hand.
#[test]
fn the_printed_hash_chooses_the_random_colours() {
    let text = line_of("ch22/thousand-spheres");
    for formula in [
        "h = mix(mix(h) ^ word)",
        "z = x + 0x9e3779b97f4a7c15; z = (z ^ (z >> 30)) · 0xbf58476d1ce4e5b9; z = (z ^ (z >> 27)) · \
         0x94d049bb133111eb; mix = z ^ (z >> 31)",
        "the first three numbers of the generator (see Random numbers) with the seed hash(seed, n)",
        "of a lattice those of the copy (0, 0, 0), then of (1, 0, 0) …",
    ] {
        assert_says(&text, formula);
    }
    let (scene, source) = scene::parse(ROW.to_owned(), "".as_ref()).expect("it is a scene");
    let world = World::of_source(&scene, &source, 1).expect("it is valid");
    let texture = RandomColors { seed: 7 }.build(&mut Resources::default()).expect("it is valid");
    for ([x, y, z], number) in [
        ([0.0, 0.0, 0.0], 0),
        ([10.0, 0.0, 0.0], 1),
        ([20.0, 0.0, 0.0], 2),
        ([10.0, 5.0, 0.0], 3),
        ([20.0, 5.0, 0.0], 4),
        ([10.0, 0.0, 40.0], 5),
        ([20.0, 5.0, 40.0], 8),
        ([30.0, 0.0, 0.0], 9),
    ] {
        let ray = Ray::new(Point::new(x, y, z + 9.0), -Vector::Z);
        let hit = world.hit(&ray, Span::AHEAD).expect("there is a shape");
        let mut generator = Generator::new(hash(&[7, number]));
        let expected = [0; 3].map(|_| generator.number());
        assert_eq!(texture.color(&hit.texture_point()).to_array(), expected, "{number}");
    }
}

/// The direction of an azimuth from +z towards +x and an angle to +y.
fn direction(azimuth: f64, angle: f64) -> V {
    [sin(angle) * sin(azimuth), cos(angle), sin(angle) * cos(azimuth)]
}

fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

fn is_even(number: f64) -> bool {
    number.rem_euclid(2.0) == 0.0
}

fn is_within([from, to]: [f64; 2], number: f64) -> bool {
    (from..to).contains(&number)
}

fn globe(u: f64, v: f64) -> V {
    let d = direction(TAU * u, PI * (1.0 - v));
    let mut generator = Generator::new(29);
    let mut h = 0.0;
    for i in 0..24 {
        let f = 2.0 + f64::from(i) / 2.0;
        let r = [0; 4].map(|_| 2.0 * generator.number() - 1.0);
        h += cos(f * dot([r[0], r[1], r[2]], d) + TAU * r[3]) / f;
    }
    let l = 2.0 * (v - 0.5).abs();
    if l + h / 10.0 > 0.87 {
        [0.85, 0.9, 0.95]
    } else if h < 0.15 {
        [0.02, 0.08, 0.25 + 0.1 * h.max(-1.0)]
    } else if h < 0.25 {
        [0.6, 0.5, 0.25]
    } else if l < 0.3 {
        [0.35, 0.3, 0.1]
    } else {
        [0.08, 0.25, 0.06]
    }
}

fn lace(u: f64, v: f64) -> V {
    let [x, y] = [u, v].map(|t| 2.0 * (4.0 * t - (4.0 * t).floor()) - 1.0);
    let (r, phi) = (length(x, y), atan2(y, x));
    let is_thread = r < 0.1
        || (r - 0.92).abs() < 0.05
        || (r - 0.6 - 0.18 * cos(8.0 * phi)).abs() < 0.05
        || (r - 0.3 - 0.08 * cos(4.0 * phi)).abs() < 0.04
        || r > 0.92 && (x.abs() - y.abs()).abs() < 0.06
        || r > 0.3 && r < 0.92 && (r * sin(8.0 * phi)).abs() < 0.04;
    if is_thread { [0.9, 0.87, 0.78] } else { [0.1, 0.04, 0.14] }
}

fn country(u: f64, v: f64) -> V {
    let h = |n: f64, p: f64| sin(TAU * (n * u + p)) + 0.4 * sin(TAU * (3.0 * n * u - p));
    let c = (24.0 * u).floor();
    let t = 0.1 + 0.01 * (hash(&[c as u64]) % 8) as f64;
    let (x, y) = ((2.0 * (24.0 * u - c) - 1.0) / 0.8, (v - 0.3 - t / 2.0) / t);
    if v > 0.22 && x * x + y * y < 0.6 {
        [0.03, 0.13, 0.03]
    } else if v < 0.25 + 0.02 * h(3.0, 0.1) {
        let even = is_even((30.0 * u + 20.0 * v * v).floor());
        if even { [0.45, 0.4, 0.08] } else { [0.2, 0.35, 0.06] }
    } else if v < 0.42 + 0.04 * h(2.0, 0.4) {
        [0.15, 0.3, 0.1]
    } else if v < 0.55 + 0.06 * h(4.0, 0.7) {
        [0.25, 0.35, 0.35]
    } else {
        let low = times(2.0 * (1.0 - v), [-0.1, -0.05, 0.0]);
        add(add([0.9, 0.95, 1.0], low), times(v - 0.5, [-1.0, -0.7, -0.1]))
    }
}

fn billiard_ball(u: f64, v: f64) -> V {
    let [x, y, z] = direction(TAU * u, PI * (1.0 - v));
    let x = if z < 0.0 { -x } else { x };
    let is_spot = length(x, y) < 0.42
        && (length(x, y - 0.125) - 0.1).abs() >= 0.035
        && (length(x, y + 0.115) - 0.13).abs() >= 0.035;
    if is_spot { [0.85, 0.82, 0.72] } else { [0.03; 3] }
}

fn sky_dome(u: f64, v: f64) -> V {
    let d = direction(TAU * u, PI / 2.0 * (1.0 - v));
    let off = add(d, times(-1.0, direction(PI / 4.0, PI / 4.0)));
    let o = dot(off, off).sqrt();
    if o < 0.028 {
        return times(1500.0, [1.0, 0.9, 0.7]);
    }
    let h = (1.0 - d[1]) * (1.0 - d[1]);
    let (x, z) = (d[0] / (d[1] + 0.3), d[2] / (d[1] + 0.3));
    let w = sin(5.0 * x + 2.0 * sin(3.0 * z)) + 0.6 * sin(11.0 * z + 3.0 * x) + 0.3 * sin(23.0 * x);
    let c = (0.35 * (w - 0.4)).clamp(0.0, 0.6);
    let g = 0.4 / (1.0 + 60.0 * o * o);
    let haze = add([0.12, 0.3, 0.75], times(h, [0.5, 0.42, 0.15]));
    add(haze, add(times(c, [0.6, 0.55, 0.3]), times(g, [1.0, 0.85, 0.5])))
}

fn courtyard(u: f64, v: f64) -> V {
    let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    let r = length(x, y);
    if r >= 1.0 {
        return [0.0; 3];
    }
    let d = [x * sin(PI * r) / r, y * sin(PI * r) / r, cos(PI * r)];
    let [to_x, to_z] = [1.0 / d[0].abs(), 3.0 / d[2].abs()];
    let t = to_x.min(to_z);
    let h = t * d[1];
    if h > 1.2 {
        return [1.2, 1.6, 2.4];
    }
    if h < -0.4 {
        let [px, pz] = [d[0], d[2]].map(|d_i| -0.4 * d_i / d[1]);
        let even = is_even((4.0 * px).floor() + (4.0 * pz).floor());
        return if even { [0.6, 0.55, 0.45] } else { [0.35, 0.3, 0.25] };
    }
    let (a, s) = if to_x < to_z { (t * d[2], 0.8) } else { (t * d[0], 0.55) };
    let [a, b] = [a / 0.5, (h + 0.4) / 0.8].map(|t| t - t.floor());
    if is_within([0.3, 0.7], a) && is_within([0.25, 0.75], b) {
        [4.0, 2.8, 1.2]
    } else if is_within([0.24, 0.76], a) && is_within([0.2, 0.8], b) {
        [0.25; 3]
    } else if b > 0.94 {
        times(s, [0.9, 0.85, 0.75])
    } else {
        times(s, [0.7, 0.55, 0.35])
    }
}

fn uv_grid(u: f64, v: f64) -> V {
    let is_line = |x: f64| (x - x.round()).abs() < 0.08;
    let is_black = is_line(24.0 * u) || is_line(12.0 * v);
    if is_black { [0.0; 3] } else { [0.2 + 0.8 * u, 0.2 + 0.8 * v, 0.5] }
}

fn checker(u: f64, v: f64) -> V {
    if is_even((8.0 * u).floor() + (8.0 * v).floor()) { [1.0; 3] } else { [0.02; 3] }
}

/// A formula of u and v.
type Formula = fn(f64, f64) -> V;

/// Law: the printed formulas are those of the drawn images. Oracle: the printed formulas, written out here; the
/// numbers in the text are those of the formulas here, in any order.
#[test]
fn the_printed_formulas_draw_the_images() {
    // no texel is on an edge of a picture, where rounding decides
    const SIZE: [u32; 2] = [59, 61];
    let source = include_str!("drawings.rs");
    let all: [(Picture, &str, Formula); 8] = [
        (Picture::UvGrid, "uv_grid", uv_grid),
        (Picture::Checker, "checker", checker),
        (Picture::Globe, "globe", globe),
        (Picture::Lace, "lace", lace),
        (Picture::Country, "country", country),
        (Picture::BilliardBall, "billiard_ball", billiard_ball),
        (Picture::SkyDome, "sky_dome", sky_dome),
        (Picture::Courtyard, "courtyard", courtyard),
    ];
    let formulas = || describe::details().filter(|(list, ..)| *list == "pictures");
    assert_eq!(all.len(), formulas().count());
    for (picture, name, formula) in all {
        let drawn = Drawn { picture, width: SIZE[0], height: SIZE[1] };
        let image = Image::of_drawn(drawn, Some(Mapping::Square));
        let image = image.build(&mut Resources::default()).expect("it is valid");
        let rows = |column| (0..SIZE[1]).map(move |row| [column, row]);
        for at in (0..SIZE[0]).flat_map(rows) {
            let [u, v] = [0, 1].map(|i| (f64::from(at[i]) + 0.5) / f64::from(SIZE[i]));
            let local = Point::new(2.0 * v - 1.0, 0.0, 2.0 * u - 1.0);
            let surface = Surface::flat(local, local, Normal::Y);
            let found = image.color(&TexturePoint::new(&surface)).to_array();
            let expected = formula(u, v);
            // texels are kept in single precision
            let error = largest_difference(found, expected) / (1.0 + expected[0]);
            assert!(error < 1e-6, "{name} at {u}, {v}: {found:?}, expected {expected:?}");
        }
        let (_, _, text) = formulas()
            .find(|(_, its, _)| *its == name)
            .unwrap_or_else(|| panic!("no formula of {name}"));
        let here = source.split_once(&format!("fn {name}(")).expect("it is above").1;
        let here = decimals(here.split_once("\n}\n").expect("it ends").0);
        assert_eq!(
            decimals(&text),
            here,
            "{name}: the decimal numbers of the text and of the formula here"
        );
    }
}

/// The numbers of a text that have digits behind the point other than 0.
fn decimals(text: &str) -> BTreeSet<u64> {
    let all = super::numbers(text).into_iter().map(f64::abs);
    all.filter(|number| number.fract() != 0.0).map(f64::to_bits).collect()
}
