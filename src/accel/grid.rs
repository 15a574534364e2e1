//! The regular grid (Suffern, ch. 22): equal cells, each with the primitives whose boxes overlap
//! it, walked cell by cell along the ray.
//!
//! As in the book, `n` primitives in a box of sides `w` get `⌊2 w/s⌋ + 1` cells on each axis, where
//! `s` is the cube root of the volume for each primitive: about eight cells for each. The walk
//! differs from the book's in two ways. A hit may lie beyond the cell in which its primitive is
//! tested; the book discards it and finds it again later. Here it stays the best so far, and the
//! walk ends at the first cell that begins beyond it. And the planes between cells are computed
//! from their indices, not by repeated addition, so that errors do not grow along the ray.
//!
//! No hit is lost. A hit lies in its primitive's box grown by the ray's slack ([`BoxRay`]). The box
//! that is sorted into cells is grown by [`PAD`], which is larger. The walk visits the cell of
//! every point of the ray except for rounding, which is far less than the difference of the two. A
//! ray from so far away that its slack is not less than the padding tests every primitive.

use std::ops::Range;

use super::Counter;
use crate::math::{Aabb, BoxRay, Ray, Span, Vector, cbrt};

/// The book's `multiplier`: `n` primitives in a cube get about `multiplier · ∛n` cells on each
/// axis.
pub(super) const MULTIPLIER: f64 = 2.0;
/// The padding of boxes, in cells.
const PAD: f64 = 1.0 / 64.0;
/// The least padding, relative to the longest extent or the largest coordinate.
const MIN_PAD: f64 = 1.0 / (1 << 20) as f64;
/// The least extent of the grid, relative to the largest coordinate.
const MIN_EXTENT: f64 = 1.0 / (1 << 30) as f64;
/// The number of primitives that a walk remembers, in order not to test them again in the next
/// cell. Without mailboxes a ray that misses tests most primitives three times, and nine times in a
/// grid in a grid (Shevtsov, Soupikov & Kapustin, "Ray-Triangle Intersection Algorithm for Modern
/// CPU Architectures", 2007).
const MAILBOXES: usize = 16;
/// The most entries of all cells, for each primitive. A grid of large primitives, which overlap
/// many cells, gets larger cells; otherwise memory would run out.
const MAX_ENTRIES: usize = 32;
const FEW_ENTRIES: usize = 1 << 20;

/// Primitives sorted into cells.
#[derive(Debug)]
pub struct Grid {
    /// All primitives, for rays from too far away.
    all: Vec<u32>,
    cells: Division,
    /// The start of each cell's entries, and the end of the last one's.
    starts: Vec<u32>,
    entries: Vec<u32>,
}

/// How a box is divided.
#[derive(Debug)]
struct Division {
    bounds: Aabb,
    counts: [usize; 3],
    /// The sides of a cell; 0 where all boxes are flat and in one plane.
    sides: [f64; 3],
    /// The padding of the primitives' boxes.
    pad: f64,
}

impl Grid {
    /// The grid over the primitives `which`; `bounds` are the boxes of all. `multiplier` is reduced
    /// until the entries fit.
    pub(super) fn build(bounds: &[Aabb], which: &[u32], mut multiplier: f64) -> Self {
        let boxes: Vec<Aabb> = which.iter().map(|&i| bounds[i as usize]).collect();
        let most = (MAX_ENTRIES * boxes.len()).max(FEW_ENTRIES);
        let cells = loop {
            let cells = Division::of(&boxes, multiplier);
            let entries = boxes.iter().map(|b| cells.ranges(b).map(|r| r.len()).iter().product());
            if multiplier < 0.01 || entries.fold(0, usize::saturating_add) <= most {
                break cells;
            }
            multiplier *= 0.5;
        };
        // counting sort: the number of entries of each cell, where they start, then the entries
        let number = cells.counts.iter().product::<usize>();
        let mut starts = vec![0_u32; number + 1];
        for cell in boxes.iter().flat_map(|b| cells.overlapped(b)) {
            starts[cell + 1] += 1;
        }
        for cell in 0..number {
            starts[cell + 1] += starts[cell];
        }
        let mut next = starts.clone();
        let mut entries = vec![0; starts[number] as usize];
        for (&index, b) in which.iter().zip(&boxes) {
            for cell in cells.overlapped(b) {
                entries[next[cell] as usize] = index;
                next[cell] += 1;
            }
        }
        Self { all: which.to_vec(), cells, starts, entries }
    }

    /// Tests the primitives in the cells along the ray. See [`super::Accel::visit`].
    #[inline(always)]
    pub(super) fn visit(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        span: Span,
        counter: &mut impl Counter,
        mut test: impl FnMut(u32) -> f64,
    ) {
        let Some(walk) = Walk::new(&self.cells, ray, box_ray, span) else {
            for &index in &self.all {
                counter.test();
                if test(index) == f64::NEG_INFINITY {
                    return;
                }
            }
            return;
        };
        let mut tested = [u32::MAX; MAILBOXES];
        let mut end = span.max;
        for (cell, leaves) in walk {
            counter.step();
            for &index in self.cell(cell) {
                if std::mem::replace(&mut tested[index as usize % MAILBOXES], index) != index {
                    counter.test();
                    end = test(index);
                    if end == f64::NEG_INFINITY {
                        return;
                    }
                }
            }
            if end < leaves {
                return;
            }
        }
    }

    /// The cells along the ray, each with the `t` at which the ray leaves it; `None` for a ray from
    /// too far away.
    pub(super) fn walk(&self, ray: &Ray, span: Span) -> Option<Vec<(usize, f64)>> {
        let box_ray = BoxRay::new(ray, self.cells.bounds.largest_coordinate());
        Some(Walk::new(&self.cells, ray, &box_ray, span)?.collect())
    }

    /// Cells on each axis.
    pub(super) fn resolution(&self) -> [usize; 3] {
        self.cells.counts
    }

    /// The primitives in a cell. Cells are numbered along x first, then along y.
    pub(super) fn cell(&self, cell: usize) -> &[u32] {
        &self.entries[self.starts[cell] as usize..self.starts[cell + 1] as usize]
    }

    pub(super) fn memory_bytes(&self) -> usize {
        size_of_val(&*self.all) + size_of_val(&*self.starts) + size_of_val(&*self.entries)
    }
}

impl Division {
    fn of(boxes: &[Aabb], multiplier: f64) -> Self {
        let whole = boxes.iter().fold(Aabb::EMPTY, |all, &b| all.union(b));
        let n = boxes.len().max(1) as f64;
        let largest = whole.largest_coordinate();
        let w = thickened(whole.extent(), MIN_EXTENT * largest, n);
        let s = cbrt(w[0] * w[1] * w[2] / n);
        let counts = w.map(|w| (multiplier * w / s) as usize + 1);
        let side = |extent: f64, i: usize| extent / counts[i] as f64;
        let longest = (0..3).map(|i| side(w[i], i)).fold(0.0, f64::max);
        let sides = std::array::from_fn(|i| side(whole.extent().along(i), i));
        let pad = (PAD * longest).max(MIN_PAD * whole.extent().max_abs());
        Self { bounds: whole, counts, sides, pad }
    }

    /// The cell of a coordinate on an axis; the first or last for what lies outside.
    fn along(&self, axis: usize, x: f64) -> usize {
        let cell = (x - self.bounds.min.along(axis)) / self.sides[axis];
        (cell as usize).min(self.counts[axis] - 1) // negative numbers and 0/0 become 0
    }

    /// The number of a cell: the first index runs fastest.
    fn number(&self, [x, y, z]: [usize; 3]) -> usize {
        x + self.counts[0] * (y + self.counts[1] * z)
    }

    /// The range of cells on each axis that the padded box overlaps.
    fn ranges(&self, b: &Aabb) -> [Range<usize>; 3] {
        [0, 1, 2].map(|axis| {
            let (min, max) = (b.min.along(axis) - self.pad, b.max.along(axis) + self.pad);
            self.along(axis, min)..self.along(axis, max) + 1
        })
    }

    /// The cells that the padded box overlaps.
    fn overlapped(&self, b: &Aabb) -> impl Iterator<Item = usize> {
        let [xs, ys, zs] = self.ranges(b);
        zs.flat_map(move |z| {
            let xs = xs.clone();
            ys.clone().flat_map(move |y| xs.clone().map(move |x| self.number([x, y, z])))
        })
    }

    /// The coordinate of the border between cells `k − 1` and `k` of an axis.
    fn border(&self, axis: usize, k: usize) -> f64 {
        self.bounds.min.along(axis) + k as f64 * self.sides[axis]
    }
}

/// Extents without a flat one, for which the formula has no answer. A sheet gets the thickness of
/// the width of each primitive's share of it, a line that of the length of its share.
fn thickened(extent: Vector, least: f64, n: f64) -> [f64; 3] {
    let mut w = extent.to_array();
    let mut by_length = [0, 1, 2];
    by_length.sort_by(|&i, &j| w[j].total_cmp(&w[i]));
    let [long, middle, short] = by_length;
    w[long] = w[long].max(least);
    w[middle] = w[middle].max(w[long] / n);
    w[short] = w[short].max((w[long] * w[middle] / n).sqrt());
    w
}

/// The cells along a ray, each with the `t` at which the ray leaves it.
struct Walk<'a> {
    cells: &'a Division,
    ray: &'a Ray,
    /// One over the direction.
    inverse: [f64; 3],
    cell: [usize; 3],
    /// The `t` at which the ray leaves the cell on each axis.
    next: [f64; 3],
    /// The `t` at which it leaves the last cell.
    far: f64,
    inside: bool,
}

impl<'a> Walk<'a> {
    /// `None` for a ray whose slack is too large, or whose numbers overflow.
    fn new(cells: &'a Division, ray: &'a Ray, box_ray: &BoxRay, span: Span) -> Option<Self> {
        let (start, far) = box_ray.crossing(&cells.bounds, span.min, f64::INFINITY);
        let inside = start <= far;
        if 2.0 * box_ray.slack() > cells.pad || inside && !start.is_finite() {
            return None;
        }
        let inverse = box_ray.inverse();
        let mut walk = Self { cells, ray, inverse, cell: [0; 3], next: [0.0; 3], far, inside };
        for axis in 0..3 {
            let x = ray.origin.along(axis) + start * ray.direction.along(axis);
            walk.cell[axis] = cells.along(axis, x);
            walk.next[axis] = walk.end(axis);
        }
        Some(walk)
    }

    fn backward(&self, axis: usize) -> bool {
        self.inverse[axis].is_sign_negative()
    }

    /// The `t` at which the ray leaves its cell on this axis. It is infinite for a ray parallel to
    /// the borders, and at an outermost border, because boxes grown by a ray's slack may extend
    /// beyond it.
    fn end(&self, axis: usize) -> f64 {
        let k = self.cell[axis] + usize::from(!self.backward(axis));
        if k == 0 || k == self.cells.counts[axis] || self.inverse[axis].is_infinite() {
            return f64::INFINITY;
        }
        (self.cells.border(axis, k) - self.ray.origin.along(axis)) * self.inverse[axis]
    }
}

impl Iterator for Walk<'_> {
    type Item = (usize, f64);

    fn next(&mut self) -> Option<(usize, f64)> {
        if !self.inside {
            return None;
        }
        let cell = self.cells.number(self.cell);
        let [x, y, z] = self.next;
        let axis = if x <= y && x <= z { 0 } else { 1 + usize::from(z < y) };
        let end = self.next[axis];
        self.inside = end < self.far; // false at an outermost border
        if self.inside {
            let i = self.cell[axis];
            self.cell[axis] = if self.backward(axis) { i - 1 } else { i + 1 };
            self.next[axis] = self.end(axis);
        }
        Some((cell, end))
    }
}
