//! The beveled cylinder (Suffern, ch. 21).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::edges::{Named, check_bevel, extended, inset, overlap, rounding, tube};
use super::shoulder::Shoulder;
use crate::invalid::{Invalid, shown};
use crate::kinds::{Custom, Specification};
use crate::math::{Axis, Point, Step, Vector};
use crate::shapes::composite::assembly::{Materials, smooth_solid};
use crate::shapes::part::angles::full_turn;
use crate::shapes::{Context, Disk, Instance, Kind, OpenCylinder, Shape};

/// A solid cylinder with round edges, as the parts `bottom`, `top`, `wall`, `bottom_edge` and
/// `top_edge`; normals point outward. With a bevel as large as the radius it has hemispheres for
/// ends, and figure 21.13's is a sphere.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BeveledCylinder {
    /// The height of the bottom.
    pub y0: f64,
    /// The height of the top, above `y0`.
    pub y1: f64,
    /// The radius; positive.
    pub radius: f64,
    /// The radius of the edges: at most the radius and half of the height.
    pub bevel: f64,
    /// The names of materials of parts that have one of their own, as `{ wall = "red" }`.
    #[serde(default, skip_serializing_if = "Materials::is_empty")]
    pub materials: Materials,
}

impl Specification for BeveledCylinder {
    type Built = Arc<dyn Shape>;
    type Context = Context;

    fn build(&self, context: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        let Self { y0, y1, radius, bevel, .. } = *self;
        let wall = OpenCylinder { y0, y1, radius, inward: false }.checked()?;
        let largest = y0.abs().max(y1.abs()).max(radius);
        check_bevel(bevel, largest, &[("height", [y0, y1])])?;
        if bevel > radius {
            let [found, most] = [bevel, radius].map(shown);
            let problem = format!("found {found}, but at most {most} fits, the radius");
            return Err(Invalid::field("bevel", problem));
        }
        let flat = radius - bevel;
        let [low, high] = inset([y0, y1], bevel);
        let over = overlap(largest, bevel);
        let mut parts: Vec<Named> = Vec::new();
        if flat > 0.0 {
            for (name, y, normal) in [("bottom", y0, -Vector::Y), ("top", y1, Vector::Y)] {
                let center = Point::new(0.0, y, 0.0);
                parts.push((name, Disk { center, normal, radius: flat + over }.into()));
            }
        }
        if low < high {
            let [y0, y1] = extended([low, high], over);
            parts.push(("wall", OpenCylinder { y0, y1, ..wall }.into()));
        }
        // a tube wider than the circle it follows is no part torus of ours
        let by_the_book = context.textbook().is_some() && bevel < flat;
        let edge = |steps| {
            let shoulder = if by_the_book {
                tube(flat, bevel, full_turn(), [0.0, 90.0])
            } else {
                let shoulder = Shoulder { disk: flat, distance: bevel };
                Kind::Custom(Custom(Arc::new(shoulder) as Arc<_>))
            };
            Kind::from(Instance::new(shoulder, steps))
        };
        let up = |y: f64| Step::Translate(y * Vector::Y);
        parts.push(("bottom_edge", edge(vec![Step::Reflect(Axis::Y), up(low)])));
        parts.push(("top_edge", edge(vec![up(high)])));
        smooth_solid(&parts, &self.materials, None, rounding(largest), context)
    }

    fn scaled(&self, factor: f64) -> Self {
        let lengths = [self.y0, self.y1, self.radius, self.bevel];
        let [y0, y1, radius, bevel] = lengths.map(|length| factor * length);
        Self { y0, y1, radius, bevel, materials: self.materials.clone() }
    }

    fn specimens() -> Vec<Self> {
        let beveled =
            |y0, y1, radius, bevel| Self { y0, y1, radius, bevel, materials: Materials::new() };
        vec![
            beveled(-1.0, 1.0, 1.0, 0.125),
            beveled(0.25, 1.85, 1.0, 0.75),
            beveled(-0.75, 1.25, 1.0, 1.0),
        ]
    }
}
