//! Cells of directions that adapt to samples, and integrals over them whose error is known.
//!
//! Counts in fixed cells tell nothing of a narrow lobe, and a fixed quadrature calls it wrong. So the cells are
//! divided where samples are, and each integral is refined until it no longer changes and could have given the samples
//! in its piece: a rule that sees nothing of a spike agrees with itself, but not with them.

use std::f64::consts::TAU;

use groundtruth::math::{Frame, Vector, atan2, cos, sin};

/// A part of a hemisphere: a rectangle in the height `s = 1 − |cos θ|` and the azimuth φ, which is a solid angle of
/// its area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// 1 above the surface, −1 below.
    pub side: f64,
    s: [f64; 2],
    phi: [f64; 2],
}

/// The local frame turned about the normal, so that azimuths begin opposite to the samples and no lobe lies across 0.
fn opposite_to(directions: &[Vector]) -> Frame {
    let sum = directions.iter().fold(Vector::ZERO, |sum, w| sum + *w);
    let level = Vector::new(sum.x(), sum.y(), 0.0).unit().unwrap_or(Vector::X);
    Frame { u: -level, v: -Vector::Z.cross(level), w: Vector::Z }
}

/// A direction in these coordinates: side, height and azimuth.
fn coordinates(w: Vector, frame: &Frame) -> (f64, [f64; 2]) {
    let w = frame.to_local(w);
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

    /// Whether it holds these coordinates; its lower sides belong to it, and the end of the sphere.
    fn holds(&self, [s, phi]: [f64; 2]) -> bool {
        let within = |x: f64, [low, high]: [f64; 2], last: f64| {
            low <= x && (x < high || high == last && x <= high)
        };
        within(s, self.s, 1.0) && within(phi, self.phi, TAU)
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
#[derive(Debug)]
pub struct Cells {
    /// The cells.
    pub all: Vec<Cell>,
    /// Where their integrals begin: pieces of the cell of an index, small where its directions are.
    pieces: Vec<(usize, Cell)>,
    frame: Frame,
}

impl Cells {
    /// Divides each hemisphere `depth` times, at the medians of the directions.
    pub fn around(directions: &[Vector], depth: u32) -> Self {
        let frame = opposite_to(directions);
        let mut cells = Self { all: Vec::new(), pieces: Vec::new(), frame };
        for side in [1.0, -1.0] {
            let here =
                directions.iter().map(|w| coordinates(*w, &frame)).filter(|(of, _)| *of == side);
            let here = here.map(|(_, at)| at).collect();
            cells.divide(Cell::hemisphere(side), here, depth);
        }
        cells
    }

    /// The index of the cell that holds a direction, whose coordinates are finite.
    pub fn index(&self, w: Vector) -> usize {
        let (side, at) = coordinates(w, &self.frame);
        let holds = |cell: &Cell| cell.side == side && cell.holds(at);
        self.all.iter().position(holds).expect("cells cover the sphere")
    }

    fn divide(&mut self, cell: Cell, mut inside: Vec<[f64; 2]>, depth: u32) {
        if depth == 0 || inside.len() < 2 {
            let index = self.all.len();
            self.all.push(cell);
            return self.pieces.extend(pieces(cell, &inside).into_iter().map(|it| (index, it)));
        }
        let axis = depth as usize % 2;
        inside.sort_by(|a, b| a[axis].total_cmp(&b[axis]));
        let middle = inside.len() / 2;
        let at = 0.5 * (inside[middle - 1][axis] + inside[middle][axis]);
        let high = inside.split_off(inside.partition_point(|it| it[axis] < at));
        let [below, above] = cell.split(axis, at);
        self.divide(below, inside, depth - 1);
        self.divide(above, high, depth - 1);
    }
}

/// A cell in pieces: the box around the directions in it, and rings around that, each three times as large as the one
/// before. In a large cell with all of a narrow lobe in one corner, a rule for the whole would see nothing.
fn pieces(cell: Cell, inside: &[[f64; 2]]) -> Vec<Cell> {
    if inside.is_empty() {
        return vec![cell];
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

/// A part of a cell, and the samples in it.
#[derive(Clone)]
struct Part {
    of: usize,
    cell: Cell,
    inside: Vec<[f64; 2]>,
}

impl Part {
    fn quarters(&self) -> [Self; 4] {
        self.cell.quarters().map(|cell| self.part(cell))
    }

    /// The samples that are in a part of it.
    fn part(&self, cell: Cell) -> Self {
        let inside = self.inside.iter().filter(|at| cell.holds(**at)).copied().collect();
        Self { of: self.of, cell, inside }
    }

    /// Whether more samples are in it than such an integral explains, by two standard deviations and one sample: then
    /// a spike may not have been seen.
    fn is_crowded(&self, expected: f64) -> bool {
        let is_divisible = self.cell.solid_angle() > SMALLEST;
        let most = expected + 2.0 * expected.max(0.0).sqrt() + 1.0;
        is_divisible && self.inside.len() as f64 > most
    }
}

/// Smaller parts are not divided for the sake of the samples in them: a direction may come again and again.
const SMALLEST: f64 = 1e-18;

/// The samples of a density.
#[derive(Clone, Copy, Debug)]
pub struct DensitySamples<'a> {
    /// Their directions.
    pub directions: &'a [Vector],
    /// How many were drawn, with those that have no direction.
    pub drawn: usize,
}

/// The integrals of N functions over each cell; the first of them is the density of the samples. A piece is divided in
/// four until that changes its integral by no more than a sixteenth of the tolerances and explains the samples in the four, or
/// `budget` values are spent, and half as many where it has not settled then. `values` gives the functions in many directions.
///
/// # Errors
/// Those of `values`.
pub fn integrals<const N: usize, E>(
    cells: &Cells,
    samples: DensitySamples<'_>,
    tolerances: [f64; N],
    budget: usize,
    values: &mut impl FnMut(&[Vector]) -> Result<Vec<[f64; N]>, E>,
) -> Result<Integrals<N>, E> {
    let mut found = vec![Integral::<N>::NONE; cells.all.len()];
    let mut inside = vec![Vec::new(); cells.all.len()];
    for w in samples.directions {
        inside[cells.index(*w)].push(coordinates(*w, &cells.frame).1);
    }
    let begun = cells
        .pieces
        .iter()
        .map(|(of, cell)| Part { of: *of, cell: *cell, inside: inside[*of].clone() }.part(*cell));
    let mut open = measured(&cells.frame, begun.collect(), values)?;
    let mut spent = open.len() * NODES.len() * NODES.len();
    let mut is_steady = true;
    // the search for spikes takes no more than the budget: what does not settle has half of it more
    while !open.is_empty() && (spent < budget || !is_steady && spent < budget + budget / 2) {
        let is_searched = spent < budget;
        let quarters = open.iter().flat_map(|(part, _)| part.quarters()).collect();
        let finer = measured(&cells.frame, quarters, values)?;
        spent += finer.len() * NODES.len() * NODES.len();
        let mut finer = finer.into_iter();
        let mut still_open = Vec::new();
        is_steady = true;
        for (part, coarse) in open {
            let quarters: Vec<(Part, [f64; N])> = finer.by_ref().take(4).collect();
            let value = std::array::from_fn(|k| quarters.iter().map(|(_, it)| it[k]).sum());
            let error = std::array::from_fn(|k| f64::abs(coarse[k] - value[k]));
            let is_settled = (0..N).all(|k| error[k] <= tolerances[k] / 16.0);
            is_steady &= is_settled;
            let drawn = samples.drawn as f64;
            let is_crowded = || quarters.iter().any(|(it, value)| it.is_crowded(drawn * value[0]));
            if is_settled && !(is_searched && is_crowded()) {
                found[part.of].add(value, error);
            } else {
                still_open.extend(quarters);
            }
        }
        open = still_open;
    }
    // if only crowds are left, they are no spikes: samples are where the density is lower
    for (part, value) in &open {
        found[part.of].add(*value, if is_steady { [0.0; N] } else { value.map(f64::abs) });
    }
    // a division changes far more than the next one would: the sum of many changes may exceed a tolerance
    let is_within = |it: &Integral<N>| (0..N).all(|k| it.error[k] <= 4.0 * tolerances[k]);
    let is_known = (open.is_empty() || is_steady) && found.iter().all(is_within);
    let mut whole = Integral::NONE;
    found.iter().for_each(|it| whole.add(it.value, it.error));
    Ok(Integrals { cells: found, whole, is_known })
}

/// Parts that are measured at once: what is asked and answered of all of them may be a gigabyte.
const AT_ONCE: usize = 4000;

/// The integrals over parts, each by one rule of sixteen points.
fn measured<const N: usize, E>(
    frame: &Frame,
    mut parts: Vec<Part>,
    values: &mut impl FnMut(&[Vector]) -> Result<Vec<[f64; N]>, E>,
) -> Result<Vec<(Part, [f64; N])>, E> {
    let points = |part: &Part| {
        let cell = part.cell;
        NODES
            .into_iter()
            .flat_map(move |(a, _)| NODES.map(|(b, _)| frame.to_world(cell.at([a, b]))))
    };
    let weights: Vec<f64> = NODES.iter().flat_map(|(_, a)| NODES.map(|(_, b)| a * b)).collect();
    let sum = |values: &[[f64; N]], k: usize| -> f64 {
        values.iter().zip(&weights).map(|(value, weight)| weight * value[k]).sum()
    };
    let integral = |(part, values): (Part, &[[f64; N]])| {
        let value = std::array::from_fn(|k| part.cell.solid_angle() * sum(values, k));
        (part, value)
    };
    let mut all = Vec::with_capacity(parts.len());
    while !parts.is_empty() {
        let now: Vec<Part> = parts.drain(..parts.len().min(AT_ONCE)).collect();
        let directions: Vec<Vector> = now.iter().flat_map(points).collect();
        let values = values(&directions)?;
        all.extend(now.into_iter().zip(values.chunks(weights.len())).map(integral));
    }
    Ok(all)
}
