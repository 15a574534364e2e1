//! Laws of cells and walks (Suffern, ch. 22), which are private.

use super::*;
use crate::math::{Pcg32, Point, Ray, Span};

fn cube_of_boxes(n: usize, seed: u64, radius: f64) -> Vec<Aabb> {
    let mut random = Pcg32::new(seed, 0);
    let mut coordinate = || 2.0 * random.uniform() - 1.0;
    let half = Vector::new(radius, radius, radius);
    let mut boxes: Vec<Aabb> = (0..n)
        .map(|_| {
            let center = Point::new(coordinate(), coordinate(), coordinate());
            Aabb { min: center - half, max: center + half }
        })
        .collect();
    // objects in two opposite corners, so that the sides of the cube are known
    for (at, corner) in [(0, -1.0), (1, 1.0)] {
        let center = Point::new(corner, corner, corner);
        boxes[at] = Aabb { min: center - half, max: center + half };
    }
    boxes
}

fn grid(boxes: &[Aabb]) -> Grid {
    Grid::build(boxes, &Vec::from_iter(0..boxes.len() as u32), MULTIPLIER)
}

/// Law: a thousand objects in a cube have 20 or 21 cells on each axis, and any number of them about
/// eight for each (Suffern, ch. 22, invariant 3). Oracle: the book's formula, worked by hand.
#[test]
fn cells_are_as_many_as_the_book_says() {
    for (n, on_axis) in [(1000, 20..=21), (8, 4..=5), (27_000, 60..=61)] {
        let boxes = cube_of_boxes(n, 22, 0.01);
        let counts = grid(&boxes).cells.counts;
        assert!(counts.iter().all(|count| on_axis.contains(count)), "{n}: {counts:?}");
    }
}

/// Law: a slab has fewer cells across it, in proportion. Oracle: the book's formula by hand: sides
/// 4, 2, 1 and 64 objects make s = (8/64)^(1/3) = 1/2, so 17, 9 and 5 cells.
#[test]
fn cells_are_cubes_in_slabs() {
    let corners = [Point::ORIGIN, Point::new(4.0, 2.0, 1.0)].map(|p| Aabb { min: p, max: p });
    let boxes: Vec<Aabb> = corners.into_iter().cycle().take(64).collect();
    assert_eq!(grid(&boxes).cells.counts, [17, 9, 5]);
}

/// Law: flat, thin and pointlike scenes have a sane number of cells. Oracle: by
/// the formula for a square and a line: about 4 and 2 cells for each object, three thick.
#[test]
fn flat_scenes_do_not_explode() {
    for (extent, most) in
        [([1.0, 0.0, 1.0], 16), ([0.0, 1.0, 0.0], 32), ([0.0; 3], 32), ([1e-9; 3], 64)]
    {
        let n = 400;
        let mut random = Pcg32::new(3, 0);
        let boxes: Vec<Aabb> = (0..n)
            .map(|_| Aabb::around([Point::from(extent.map(|e| e * random.uniform()))]))
            .collect();
        let cells = grid(&boxes).cells;
        let number: usize = cells.counts.iter().product();
        assert!((1..=most * n).contains(&number), "{extent:?}: {:?}", cells.counts);
        assert!(cells.pad > 0.0 || extent == [0.0; 3], "{:?}", cells.pad);
    }
}

/// Law: every object is in at least one cell, and the cells it is in cover its box (invariant 5).
/// Oracle: the boxes of all cells, one by one.
#[test]
fn the_cells_of_an_object_cover_its_box() {
    let boxes = cube_of_boxes(60, 5, 0.15);
    let grid = grid(&boxes);
    for (index, b) in (0..).zip(&boxes) {
        for number in 0..grid.starts.len() - 1 {
            let (min, max) = corners(&grid.cells, number);
            let apart = (0..3).any(|i| max[i] < b.min.along(i) || min[i] > b.max.along(i));
            assert!(apart || grid.cell(number).contains(&index), "object {index}, cell {number}");
        }
        assert!(grid.entries.contains(&index));
    }
}

fn corners(cells: &Division, number: usize) -> ([f64; 3], [f64; 3]) {
    let [nx, ny, _] = cells.counts;
    let place = [number % nx, number / nx % ny, number / nx / ny];
    let at = |axis: usize, k: usize| cells.bounds.min.along(axis) + k as f64 * cells.sides[axis];
    (std::array::from_fn(|i| at(i, place[i])), std::array::from_fn(|i| at(i, place[i] + 1)))
}

/// Law: a walk passes each cell that the ray crosses, none twice, in order of distance, each ending
/// where the next begins; from outside, from inside, along walls and through corners. Oracle: the
/// slab test of every cell (cells that are only touched may be left out).
#[test]
fn a_walk_passes_the_cells_that_the_ray_crosses() {
    let boxes = cube_of_boxes(64, 7, 0.01);
    let grid = grid(&boxes);
    let mut random = Pcg32::new(8, 0);
    let mut visited = 0;
    for case in 0..3000 {
        let mut numbers = || {
            std::array::from_fn(|_| match (case % 3, random.below(3)) {
                (1, 0) => 0.0,
                (2, _) => f64::from(random.below(9)) / 4.0 - 1.0,
                _ => 4.0 * random.uniform() - 2.0,
            })
        };
        let (origin, direction): ([f64; 3], [f64; 3]) = (numbers(), numbers());
        if direction == [0.0; 3] {
            continue;
        }
        let ray = Ray::new(origin.into(), direction.into());
        let box_ray = BoxRay::new(&ray, grid.cells.bounds.largest_coordinate());
        let walk = Walk::new(&grid.cells, &ray, &box_ray, Span::AHEAD);
        let walk = walk.unwrap_or_else(|| panic!("{case}: {origin:?} {direction:?} {ray:?}"));
        let mut seen = std::collections::HashSet::new();
        let mut before = f64::NEG_INFINITY;
        for (cell, end) in walk {
            assert!(seen.insert(cell), "twice in cell {cell}");
            assert!(end >= before, "{end} after {before}");
            before = end;
            visited += 1;
        }
        for cell in 0..grid.starts.len() - 1 {
            let (min, max) = corners(&grid.cells, cell);
            let shrunk = 1e-6 * grid.cells.sides[0] + box_ray.slack();
            let inner = Aabb {
                min: Point::from(min.map(|x| x + shrunk)),
                max: Point::from(max.map(|x| x - shrunk)),
            };
            let (near, far) = box_ray.crossing(&inner, 0.0, f64::INFINITY);
            let crossed = near + 1e-6 < far;
            assert!(!crossed || seen.contains(&cell), "{origin:?} {direction:?} misses {cell}");
        }
    }
    assert!(visited > 3000, "only {visited} cells");
}

/// Law: objects that overlap a great many cells do not fill the memory. Oracle: the limit.
#[test]
fn large_objects_get_coarser_cells() {
    let boxes = cube_of_boxes(40_000, 9, 1.0);
    let grid = grid(&boxes);
    assert!(grid.entries.len() <= MAX_ENTRIES * boxes.len(), "{}", grid.entries.len());
}
