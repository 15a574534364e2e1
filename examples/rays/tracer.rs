//! A small path tracer that writes down its rays: a loop, not a recursion, with throughput, roulette, and a lamp that is
//! a ball: at each hit it is sampled, and met by scattered rays, too; the power heuristic weights both. Single precision.
//!     rustc -O --edition 2021 tracer.rs && RAYS=/8 ./tracer > picture.ppm && groundtruth rays rays.jsonl
mod rays;
use std::{f32::consts::PI, ops::{Add, Mul, Sub}};

#[derive(Clone, Copy)]
struct V(f32, f32, f32);
const BLACK: V = V(0.0, 0.0, 0.0);
impl Add for V { type Output = V; fn add(self, b: V) -> V { V(self.0 + b.0, self.1 + b.1, self.2 + b.2) } }
impl Sub for V { type Output = V; fn sub(self, b: V) -> V { V(self.0 - b.0, self.1 - b.1, self.2 - b.2) } }
impl Mul for V { type Output = V; fn mul(self, b: V) -> V { V(self.0 * b.0, self.1 * b.1, self.2 * b.2) } }
impl Mul<V> for f32 { type Output = V; fn mul(self, b: V) -> V { V(self * b.0, self * b.1, self * b.2) } }
impl V {
    fn dot(self, b: V) -> f32 { self.0 * b.0 + self.1 * b.1 + self.2 * b.2 }
    fn cross(self, b: V) -> V { V(self.1 * b.2 - self.2 * b.1, self.2 * b.0 - self.0 * b.2, self.0 * b.1 - self.1 * b.0) }
    fn unit(self) -> V { 1.0 / self.dot(self).sqrt() * self }
    fn max(self) -> f32 { self.0.max(self.1).max(self.2) }
}
impl rays::Xyz for V { fn xyz(self) -> [f64; 3] { [self.0.into(), self.1.into(), self.2.into()] } }
struct Ball { name: &'static str, center: V, radius: f32, albedo: V, light: f32 }
const BALLS: [Ball; 5] = [
    Ball { name: "lamp", center: V(1.5, 4.0, 0.5), radius: 0.5, albedo: BLACK, light: 30.0 },
    Ball { name: "ground", center: V(0.0, -100.0, 0.0), radius: 100.0, albedo: V(0.7, 0.7, 0.7), light: 0.0 },
    Ball { name: "clay", center: V(-1.2, 1.0, 0.0), radius: 1.0, albedo: V(0.75, 0.35, 0.25), light: 0.0 },
    Ball { name: "chalk", center: V(1.0, 0.7, 0.8), radius: 0.7, albedo: V(0.85, 0.85, 0.85), light: 0.0 },
    Ball { name: "moss", center: V(2.6, 0.9, -0.8), radius: 0.9, albedo: V(0.3, 0.6, 0.2), light: 0.0 },
];
const LAMP: &Ball = &BALLS[0];
struct Hit { t: f32, point: V, normal: V, ball: &'static Ball }

fn nearest(o: V, d: V) -> Option<Hit> {
    let mut found: Option<Hit> = None;
    for ball in &BALLS {
        let (between, nearest) = (o - ball.center, found.as_ref().map_or(f32::MAX, |hit| hit.t));
        let (half, size) = (between.dot(d), between.dot(between).sqrt());
        let across = between - half * d; // shorter than `between`: little is lost at the large ball
        let square = ball.radius * ball.radius - across.dot(across);
        if square < 0.0 { continue }
        let root = -half.signum() * (half.abs() + square.sqrt());
        let other = (size - ball.radius) * (size + ball.radius) / root;
        let t = if root.min(other) > 0.0 { root.min(other) } else { root.max(other) };
        if t <= 0.0 || t >= nearest { continue }
        found = Some(Hit { t, point: o + t * d, normal: (between + t * d).unit(), ball });
    }
    found
}

struct Random(u64);
impl Random {
    /// Uniform in [0, 1): PCG.
    fn next(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let word = (((self.0 >> 18) ^ self.0) >> 27) as u32;
        (word.rotate_right((self.0 >> 59) as u32) >> 8) as f32 / 16777216.0
    }
    /// A direction about `n`, whose cosine is given.
    fn around(&mut self, n: V, cos: f32) -> V {
        let (sin, phi) = ((1.0 - cos * cos).max(0.0).sqrt(), 2.0 * PI * self.next());
        let s = if n.0.abs() > 0.9 { V(0.0, 1.0, 0.0) } else { V(1.0, 0.0, 0.0) }.cross(n).unit();
        (sin * phi.cos() * s + sin * phi.sin() * n.cross(s) + cos * n).unit()
    }
}

/// One minus the cosine of the cone in which the lamp is seen, and the density with which its directions are drawn.
fn lamp_cone(from: V) -> (f32, f32) {
    let way = LAMP.center - from;
    let square = LAMP.radius * LAMP.radius / way.dot(way);
    let one_minus = square / (1.0 + (1.0 - square).max(0.0).sqrt());
    (one_minus, 1.0 / (2.0 * PI * one_minus))
}
fn power(own: f32, other: f32) -> f32 { own * own / (own * own + other * other) }
fn start(hit: &Hit) -> V { hit.point + 1e-3 * hit.normal }

/// The lamp as one shadow ray sees it.
fn direct(hit: &Hit, random: &mut Random) -> V {
    let (from, f) = (start(hit), 1.0 / PI * hit.ball.albedo);
    let (one_minus, pdf) = lamp_cone(from);
    let in_cone = 1.0 - random.next() * one_minus;
    let to = random.around((LAMP.center - from).unit(), in_cone);
    let cos = to.dot(hit.normal);
    if cos <= 0.0 { return BLACK }
    let (other, mis) = (cos / PI, power(pdf, cos / PI));
    let weight = (cos / pdf * mis) * f;
    let mut log = rays::Ray::new("shadow", from, to);
    log.text("light", "lamp");
    log.color("f", f);
    log.color("weight", weight);
    for (name, number) in [("cos", cos), ("pdf", pdf), ("other_pdf", other), ("mis", mis)] { log.number(name, number) }
    match nearest(from, to) {
        Some(it) if it.ball.light > 0.0 => { log.number("end", it.t); LAMP.light * weight }
        Some(it) => { log.hit(it.t, it.point, it.normal, it.ball.name); BLACK }
        None => BLACK, // past the edge of the lamp, by rounding
    }
}

fn radiance(mut o: V, mut d: V, random: &mut Random) -> V {
    let (mut sum, mut throughput, mut pdf) = (BLACK, V(1.0, 1.0, 1.0), 1.0);
    let mut path = vec![rays::Ray::new("camera", o, d)];
    for depth in 0..6 {
        let log = path.last_mut().expect("it has the camera's ray");
        log.color("throughput", throughput);
        let Some(hit) = nearest(o, d) else { break };
        log.hit(hit.t, hit.point, hit.normal, hit.ball.name);
        if hit.ball.light > 0.0 {
            // the lamp's samples find it, too
            let other = if depth == 0 { 0.0 } else { lamp_cone(o).1 };
            let mis = power(pdf, other);
            sum = sum + (mis * hit.ball.light) * throughput;
            for (name, number) in [("emitted", hit.ball.light), ("other_pdf", other), ("mis", mis)] { log.number(name, number) }
            break;
        }
        let lit = direct(&hit, random);
        log.color("direct", lit);
        sum = sum + throughput * lit;
        let choice = if depth < 2 { 1.0 } else { hit.ball.albedo.max() };
        if depth == 5 || random.next() >= choice { break }
        let (cos, f) = ((1.0 - random.next()).sqrt(), 1.0 / PI * hit.ball.albedo);
        (o, d, pdf) = (start(&hit), random.around(hit.normal, cos), cos / PI);
        let weight = (cos / (pdf * choice)) * f;
        throughput = throughput * weight;
        let mut log = rays::Ray::new("path", o, d);
        log.color("f", f);
        log.color("weight", weight);
        for (name, number) in [("cos", cos), ("pdf", pdf), ("choice", choice)] { log.number(name, number) }
        path.push(log);
    }
    sum
}

fn main() {
    let (width, height, samples) = (160, 120, 8);
    for Ball { name, center: V(x, y, z), radius, .. } in &BALLS {
        rays::line(&format!(r#"{{"object": "{name}", "sphere": {{"center": [{x}, {y}, {z}], "radius": {radius}}}}}"#));
    }
    rays::line(r#"{"lamp": "lamp", "object": "lamp"}"#);
    println!("P3 {width} {height} 255");
    for y in 0..height {
        for x in 0..width {
            let (mut random, mut sum) = (Random((y * width + x) as u64 * 0x9E37_79B9_7F4A_7C15), BLACK);
            for sample in 0..samples {
                rays::pixel(x, y, sample);
                let (px, py) = (x as f32 - 80.0 + random.next(), 60.0 - y as f32 - random.next());
                sum = sum + radiance(V(0.5, 2.0, 7.0), V(px, py - 12.0, -144.0).unit(), &mut random);
            }
            let [r, g, b] = [sum.0, sum.1, sum.2].map(|x| (255.99 * (x / samples as f32).min(1.0).sqrt()) as u8);
            println!("{r} {g} {b}");
        }
    }
}
