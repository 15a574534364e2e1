//! A regular grid for inspection: its cells, the objects in them, and the cells that a ray visits.

use super::grid::Grid;
use crate::math::{Aabb, Ray, Span};

/// The regular grid over the boxes of objects (Suffern, ch. 22), without a search.
#[derive(Debug)]
pub struct Cells {
    grid: Grid,
    bounds: Aabb,
}

impl Cells {
    /// The grid over these boxes, which must be bounded. `multiplier` is the book's; it is reduced
    /// if the boxes overlap so many cells that memory would run out.
    pub fn of(bounds: &[Aabb], multiplier: f64) -> Self {
        let all = Vec::from_iter(0..bounds.len() as u32);
        let grid = Grid::build(bounds, &all, multiplier);
        let whole = bounds.iter().fold(Aabb::EMPTY, |all, &b| all.union(b));
        Self { grid, bounds: whole }
    }

    /// The box around all boxes, which the cells divide.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// The number of cells on each axis.
    pub fn resolution(&self) -> [usize; 3] {
        self.grid.resolution()
    }

    /// The objects whose boxes, grown a little, overlap a cell, in ascending order.
    pub fn objects(&self, [x, y, z]: [usize; 3]) -> &[u32] {
        let [nx, ny, _] = self.resolution();
        self.grid.cell(x + nx * (y + ny * z))
    }

    /// The cells that the ray visits if it hits nothing, in order; `None` for a ray from so far
    /// away that every object is tested instead.
    pub fn visited(&self, ray: &Ray) -> Option<Vec<[usize; 3]>> {
        let [nx, ny, _] = self.resolution();
        let indices = |cell: usize| [cell % nx, cell / nx % ny, cell / nx / ny];
        let walk = self.grid.walk(ray, Span::AHEAD)?;
        Some(walk.into_iter().map(|(cell, _)| indices(cell)).collect())
    }
}
