//! The build of the tree: primitives are split by the surface-area heuristic, down to single ones.
//!
//! Source: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies" (2007), for the
//! binned build. The build is parallel and deterministic: the two halves are independent.

use arrayvec::ArrayVec;

use crate::math::{Aabb, Point};

/// A primitive while the tree is being built.
#[derive(Clone, Copy)]
pub struct Item {
    pub bounds: Aabb,
    pub index: u32,
}

/// A node of a binary tree over `count` primitives, which has `2·count − 1` nodes in depth-first
/// order: the left half follows its parent, and the right half follows that.
#[derive(Clone, Copy, Debug)]
pub struct BuiltNode {
    pub bounds: Aabb,
    pub count: u32,
}

/// Candidate splits on each axis.
const BINS: usize = 16;
/// From this depth on, primitives are split into equal halves, so that the tree is at most 32
/// deeper.
const SAH_DEPTH: usize = 40;
/// The largest depth of a tree: 2³² primitives are single after 32 halvings.
pub const MAX_DEPTH: usize = SAH_DEPTH + 32;
/// With fewer primitives, a second thread does not pay.
const PARALLEL: usize = 4096;

impl Item {
    /// Twice the centre.
    fn center(&self) -> Point {
        self.bounds.min + self.bounds.max.to_vector()
    }
}

/// The tree over `items`, which it puts in the order of the tree's leaves; no nodes if there are
/// none.
pub fn binary_tree(items: &mut [Item]) -> Vec<BuiltNode> {
    if items.is_empty() {
        return Vec::new();
    }
    let nowhere = BuiltNode { bounds: Aabb::EMPTY, count: 0 };
    let mut tree = vec![nowhere; 2 * items.len() - 1];
    subtree(items, &mut tree, 0);
    tree
}

fn subtree(items: &mut [Item], tree: &mut [BuiltNode], depth: usize) {
    let count = items.len();
    let bounds = items.iter().fold(Aabb::EMPTY, |all, item| all.union(item.bounds));
    let (root, below) = tree.split_first_mut().expect("a tree has a root");
    *root = BuiltNode { bounds, count: count as u32 };
    if count == 1 {
        return;
    }
    let plane = if count > 2 && depth < SAH_DEPTH { cheapest_plane(items) } else { None };
    // only two, all centres coincide, or too deep: equal halves in the order of objects
    let middle = plane.map_or(count / 2, |p| partition(items, |item| p.bin(item) < p.first_high));
    let (low, high) = items.split_at_mut(middle);
    let (left, right) = below.split_at_mut(2 * middle - 1);
    let build_low = || subtree(low, left, depth + 1);
    let build_high = || subtree(high, right, depth + 1);
    join(count, build_low, build_high);
}

/// Runs both: on two threads if there are many primitives, otherwise one after the other.
pub fn join<A: Send, B: Send>(
    primitives: usize,
    low: impl FnOnce() -> A + Send,
    high: impl FnOnce() -> B + Send,
) -> (A, B) {
    if primitives > PARALLEL { rayon::join(low, high) } else { (low(), high()) }
}

/// Puts the low items first and returns their number.
fn partition(items: &mut [Item], is_low: impl Fn(&Item) -> bool) -> usize {
    let mut low = 0;
    for i in 0..items.len() {
        if is_low(&items[i]) {
            items.swap(low, i);
            low += 1;
        }
    }
    low
}

/// A split between two bins of an axis.
struct Split {
    axis: usize,
    start: f64,
    bins_per_length: f64,
    first_high: usize,
}

impl Split {
    /// The bins of an axis; `None` if all centres coincide on it.
    fn new(axis: usize, centers: &Aabb) -> Option<Self> {
        let [start, end] = [centers.min, centers.max].map(|corner| corner.along(axis));
        let bins_per_length = BINS as f64 / (end - start);
        let is_divided = end > start && bins_per_length.is_finite();
        is_divided.then_some(Self { axis, start, bins_per_length, first_high: 0 })
    }

    fn bin(&self, item: &Item) -> usize {
        let bin = (item.center().along(self.axis) - self.start) * self.bins_per_length;
        (bin as usize).min(BINS - 1)
    }
}

/// The number of primitives in a bin, and their bounding box.
type Bin = (u32, Aabb);

/// The split of the least expected cost over all axes; `None` if all centres coincide.
fn cheapest_plane(items: &[Item]) -> Option<Split> {
    let centers = items.iter().fold(Aabb::EMPTY, |all, item| {
        let center = item.center();
        all.union(Aabb { min: center, max: center })
    });
    let planes: ArrayVec<_, 3> = (0..3).filter_map(|axis| Split::new(axis, &centers)).collect();
    let mut bins = [[(0, Aabb::EMPTY); BINS]; 3];
    for item in items {
        for (plane, bins) in planes.iter().zip(&mut bins) {
            let (count, bounds) = &mut bins[plane.bin(item)];
            *count += 1;
            *bounds = bounds.union(item.bounds);
        }
    }
    let mut best: Option<(f64, Split)> = None;
    for (mut plane, bins) in planes.into_iter().zip(&bins) {
        let (cost, first_high) = cheapest_border(bins);
        plane.first_high = first_high;
        if best.as_ref().is_none_or(|(least, _)| cost < *least) {
            best = Some((cost, plane));
        }
    }
    best.map(|(_, plane)| plane)
}

/// The border between two bins with the least sum of area × count, and that sum. Neither half is
/// empty, because the first and the last bin are not.
fn cheapest_border(bins: &[Bin; BINS]) -> (f64, usize) {
    let add = |a: Bin, b: Bin| (a.0 + b.0, a.1.union(b.1));
    let weight =
        |(count, bounds): Bin| if count == 0 { 0.0 } else { count as f64 * bounds.half_area() };
    let mut above = [0.0; BINS];
    let mut so_far = (0, Aabb::EMPTY);
    for i in (1..BINS).rev() {
        so_far = add(so_far, bins[i]);
        above[i] = weight(so_far);
    }
    let mut so_far = (0, Aabb::EMPTY);
    let mut least = (f64::INFINITY, 1);
    for border in 1..BINS {
        so_far = add(so_far, bins[border - 1]);
        let cost = weight(so_far) + above[border];
        if cost < least.0 {
            least = (cost, border);
        }
    }
    least
}
