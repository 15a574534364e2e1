//! Cells of directions that adapt to samples, and integrals over them whose error is known.
//!
//! Counts in fixed cells tell nothing of a narrow lobe, and a fixed quadrature calls it wrong. So the cells are
//! divided where samples are, and each integral is refined until it no longer changes.

use std::f64::consts::TAU;

use groundtruth::math::{Vector, atan2, cos, sin};

/// A part of a hemisphere: a rectangle in the height `s = 1 − |cos θ|` and the azimuth φ, which is a solid angle of
/// its area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// 1 above the surface, −1 below.
    pub side: f64,
    s: [f64; 2],
    phi: [f64; 2],
}

/// A direction in these coordinates: side, height and azimuth.
fn coordinates(w: Vector) -> (f64, [f64; 2]) {
    // not 1 − |z|, which loses its digits near the normal
    let s = (w.x() * w.x() + w.y() * w.y()) / (1.0 + w.z().abs());
    let phi = atan2(w.y(), w.x());
    (1.0_f64.copysign(w.z()), [s.min(1.0), if phi < 0.0 { phi + TAU } else { phi }])
}

impl Cell {
    fn hemisphere(side: f64) -> Self {
        Self { side, s: [0.0, 1.0], phi: [0.0, TAU] }
    }

    /// The direction at these shares of the sides.
    fn at(&self, [a, b]: [f64; 2]) -> Vector {
        let s = self.s[0] + a * (self.s[1] - self.s[0]);
        let phi = self.phi[0] + b * (self.phi[1] - self.phi[0]);
        let sine = (s * (2.0 - s)).sqrt();
        Vector::new(sine * cos(phi), sine * sin(phi), self.side * (1.0 - s))
    }

    fn solid_angle(&self) -> f64 {
        (self.s[1] - self.s[0]) * (self.phi[1] - self.phi[0])
    }

    /// The parts below and above a coordinate along an axis.
    fn split(&self, axis: usize, at: f64) -> [Self; 2] {
        let (mut low, mut high) = (*self, *self);
        match axis {
            0 => (low.s[1], high.s[0]) = (at, at),
            _ => (low.phi[1], high.phi[0]) = (at, at),
        }
        [low, high]
    }

    /// Its range along an axis: 0 is s, 1 is φ.
    fn range(&self, axis: usize) -> [f64; 2] {
        if axis == 0 { self.s } else { self.phi }
    }

    fn quarters(&self) -> [Self; 4] {
        let middle = |[low, high]: [f64; 2]| 0.5 * (low + high);
        let [a, b] = self.split(0, middle(self.s));
        let ([a, b], [c, d]) = (a.split(1, middle(self.phi)), b.split(1, middle(self.phi)));
        [a, b, c, d]
    }
}

/// Cells that divide the sphere, each of which holds about as many of the directions.
#[derive(Debug, Default)]
pub struct Cells {
    /// The cells.
    pub all: Vec<Cell>,
    /// Where their integrals begin: pieces of the cell of an index, small where its directions are.
    pieces: Vec<(usize, Cell)>,
}

impl Cells {
    /// Divides each hemisphere `depth` times, at the medians of the directions or between two groups of them.
    pub fn around(directions: &[Vector], depth: u32) -> Self {
        let mut cells = Self::default();
        for side in [1.0, -1.0] {
            let here = directions.iter().map(|w| coordinates(*w)).filter(|(of, _)| *of == side);
            let here = here.map(|(_, at)| at).collect();
            cells.divide(Cell::hemisphere(side), here, depth);
        }
        cells
    }

    /// The index of the cell that holds a direction.
    pub fn index(&self, w: Vector) -> usize {
        let (side, [s, phi]) = coordinates(w);
        let holds = |cell: &&Cell| {
            let within = |x: f64, [low, high]: [f64; 2]| low <= x && x <= high;
            cell.side == side && within(s, cell.s) && within(phi, cell.phi)
        };
        self.all.iter().position(|cell| holds(&cell)).expect("cells cover the sphere")
    }
}

impl Cells {
    fn divide(&mut self, cell: Cell, mut inside: Vec<[f64; 2]>, depth: u32) {
        if depth == 0 || inside.len() < 2 {
            let index = self.all.len();
            self.all.push(cell);
            return self.pieces.extend(pieces(cell, &inside).into_iter().map(|it| (index, it)));
        }
        let axis = depth as usize % 2;
        inside.sort_by(|a, b| a[axis].total_cmp(&b[axis]));
        let middle = inside.len() / 2;
        let median = 0.5 * (inside[middle - 1][axis] + inside[middle][axis]);
        let at = gap_in(&cell, &inside, axis).unwrap_or(median);
        let high = inside.split_off(inside.partition_point(|it| it[axis] < at));
        let [below, above] = cell.split(axis, at);
        self.divide(below, inside, depth - 1);
        self.divide(above, high, depth - 1);
    }
}

/// A cell in pieces: the box around the directions in it, and rings around that, each three times as large as the one
/// before. In a large cell with all of a narrow lobe in one corner, a rule for the whole would see nothing. Where the
/// directions are in two groups, as on both sides of the azimuth 0, the cell is divided between them first.
fn pieces(cell: Cell, inside: &[[f64; 2]]) -> Vec<Cell> {
    if inside.is_empty() {
        return vec![cell];
    }
    for axis in [0, 1] {
        if let Some(at) = gap_in(&cell, inside, axis) {
            let [below, above] = cell.split(axis, at);
            let (low, high): (Vec<_>, Vec<_>) = inside.iter().partition(|it| it[axis] < at);
            return [pieces(below, &low), pieces(above, &high)].concat();
        }
    }
    let ends = [0, 1].map(|axis| {
        let low = inside.iter().map(|at| at[axis]).fold(f64::INFINITY, f64::min);
        let high = inside.iter().map(|at| at[axis]).fold(f64::NEG_INFINITY, f64::max);
        [low, high]
    });
    let mut boxes = vec![cell];
    // at least so large that doubles tell its sides apart
    let mut half = ends.map(|[low, high]| (0.5 * (high - low)).max(1e-9));
    let mut rings = Vec::new();
    loop {
        half = half.map(|half| 3.0 * half);
        let middle = ends.map(|[low, high]| 0.5 * (low + high));
        let within = |axis: usize| {
            let [from, to] = cell.range(axis);
            [(middle[axis] - half[axis]).max(from), (middle[axis] + half[axis]).min(to)]
        };
        let ring = Cell { s: within(0), phi: within(1), ..cell };
        if ring == cell {
            break;
        }
        rings.push(ring);
    }
    boxes.extend(rings.into_iter().rev());
    let mut pieces: Vec<Cell> =
        boxes.windows(2).flat_map(|pair| around(pair[0], pair[1])).collect();
    pieces.push(boxes[boxes.len() - 1]);
    pieces
}

/// Where directions are in two groups along an axis, far apart for the cell and for their own extent: between them.
fn gap_in(cell: &Cell, inside: &[[f64; 2]], axis: usize) -> Option<f64> {
    let mut along: Vec<f64> = inside.iter().map(|at| at[axis]).collect();
    along.sort_by(f64::total_cmp);
    let gaps = along.windows(2).map(|pair| (pair[1] - pair[0], 0.5 * (pair[0] + pair[1])));
    let (gap, middle) = gaps.max_by(|a, b| a.0.total_cmp(&b.0))?;
    let [from, to] = cell.range(axis);
    let extent = along[along.len() - 1] - along[0];
    (gap > 0.5 * extent && gap > 0.25 * (to - from)).then_some(middle)
}

/// What a cell has outside of a smaller one.
fn around(mut cell: Cell, inner: Cell) -> Vec<Cell> {
    let mut pieces = Vec::new();
    for (axis, [low, high]) in [(0, inner.s), (1, inner.phi)] {
        let [from, to] = cell.range(axis);
        if low > from {
            let [below, above] = cell.split(axis, low);
            pieces.push(below);
            cell = above;
        }
        if high < to {
            let [below, above] = cell.split(axis, high);
            pieces.push(above);
            cell = below;
        }
    }
    pieces
}

/// An integral, and how much it changed when its pieces were halved the last time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integral<const N: usize> {
    /// Of each integrand.
    pub value: [f64; N],
    /// Of each integrand, at most.
    pub error: [f64; N],
}

impl<const N: usize> Integral<N> {
    const NONE: Self = Self { value: [0.0; N], error: [0.0; N] };

    fn add(&mut self, value: [f64; N], error: [f64; N]) {
        for k in 0..N {
            self.value[k] += value[k];
            self.error[k] += error[k];
        }
    }
}

/// The integrals over all cells, and their sum; whether each is known to the tolerances.
#[derive(Debug)]
pub struct Integrals<const N: usize> {
    /// Of each cell.
    pub cells: Vec<Integral<N>>,
    /// Of the sphere.
    pub whole: Integral<N>,
    /// Whether the budget sufficed.
    pub is_known: bool,
}

/// Nodes and weights of Gauss's rule of four points on `[0, 1]` (Abramowitz & Stegun, table 25.4).
const NODES: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

/// A piece of a cell whose integral is not known yet.
struct Piece<const N: usize> {
    of: usize,
    cell: Cell,
    value: [f64; N],
}

/// The integrals of N functions over each cell. A piece is divided in four until that changes its integral by no more
/// than an eighth of the tolerances, or `budget` values are spent. `values` gives the functions in many directions.
///
/// # Errors
/// Those of `values`.
pub fn integrals<const N: usize, E>(
    cells: &Cells,
    tolerances: [f64; N],
    budget: usize,
    values: &mut impl FnMut(&[Vector]) -> Result<Vec<[f64; N]>, E>,
) -> Result<Integrals<N>, E> {
    let mut found = vec![Integral::<N>::NONE; cells.all.len()];
    let mut open = measured(cells.pieces.clone(), values)?;
    let mut spent = open.len() * NODES.len() * NODES.len();
    while !open.is_empty() && spent < budget {
        let quarters = open.iter().flat_map(|it| it.cell.quarters().map(|cell| (it.of, cell)));
        let finer = measured(quarters.collect(), values)?;
        spent += finer.len() * NODES.len() * NODES.len();
        let mut finer = finer.into_iter();
        let mut still_open = Vec::new();
        for coarse in open {
            let parts: Vec<Piece<N>> = finer.by_ref().take(4).collect();
            let value = std::array::from_fn(|k| parts.iter().map(|part| part.value[k]).sum());
            let error = std::array::from_fn(|k| f64::abs(coarse.value[k] - value[k]));
            if (0..N).all(|k| error[k] <= tolerances[k] / 8.0) {
                found[coarse.of].add(value, error);
            } else {
                still_open.extend(parts);
            }
        }
        open = still_open;
    }
    for piece in &open {
        found[piece.of].add(piece.value, piece.value.map(f64::abs));
    }
    let is_within = |it: &Integral<N>| (0..N).all(|k| it.error[k] <= tolerances[k]);
    let is_known = open.is_empty() && found.iter().all(is_within);
    let mut whole = Integral::NONE;
    found.iter().for_each(|it| whole.add(it.value, it.error));
    Ok(Integrals { cells: found, whole, is_known })
}

/// The integrals over cells, each by one rule of sixteen points.
fn measured<const N: usize, E>(
    cells: Vec<(usize, Cell)>,
    values: &mut impl FnMut(&[Vector]) -> Result<Vec<[f64; N]>, E>,
) -> Result<Vec<Piece<N>>, E> {
    let points = |cell: &Cell| {
        let cell = *cell;
        NODES.into_iter().flat_map(move |(a, _)| NODES.map(|(b, _)| cell.at([a, b])))
    };
    let directions: Vec<Vector> = cells.iter().flat_map(|(_, cell)| points(cell)).collect();
    let values = values(&directions)?;
    let weights: Vec<f64> = NODES.iter().flat_map(|(_, a)| NODES.map(|(_, b)| a * b)).collect();
    let pieces = cells.into_iter().zip(values.chunks(weights.len()));
    let sum = |values: &[[f64; N]], k: usize| -> f64 {
        values.iter().zip(&weights).map(|(value, weight)| weight * value[k]).sum()
    };
    let piece = |((of, cell), values): ((usize, Cell), &[[f64; N]])| {
        let value = std::array::from_fn(|k| cell.solid_angle() * sum(values, k));
        Piece { of, cell, value }
    };
    Ok(pieces.map(piece).collect())
}
