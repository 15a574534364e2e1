//! The outlines of a scene's shapes in a plane, found by the tracer's own rays.
//!
//! Rays along the lines of a square grid give every crossing with a surface. In a cell of the grid, two crossings of the
//! same object are joined if a ray across the middle between them meets the object there; if the normals at both ends
//! differ, that meeting becomes a point of the outline, and its halves are treated in the same way. Corners are so found
//! to 1/512 of a cell.

use groundtruth::math::{Point, Ray, Span, Vector};
use groundtruth::world::World;

use super::SectionPlane;

/// Cells of the grid along a side.
const CELLS: usize = 96;
/// The part of a cell by which the grid is moved off the centre of the window: surfaces of scenes like to be parallel to the
/// normal of the hit and at round distances, and a grid line within a surface would miss it.
const OFFSET: f64 = 0.381_966;
/// The most surfaces along a grid line.
const MAX_SURFACES: usize = 512;
/// Where the normals at two neighbouring points have a smaller cosine (more than 8° between them), another point is sought.
const SAME_NORMAL: f64 = 0.99;
/// How often a piece of an outline is halved.
const MAX_HALVINGS: u32 = 9;

/// A square of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Its centre.
    pub center: [f64; 2],
    /// Half its side; positive.
    pub half: f64,
}

/// A part of the outline of an object.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// The index of the object.
    pub object: u32,
    /// Its points, each of them a hit.
    pub points: Vec<[f64; 2]>,
}

/// A point where a line of the plane meets a surface.
#[derive(Clone, Copy, Debug)]
struct Crossing {
    object: u32,
    at: [f64; 2],
    /// The part of the normal in the plane; unit, or zero.
    normal: [f64; 2],
}

/// The outlines of all objects in a window of a plane.
///
/// Each point is a hit of the tracer. Between two neighbours, less than √2/96 of the window's side apart, the outline is
/// drawn straight; their normals differ by less than 8° there (or they are 1/512 of that apart), so that it is off by less
/// than 0.05 % of the side. What is smaller than a cell, 1/96 of the side, may be missing.
pub fn outlines(world: &World, plane: &SectionPlane, window: Window) -> Vec<Curve> {
    let scan = Scan { world, plane, window };
    let (crossings, cells) = scan.crossings();
    let mut links: Vec<Vec<Link>> = vec![Vec::new(); crossings.len()];
    for cell in cells {
        scan.join(&crossings, &cell, &mut links);
    }
    chained(&crossings, links)
}

/// A join of a crossing to another one, by way of these points.
#[derive(Clone, Debug)]
struct Link {
    to: usize,
    by: Vec<[f64; 2]>,
}

struct Scan<'a> {
    world: &'a World,
    plane: &'a SectionPlane,
    window: Window,
}

impl Scan<'_> {
    fn cell(&self) -> f64 {
        2.0 * self.window.half / CELLS as f64
    }

    /// The coordinate of a line of the grid.
    fn line(&self, axis: usize, index: usize) -> f64 {
        self.window.center[axis] - self.window.half + (index as f64 + OFFSET) * self.cell()
    }

    /// All crossings, and which of them are on the border of each cell.
    fn crossings(&self) -> (Vec<Crossing>, Vec<Vec<usize>>) {
        let mut found = Vec::new();
        let mut cells = vec![Vec::new(); CELLS * CELLS];
        let length = CELLS as f64 * self.cell();
        for axis in [0, 1] {
            let mut along = [0.0; 2];
            along[axis] = 1.0;
            for index in 0..=CELLS {
                let mut from = [0.0; 2];
                from[axis] = self.line(axis, 0);
                from[1 - axis] = self.line(1 - axis, index);
                for crossing in self.along(from, along, length) {
                    let step = (crossing.at[axis] - from[axis]) / self.cell();
                    let step = (step.max(0.0) as usize).min(CELLS - 1);
                    // the cells on both sides of the line
                    for side in [index.checked_sub(1), Some(index).filter(|&it| it < CELLS)] {
                        let Some(side) = side else { continue };
                        let [column, row] = if axis == 0 { [step, side] } else { [side, step] };
                        cells[row * CELLS + column].push(found.len());
                    }
                    found.push(crossing);
                }
            }
        }
        (found, cells)
    }

    /// The crossings of a line from a point, in a unit direction.
    fn along(&self, from: [f64; 2], along: [f64; 2], length: f64) -> Vec<Crossing> {
        let (start, direction) = (self.plane.to_space(from), self.plane.vector(along));
        let mut found = Vec::new();
        let (mut origin, mut left) = (start, length);
        for _ in 0..MAX_SURFACES {
            let ray = Ray::new(origin, direction);
            let Some(hit) = self.world.hit(&ray, Span { min: 0.0, max: left }) else { break };
            let point = hit.surface.point;
            found.push(self.crossing(hit.object.index, point, hit.surface.normal.into()));
            origin = hit.surface.leave(direction);
            left = length - (point - start).dot(direction);
        }
        found
    }

    fn crossing(&self, object: u32, point: Point, normal: Vector) -> Crossing {
        let normal = self.plane.along(normal);
        let length = length_of(normal);
        let normal = if length > 0.0 { normal.map(|it| it / length) } else { normal };
        Crossing { object, at: self.plane.to_plane(point), normal }
    }

    /// Joins the crossings on the border of a cell in pairs, those first whose chord is nearest to a right angle with the
    /// normals at its ends.
    fn join(&self, crossings: &[Crossing], cell: &[usize], links: &mut [Vec<Link>]) {
        let mut pairs = Vec::new();
        for (place, &a) in cell.iter().enumerate() {
            for &b in &cell[place + 1..] {
                if crossings[a].object == crossings[b].object {
                    pairs.push((misfit(&crossings[a], &crossings[b]), a, b));
                }
            }
        }
        pairs.sort_by(|(a, ..), (b, ..)| a.total_cmp(b));
        let mut joined: Vec<usize> = Vec::new();
        for (_, a, b) in pairs {
            if joined.contains(&a) || joined.contains(&b) {
                continue;
            }
            let mut by = Vec::new();
            if self.between(&crossings[a], &crossings[b], MAX_HALVINGS, &mut by) {
                joined.extend([a, b]);
                links[b].push(Link { to: a, by: by.iter().rev().copied().collect() });
                links[a].push(Link { to: b, by });
            }
        }
    }

    /// The points of the outline between two crossings; whether the object is met between them.
    fn between(&self, a: &Crossing, b: &Crossing, halvings: u32, by: &mut Vec<[f64; 2]>) -> bool {
        let Some(middle) = self.middle(a, b) else { return false };
        if halvings > 0 && dot(a.normal, b.normal).abs() < SAME_NORMAL {
            self.between(a, &middle, halvings - 1, by);
            by.push(middle.at);
            self.between(&middle, b, halvings - 1, by);
        }
        true
    }

    /// Where the line across the middle of the chord meets the object, next to the chord.
    fn middle(&self, a: &Crossing, b: &Crossing) -> Option<Crossing> {
        let chord = minus(b.at, a.at);
        let length = length_of(chord);
        if length <= 1e-12 * self.window.half {
            return Some(*a);
        }
        let across = [-chord[1] / length, chord[0] / length];
        let middle = [0.5 * (a.at[0] + b.at[0]), 0.5 * (a.at[1] + b.at[1])];
        // a wedge of 30° has its edge this far from the middle of a chord
        let reach = 2.0 * length;
        let from = [middle[0] - reach * across[0], middle[1] - reach * across[1]];
        let found = self.along(from, across, 2.0 * reach);
        let off = |it: &Crossing| length_of(minus(it.at, middle));
        let its = found.into_iter().filter(|it| it.object == a.object);
        its.min_by(|x, y| off(x).total_cmp(&off(y)))
    }
}

/// How far the chord of two crossings is from being along the surface at both: from 0 to 2.
fn misfit(a: &Crossing, b: &Crossing) -> f64 {
    let chord = minus(b.at, a.at);
    let length = length_of(chord);
    let along = |it: &Crossing| dot(it.normal, chord).abs();
    if length > 0.0 { (along(a) + along(b)) / length } else { 0.0 }
}

/// The curves of joined crossings: from end to end first, then those that are closed.
fn chained(crossings: &[Crossing], mut links: Vec<Vec<Link>>) -> Vec<Curve> {
    let ends: Vec<usize> = (0..links.len()).filter(|&it| links[it].len() == 1).collect();
    let mut curves = Vec::new();
    for start in ends.into_iter().chain(0..crossings.len()) {
        let mut points = vec![crossings[start].at];
        let mut at = start;
        while let Some(link) = links[at].pop() {
            // the same join, seen from its other end
            if let Some(back) = links[link.to].iter().position(|other| other.to == at) {
                links[link.to].remove(back);
            }
            points.extend(link.by);
            points.push(crossings[link.to].at);
            at = link.to;
        }
        if points.len() > 1 {
            curves.push(Curve { object: crossings[start].object, points: straightened(points) });
        }
    }
    curves
}

/// Without the points that are on the straight line between their neighbours.
fn straightened(points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let mut kept: Vec<[f64; 2]> = Vec::new();
    for point in points {
        if let [.., before, last] = kept[..] {
            let (to_last, to_point) = (minus(last, before), minus(point, before));
            let off = (to_last[0] * to_point[1] - to_last[1] * to_point[0]).abs();
            if off <= 1e-9 * dot(to_point, to_point) && dot(to_last, minus(point, last)) > 0.0 {
                kept.pop();
            }
        }
        kept.push(point);
    }
    kept
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn length_of(a: [f64; 2]) -> f64 {
    dot(a, a).sqrt()
}
