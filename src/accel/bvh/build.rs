//! The binary tree: boxes split by the surface-area heuristic, down to single primitives.
//!
//! Source: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies" (2007), for the
//! binned build. The build is parallel and deterministic: the two halves do not know each other.

/// A box in the frame, in single precision, rounded outward.
#[derive(Clone, Copy, Debug)]
pub struct Box32 {
    pub min: [f32; 3],
    pub max: [f32; 3],
}

/// A primitive while the tree is being built.
#[derive(Clone, Copy)]
pub struct Item {
    pub bounds: Box32,
    pub index: u32,
}

/// A node of the binary tree, which has `count` primitives and `2·count − 1` nodes, in depth-first
/// order: the left half follows its parent, and the right half follows that.
#[derive(Clone, Copy)]
pub struct Binary {
    pub bounds: Box32,
    pub count: u32,
}

/// Candidate splits on each axis.
const BINS: usize = 16;
/// From this depth on, halves are equal, so that the tree is at most 32 deeper.
const SAH_DEPTH: usize = 40;
/// No tree is deeper: halves of 2³² primitives have one each after 32 steps.
pub const DEEPEST: usize = SAH_DEPTH + 32;
/// Below this many primitives a thread of its own is not worth starting.
const PARALLEL: usize = 4096;

impl Box32 {
    pub const EMPTY: Self = Self { min: [f32::INFINITY; 3], max: [f32::NEG_INFINITY; 3] };

    fn union(self, other: Self) -> Self {
        let (a, b) = (self, other);
        Self {
            min: [0, 1, 2].map(|i| if a.min[i] < b.min[i] { a.min[i] } else { b.min[i] }),
            max: [0, 1, 2].map(|i| if a.max[i] > b.max[i] { a.max[i] } else { b.max[i] }),
        }
    }

    pub fn longest_side(&self) -> f32 {
        (0..3).map(|i| self.max[i] - self.min[i]).fold(0.0, f32::max)
    }

    /// Half the surface area.
    pub fn half_area(&self) -> f32 {
        let [x, y, z] = [0, 1, 2].map(|i| self.max[i] - self.min[i]);
        x * y + y * z + z * x
    }
}

impl Item {
    /// Twice the centre along an axis.
    fn center(&self, axis: usize) -> f32 {
        self.bounds.min[axis] + self.bounds.max[axis]
    }
}

/// The tree over `items` (at least one), which it puts in the order of the tree's leaves.
pub fn binary_tree(items: &mut [Item]) -> Vec<Binary> {
    let nowhere = Binary { bounds: Box32::EMPTY, count: 0 };
    let mut tree = vec![nowhere; 2 * items.len() - 1];
    subtree(items, &mut tree, 0);
    tree
}

fn subtree(items: &mut [Item], tree: &mut [Binary], depth: usize) {
    let count = items.len();
    let bounds = items.iter().fold(Box32::EMPTY, |all, item| all.union(item.bounds));
    let (root, below) = tree.split_first_mut().expect("a tree has a root");
    *root = Binary { bounds, count: count as u32 };
    if count == 1 {
        return;
    }
    let plane = if depth < SAH_DEPTH { cheapest_plane(items) } else { None };
    // all centres in one place, or too deep: equal halves in the order of objects
    let middle = plane.map_or(count / 2, |p| partition(items, |item| p.bin(item) < p.first_high));
    let (low, high) = items.split_at_mut(middle);
    let (left, right) = below.split_at_mut(2 * middle - 1);
    let build_low = || subtree(low, left, depth + 1);
    let build_high = || subtree(high, right, depth + 1);
    join(count, build_low, build_high);
}

/// Both: on two threads if there are many primitives, otherwise one after the other.
pub fn join<A: Send, B: Send>(
    primitives: usize,
    low: impl FnOnce() -> A + Send,
    high: impl FnOnce() -> B + Send,
) -> (A, B) {
    if primitives > PARALLEL { rayon::join(low, high) } else { (low(), high()) }
}

/// Puts the low ones first and says how many they are.
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
struct Plane {
    axis: usize,
    start: f32,
    bins_per_length: f32,
    first_high: usize,
}

impl Plane {
    fn bin(&self, item: &Item) -> usize {
        let place = (item.center(self.axis) - self.start) * self.bins_per_length;
        (place as usize).min(BINS - 1)
    }
}

/// Some primitives, and the box around them.
type Bin = (u32, Box32);

/// The split of the least expected cost over all axes; `None` if all centres are in one place.
fn cheapest_plane(items: &[Item]) -> Option<Plane> {
    let mut best: Option<(f32, Plane)> = None;
    for axis in 0..3 {
        let (low, high) = items
            .iter()
            .map(|item| item.center(axis))
            .fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), c| (low.min(c), high.max(c)));
        let bins_per_length = BINS as f32 / (high - low);
        if !(high > low && bins_per_length.is_finite()) {
            continue;
        }
        let mut plane = Plane { axis, start: low, bins_per_length, first_high: 0 };
        let mut bins = [(0, Box32::EMPTY); BINS];
        for item in items {
            let (count, bounds) = &mut bins[plane.bin(item)];
            *count += 1;
            *bounds = bounds.union(item.bounds);
        }
        let (cost, first_high) = cheapest_border(&bins);
        plane.first_high = first_high;
        if best.as_ref().is_none_or(|(least, _)| cost < *least) {
            best = Some((cost, plane));
        }
    }
    best.map(|(_, plane)| plane)
}

/// The border between two bins with the least sum of area × count, and that sum. The first and the
/// last bin are not empty, so neither half is.
fn cheapest_border(bins: &[Bin; BINS]) -> (f32, usize) {
    let add = |a: Bin, b: Bin| (a.0 + b.0, a.1.union(b.1));
    let weight =
        |(count, bounds): Bin| if count == 0 { 0.0 } else { count as f32 * bounds.half_area() };
    let mut above = [0.0; BINS];
    let mut so_far = (0, Box32::EMPTY);
    for i in (1..BINS).rev() {
        so_far = add(so_far, bins[i]);
        above[i] = weight(so_far);
    }
    let mut so_far = (0, Box32::EMPTY);
    let mut least = (f32::INFINITY, 1);
    for border in 1..BINS {
        so_far = add(so_far, bins[border - 1]);
        let cost = weight(so_far) + above[border];
        if cost < least.0 {
            least = (cost, border);
        }
    }
    least
}
