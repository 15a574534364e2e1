//! Writes down the rays of chosen pixels, one JSON object a line, for `groundtruth rays` (docs/rays.md). Rust 1.70.
//!
//! RAYS=120,80 cargo run     writes rays.jsonl: the rays of that pixel; RAYS="120,80;121,80" of two,
//!                           RAYS=10x10+120+80 of a block, RAYS=/16 of each 16th column and row
//! RAYS_FILE=other.jsonl     to another file
//!
//! mod rays;  impl rays::Xyz for Vec3 { fn xyz(self) -> [f64; 3] { [self.x.into(), self.y.into(), self.z.into()] } }
//! rays::pixel(x, y, sample);                                     before the camera's ray of a sample
//! let mut log = rays::Ray::new("reflected", origin, direction);  where a ray begins: camera, reflected, transmitted,
//!                                                                diffuse, path, shadow; the ray around is its parent
//! log.hit(t, point, normal, "ball");                             where it ends; not called if it hits nothing
//! log.number("pdf", pdf); log.color("weight", w);                what else is known, as "radiance": docs/rays.md
//! The line is written when `log` is dropped. A path in a loop pushes its rays to a `Vec` that lives as long as the path.
#![allow(dead_code)]

use std::sync::{Mutex, OnceLock};
use std::{cell::Cell, fmt::Write as _, fs::File, io::Write as _};

/// Vectors and colours.
pub trait Xyz { fn xyz(self) -> [f64; 3]; }
impl<T: Into<f64>> Xyz for [T; 3] { fn xyz(self) -> [f64; 3] { self.map(Into::into) } }

/// Of a thread: whether it is in a chosen pixel, the next ray's number, and that of the ray around it.
#[derive(Clone, Copy)]
struct State { on: bool, x: i64, y: i64, sample: i64, next: i64, open: i64 }

thread_local! {
    static STATE: Cell<State> = const { Cell::new(State { on: false, x: 0, y: 0, sample: 0, next: 0, open: -1 }) };
}

/// Pixels: every `step`-th column and row of a block, as x, y, width, height, step.
fn block(item: &str) -> Option<[i64; 5]> {
    let numbers: Vec<i64> = item.split(['x', '+', ',', '/']).filter_map(|it| it.trim().parse().ok()).collect();
    let signs: String = item.chars().filter(|c| !c.is_ascii_digit() && *c != ' ').collect();
    match (signs.as_str(), &numbers[..]) {
        (",", &[x, y]) => Some([x, y, 1, 1, 1]),
        ("x++", &[width, height, x, y]) => Some([x, y, width, height, 1]),
        ("/", &[step]) if step > 0 => Some([0, 0, i64::MAX, i64::MAX, step]),
        _ => None,
    }
}

fn log() -> Option<&'static (Mutex<File>, Vec<[i64; 5]>)> {
    static LOG: OnceLock<Option<(Mutex<File>, Vec<[i64; 5]>)>> = OnceLock::new();
    let open = || {
        let items = std::env::var("RAYS").ok().filter(|it| !it.is_empty())?;
        let read = |item| block(item).ok_or(item);
        let chosen = items.split(';').filter(|it| !it.is_empty()).map(read).collect::<Result<_, _>>();
        let wrong = |item| eprintln!("rays: RAYS is x,y or WxH+X+Y or /N, or several with ';', not {item}");
        let chosen = chosen.map_err(wrong).ok()?;
        let name = std::env::var("RAYS_FILE").unwrap_or_else(|_| "rays.jsonl".to_owned());
        let mut file = File::create(&name).map_err(|e| eprintln!("rays: {name}: {e}")).ok()?;
        file.write_all(b"{\"rays\": 1}\n").ok()?;
        Some((Mutex::new(file), chosen))
    };
    LOG.get_or_init(open).as_ref()
}

/// A line of its own: `{"object": "ball", "sphere": {"center": [0, 1, 0], "radius": 1}}` or `{"lamp": "sun", …}`.
pub fn line(json: &str) {
    let file = log().and_then(|log| log.0.lock().ok());
    file.map(|mut file| file.write_all(format!("{json}\n").as_bytes()));
}

pub fn pixel(x: impl TryInto<i64>, y: impl TryInto<i64>, sample: impl TryInto<i64>) {
    let Some((_, chosen)) = log() else { return };
    let [x, y, sample] = [x.try_into().ok(), y.try_into().ok(), sample.try_into().ok()].map(Option::unwrap_or_default);
    let is_in = |at: i64, length: i64, step: i64| at >= 0 && at < length && at % step == 0;
    let on = chosen.iter().any(|&[left, top, w, h, step]| is_in(x - left, w, step) && is_in(y - top, h, step));
    STATE.set(State { on, x, y, sample, next: 0, open: -1 });
}

/// A ray; its line is written when it is dropped.
pub struct Ray { on: bool, own: i64, before: i64, line: String }

impl Ray {
    pub fn new(kind: &str, origin: impl Xyz, direction: impl Xyz) -> Self {
        let State { on, x, y, sample, next, open } = STATE.get();
        let mut ray = Self { on, own: next, before: open, line: String::new() };
        if on {
            STATE.set(State { next: next + 1, open: next, ..STATE.get() });
            ray.line = format!("{{\"pixel\": [{x}, {y}], \"sample\": {sample}, \"ray\": {next}");
            (open >= 0).then(|| ray.put("parent", open));
            ray.text("kind", kind);
            ray.color("origin", origin);
            ray.color("direction", direction);
        }
        ray
    }
    fn put(&mut self, field: &str, value: impl std::fmt::Debug) { _ = write!(self.line, ", \"{field}\": {value:?}"); }
    pub fn number(&mut self, field: &str, x: impl Into<f64>) { if self.on { self.put(field, x.into()) } }
    pub fn flag(&mut self, field: &str, x: bool) { if self.on { self.put(field, x) } }
    pub fn color(&mut self, field: &str, v: impl Xyz) { if self.on { self.put(field, v.xyz()) } }
    pub fn text(&mut self, field: &str, value: &str) {
        let escape = |c| match c {
            '"' | '\\' => format!("\\{c}"),
            c if c < ' ' => format!("\\u{:04x}", c as u32),
            c => c.to_string(),
        };
        if self.on {
            _ = write!(self.line, ", \"{field}\": \"{}\"", value.chars().map(escape).collect::<String>());
        }
    }
    pub fn hit(&mut self, t: impl Into<f64>, point: impl Xyz, normal: impl Xyz, object: &str) {
        self.number("t", t);
        self.color("point", point);
        self.color("normal", normal);
        self.text("object", object);
    }
}

impl Drop for Ray {
    fn drop(&mut self) {
        if self.on {
            let state = STATE.get();
            STATE.set(State { open: if state.open >= self.own { self.before } else { state.open }, ..state });
            line(&format!("{}}}", self.line));
        }
    }
}
