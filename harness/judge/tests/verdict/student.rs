//! A ray tracer as a student writes it, with the mistakes that students make: spheres, planes and boxes in the light of a
//! sun and a lamp. It shares nothing with ours.

use groundtruth::math::{Pcg32, power};

type V = [f64; 3];

fn add(a: V, b: V) -> V {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn sub(a: V, b: V) -> V {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn mul(k: f64, a: V) -> V {
    a.map(|x| k * x)
}

fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: V) -> V {
    mul(1.0 / dot(a, a).sqrt(), a)
}

/// The mistakes, each with the names that say it: of the catalogue, or words of a harmless change. Without a name the
/// catalogue does not have it.
pub const MISTAKES: &[(&str, &[&str])] = &[
    ("no 1/π", &["lambertian-without-pi"]),
    ("no cosine", &["no-cosine"]),
    ("rows upside down", &["upside down"]),
    ("Blinn for Phong", &["highlight-of-half-vector"]),
    ("the sun is not normalised", &["sun-not-normalised"]),
    ("acne", &["acne", "shadow-offset", "no-offset"]),
    ("a normal not of unit length", &["sphere-normal-not-unit", "normal-not-unit", "not of unit"]),
    ("samples at the corners of cells", &["pixel-corner", "corner", "half a pixel"]),
    // twenty more of the kind
    ("1/π twice", &["lambertian-pi-twice"]),
    ("cosine twice", &["cosine-twice"]),
    ("no shadows", &["no-shadows"]),
    ("shadow rays without an end", &["shadow-rays-without-end", "distance"]),
    ("no ambient light", &["no-ambient"]),
    ("ambient light without ka", &["ambient-without-ka"]),
    ("ambient light of kd", &["ambient-of-kd"]),
    ("ambient light over π", &["ambient-over-pi"]),
    ("ambient light for each light", &["ambient-for-each-light"]),
    ("the sun from the other side", &["sun-reversed"]),
    ("no highlight", &["no-highlight"]),
    ("a highlight without cosine", &["highlight-without-cosine"]),
    ("a highlight of the surface's colour", &["highlight-of-surface-colour"]),
    ("a normalised highlight", &["highlight-normalised"]),
    (
        "colours of lamps exchanged",
        &["lamps-exchanged", "colours-of-lights-exchanged", "exchanged"],
    ),
    ("blue before red", &["blue, green, red"]),
    ("left and right exchanged", &["left and right"]),
    ("half of all light", &["divided by 2", "1/2", "0.5"]),
    ("the last sample left out", &["last-sample-left-out"]),
    ("the cosine of the viewer", &["cosine-of-viewer"]),
];

/// The shapes: spheres (centre, radius), boxes (corners), and the ground at height 0.
#[derive(Clone, Copy)]
pub enum Shape {
    Ball(V, f64),
    Block(V, V),
    Ground,
}

#[derive(Clone, Copy)]
pub struct Thing {
    pub shape: Shape,
    pub color: V,
    pub ka: f64,
    pub kd: f64,
    pub ks: f64,
    pub exponent: f64,
}

/// A scene: things, a background, and the number of samples: 1 in the middle, or independent ones.
#[derive(Clone)]
pub struct Stage {
    pub name: &'static str,
    pub things: Vec<Thing>,
    pub background: f64,
    pub samples: u32,
}

const EYE: V = [1.0, 2.5, 8.0];
const LOOK_AT: V = [0.0, 0.8, 0.0];
const DISTANCE: f64 = 60.0;
const SIZE: [u32; 2] = [48, 36];
const SUN: V = [1.0, 2.0, 1.5];
const SUN_LIGHT: V = [1.6, 1.5, 1.3];
const LAMP: V = [-3.0, 4.0, 3.0];
const LAMP_LIGHT: V = [0.7, 0.9, 1.3];
const SKY: f64 = 0.5;

/// The stages: three balls; balls and a box, whose background settles how values are encoded; balls with noise.
pub fn stages() -> Vec<Stage> {
    let thing = |shape, color| Thing { shape, color, ka: 0.3, kd: 0.65, ks: 0.25, exponent: 20.0 };
    let matte = |shape, color| Thing { ks: 0.0, ..thing(shape, color) };
    let balls = vec![
        thing(Shape::Ball([-1.7, 0.8, 0.3], 0.8), [0.9, 0.3, 0.1]),
        thing(Shape::Ball([0.2, 1.2, -0.8], 1.2), [0.2, 0.4, 0.9]),
        thing(Shape::Ball([1.8, 0.6, 0.8], 0.6), [0.3, 0.8, 0.2]),
        matte(Shape::Ground, [0.7, 0.65, 0.5]),
        // above the lamp and out of sight
        matte(Shape::Block([-6.0, 6.0, 0.0], [-2.0, 6.5, 6.0]), [0.5, 0.5, 0.5]),
    ];
    let mut block = balls.clone();
    block[1] = thing(Shape::Block([-0.6, 0.0, -1.6], [1.0, 1.5, -0.2]), [0.8, 0.7, 0.3]);
    vec![
        Stage { name: "balls", things: balls.clone(), background: 0.0, samples: 1 },
        Stage { name: "block", things: block, background: 0.4, samples: 1 },
        Stage { name: "noise", things: balls, background: 0.0, samples: 9 },
    ]
}

impl Stage {
    /// As a scene file of ours.
    pub fn scene(&self) -> String {
        let [w, h] = SIZE;
        let sampler = if self.samples == 1 { "regular" } else { "random" };
        let mut text = format!(
            "about = \"{}\"\nbackground = {}\nimage = {{ width = {w}, height = {h}, samples = {}, sampler.{sampler} = {{}}, \
             gamma = 1 }}\ncamera = {{ eye = {EYE:?}, look_at = {LOOK_AT:?}, lens.pinhole = {{ distance = {DISTANCE} }} }}\n\
             [[lights]]\nname = \"sky\"\nsource.ambient = {{ ls = {SKY} }}\n[[lights]]\nname = \"sun\"\n\
             source.directional = {{ direction = {SUN:?}, ls = 1, color = {SUN_LIGHT:?} }}\n[[lights]]\nname = \"lamp\"\n\
             source.point = {{ location = {LAMP:?}, ls = 1, color = {LAMP_LIGHT:?} }}\n",
            self.name, self.background, self.samples
        );
        for (index, thing) in self.things.iter().enumerate() {
            let Thing { shape, color, ka, kd, ks, exponent } = thing;
            let recipe = match *ks > 0.0 {
                true => format!(
                    "phong = {{ ka = {ka}, kd = {kd}, cd = {color:?}, ks = {ks}, exponent = {exponent} }}"
                ),
                false => format!("matte = {{ ka = {ka}, kd = {kd}, cd = {color:?} }}"),
            };
            let shape = match shape {
                Shape::Ball(center, radius) => {
                    format!("sphere = {{ center = {center:?}, radius = {radius} }}")
                }
                Shape::Block(min, max) => format!("box = {{ min = {min:?}, max = {max:?} }}"),
                Shape::Ground => "plane = { point = [0, 0, 0], normal = [0, 1, 0] }".to_owned(),
            };
            text += &format!(
                "[[materials]]\nname = \"m{index}\"\nrecipe.{recipe}\n[[objects]]\nname = \"thing {index}\"\nmaterial = \
                 \"m{index}\"\nshape.{shape}\n"
            );
        }
        text
    }
}

/// The student's program.
pub struct Student<'a> {
    pub stage: &'a Stage,
    /// A mistake, by its name; empty for none.
    pub mistake: &'a str,
}

impl Student<'_> {
    fn errs(&self, mistake: &str) -> bool {
        self.mistake == mistake
    }

    /// The picture: red, green, blue, row by row from the top left.
    pub fn picture(&self, seed: u64) -> Vec<V> {
        let [width, height] = SIZE;
        let mut random = Pcg32::new(seed, 77);
        let mut picture = Vec::new();
        for y in 0..height {
            for x in 0..width {
                let mut sum = [0.0; 3];
                let count = self.stage.samples;
                for index in 0..count {
                    let mut at = || {
                        if count == 1 {
                            0.5
                        } else {
                            f64::from(random.below(1 << 30)) / f64::from(1 << 30)
                        }
                    };
                    let [mut dx, mut dy] = [at(), at()];
                    if self.errs("samples at the corners of cells") {
                        (dx, dy) = (dx - 0.5, dy + 0.5);
                    }
                    let last = count > 1 && index + 1 == count;
                    if !(last && self.errs("the last sample left out")) {
                        sum = add(sum, self.film(f64::from(x) + dx, f64::from(y) + dy));
                    }
                }
                picture.push(mul(1.0 / f64::from(count), sum));
            }
        }
        let row = |y: usize| picture[y * width as usize..][..width as usize].to_vec();
        match self.mistake {
            "rows upside down" => (0..height as usize).rev().flat_map(row).collect(),
            "left and right exchanged" => {
                (0..height as usize).flat_map(|y| row(y).into_iter().rev()).collect()
            }
            "blue before red" => picture.into_iter().map(|[r, g, b]| [b, g, r]).collect(),
            "half of all light" => picture.into_iter().map(|color| mul(0.5, color)).collect(),
            _ => picture,
        }
    }

    /// What arrives at a point of the film, in pixels from the top left corner.
    fn film(&self, x: f64, y: f64) -> V {
        let w = unit(sub(EYE, LOOK_AT));
        let u = unit(cross([0.0, 1.0, 0.0], w));
        let v = cross(w, u);
        let [px, py] = [x - 0.5 * f64::from(SIZE[0]), 0.5 * f64::from(SIZE[1]) - y];
        let d = unit(sub(add(mul(px, u), mul(py, v)), mul(DISTANCE, w)));
        match self.nearest(EYE, d, 1e-6) {
            Some((t, thing)) => self.shade(add(EYE, mul(t, d)), d, thing),
            None => [self.stage.background; 3],
        }
    }

    fn nearest(&self, o: V, d: V, least: f64) -> Option<(f64, &Thing)> {
        let hits =
            self.stage.things.iter().filter_map(|it| Some((hit(it.shape, o, d, least)?, it)));
        hits.min_by(|a, b| a.0.total_cmp(&b.0))
    }

    fn shade(&self, p: V, d: V, thing: &Thing) -> V {
        use std::f64::consts::PI;
        let Thing { color, ka, kd, ks, exponent, .. } = *thing;
        let mut n = normal(thing.shape, p);
        if let (Shape::Ball(c, _), true) = (thing.shape, self.errs("a normal not of unit length")) {
            n = sub(p, c);
        }
        let wo = mul(-1.0, d);
        let factor = match self.mistake {
            "no ambient light" => 0.0,
            "ambient light without ka" => 1.0,
            "ambient light of kd" => kd,
            "ambient light over π" => ka / PI,
            "ambient light for each light" => 2.0 * ka,
            _ => ka,
        };
        let mut sum = mul(factor * SKY, color);
        let [mut sun, mut lamp] = [SUN_LIGHT, LAMP_LIGHT];
        if self.errs("colours of lamps exchanged") {
            (sun, lamp) = (lamp, sun);
        }
        let to_lamp = sub(LAMP, p);
        let mut to_sun = SUN;
        if self.errs("the sun from the other side") {
            to_sun = mul(-1.0, SUN);
        }
        let lights = [(to_sun, f64::INFINITY, sun), (to_lamp, dot(to_lamp, to_lamp).sqrt(), lamp)];
        for (to, distance, light) in lights {
            let l = unit(to);
            let mut cos = dot(n, l);
            if cos <= 0.0 {
                continue;
            }
            let (least, far) = match self.mistake {
                "acne" => (0.0, distance),
                "shadow rays without an end" => (1e-6, f64::INFINITY),
                _ => (1e-6, distance),
            };
            let blocked = self.nearest(p, l, least).is_some_and(|(t, _)| t < far);
            if blocked && !self.errs("no shadows") {
                continue;
            }
            if self.errs("the sun is not normalised") && distance.is_infinite() {
                cos = dot(n, to);
            }
            let mut f = mul(kd / PI, color);
            f = match self.mistake {
                "no 1/π" => mul(PI, f),
                "1/π twice" => mul(1.0 / PI, f),
                _ => f,
            };
            let r = sub(mul(2.0 * dot(n, l), n), l);
            let mut lobe = dot(r, wo).max(0.0);
            if self.errs("Blinn for Phong") {
                lobe = dot(n, unit(add(l, wo))).max(0.0);
            }
            let mut shine = [ks * power(lobe, exponent); 3];
            shine = match self.mistake {
                "no highlight" => [0.0; 3],
                "a highlight without cosine" => mul(1.0 / cos, shine),
                "a highlight of the surface's colour" => [0, 1, 2].map(|i| shine[i] * color[i]),
                "a normalised highlight" => mul((exponent + 2.0) / (2.0 * PI), shine),
                _ => shine,
            };
            let cos = match self.mistake {
                "no cosine" => 1.0,
                "cosine twice" => cos * cos,
                "the cosine of the viewer" => dot(n, wo),
                _ => cos,
            };
            let f = add(f, shine);
            sum = add(sum, [0, 1, 2].map(|i| f[i] * light[i] * cos));
        }
        sum
    }
}

fn hit(shape: Shape, o: V, d: V, least: f64) -> Option<f64> {
    match shape {
        Shape::Ground => {
            let t = -o[1] / d[1];
            (t > least && t.is_finite()).then_some(t)
        }
        Shape::Ball(c, r) => {
            let to = sub(o, c);
            let (b, e) = (dot(to, d), dot(to, to) - r * r);
            let root = (b * b - e).sqrt();
            [-b - root, -b + root].into_iter().find(|t| *t > least)
        }
        Shape::Block(low, high) => {
            let (mut near, mut far) = (f64::NEG_INFINITY, f64::INFINITY);
            for i in 0..3 {
                let [a, b] = [(low[i] - o[i]) / d[i], (high[i] - o[i]) / d[i]];
                (near, far) = (near.max(a.min(b)), far.min(a.max(b)));
            }
            let t = if near > least { near } else { far };
            (near <= far && t > least).then_some(t)
        }
    }
}

fn normal(shape: Shape, p: V) -> V {
    match shape {
        Shape::Ground => [0.0, 1.0, 0.0],
        Shape::Ball(c, r) => mul(1.0 / r, sub(p, c)),
        Shape::Block(low, high) => {
            let mut best = (f64::INFINITY, [0.0; 3]);
            for i in 0..3 {
                for (face, sign) in [(low[i], -1.0), (high[i], 1.0)] {
                    let mut n = [0.0; 3];
                    n[i] = sign;
                    if (p[i] - face).abs() < best.0 {
                        best = ((p[i] - face).abs(), n);
                    }
                }
            }
            best.1
        }
    }
}
