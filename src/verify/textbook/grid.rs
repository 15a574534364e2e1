//! The regular grid (Suffern, ch. 22): objects in cells, and a walk that adds up where the next cell
//! begins on each axis.

use std::array::from_fn;

use super::Textbook;
use super::compound::{Part, around};
use super::cuboid::{slab, slabs};
use crate::math::{Aabb, Point, Ray, floor, power};

/// So many cells for each object, at most: where boxes are needles, the book's formula asks for more
/// than memory holds.
const MOST_CELLS: f64 = 64.0;

/// Objects in cells.
#[derive(Debug)]
pub struct Grid {
    min: Point,
    max: Point,
    counts: [usize; 3],
    /// The places in `parts` of what is in each cell, x fastest.
    cells: Vec<Vec<usize>>,
    parts: Vec<Part>,
}

impl Grid {
    /// Parts in their boxes, which are bounded.
    pub fn new(parts: Vec<(Aabb, Part)>) -> Self {
        let (boxes, parts): (Vec<Aabb>, Vec<Part>) = parts.into_iter().unzip();
        let [min, max] = around(&boxes);
        let w = max - min;
        let s = power(w.x() * w.y() * w.z() / boxes.len() as f64, 1.0 / 3.0);
        let mut multiplier = 2.0;
        let counts = loop {
            let counts: [f64; 3] = from_fn(|i| floor(multiplier * w.along(i) / s) + 1.0);
            let most = 8.0 + MOST_CELLS * boxes.len() as f64;
            if counts.iter().product::<f64>() <= most {
                break counts.map(|n| n as usize);
            }
            multiplier *= 0.5;
        };
        let mut grid = Self { min, max, counts, cells: Vec::new(), parts };
        grid.cells.resize(counts.iter().product(), Vec::new());
        for (object, own) in boxes.iter().enumerate() {
            let first: [usize; 3] = from_fn(|i| grid.cell(i, own.min.along(i)));
            let last: [usize; 3] = from_fn(|i| grid.cell(i, own.max.along(i)));
            for z in first[2]..=last[2] {
                for y in first[1]..=last[1] {
                    for x in first[0]..=last[0] {
                        let place = grid.place([x, y, z]);
                        grid.cells[place].push(object);
                    }
                }
            }
        }
        grid
    }

    /// Which cell of axis `i` a coordinate is in; the first or last for those outside.
    fn cell(&self, i: usize, x: f64) -> usize {
        let (low, high) = (self.min.along(i), self.max.along(i));
        let n = self.counts[i] as f64;
        ((x - low) * n / (high - low)).clamp(0.0, n - 1.0) as usize
    }

    fn place(&self, [x, y, z]: [usize; 3]) -> usize {
        x + self.counts[0] * (y + self.counts[1] * z)
    }
}

impl Textbook for Grid {
    fn hit(&self, ray: &Ray) -> Option<f64> {
        let (min, max) = (self.min, self.max);
        let (t0, t1) = slabs(ray, min, max);
        if t0 > t1 {
            return None;
        }
        let inside = (0..3).all(|i| {
            let o = ray.origin.along(i);
            min.along(i) < o && o < max.along(i)
        });
        let start = if inside { ray.origin } else { ray.at(t0) };
        let mut at: [usize; 3] = from_fn(|i| self.cell(i, start.along(i)));

        let slabs: [(f64, f64); 3] = from_fn(|i| slab(ray, min, max, i));
        let step: [f64; 3] = from_fn(|i| (slabs[i].1 - slabs[i].0) / self.counts[i] as f64);
        let mut next: [f64; 3] = from_fn(|i| {
            let d = ray.direction.along(i);
            if d > 0.0 {
                slabs[i].0 + (at[i] + 1) as f64 * step[i]
            } else if d < 0.0 {
                slabs[i].0 + (self.counts[i] - at[i]) as f64 * step[i]
            } else {
                f64::INFINITY
            }
        });
        loop {
            let [x, y, z] = next;
            let axis = if x < y && x < z {
                0
            } else if y < z {
                1
            } else {
                2
            };
            let objects = self.cells[self.place(at)].iter();
            let hits = objects.filter_map(|&object| self.parts[object].hit(ray));
            let nearest = hits.fold(f64::INFINITY, |least, t| if t < least { t } else { least });
            if nearest < next[axis] {
                return Some(nearest);
            }
            next[axis] += step[axis];
            let forward = ray.direction.along(axis) > 0.0;
            let last = if forward { self.counts[axis] - 1 } else { 0 };
            if at[axis] == last || next[axis].is_nan() {
                return None;
            }
            at[axis] = if forward { at[axis] + 1 } else { at[axis] - 1 };
        }
    }
}
