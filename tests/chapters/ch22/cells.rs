//! Cells, the objects in them, and walks along rays.

use groundtruth::accel::Cells;
use groundtruth::math::BoxRay;

use crate::prelude::*;

/// The book's multiplier: eight cells for each object.
const MULTIPLIER: f64 = 2.0;

fn cube_of_boxes(n: usize, seed: u64, radius: f64) -> Vec<Aabb> {
    let mut random = Pcg32::new(seed, 0);
    let mut coordinate = || 2.0 * random.uniform() - 1.0;
    let half = Vector::new(radius, radius, radius);
    let around = |center: Point| Aabb { min: center - half, max: center + half };
    let center = |_| Point::new(coordinate(), coordinate(), coordinate());
    let mut boxes: Vec<Aabb> = (0..n).map(center).map(around).collect();
    // objects in two opposite corners, so that the sides of the cube are known
    for (at, corner) in [(0, -1.0), (1, 1.0)] {
        boxes[at] = around(Point::new(corner, corner, corner));
    }
    boxes
}

/// The places of all cells, and their sides.
fn places(cells: &Cells) -> (Vec<[usize; 3]>, [f64; 3]) {
    let [nx, ny, nz] = cells.resolution();
    let place = |cell: usize| [cell % nx, cell / nx % ny, cell / nx / ny];
    let sides = [0, 1, 2].map(|i| cells.bounds().extent().along(i) / [nx, ny, nz][i] as f64);
    ((0..nx * ny * nz).map(place).collect(), sides)
}

/// The box of a cell.
fn boxed(cells: &Cells, sides: [f64; 3], place: [usize; 3]) -> Aabb {
    let min = cells.bounds().min;
    let corner = |more: usize| {
        Point::from([0, 1, 2].map(|i| min.along(i) + (place[i] + more) as f64 * sides[i]))
    };
    Aabb { min: corner(0), max: corner(1) }
}

/// Law: a thousand objects in a cube have 20 or 21 cells on each axis, and any number of them about
/// eight for each (invariant 3). Oracle: the book's formula, worked by hand.
/// Book: the number of cells.
#[test]
fn cells_are_as_many_as_the_book_says() {
    for (n, on_axis) in [(1000, 20..=21), (8, 4..=5), (27_000, 60..=61)] {
        let counts = Cells::of(&cube_of_boxes(n, 22, 0.01), MULTIPLIER).resolution();
        assert!(counts.iter().all(|count| on_axis.contains(count)), "{n}: {counts:?}");
    }
}

/// Law: a slab has fewer cells across it, in proportion. Oracle: the book's formula by hand: sides
/// 4, 2, 1 and 64 objects make s = (8/64)^(1/3) = 1/2, so 17, 9 and 5 cells.
/// Book: the number of cells.
#[test]
fn cells_are_cubes_in_slabs() {
    let corners = [Point::ORIGIN, Point::new(4.0, 2.0, 1.0)].map(|p| Aabb { min: p, max: p });
    let boxes: Vec<Aabb> = corners.into_iter().cycle().take(64).collect();
    assert_eq!(Cells::of(&boxes, MULTIPLIER).resolution(), [17, 9, 5]);
}

/// Law: flat, thin and pointlike scenes have a sane number of cells, and a ray from near walks them. Oracle: by
/// the formula for a square and a line: about 4 and 2 cells for each object, three thick.
#[test]
fn flat_scenes_do_not_explode() {
    for (extent, most) in
        [([1.0, 0.0, 1.0], 16), ([0.0, 1.0, 0.0], 32), ([0.0; 3], 32), ([1e-9; 3], 64)]
    {
        let n = 400;
        let mut random = Pcg32::new(3, 0);
        let point = |_| Aabb::around([Point::from(extent.map(|e| e * random.uniform()))]);
        let cells = Cells::of(&(0..n).map(point).collect::<Vec<_>>(), MULTIPLIER);
        let number: usize = cells.resolution().iter().product();
        assert!((1..=most * n).contains(&number), "{extent:?}: {:?}", cells.resolution());
        let across = Ray::new(Point::from(extent.map(|e| -e)), Vector::new(1.0, 1.0, 1.0));
        assert!(cells.visited(&across).is_some() || extent == [0.0; 3], "{extent:?}");
    }
}

/// A ray of one of three kinds: any; with zeros in origin and direction; through corners and along walls of cells.
fn ray(random: &mut Pcg32, case: u32) -> Ray {
    let mut numbers = || {
        std::array::from_fn(|_| match (case % 3, random.below(3)) {
            (1, 0) => 0.0,
            (2, _) => f64::from(random.below(9)) / 4.0 - 1.0,
            _ => 4.0 * random.uniform() - 2.0,
        })
    };
    let (origin, direction): ([f64; 3], [f64; 3]) = (numbers(), numbers());
    Ray::new(origin.into(), direction.into())
}

/// Law: a walk passes each cell that the ray crosses, none twice, each beside the one before, and onward; from outside, from
/// inside, along walls and through corners. Oracle: the slab test of every cell (cells that are only touched may be left out).
/// Book: traversal of a grid.
#[test]
fn a_walk_passes_the_cells_that_the_ray_crosses() {
    let cells = Cells::of(&cube_of_boxes(64, 7, 0.01), MULTIPLIER);
    let (places, sides) = places(&cells);
    let mut random = Pcg32::new(8, 0);
    let mut visited = 0;
    for case in 0..3000 {
        let ray = ray(&mut random, case);
        if ray.direction == Vector::ZERO {
            continue;
        }
        let box_ray = BoxRay::new(&ray, cells.bounds().largest_coordinate());
        let walk = cells.visited(&ray).unwrap_or_else(|| panic!("{case}: {ray:?}"));
        for pair in walk.windows(2) {
            let steps = [0, 1, 2].map(|i| pair[1][i] as f64 - pair[0][i] as f64);
            let moved: f64 = steps.iter().map(|step| step.abs()).sum();
            let is_onward = Vector::from(steps).dot(ray.direction) >= 0.0;
            assert!(moved == 1.0 && is_onward, "{ray:?}: {pair:?}");
        }
        visited += walk.len();
        for &place in &places {
            let shrunk = 1e-6 * sides[0] + box_ray.slack();
            let all = Vector::new(shrunk, shrunk, shrunk);
            let cell = boxed(&cells, sides, place);
            let inner = Aabb { min: cell.min + all, max: cell.max - all };
            let (near, far) = box_ray.crossing(&inner, 0.0, f64::INFINITY);
            let crossed = near + 1e-6 < far;
            assert!(!crossed || walk.contains(&place), "{ray:?} misses {place:?}");
        }
    }
    assert!(visited > 3000, "only {visited} cells");
}

/// Law: objects that overlap a great many cells do not fill the memory. Oracle: the limit, 32 entries for each.
#[test]
fn large_objects_get_coarser_cells() {
    let boxes = cube_of_boxes(40_000, 9, 1.0);
    let cells = Cells::of(&boxes, MULTIPLIER);
    let entries: usize = places(&cells).0.iter().map(|&place| cells.objects(place).len()).sum();
    assert!(entries <= 32 * boxes.len(), "{entries}");
}
