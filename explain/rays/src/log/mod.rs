//! A log: what a program wrote down about its rays, in JSON Lines (`docs/rays.md`).

mod digits;
mod fields;
mod kind;
mod read;
mod value;

use std::fmt;
use std::sync::Arc;

use groundtruth::math::{Point, Vector};
use groundtruth::printable;
use groundtruth::rgb::Rgb;
use serde_json::{Map, Value};
use text::digits::{exact, exact_color};

use crate::placing::Placing;
pub use digits::Digits;
pub use fields::{FIELDS, Field};
pub use kind::Purpose;
pub use read::{Damaged, LogError, MAX_RAYS, read};

/// A log as it was written, a record for each of its lines.
#[derive(Clone, Debug, Default)]
pub struct Log {
    /// What its first line says of all others.
    pub head: Head,
    /// The objects of the scene, as far as it names them.
    pub objects: Vec<Named>,
    /// The lamps.
    pub lamps: Vec<Named>,
    /// The rays, in the order of their lines.
    pub rays: Vec<Ray>,
    /// The lines that could not be read.
    pub damaged: Vec<Damaged>,
    /// How many further lines could not be read.
    pub more_damaged: usize,
    /// How its numbers are printed.
    pub digits: Digits,
}

/// The first line of a log: all of it may be missing.
#[derive(Clone, Debug, Default)]
pub struct Head {
    /// Of the format: 1, if there is a head at all.
    pub version: Option<u32>,
    /// The program that wrote it.
    pub program: Option<String>,
    /// `single` or `double`.
    pub precision: Option<Precision>,
    /// The picture that the program renders: a file.
    pub picture: Option<String>,
    /// Width and height of the picture, in pixels.
    pub size: Option<[u32; 2]>,
    /// A scene of the gallery, a scene file, or a scene in the words of scene files.
    pub scene: Option<Value>,
    /// How its space lies in that of its objects.
    pub(crate) placing: Placing,
}

/// The precision in which a program computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// 24 bits.
    Single,
    /// 53 bits.
    Double,
}

/// An object or a lamp of the log: its name, and what else its line says.
#[derive(Clone, Debug)]
pub struct Named {
    /// Its name.
    pub name: Arc<str>,
    /// The other fields of its line.
    pub fields: Map<String, Value>,
}

/// One ray. What its line does not say is `None`.
#[derive(Clone, Debug, Default)]
pub struct Ray {
    /// Its line in the log, from 1.
    pub line: usize,
    /// Column and row, from 0 at the top left.
    pub pixel: Option<[u32; 2]>,
    /// The sample of the pixel.
    pub sample: u32,
    /// What the log calls it.
    pub id: Option<Id>,
    /// What the log calls the ray that sent it.
    pub parent: Option<Id>,
    /// Its purpose.
    pub kind: Option<Purpose>,
    /// Where it starts.
    pub origin: Point,
    /// Where it goes; of any length.
    pub direction: Vector,
    /// Where it ended, or a shadow ray was blocked, in lengths of the direction.
    pub t: Option<f64>,
    /// Where it ended.
    pub point: Option<Point>,
    /// Of a shadow ray: how far the lamp is, as `t`.
    pub end: Option<f64>,
    /// What it hit, or what blocked it.
    pub object: Option<Arc<str>>,
    /// The lamp it was aimed at.
    pub light: Option<Arc<str>>,
    /// The normal at its hit.
    pub normal: Option<Vector>,
    /// The normal that shading uses there.
    pub shading_normal: Option<Vector>,
    /// Texture coordinates there.
    pub uv: Option<[f64; 2]>,
    /// Whether it met the side that the normal points to.
    pub front: Option<bool>,
    /// The factors that its radiance has in its parent.
    pub factors: Factors,
    /// Emitted at its hit, towards its origin.
    pub emitted: Option<Rgb>,
    /// Added at its hit without another ray.
    pub direct: Option<Rgb>,
    /// What it brings back to its origin.
    pub radiance: Option<Rgb>,
    /// The person's own fields.
    pub others: Map<String, Value>,
}

/// What a ray's radiance is multiplied by in its parent.
#[derive(Clone, Debug, Default)]
pub struct Factors {
    /// The ratio of the indices of refraction, in either order.
    pub eta: Option<f64>,
    /// The index of the medium that it comes from.
    pub eta_from: Option<f64>,
    /// The index of the medium that it enters.
    pub eta_to: Option<f64>,
    /// The value of the BRDF, per steradian.
    pub f: Option<Rgb>,
    /// The cosine to the normal.
    pub cos: Option<f64>,
    /// The density with which its direction was drawn, per steradian.
    pub pdf: Option<f64>,
    /// The density per area of the lamp.
    pub pdf_area: Option<f64>,
    /// The density with which the other strategy draws this direction, per steradian.
    pub other_pdf: Option<f64>,
    /// The probability with which it was chosen: lobe, lamp, roulette.
    pub choice: Option<f64>,
    /// The MIS weight.
    pub mis: Option<f64>,
    /// All of them, as multiplied.
    pub weight: Option<Rgb>,
    /// The product of the weights from the camera to it.
    pub throughput: Option<Rgb>,
}

/// What a log calls a ray: any number or text.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Id {
    /// A whole number.
    Number(i64),
    /// A text.
    Text(Arc<str>),
}

impl Ray {
    /// Where it ended: its `point`, or else `t` along it; `None` if it hit nothing.
    pub fn end_point(&self) -> Option<Point> {
        self.point.or_else(|| Some(self.origin + self.t? * self.direction))
    }

    /// Whether it looks for what is in the way to a lamp or around a point.
    pub fn is_shadow(&self) -> bool {
        matches!(self.kind, Some(Purpose::Shadow | Purpose::Occlusion))
    }

    /// What its line says beside the names of rays: each field with its value in words.
    pub fn fields(&self) -> Vec<(String, String)> {
        let factors = &self.factors;
        let number = |x: Option<f64>| x.map(|x| format!("{x:?}"));
        let triple = |x: Option<[f64; 3]>| x.map(exact);
        let color = |x: Option<Rgb>| x.map(exact_color);
        let name = |x: &Option<Arc<str>>| x.as_ref().map(|x| printable::name(x));
        let own = self.others.iter();
        let own =
            own.map(|(name, value)| (printable::name(name), printable::name(&value.to_string())));
        let all = [
            ("kind", self.kind.as_ref().map(|kind| printable::name(&kind.to_string()))),
            ("origin", triple(Some(self.origin.into()))),
            ("direction", triple(Some(self.direction.into()))),
            ("t", number(self.t)),
            ("point", triple(self.point.map(Into::into))),
            ("end", number(self.end)),
            ("object", name(&self.object)),
            ("light", name(&self.light)),
            ("normal", triple(self.normal.map(Into::into))),
            ("shading_normal", triple(self.shading_normal.map(Into::into))),
            ("uv", self.uv.map(|[u, v]| format!("({u:?}, {v:?})"))),
            ("front", self.front.map(|front| front.to_string())),
            ("eta", number(factors.eta)),
            ("eta_from", number(factors.eta_from)),
            ("eta_to", number(factors.eta_to)),
            ("f", color(factors.f)),
            ("cos", number(factors.cos)),
            ("pdf", number(factors.pdf)),
            ("pdf_area", number(factors.pdf_area)),
            ("other_pdf", number(factors.other_pdf)),
            ("choice", number(factors.choice)),
            ("mis", number(factors.mis)),
            ("weight", color(factors.weight)),
            ("throughput", color(factors.throughput)),
            ("emitted", color(self.emitted)),
            ("direct", color(self.direct)),
            ("radiance", color(self.radiance)),
        ];
        let said = all.into_iter().filter_map(|(name, value)| Some((name.to_owned(), value?)));
        said.chain(own).collect()
    }

    /// Its numbers by name: those of its own fields, and its length, density and light, of which it says that they are common.
    pub fn numbers(&self) -> impl Iterator<Item = (bool, &str, f64)> {
        let own = self.others.iter();
        let own = own.filter_map(|(name, value)| Some((false, &**name, value.as_f64()?)));
        let all = [
            ("t", self.t),
            ("pdf", self.factors.pdf),
            ("weight (mean)", self.factors.weight.map(Rgb::average)),
            ("radiance (mean)", self.radiance.map(Rgb::average)),
        ];
        own.chain(all.into_iter().filter_map(|(name, value)| Some((true, name, value?))))
    }

    /// Whether its kind is this one.
    pub fn is(&self, kind: &Purpose) -> bool {
        self.kind.as_ref() == Some(kind)
    }
}

impl fmt::Display for Id {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number}"),
            Self::Text(text) => f.write_str(text),
        }
    }
}
