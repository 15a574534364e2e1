//! The cells of a regular grid: their number, their contents, and those that a ray visits.

use serde::{Deserialize, Serialize};

use super::limits;
use super::numbers::{RayData, Triple, triple};
use groundtruth::accel::Cells;
use groundtruth::invalid::{Invalid, finite_point, positive, shown};
use groundtruth::math::{Aabb, Point, lists};
use groundtruth::shapes::{Context, Kind};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Grid {
    boxes: Option<Vec<Corners>>,
    shapes: Option<Vec<Kind>>,
    #[serde(default = "two")]
    multiplier: f64,
    ray: Option<RayData>,
    #[serde(default, deserialize_with = "lists::exactly_if_any")]
    cell: Option<[u32; 3]>,
}

/// The book's.
fn two() -> f64 {
    2.0
}

/// An object's box.
#[derive(Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
struct Corners {
    min: Point,
    max: Point,
}

#[derive(Serialize)]
pub struct CellsVisited {
    /// Cells along x, y and z.
    resolution: [usize; 3],
    min: Triple,
    max: Triple,
    /// Of shapes, those without bounds, which are in no cell.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    unbounded: Vec<u32>,
    /// Of the cell asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    objects: Option<Vec<u32>>,
    /// Along the ray asked for; null if it tests all objects.
    #[serde(skip_serializing_if = "Option::is_none")]
    visited: Option<Option<Vec<Visited>>>,
}

#[derive(Serialize)]
struct Visited {
    cell: [usize; 3],
    objects: Vec<u32>,
}

impl super::Question for Grid {
    type Answer = CellsVisited;

    fn answer(&self) -> Result<CellsVisited, Invalid> {
        let ray = self.ray.map(|ray| ray.ray()).transpose()?;
        let all = self.bounds()?;
        let (which, unbounded): (Vec<u32>, _) =
            (0..all.len() as u32).partition(|&i| all[i as usize].is_bounded());
        let bounds: Vec<Aabb> = which.iter().map(|&i| all[i as usize]).collect();
        self.check_multiplier(bounds.len())?;
        let cells = Cells::of(&bounds, self.multiplier);
        let objects = |cell| {
            let inside = cells.objects(cell).iter();
            inside.map(|&index| which[index as usize]).collect::<Vec<u32>>()
        };
        let look = |cell| Visited { cell, objects: objects(cell) };
        let visited = ray.map(|ray| {
            let visited = cells.visited(&ray);
            visited.map(|visited| visited.into_iter().map(look).collect())
        });
        let resolution = cells.resolution();
        let cell = self.cell.map(|cell| inside(cell, resolution)).transpose()?;
        let (min, max) = (triple(cells.bounds().min), triple(cells.bounds().max));
        Ok(CellsVisited { resolution, min, max, unbounded, objects: cell.map(objects), visited })
    }
}

impl Grid {
    /// The boxes of all objects; those of shapes may be unbounded.
    fn bounds(&self) -> Result<Vec<Aabb>, Invalid> {
        let (field, all) = match (&self.boxes, &self.shapes) {
            (Some(boxes), None) => {
                let checked = boxes.iter().enumerate();
                let checked = checked.map(|(index, b)| b.checked().map_err(|e| e.inside(index)));
                ("boxes", checked.collect::<Result<Vec<Aabb>, _>>())
            }
            (None, Some(shapes)) => ("shapes", bounds_of(shapes)),
            _ => return Err(Invalid::new("needs either `boxes` or `shapes`")),
        };
        let all = all.map_err(|e| e.inside(field))?;
        if all.iter().any(Aabb::is_bounded) {
            return Ok(all);
        }
        Err(Invalid::field(field, "found none with bounds, but a grid has at least one"))
    }

    /// Refuses a multiplier that makes no cells, or too many.
    fn check_multiplier(&self, objects: usize) -> Result<(), Invalid> {
        let multiplier = positive("multiplier", self.multiplier)?;
        let most = groundtruth::math::cbrt(limits::MAX_CELLS / objects as f64);
        if multiplier <= most {
            return Ok(());
        }
        let (found, most) = (shown(multiplier), shown((1e3 * most).trunc() / 1e3));
        let problem = format!("found {found}, but at most {most} fits for {objects} objects");
        Err(Invalid::field("multiplier", problem))
    }
}

impl Corners {
    fn checked(&self) -> Result<Aabb, Invalid> {
        let (min, max) = (finite_point("min", self.min)?, finite_point("max", self.max)?);
        if (0..3).all(|axis| min.along(axis) <= max.along(axis)) {
            return Ok(Aabb { min, max });
        }
        let (min, max) = (min.to_array(), max.to_array());
        let problem = format!("found {max:?}, but no coordinate may be below that of min, {min:?}");
        Err(Invalid::field("max", problem))
    }
}

fn bounds_of(shapes: &[Kind]) -> Result<Vec<Aabb>, Invalid> {
    limits::buildable(shapes.iter(), |index, e| e.inside(index))?;
    let mut context = Context::default();
    let bounds = shapes.iter().enumerate().map(|(index, shape)| {
        let shape = shape.build(&mut context).map_err(|e| e.inside(index))?;
        Ok(shape.bounds())
    });
    bounds.collect()
}

/// The cell, if the grid has it.
fn inside(cell: [u32; 3], resolution: [usize; 3]) -> Result<[usize; 3], Invalid> {
    let indices = cell.map(|at| at as usize);
    if indices.iter().zip(resolution).all(|(&at, count)| at < count) {
        return Ok(indices);
    }
    let [x, y, z] = resolution;
    let problem = format!("found {cell:?}, but the grid has {x} × {y} × {z} cells, counted from 0");
    Err(Invalid::field("cell", problem))
}
