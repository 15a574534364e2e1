//! What a description says is what the tracer does: its numbers and formulas give the same rays and pixels.

use std::collections::BTreeMap;
use std::path::Path;

use groundtruth::math::power;
use groundtruth::render;

use super::{Described, described, numbers, section};

/// A vector of three numbers.
pub type V = [f64; 3];

pub fn add(a: V, b: V) -> V {
    [0, 1, 2].map(|i| a[i] + b[i])
}

pub fn times(t: f64, a: V) -> V {
    a.map(|x| t * x)
}

pub fn dot(a: V, b: V) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

pub fn unit(a: V) -> V {
    times(1.0 / dot(a, a).sqrt(), a)
}

pub fn largest_difference(a: V, b: V) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max)
}

/// The text of a section as one line.
pub fn prose(text: &str, title: &str) -> String {
    let lines = section(text, title);
    lines.iter().map(|line| line.trim()).collect::<Vec<_>>().join(" ")
}

/// What follows the last place where these words stand.
pub fn after<'a>(text: &'a str, words: &str) -> &'a str {
    text.rsplit_once(words).unwrap_or_else(|| panic!("{words:?} in {text}")).1
}

fn vector_after(text: &str, words: &str) -> V {
    let (inside, _) = after(text, words).split_once(']').expect("it ends");
    numbers(inside).try_into().expect("three numbers")
}

/// A camera, as the description has it.
pub struct Camera {
    /// The section of the camera.
    pub text: String,
    /// u, v, w.
    pub axes: [V; 3],
    /// Of each eye: its position, and what is added to x.
    pub eyes: Vec<(V, f64)>,
    /// The first column of each eye's image.
    pub first_columns: Vec<u32>,
    side: f64,
    half_width: f64,
    half_height: f64,
}

impl Camera {
    pub fn of_text(text: &str) -> Self {
        let camera = prose(text, "CAMERA");
        let axes = ["u = [", "v = [", "w = ["].map(|name| vector_after(&camera, name));
        let corner = numbers(after(&camera, "from x = ").split_once("to x").expect("a range").0);
        let &[side, half_width, _, half_height, one] = &corner[..] else { panic!("{corner:?}") };
        assert_eq!(one, 1.0);
        let (eyes, first_columns) = match camera.contains("This is a stereo pair") {
            false => (vec![(vector_after(&camera, "The rays start at e = ["), 0.0)], vec![0]),
            true => {
                let left = vector_after(&camera, "The rays of the left eye start at e = [");
                let right = vector_after(&camera, "those of the right eye at e = [");
                let shift = numbers(after(&camera, "In the formula below add "))[0];
                let columns = numbers(after(&camera, "the left eye begins at column "));
                let columns = vec![columns[0] as u32, columns[1] as u32];
                (vec![(left, shift), (right, -shift)], columns)
            }
        };
        Self { text: camera, axes, eyes, first_columns, side, half_width, half_height }
    }

    /// The film point with these distances from the lower left corner of a pixel, in pixels.
    pub fn film(&self, [c, r]: [u32; 2], [dx, dy]: [f64; 2]) -> [f64; 2] {
        let (c, r) = (f64::from(c), f64::from(r));
        let x = self.side * (c - self.half_width + dx);
        [x, self.side * (self.half_height - r - 1.0 + dy)]
    }

    /// The direction of a film point's ray through a pinhole.
    pub fn direction(&self, [x, y]: [f64; 2], shift: f64) -> V {
        let formula = numbers(after(&self.text, "the direction (x / "));
        let [zoom, zoom_again, distance] = formula[..3] else { panic!("{formula:?}") };
        assert_eq!(zoom, zoom_again);
        let [u, v, w] = self.axes;
        let across = add(times((x + shift) / zoom, u), times(y / zoom, v));
        unit(add(across, times(-distance, w)))
    }
}

const LIT_SPHERE: &str = r#"
background = [0.1, 0.2, 0.3]
[image]
width = 24
height = 16
[camera]
eye = [1, 2, 6]
look_at = [0, 0.25, 0]
exposure_time = 0.75
lens.pinhole = { distance = 40, zoom = 1.5 }
[[lights]]
name = "sky"
source.ambient = { ls = 0.5, color = [0.5, 0.75, 1] }
[[lights]]
name = "sun"
source.directional = { ls = 2.5, color = [1, 0.9, 0.8], direction = [2, 3, 4] }
[[lights]]
name = "bulb"
source.point = { ls = 30, color = [0.25, 1, 0.5], location = [-3, 2, 4], attenuation = 2 }
[[materials]]
name = "red"
recipe.phong = { ka = 0.3, kd = 0.6, cd = [1, 0.5, 0.25], ks = 0.4, cs = [0.5, 1, 1], exponent = 7 }
[[objects]]
name = "ball"
material = "red"
shape.sphere = { center = [0.25, 0.125, 0.5], radius = 1.25 }
"#;

/// The formulas that the test below puts numbers into.
const FORMULAS: [&str; 5] = [
    "`ambient`: adds ρa · ls · color,",
    "`directional`: adds f(ωi, ωo) · ls · color · cosθ with ωi = direction / |direction|,",
    "`point`: adds f(ωi, ωo) · ls · color / d^attenuation · cosθ, where ωi leads from the hit to \
     `location` and d is its distance,",
    "`phong`: ρa = ka · cd, and f = kd · cd / π + ks · cs · max(0, r·ωo)^exponent with r = 2 (n·ωi) n \
     - ωi.",
    "That value times the exposure_time 0.75 of the camera is the pixel.",
];

/// The settings of an entry of a section, counted from 0, by name: a number three times, a text as NaN.
fn settings(text: &str, title: &str, number: usize) -> BTreeMap<String, V> {
    let lines = section(text, title);
    let entries = lines.split(|line| line.is_empty()).filter(|entry| !entry.is_empty());
    let mut entries = entries.filter(|entry| entry.iter().any(|line| line.contains("  name = ")));
    let entry = entries.nth(number).expect("there are so many");
    let named = entry.iter().filter_map(|line| line.split_once(" = "));
    named
        .map(|(name, value)| {
            let value = match numbers(value)[..] {
                [a, b, c] => [a, b, c],
                [grey] => [grey; 3],
                _ => [f64::NAN; 3],
            };
            (name.trim().to_owned(), value)
        })
        .collect()
}

/// Some hundred operations on numbers of at most 30, among them a power of 7.
const SUM: f64 = 1e-12;

/// Law: the printed numbers in the printed formulas give the pixels: ambient, directional and point light on a
/// sphere of Phong's material. Oracle: the book's formulas, computed here from the text alone.
#[test]
fn the_printed_formulas_give_the_pixels() {
    let (scene, _) = scenefile::parse(LIT_SPHERE.to_owned(), Path::new("")).expect("it is a scene");
    let Described { world, text } = described("lit sphere", &scene);
    let whole: String = text.split_whitespace().collect::<Vec<_>>().join(" ");
    for formula in FORMULAS {
        assert!(whole.contains(formula), "{formula}\n{text}");
    }
    let camera = Camera::of_text(&text);
    let exposure = numbers(after(&text, "exposure_time = "))[0];
    let mut lit = 0;
    for pixel in (0..16).flat_map(|y| (0..24).map(move |x| [x, y])) {
        let direction = camera.direction(camera.film(pixel, [0.5, 0.5]), 0.0);
        let expected = radiance(&text, camera.eyes[0].0, direction, &mut lit);
        let expected = times(exposure, expected);
        let found = render::pixel(&world, pixel).to_array();
        let error = largest_difference(found, expected);
        assert!(error < SUM, "{pixel:?}: {found:?}, expected {expected:?}");
    }
    assert!(lit > 50, "only {lit} pixels show the sphere in the light");
}

/// The radiance of a ray, from the text alone.
fn radiance(text: &str, origin: V, direction: V, lit: &mut u32) -> V {
    let ball = settings(text, "OBJECTS", 0);
    let (center, radius) = (ball["center"], ball["radius"][0]);
    let to_origin = add(origin, times(-1.0, center));
    let (b, c) = (dot(to_origin, direction), dot(to_origin, to_origin) - radius * radius);
    if b * b < c {
        return vector_after(text, "background = [");
    }
    let hit = add(origin, times(-b - (b * b - c).sqrt(), direction));
    let n = times(1.0 / radius, add(hit, times(-1.0, center)));
    let red = settings(text, "MATERIALS", 0);
    let product = |names: &[&str]| {
        let all = names.iter().map(|name| red[*name]);
        all.fold([1.0; 3], |a, b| [0, 1, 2].map(|i| a[i] * b[i]))
    };
    let [sky, sun, bulb] = [0, 1, 2].map(|number| settings(text, "LIGHTS", number));
    let mut sum = [0, 1, 2].map(|i| product(&["ka", "cd"])[i] * sky["ls"][0] * sky["color"][i]);
    let to_bulb = add(bulb["location"], times(-1.0, hit));
    let distance = dot(to_bulb, to_bulb).sqrt();
    for (light, wi, weakening) in [
        (&sun, unit(sun["direction"]), 1.0),
        (&bulb, unit(to_bulb), power(distance, bulb["attenuation"][0])),
    ] {
        let cosine = dot(n, wi);
        if cosine <= 0.0 {
            continue; // the sphere itself is before the light
        }
        *lit += 1;
        let r = add(times(2.0 * cosine, n), times(-1.0, wi));
        let highlight = power(dot(r, times(-1.0, direction)).max(0.0), red["exponent"][0]);
        for i in 0..3 {
            let f = product(&["kd", "cd"])[i] / std::f64::consts::PI
                + product(&["ks", "cs"])[i] * highlight;
            sum[i] += f * light["ls"][0] * light["color"][i] / weakening * cosine;
        }
    }
    sum
}

/// Golden: the description of that scene, with a lamp that is off and a stereo pair, and the files of a mesh.
#[test]
fn descriptions_read_as_before() {
    let text = LIT_SPHERE.replace("name = \"sun\"", "name = \"sun\"\nenabled = false").replace(
        "exposure_time = 0.75",
        "stereo = { viewing = \"parallel\", gap = 3, separation = 2 }",
    );
    let (scene, _) = scenefile::parse(text, Path::new("")).expect("it is a scene");
    let mut all = described("lit sphere", &scene).text;
    let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes"));
    let (scene, source) = scenefile::open(&folder.join("knot.toml")).expect("it is a scene");
    let world = source.world(&scene, 1).expect("it is valid");
    let text = exchange::describe::describe("knot", &scene, &world, folder).expect("it is plain");
    all += &format!("\nFILES of another\n{}\n", prose(&text, "FILES"));
    insta::assert_snapshot!(all);
}
