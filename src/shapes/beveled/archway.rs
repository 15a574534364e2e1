//! The archway (Suffern, ch. 21): two columns of beveled boxes that carry a round arch of beveled
//! wedges.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::beveled_box::RoundedBox;
use super::edges::{Named, check_bevel, extended, inset, overlap, rounding, uncovered, widened};
use super::wedge_parts::{Sides, Wedge};
use crate::accel::Method;
use crate::invalid::{Invalid, length, shown};
use crate::kinds::Specification;
use crate::math::{Point, Step, Vector};
use crate::shapes::composite::assembly::{Materials, smooth_solid};
use crate::shapes::{Context, Instance, Kind, Rectangle, Shape};

/// More stones than anyone could see.
const MOST_STONES: u32 = 1000;

/// An archway of stones with round edges, as the parts `columns` and `arch`; normals point outward.
/// It stands on the plane y = 0 and faces along the z axis, its middle above the origin.
///
/// Stones touch. Where they do, the book's have two faces in one place, and a ray that leaves one
/// would be in the other; here such faces are left out, so that the archway is one solid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Archway {
    /// From the left side of the left column to the right side of the right one; positive.
    pub width: f64,
    /// The height of the top of the arch: more than half of `width`.
    pub height: f64,
    /// From back to front; positive.
    pub depth: f64,
    /// The width of each column, and of the arch from its inside to its outside: positive, and less
    /// than half of `width`.
    pub column_width: f64,
    /// How many boxes each column has: from 1 to 1000.
    pub blocks: u32,
    /// How many wedges the arch has: from 1 to 1000.
    pub wedges: u32,
    /// The radius of the stones' edges: positive, at most half of what is shortest of each stone.
    pub bevel: f64,
    /// How rays find its parts, `"grid"` in the book; as the scene if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub accel: Option<Method>,
    /// The names of materials of parts that have one of their own, as `{ wall = "red" }`.
    #[serde(default, skip_serializing_if = "Materials::is_empty")]
    pub materials: Materials,
}

impl Archway {
    fn check(&self) -> Result<(), Invalid> {
        length("width", self.width)?;
        length("height", self.height)?;
        length("depth", self.depth)?;
        length("column_width", self.column_width)?;
        let half = 0.5 * self.width;
        if self.height <= half {
            let [found, half] = [self.height, half].map(shown);
            let problem = format!("found {found}, but it must be above half the width, {half}");
            return Err(Invalid::field("height", problem));
        }
        if self.column_width >= half {
            let [found, half] = [self.column_width, half].map(shown);
            let problem = format!("found {found}, but it must be below half the width, {half}");
            return Err(Invalid::field("column_width", problem));
        }
        for (field, count) in [("blocks", self.blocks), ("wedges", self.wedges)] {
            if !(1..=MOST_STONES).contains(&count) {
                let problem = format!("found {count}, but from 1 to {MOST_STONES} are needed");
                return Err(Invalid::field(field, problem));
            }
        }
        let block = [0.0, self.spring() / f64::from(self.blocks)];
        let extents = [
            ("depth", self.z()),
            ("width of the columns", [0.0, self.column_width]),
            ("height of a block", block),
        ];
        check_bevel(self.bevel, self.largest(), &extents)?;
        self.stones_of_arch().try_for_each(|wedge| wedge.check())
    }

    /// The height where the arch begins: that of its middle.
    fn spring(&self) -> f64 {
        self.height - 0.5 * self.width
    }

    fn z(&self) -> [f64; 2] {
        [-0.5 * self.depth, 0.5 * self.depth]
    }

    /// The radii of the arch, and the distances of a column's sides from the middle.
    fn radii(&self) -> [f64; 2] {
        let outer = 0.5 * self.width;
        [outer - self.column_width, outer]
    }

    /// The largest extent.
    fn largest(&self) -> f64 {
        self.height.max(self.width).max(self.depth)
    }

    /// How far each stone reaches into those it touches, half of what the two have in common. A ray
    /// in the plane between them only touches the roundings of both: it would be rounded off them, into
    /// the stone, whose face there is left out.
    fn overlap(&self) -> f64 {
        0.5 * overlap(self.largest(), self.bevel)
    }

    /// About the y axis, from azimuth 90 to 270.
    fn stones_of_arch(&self) -> impl Iterator<Item = Wedge> {
        let (y, r, bevel) = (self.z(), self.radii(), self.bevel);
        let step = 180.0 / f64::from(self.wedges);
        let azimuth = move |i: u32| 90.0 + step * f64::from(i);
        let over = self.overlap();
        let phi = move |i: u32| widened([azimuth(i), azimuth(i + 1)], over, r[0]);
        (0..self.wedges).map(move |i| Wedge { y, r, phi: phi(i), bevel })
    }

    /// The arch, turned by y → z, z → −y: from +x over the top to −x.
    fn arch(&self) -> Vec<Named> {
        let seen = Sides { inner_wall: true, outer_wall: true, ends: false };
        let steps = vec![Step::RotateX(90.0), Step::Translate(self.spring() * Vector::Y)];
        let turned = |(_, part)| ("arch", Kind::from(Instance::new(part, steps.clone())));
        self.stones_of_arch().flat_map(|wedge| wedge.parts(seen)).map(turned).collect()
    }

    fn columns(&self) -> Vec<Named> {
        let [inner, outer] = self.radii();
        let height = |block: u32| self.spring() * (f64::from(block) / f64::from(self.blocks));
        let mut parts = Vec::new();
        for x in [[-outer, -inner], [inner, outer]] {
            for block in 0..self.blocks {
                let [low, high] = extended([height(block), height(block + 1)], self.overlap());
                let low = if block == 0 { 0.0 } else { low };
                let extents = [x, [low, high], self.z()];
                let stone = RoundedBox::new(extents, self.bevel);
                let touches = |name| name == "top" || name == "bottom" && block > 0;
                parts.extend(stone.faces().into_iter().filter(|(name, _)| !touches(*name)));
                parts.extend(stone.edges());
                parts.extend(stone.corners());
            }
        }
        parts.into_iter().map(|(_, part)| ("columns", part)).collect()
    }

    /// What of the faces between columns and arch can be seen in the grooves of the other: a wedge's
    /// begins and ends nearer to the middle than a block's.
    fn faces_between(&self) -> Vec<Named> {
        let [z0, z1] = inset(self.z(), self.bevel);
        let blocks = inset(self.radii(), self.bevel);
        let wedges = self.stones_of_arch().next().map_or(blocks, |wedge| wedge.ends());
        let is_left = |range: &[f64; 2]| range[0] < range[1];
        let [blocks, wedges] =
            [blocks, wedges].map(|range| Vec::from_iter([range].into_iter().filter(is_left)));
        if z0 >= z1 {
            return Vec::new();
        }
        let face = |x: f64, width: f64, up: bool| {
            let corner = Point::new(x, self.spring(), z0);
            let (a, b) = ((z1 - z0) * Vector::Z, width * Vector::X);
            let (a, b) = if up { (a, b) } else { (b, a) };
            Kind::from(Rectangle { corner, a, b })
        };
        let mut faces = Vec::new();
        for (name, ranges, up) in [
            ("columns", uncovered(&blocks, &wedges), true),
            ("arch", uncovered(&wedges, &blocks), false),
        ] {
            for [from, to] in ranges {
                faces.push((name, face(from, to - from, up)));
                faces.push((name, face(-to, to - from, up)));
            }
        }
        faces
    }
}

impl Specification for Archway {
    type Built = Arc<dyn Shape>;
    type Context = Context;

    fn build(&self, context: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        self.check()?;
        let mut parts = self.columns();
        parts.extend(self.arch());
        parts.extend(self.faces_between());
        let rounding = rounding(self.largest());
        smooth_solid(&parts, &self.materials, self.accel, rounding, context)
    }

    fn scaled(&self, factor: f64) -> Self {
        let lengths = [self.width, self.height, self.depth, self.column_width, self.bevel];
        let [width, height, depth, column_width, bevel] = lengths.map(|length| factor * length);
        let materials = self.materials.clone();
        Self { width, height, depth, column_width, bevel, materials, ..*self }
    }

    fn specimens() -> Vec<Self> {
        let arch = |[width, height, depth]: [f64; 3], column_width, blocks, wedges, bevel| Self {
            width,
            height,
            depth,
            column_width,
            blocks,
            wedges,
            bevel,
            accel: None,
            materials: Materials::new(),
        };
        vec![arch([20.0, 25.0, 3.0], 4.0, 6, 10, 0.5), arch([2.0, 1.5, 0.5], 0.375, 1, 3, 0.125)]
    }
}
