//! The bounding volume hierarchy: a binary tree of boxes, built by the surface-area heuristic.
//!
//! Source: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies" (2007), for the
//! binned build. The build is parallel and deterministic: the two halves do not know each other.

use super::frame::Frame;
use super::search::{Any, Nearest};
use super::{Counter, Primitives};
use crate::math::Aabb;
use crate::shapes::Candidate;

/// Nodes in depth-first order: the left child of an inner node follows it.
#[derive(Debug)]
pub struct Bvh {
    nodes: Vec<Node>,
    /// Primitive numbers, leaf by leaf.
    order: Vec<u32>,
}

#[derive(Clone, Debug)]
struct Node {
    bounds: Aabb,
    /// Inner node: where its right child is. Leaf: where its primitives start in `order`.
    next: u32,
    /// Primitives of a leaf; 0 for an inner node.
    count: u32,
}

/// Candidate splits on each axis.
const BINS: usize = 16;
/// The cost of visiting an inner node, in primitive tests.
const VISIT_COST: f64 = 1.0;
/// A leaf never holds more.
const LARGEST_LEAF: usize = 8;
/// From this depth on, halves are equal, so that the tree is at most 32 deeper.
const SAH_DEPTH: usize = 64;
/// Deep enough for any tree: see [`SAH_DEPTH`].
const STACK: usize = SAH_DEPTH + 33;
/// Below this many primitives a thread of its own is not worth starting.
const PARALLEL: usize = 4096;

/// A primitive while the tree is being built.
#[derive(Clone, Copy)]
struct Item {
    bounds: Aabb,
    index: u32,
}

impl Item {
    /// Twice the centre along an axis.
    fn center(&self, axis: usize) -> f64 {
        self.bounds.min.along(axis) + self.bounds.max.along(axis)
    }
}

impl Bvh {
    /// Over these primitives, whose boxes are `bounds`.
    pub(super) fn build(frame: &Frame, bounds: &[Aabb], which: &[u32]) -> Self {
        let item = |&index: &u32| Item { bounds: frame.boxed(&bounds[index as usize]), index };
        let mut items: Vec<Item> = which.iter().map(item).collect();
        let nodes = if items.is_empty() { Vec::new() } else { subtree(&mut items, 0, 0) };
        Self { nodes, order: items.iter().map(|item| item.index).collect() }
    }

    /// Visits nearer boxes first; a box entered behind the best hit is skipped.
    pub(super) fn nearest<P: Primitives, C: Counter>(&self, search: &mut Nearest<'_, P, C>) {
        let mut stack = [(0_u32, 0.0_f64); STACK];
        let mut waiting = 0;
        let mut current =
            self.nodes.first().and_then(|root| search.enters(&root.bounds)).map(|_| 0);
        loop {
            let Some(at) = current else {
                // equal distance is not farther: ties are settled by the order of objects
                match stack[..waiting].iter().rposition(|&(_, entry)| entry <= search.farthest()) {
                    Some(place) => (current, waiting) = (Some(stack[place].0), place),
                    None => return,
                }
                continue;
            };
            search.counter.step();
            let node = &self.nodes[at as usize];
            if node.count > 0 {
                self.leaf(node).iter().for_each(|&index| search.consider(index));
                current = None;
                continue;
            }
            let [left, right] = [at + 1, node.next];
            let entries = [left, right].map(|i| search.enters(&self.nodes[i as usize].bounds));
            current = match entries {
                [Some(l), Some(r)] => {
                    let (near, far) = if l <= r { (left, (right, r)) } else { (right, (left, l)) };
                    stack[waiting] = far;
                    waiting += 1;
                    Some(near)
                }
                [Some(_), None] => Some(left),
                [None, Some(_)] => Some(right),
                [None, None] => None,
            };
        }
    }

    pub(super) fn any<P: Primitives>(&self, search: &Any<'_, P>) -> Option<(u32, Candidate)> {
        let mut stack = [0_u32; STACK];
        let mut waiting = usize::from(!self.nodes.is_empty());
        while waiting > 0 {
            waiting -= 1;
            let at = stack[waiting];
            let node = &self.nodes[at as usize];
            if !search.enters(&node.bounds) {
                continue;
            }
            if node.count > 0 {
                if let Some(hit) =
                    self.leaf(node).iter().copied().find_map(|index| search.consider(index))
                {
                    return Some(hit);
                }
            } else {
                stack[waiting] = node.next;
                stack[waiting + 1] = at + 1;
                waiting += 2;
            }
        }
        None
    }

    pub(super) fn memory_bytes(&self) -> usize {
        size_of_val(&*self.nodes) + size_of_val(&*self.order)
    }

    fn leaf(&self, node: &Node) -> &[u32] {
        let first = node.next as usize;
        &self.order[first..first + node.count as usize]
    }
}

/// The nodes of the tree over `items`, which it puts in leaf order; `first` is where they stand in
/// the whole order. Places of nodes are relative to the root of the subtree.
fn subtree(items: &mut [Item], first: u32, depth: usize) -> Vec<Node> {
    let bounds = items.iter().fold(Aabb::EMPTY, |all, item| all.union(item.bounds));
    let Some(middle) = split(items, &bounds, depth) else {
        return vec![Node { bounds, next: first, count: items.len() as u32 }];
    };
    let parallel = items.len() > PARALLEL;
    let (low, high) = items.split_at_mut(middle);
    let mut build_low = || subtree(low, first, depth + 1);
    let mut build_high = || subtree(high, first + middle as u32, depth + 1);
    let (left, right) =
        if parallel { rayon::join(build_low, build_high) } else { (build_low(), build_high()) };
    let right_at = 1 + left.len() as u32;
    let mut nodes = Vec::with_capacity(1 + left.len() + right.len());
    nodes.push(Node { bounds, next: right_at, count: 0 });
    for (half, offset) in [(left, 1), (right, right_at)] {
        let moved = |node: Node| match node.count {
            0 => Node { next: node.next + offset, ..node },
            _ => node,
        };
        nodes.extend(half.into_iter().map(moved));
    }
    nodes
}

/// Reorders the items into two groups and says where the second starts; `None` for a leaf.
fn split(items: &mut [Item], bounds: &Aabb, depth: usize) -> Option<usize> {
    if items.len() == 1 {
        return None;
    }
    let leaf_cost = items.len() as f64;
    let best = if depth < SAH_DEPTH { cheapest_plane(items, bounds) } else { None };
    match best {
        Some((cost, _)) if items.len() <= LARGEST_LEAF && cost >= leaf_cost => None,
        Some((_, plane)) => Some(partition(items, |item| plane.bin(item) < plane.first_high)),
        // all centres in one place, or too deep: equal halves in the order of objects
        None if items.len() <= LARGEST_LEAF => None,
        None => Some(items.len() / 2),
    }
}

/// A stable partition, so that the build does not depend on chance.
fn partition(items: &mut [Item], is_low: impl Fn(&Item) -> bool) -> usize {
    let (low, high): (Vec<_>, Vec<_>) = items.iter().partition(|item| is_low(item));
    items[..low.len()].copy_from_slice(&low);
    items[low.len()..].copy_from_slice(&high);
    low.len()
}

/// A split between two bins of an axis.
struct Plane {
    axis: usize,
    start: f64,
    bins_per_length: f64,
    first_high: usize,
}

impl Plane {
    fn bin(&self, item: &Item) -> usize {
        let place = (item.center(self.axis) - self.start) * self.bins_per_length;
        (place as usize).min(BINS - 1)
    }
}

/// The split of the least expected cost over all axes, and that cost in primitive tests.
fn cheapest_plane(items: &[Item], bounds: &Aabb) -> Option<(f64, Plane)> {
    let mut best: Option<(f64, Plane)> = None;
    for axis in 0..3 {
        let (low, high) = items
            .iter()
            .map(|item| item.center(axis))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), c| (low.min(c), high.max(c)));
        let bins_per_length = BINS as f64 / (high - low);
        // an extent that overflows would put everything into one bin
        if !(high > low && (high - low).is_finite() && bins_per_length.is_finite()) {
            continue;
        }
        let mut plane = Plane { axis, start: low, bins_per_length, first_high: 0 };
        let mut bins = [(0_usize, Aabb::EMPTY); BINS];
        for item in items {
            let (count, bounds) = &mut bins[plane.bin(item)];
            *count += 1;
            *bounds = bounds.union(item.bounds);
        }
        let (cost, first_high) = cheapest_border(&bins);
        plane.first_high = first_high;
        let cost = VISIT_COST + cost / bounds.half_area();
        // a flat box of no area makes the cost NaN: any split will do
        if best.as_ref().is_none_or(|(least, _)| cost < *least) {
            best = Some((cost, plane));
        }
    }
    best
}

/// The border between two bins with the least sum of area × count, and that sum.
fn cheapest_border(bins: &[(usize, Aabb); BINS]) -> (f64, usize) {
    let mut above = [0.0; BINS];
    let mut so_far = (0, Aabb::EMPTY);
    for i in (1..BINS).rev() {
        so_far = (so_far.0 + bins[i].0, so_far.1.union(bins[i].1));
        above[i] = weight(&so_far);
    }
    let mut so_far = (0, Aabb::EMPTY);
    let mut least = (f64::INFINITY, 1);
    for border in 1..BINS {
        so_far = (so_far.0 + bins[border - 1].0, so_far.1.union(bins[border - 1].1));
        let cost = weight(&so_far) + above[border];
        if cost < least.0 {
            least = (cost, border);
        }
    }
    least
}

fn weight((count, bounds): &(usize, Aabb)) -> f64 {
    if *count == 0 { 0.0 } else { *count as f64 * bounds.half_area() }
}
