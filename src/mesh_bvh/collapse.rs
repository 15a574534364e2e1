//! Turns the binary tree into a tree of sixteen children a node, of the least expected cost.
//!
//! Source: Ylitie, Karras & Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed
//! Wide BVHs" (HPG 2017), section 3: for every binary subtree, bottom up, the least cost of
//! representing it by at most 1, 2 … 15 children of one node. A child is a leaf or a node.

use arrayvec::ArrayVec;

use super::block::Block;
use super::node::{LEAF, Node, WIDTH};
use crate::accel::build::{BuiltNode as Binary, join};
use crate::math::Point;

/// The cost of testing a node's boxes, in blocks of triangles.
const NODE_COST: f64 = 1.0;

/// The best choices for one binary subtree.
#[derive(Clone, Copy, Default)]
struct Choice {
    /// As one child: whether a leaf rather than a node.
    leaf: bool,
    /// As `i` children: the number of children of its left half; 0 if `i − 1` children are as good.
    left: [u8; WIDTH + 1],
}

/// The least costs as 1 to 15 children; index 0 is not used.
type Costs = [f64; WIDTH];

/// The wide tree of the least cost over a binary tree: its nodes, the root first, and the blocks of
/// triangles that are its leaves. `order` are the triangles in the order of the binary tree's
/// leaves.
pub fn collapse(
    tree: &[Binary],
    order: &[u32],
    triangles: &[[u32; 3]],
    vertices: &[Point],
) -> (Vec<Node>, Vec<Block>) {
    let mut choices = vec![Choice::default(); tree.len()];
    choose(tree, &mut choices, order, triangles);
    let (nodes, blocks) = (vec![Node::EMPTY], Vec::new());
    let mut wide = Wide { tree, choices: &choices, order, triangles, vertices, nodes, blocks };
    let all = Subtree { root: 0, first: 0 };
    if choices[0].leaf {
        let leaf = wide.leaf(all);
        wide.nodes[0].set(0, &tree[0].bounds, leaf);
    } else {
        wide.fill(0, all);
    }
    (wide.nodes, wide.blocks)
}

/// Fills in the choices of a subtree, and returns its costs.
fn choose(tree: &[Binary], choices: &mut [Choice], order: &[u32], triangles: &[[u32; 3]]) -> Costs {
    let area = tree[0].bounds.half_area();
    let (choice, below) = choices.split_first_mut().expect("a tree has a root");
    if order.len() == 1 {
        choice.leaf = true;
        return [area; WIDTH];
    }
    let leaf = if Block::fits(order, triangles) { area } else { f64::INFINITY };
    let middle = tree[1].count as usize;
    let (low, high) = below.split_at_mut(2 * middle - 1);
    let half = |start, choices, order| move || choose(&tree[start..], choices, order, triangles);
    let choose_low = half(1, low, &order[..middle]);
    let choose_high = half(2 * middle, high, &order[middle..]);
    let (low, high) = join(order.len(), choose_low, choose_high);
    let shared = |all: usize| {
        let costs = (1..all)
            .map(|left| (low[left.min(WIDTH - 1)] + high[(all - left).min(WIDTH - 1)], left as u8));
        costs.fold((f64::INFINITY, 1), |least, other| if other.0 < least.0 { other } else { least })
    };
    let (inside, left) = shared(WIDTH);
    choice.left[WIDTH] = left;
    let node = NODE_COST * area + inside;
    // a box of zero area costs nothing: at equal costs choose the leaf, if it is allowed
    choice.leaf = leaf <= node && leaf < f64::INFINITY;
    let mut costs = [leaf.min(node); WIDTH];
    for all in 2..WIDTH {
        let (cost, left) = shared(all);
        let fewer = costs[all - 1];
        (costs[all], choice.left[all]) = if cost < fewer { (cost, left) } else { (fewer, 0) };
    }
    costs
}

/// A subtree of the binary tree: the index of its root, and of its first triangle in the order.
#[derive(Clone, Copy)]
struct Subtree {
    root: usize,
    first: usize,
}

/// The wide tree under construction.
struct Wide<'a> {
    tree: &'a [Binary],
    choices: &'a [Choice],
    order: &'a [u32],
    triangles: &'a [[u32; 3]],
    vertices: &'a [Point],
    nodes: Vec<Node>,
    blocks: Vec<Block>,
}

impl Wide<'_> {
    /// Gives a node the children of least cost for a subtree, and adds everything below them.
    fn fill(&mut self, node: usize, subtree: Subtree) {
        let mut children = ArrayVec::new();
        let left = self.choices[subtree.root].left[WIDTH];
        self.halves(subtree, left, WIDTH as u8, &mut children);
        for (slot, child) in children.into_iter().enumerate() {
            let index = if self.choices[child.root].leaf {
                self.leaf(child)
            } else {
                self.nodes.push(Node::EMPTY);
                let index = self.nodes.len() - 1;
                self.fill(index, child);
                index as u32
            };
            self.nodes[node].set(slot, &self.tree[child.root].bounds, index);
        }
    }

    /// Lists the roots of the `all` children that represent a subtree.
    fn roots(&self, subtree: Subtree, mut all: u8, children: &mut ArrayVec<Subtree, WIDTH>) {
        let choice = &self.choices[subtree.root];
        while all > 1 && choice.left[all as usize] == 0 {
            all -= 1;
        }
        if all == 1 {
            children.push(subtree);
        } else {
            self.halves(subtree, choice.left[all as usize], all, children);
        }
    }

    fn halves(
        &self,
        Subtree { root, first }: Subtree,
        left: u8,
        all: u8,
        children: &mut ArrayVec<Subtree, WIDTH>,
    ) {
        let middle = self.tree[root + 1].count as usize;
        self.roots(Subtree { root: root + 1, first }, left, children);
        let right = Subtree { root: root + 2 * middle, first: first + middle };
        self.roots(right, all - left, children);
    }

    /// Adds the block of all triangles of a subtree; returns the leaf's index.
    fn leaf(&mut self, Subtree { root, first }: Subtree) -> u32 {
        let count = self.tree[root].count as usize;
        let block = Block::new(&self.order[first..first + count], self.triangles, self.vertices);
        self.blocks.push(block);
        LEAF | (self.blocks.len() - 1) as u32
    }
}
