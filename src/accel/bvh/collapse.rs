//! From the binary tree to one of sixteen children a node, at the least expected cost.
//!
//! Source: Ylitie, Karras & Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed
//! Wide BVHs" (HPG 2017), section 3: for every binary subtree, bottom up, the least cost of standing
//! for it by at most 1, 2 … 15 children of one node. A child is a leaf or a node of its own.

use arrayvec::ArrayVec;

use super::build::{Binary, join};
use super::node::{LEAF, Node, PART, WIDTH};
use super::{LEAF_SIZE, Leaf, LeafCost, NOTHING};

/// The cost of testing a node's boxes, in leaves of one primitive.
const NODE_COST: f32 = 1.0;

/// What is best for one binary subtree.
#[derive(Clone, Copy, Default)]
struct Choice {
    /// Alone, as one child: a leaf rather than a node.
    leaf: bool,
    /// As `i` children: so many for its left half; 0 if one child less is as good.
    left: [u8; WIDTH + 1],
}

/// Least costs as 1 to 15 children; the place 0 is not used.
type Costs = [f32; WIDTH];

/// Adds the tree of the least cost over primitives (and parts) in the order of the binary tree's
/// leaves to the nodes and leaves; says where its root is.
pub fn collapse<L: LeafCost>(
    tree: &[Binary],
    order: &[u32],
    leaf_cost: &L,
    nodes: &mut Vec<Node>,
    leaves: &mut Vec<Leaf>,
) -> u32 {
    let mut choices = vec![Choice::default(); tree.len()];
    choose(tree, &mut choices, order, leaf_cost);
    let mut wide = Wide { tree, choices: &choices, order, nodes, leaves };
    let all = Subtree { at: 0, first: 0 };
    if !choices[0].leaf {
        return wide.node(all);
    }
    let mut root = Node::EMPTY;
    root.set(0, &tree[0].bounds, wide.leaf(all));
    wide.nodes.push(root);
    wide.nodes.len() as u32 - 1
}

/// Fills the choices of a subtree, and says what it costs.
fn choose<L: LeafCost>(
    tree: &[Binary],
    choices: &mut [Choice],
    order: &[u32],
    leaf_cost: &L,
) -> Costs {
    let area = tree[0].bounds.half_area();
    let (choice, below) = choices.split_first_mut().expect("a tree has a root");
    if let [index] = order {
        choice.leaf = true;
        let cost = if is_part(*index) { NODE_COST } else { leaf_cost.cost(order) };
        return [area * cost; WIDTH];
    }
    let alone = order.len() > LEAF_SIZE || order.iter().any(|&index| is_part(index));
    let leaf = area * if alone { f32::INFINITY } else { leaf_cost.cost(order) };
    let middle = tree[1].count as usize;
    let (low, high) = below.split_at_mut(2 * middle - 1);
    let half = |start, choices, order| move || choose(&tree[start..], choices, order, leaf_cost);
    let choose_low = half(1, low, &order[..middle]);
    let choose_high = half(2 * middle, high, &order[middle..]);
    let (low, high) = join(order.len(), choose_low, choose_high);
    let shared = |all: usize| {
        let costs = (1..all)
            .map(|left| (low[left.min(WIDTH - 1)] + high[(all - left).min(WIDTH - 1)], left as u8));
        costs.fold((f32::INFINITY, 1), |least, other| if other.0 < least.0 { other } else { least })
    };
    let (inside, left) = shared(WIDTH);
    choice.left[WIDTH] = left;
    let node = NODE_COST * area + inside;
    // a box of no area costs nothing: of equal costs the leaf, if there may be one
    choice.leaf = leaf <= node && leaf < f32::INFINITY;
    let mut costs = [leaf.min(node); WIDTH];
    for all in 2..WIDTH {
        let (cost, left) = shared(all);
        let fewer = costs[all - 1];
        (costs[all], choice.left[all]) = if cost < fewer { (cost, left) } else { (fewer, 0) };
    }
    costs
}

/// Whether this is a part rather than a primitive: it is never in a leaf with others.
fn is_part(index: u32) -> bool {
    index & PART == PART
}

/// A subtree of the binary tree: where its root is, and its first primitive.
#[derive(Clone, Copy)]
struct Subtree {
    at: usize,
    first: usize,
}

/// The wide tree as far as it is built.
struct Wide<'a> {
    tree: &'a [Binary],
    choices: &'a [Choice],
    order: &'a [u32],
    nodes: &'a mut Vec<Node>,
    leaves: &'a mut Vec<Leaf>,
}

impl Wide<'_> {
    /// Adds the node that stands for a subtree, and all below it; says where it is.
    fn node(&mut self, subtree: Subtree) -> u32 {
        let at = self.nodes.len();
        self.nodes.push(Node::EMPTY);
        let mut children = ArrayVec::new();
        self.halves(subtree, self.choices[subtree.at].left[WIDTH], WIDTH as u8, &mut children);
        for (slot, child) in children.into_iter().enumerate() {
            let place =
                if self.choices[child.at].leaf { self.leaf(child) } else { self.node(child) };
            self.nodes[at].set(slot, &self.tree[child.at].bounds, place);
        }
        at as u32
    }

    /// Lists the roots of the `all` children that stand for a subtree.
    fn roots(&self, subtree: Subtree, mut all: u8, children: &mut ArrayVec<Subtree, WIDTH>) {
        let choice = &self.choices[subtree.at];
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
        Subtree { at, first }: Subtree,
        left: u8,
        all: u8,
        children: &mut ArrayVec<Subtree, WIDTH>,
    ) {
        let middle = self.tree[at + 1].count as usize;
        self.roots(Subtree { at: at + 1, first }, left, children);
        let right = Subtree { at: at + 2 * middle, first: first + middle };
        self.roots(right, all - left, children);
    }

    /// Adds the leaf of all primitives of a subtree; says which it is, or which part.
    fn leaf(&mut self, Subtree { at, first }: Subtree) -> u32 {
        if is_part(self.order[first]) {
            return self.order[first];
        }
        let count = self.tree[at].count as usize;
        let mut leaf = [NOTHING; LEAF_SIZE];
        leaf[..count].copy_from_slice(&self.order[first..first + count]);
        leaf[..count].sort_unstable();
        self.leaves.push(leaf);
        LEAF | (self.leaves.len() - 1) as u32
    }
}
