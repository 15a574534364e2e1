//! The setting of a case: parameters, and from where a subject is seen.

use ask::{Draw, Subject};
use std::f64::consts::PI;

use groundtruth::math::{Vector, cos, hash, sin};
use serde_json::{Map, Value};

use crate::asked::Asked;
use crate::case::LobeCase;
use crate::description::{Description, Kind, point_within};
use crate::light::LightCase;
use crate::lobe::Lobe;
use crate::map::MapCase;

/// What a case can be asked again with.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// The parameters of the subject.
    pub parameters: Map<String, Value>,
    /// The direction to the viewer of a lobe, or the point that a light lights; of a map nothing.
    pub seen: Option<[f64; 3]>,
}

/// A case of a kind.
pub enum Case<'a> {
    /// Of a lobe.
    Lobe(LobeCase<'a>),
    /// Of a light.
    Light(LightCase<'a>),
    /// Of a map.
    Map(MapCase<'a>),
}

/// The angles, in degrees, that viewers of the first cases have with the normal: easy ones first.
const EASY: [f64; 5] = [45.0, 45.0, 10.0, 75.0, 89.0];

impl Setting {
    /// The setting of the case of an index, and the source of its random numbers.
    pub fn drawn(description: &Description, seed: u64, index: usize) -> (Self, Draw) {
        let parameters = description.parameters(index, &mut Draw::case(seed, index));
        let mut draw = Draw::new(hash(&[seed, index as u64]));
        let seen = match description.kind {
            Kind::Lobe => {
                let side = if description.claims.from_below && index % 2 == 1 { -1.0 } else { 1.0 };
                Some(viewer(index, side, &mut draw))
            }
            Kind::Light => description.points.map(|points| point_within(points, &mut draw)),
            Kind::Map => None,
        };
        (Self { parameters, seen }, draw)
    }
}

fn viewer(index: usize, side: f64, draw: &mut Draw) -> [f64; 3] {
    let whole = |low: f64, high: f64, draw: &mut Draw| draw.between(low, high).floor();
    let angle = EASY.get(index).copied().unwrap_or_else(|| whole(0.0, 88.0, draw));
    let azimuth = if index == 0 { 0.0 } else { whole(0.0, 360.0, draw) };
    let [theta, phi] = [angle, azimuth].map(|degrees| degrees * PI / 180.0);
    [sin(theta) * cos(phi), sin(theta) * sin(phi), side * cos(theta)]
}

impl<'a> Case<'a> {
    /// The case of a setting, with random numbers of its own.
    pub fn new(
        subject: &'a mut dyn Subject,
        description: &'a Description,
        setting: &Setting,
        draw: Draw,
    ) -> Self {
        let parameters = &setting.parameters;
        let asked = Asked::new(subject, (description.kind, &description.name), parameters);
        let (claims, rounding) = (&description.claims, description.rounding());
        let seen = setting.seen.unwrap_or_default();
        match description.kind {
            Kind::Lobe => Self::Lobe(LobeCase {
                lobe: Lobe { asked },
                claims,
                eta: description.eta(parameters),
                rounding,
                wo: Vector::from(seen),
                draw,
                integrated: None,
            }),
            Kind::Light => Self::Light(LightCase {
                asked,
                claims,
                rounding,
                points: description.points.expect("it was checked"),
                from: seen.into(),
                draw,
                integrated: None,
            }),
            Kind::Map => Self::Map(MapCase {
                asked,
                claims,
                domain: claims.domain.expect("it was checked"),
                rounding,
                draw,
                integrated: None,
            }),
        }
    }

    /// Forgets what was counted, so that it is counted anew.
    pub fn forget(&mut self) {
        match self {
            Self::Lobe(case) => case.integrated = None,
            Self::Light(case) => case.integrated = None,
            Self::Map(case) => case.integrated = None,
        }
    }
}
