//! The printed random numbers.

use groundtruth::kinds::Resources;
use groundtruth::math::{Point, Ray, Span, Vector, power};
use groundtruth::shapes::RandomSpheres;
use groundtruth::textures::{RandomColors, Specification};

use super::described;
use super::formulas::assert_says;

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

/// The description of a scene of random spheres as one line.
fn spheres_in_words() -> String {
    let name = "ch22/thousand-spheres";
    let scene = (gallery::find(name).expect("it is there").build)();
    described(name, &scene).text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Law: the printed generator places the random spheres. Oracle: the printed steps, written out here.
#[test]
fn the_printed_generator_places_the_spheres() {
    let text = spheres_in_words();
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
    let text = spheres_in_words();
    for formula in [
        "h = mix(mix(h) ^ word)",
        "z = x + 0x9e3779b97f4a7c15; z = (z ^ (z >> 30)) · 0xbf58476d1ce4e5b9; z = (z ^ (z >> 27)) · \
         0x94d049bb133111eb; mix = z ^ (z >> 31)",
        "the first three numbers of the generator (see Random numbers) with the seed hash(seed, n)",
        "of a lattice those of the copy (0, 0, 0), then of (1, 0, 0) …",
    ] {
        assert_says(&text, formula);
    }
    let (scene, source) = scenefile::parse(ROW.to_owned(), "".as_ref()).expect("it is a scene");
    let world = source.world(&scene, 1).expect("it is valid");
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
