//! The archway (Suffern, ch. 21): a compound of two columns of beveled boxes and a round arch of
//! beveled wedges on them.
//!
//! The middle of the arch is at the height `height − width/2`, where the columns end. The wedges
//! are built about the y axis, from azimuth 90° to 270°, and turned upright by `y → z, z → −y`. The
//! book's stones touch; here a narrow joint is between them.

use super::beveled_box::BeveledBox;
use super::beveled_wedge::BeveledWedge;
use super::edges::{Named, check_fits, half_joint, inset};
use crate::accel::Method;
use crate::invalid::{Invalid, shown};
use crate::math::{Length, Point, Step, Vector, to_degrees};
use crate::shapes::composite::assembly::{Materials, solid};
use crate::shapes::{Context, Instance, Made, Specification};

/// More stones than anyone could see.
const MAX_STONES: u32 = 1000;

/// An archway of stones with round edges, as the parts `columns` and `arch`; normals point outward.
/// It stands on the plane y = 0 and faces along the z axis, its middle above the origin. Between
/// the stones are joints, about a thousandth of the bevel wide.
#[kind(PartialEq)]
pub struct Archway {
    /// From the left side of the left column to the right side of the right one; positive.
    pub width: Length,
    /// The height of the top of the arch: more than half of `width`.
    pub height: Length,
    /// From back to front; positive.
    pub depth: Length,
    /// The width of each column, and of the arch from its inside to its outside: positive, and less
    /// than half of `width`.
    pub column_width: Length,
    /// How many boxes each column has: from 1 to 1000.
    pub blocks: u32,
    /// How many wedges the arch has: from 1 to 1000.
    pub wedges: u32,
    /// The radius of the stones' edges: positive, at most half of the shortest side of each stone.
    pub bevel: Length,
    /// How rays find the stones, `"grid"` in the book; as the scene if left out.
    pub accel: Option<Method>,
    /// The names of materials of parts that have one of their own, as `{ wall = "red" }`.
    #[optional]
    pub materials: Materials,
}

impl Archway {
    fn check(&self) -> Result<(), Invalid> {
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
            if !(1..=MAX_STONES).contains(&count) {
                let problem = format!("found {count}, but from 1 to {MAX_STONES} are needed");
                return Err(Invalid::field(field, problem));
            }
        }
        let block = [0.0, self.spring() / f64::from(self.blocks)];
        let column = [0.0, self.column_width];
        check_fits(self.bevel, &[("width of a column", column), ("height of a block", block)])
    }

    /// The height of the middle of the arch.
    fn spring(&self) -> f64 {
        self.height - 0.5 * self.width
    }

    /// The radii of the arch, which are the distances of a column's sides from the middle.
    fn radii(&self) -> [f64; 2] {
        let outer = 0.5 * self.width;
        [outer - self.column_width, outer]
    }

    fn z(&self) -> [f64; 2] {
        [-0.5 * self.depth, 0.5 * self.depth]
    }

    fn columns(&self) -> impl Iterator<Item = BeveledBox> {
        let (bevel, [inner, outer], [z0, z1]) = (self.bevel, self.radii(), self.z());
        let half = half_joint(bevel);
        let (spring, blocks) = (self.spring(), self.blocks);
        let height = move |block: u32| spring * (f64::from(block) / f64::from(blocks));
        let block = move |[x0, x1]: [f64; 2], i: u32| BeveledBox {
            min: Point::new(x0, if i == 0 { 0.0 } else { height(i) + half }, z0),
            max: Point::new(x1, height(i + 1) - half, z1),
            bevel,
            materials: Materials::new(),
        };
        let columns = [[-outer, -inner], [inner, outer]];
        columns.into_iter().flat_map(move |x| (0..blocks).map(move |i| block(x, i)))
    }

    /// About the y axis.
    fn arch(&self) -> impl Iterator<Item = BeveledWedge> {
        let (bevel, [inner_radius, outer_radius], [y0, y1]) = (self.bevel, self.radii(), self.z());
        let half = to_degrees(half_joint(bevel) / (inner_radius + bevel));
        let step = 180.0 / f64::from(self.wedges);
        let azimuth = move |wedge: u32| 90.0 + step * f64::from(wedge);
        (0..self.wedges).map(move |i| BeveledWedge {
            y0,
            y1,
            inner_radius,
            outer_radius,
            phi: inset([azimuth(i), azimuth(i + 1)], half),
            bevel,
            materials: Materials::new(),
        })
    }
}

impl Specification for Archway {
    fn make(&self, context: &mut Context) -> Made {
        self.check()?;
        let mut stones: Vec<Named> = Vec::new();
        for block in self.columns() {
            block.check()?; // names the field that does not fit
            stones.push(("columns", block.into()));
        }
        let upright = vec![Step::RotateX(90.0), Step::Translate(self.spring() * Vector::Y)];
        for wedge in self.arch() {
            wedge.checked()?;
            stones.push(("arch", Instance::new(wedge, upright.clone()).into()));
        }
        solid(&stones, &self.materials, self.accel, context)
    }
}
