//! The bounding volume hierarchy: a binary tree of boxes. A ray that misses a box misses its whole subtree.

pub(crate) mod build;

use arrayvec::ArrayVec;

use super::Counter;
use crate::math::{Aabb, BoxRay, Span};
use build::{Item, MAX_DEPTH, Node, binary_tree};

/// The most primitives of a leaf.
const LEAF: usize = 4;

/// The nodes in depth-first order: the left half of a node follows it, and the right half follows that.
#[derive(Debug)]
pub struct Bvh {
    nodes: Vec<Node>,
    /// The primitives in the order of the tree: those of a node are adjacent.
    order: Vec<u32>,
}

/// A node that the ray enters at `enter`, and the first of its primitives in the order.
struct Waiting {
    enter: f64,
    node: usize,
    first: usize,
}

impl Bvh {
    /// The tree over the primitives `which`; `bounds` are the boxes of all.
    pub(super) fn build(bounds: &[Aabb], which: Vec<u32>) -> Self {
        let item = |index| Item { bounds: bounds[index as usize], index };
        let mut items: Vec<Item> = which.into_iter().map(item).collect();
        let nodes = binary_tree(&mut items);
        Self { nodes, order: items.iter().map(|item| item.index).collect() }
    }

    /// Tests the primitives that the ray may hit, the nearest boxes first. See [`super::Accel::visit`].
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
        if let Some(root) = self.nodes.first() {
            let (enter, leave) = ray.crossing(&root.bounds, span.min, end);
            waiting.extend((enter <= leave).then_some(Waiting { enter, node: 0, first: 0 }));
        }
        'next: while let Some(Waiting { enter, mut node, mut first }) = waiting.pop() {
            if enter > end {
                continue; // a nearer hit was found meanwhile
            }
            // descend by the nearer children to a leaf; push the farther ones
            while self.nodes[node].count as usize > LEAF {
                counter.step();
                let left = node + 1;
                let on_left = self.nodes[left].count as usize;
                let right = node + 2 * on_left;
                let l = ray.crossing(&self.nodes[left].bounds, span.min, end);
                let r = ray.crossing(&self.nodes[right].bounds, span.min, end);
                match (l.0 <= l.1, r.0 <= r.1) {
                    (true, true) if l.0 < r.0 => {
                        waiting.push(Waiting { enter: r.0, node: right, first: first + on_left });
                        node = left;
                    }
                    (true, true) => {
                        waiting.push(Waiting { enter: l.0, node: left, first });
                        (node, first) = (right, first + on_left);
                    }
                    (true, false) => node = left,
                    (false, true) => (node, first) = (right, first + on_left),
                    (false, false) => continue 'next,
                }
            }
            counter.step();
            for &index in &self.order[first..first + self.nodes[node].count as usize] {
                counter.test();
                end = test(index);
                if end == f64::NEG_INFINITY {
                    return;
                }
            }
        }
    }

    pub(super) fn memory_bytes(&self) -> usize {
        size_of_val(&*self.nodes) + size_of_val(&*self.order)
    }
}
