//! The bounding volume hierarchy: a binary tree of boxes. A ray that misses a box misses its whole
//! subtree.

pub(crate) mod build;

use arrayvec::ArrayVec;

use super::Counter;
use crate::math::{Aabb, BoxRay, Span, TwoBoxes};
use build::{BuiltNode, Item, MAX_DEPTH, binary_tree};

#[derive(Debug)]
pub struct Bvh {
    /// The box of all, and the top of the tree; none if there are no primitives.
    root: Option<(Aabb, Child)>,
    branches: Vec<Fork>,
    /// The primitives in the order of the leaves, from left to right.
    order: Vec<u32>,
}

/// A place where the tree divides. Both boxes stand here, so that the walk looks at memory once for
/// two tests.
#[derive(Debug)]
struct Fork {
    boxes: TwoBoxes,
    children: [Child; 2],
}

/// What is below a branch.
#[derive(Clone, Copy, Debug)]
enum Child {
    /// The index of another branch.
    Branch(u32),
    /// The place of one primitive in the order.
    Leaf(u32),
}

/// A child whose box the ray enters at `enter`.
struct Waiting {
    enter: f64,
    child: Child,
}

impl Bvh {
    /// The tree over the primitives `which`; `bounds` are the boxes of all.
    pub(super) fn build(bounds: &[Aabb], which: Vec<u32>) -> Self {
        let item = |index| Item { bounds: bounds[index as usize], index };
        let mut items: Vec<Item> = which.into_iter().map(item).collect();
        let nodes = binary_tree(&mut items);
        let order = items.iter().map(|item| item.index).collect();
        drop(items); // their memory is as much as half of the branches take
        let root = nodes.first().map(|node| (node.bounds, child(&nodes, 0, 0)));
        Self { root, branches: branches(&nodes), order }
    }

    /// Tests the primitives that the ray may hit, the nearest boxes first. See
    /// [`super::Accel::visit`].
    #[inline(always)]
    pub(super) fn visit(
        &self,
        ray: &BoxRay,
        span: Span,
        counter: &mut impl Counter,
        mut test: impl FnMut(u32) -> f64,
    ) {
        let mut end = span.max;
        let mut waiting: ArrayVec<Waiting, { MAX_DEPTH + 1 }> = ArrayVec::new();
        if let Some((bounds, child)) = self.root {
            let (enter, leave) = ray.crossing(&bounds, span.min, end);
            waiting.extend((enter <= leave).then_some(Waiting { enter, child }));
        }
        'next: while let Some(Waiting { enter, mut child }) = waiting.pop() {
            if enter > end {
                continue; // a nearer hit was found meanwhile
            }
            // descend by the nearer children to a leaf; push the farther ones
            while let Child::Branch(number) = child {
                counter.step();
                let Fork { boxes, children: [left, right] } = &self.branches[number as usize];
                let [l, r] = ray.crossings(boxes, span.min, end);
                child = match (l.0 <= l.1, r.0 <= r.1) {
                    (true, true) if l.0 < r.0 => {
                        waiting.push(Waiting { enter: r.0, child: *right });
                        *left
                    }
                    (true, true) => {
                        waiting.push(Waiting { enter: l.0, child: *left });
                        *right
                    }
                    (true, false) => *left,
                    (false, true) => *right,
                    (false, false) => continue 'next,
                }
            }
            if let Child::Leaf(place) = child {
                counter.step();
                counter.test();
                end = test(self.order[place as usize]);
                if end == f64::NEG_INFINITY {
                    return;
                }
            }
        }
    }

    pub(super) fn memory_bytes(&self) -> usize {
        size_of_val(&*self.branches) + size_of_val(&*self.order)
    }
}

/// All nodes with two children, in depth-first order.
fn branches(nodes: &[BuiltNode]) -> Vec<Fork> {
    let mut leaves = 0; // before this node
    let mut branches = Vec::with_capacity(nodes.len() / 2);
    for (at, node) in nodes.iter().enumerate() {
        if node.count == 1 {
            leaves += 1;
            continue;
        }
        let on_left = nodes[at + 1].count;
        let [left, right] = [at + 1, at + 2 * on_left as usize];
        let boxes = TwoBoxes::new(&nodes[left].bounds, &nodes[right].bounds);
        let children = [child(nodes, left, leaves), child(nodes, right, leaves + on_left)];
        branches.push(Fork { boxes, children });
    }
    branches
}

/// The node at an index of the depth-first order, which has so many leaves before it, and all
/// others are branches.
fn child(nodes: &[BuiltNode], at: usize, leaves: u32) -> Child {
    if nodes[at].count == 1 { Child::Leaf(leaves) } else { Child::Branch(at as u32 - leaves) }
}
