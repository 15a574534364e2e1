//! Up to eight triangles on up to eight corners, tested at once: what a leaf of a mesh's bvh holds.
//!
//! The formulas are those of `watertight.rs`, the same for eight triangles as for one. What they find
//! of a triangle that looks large is its hit, to the last bit; the others are left to
//! [`ShearedRay::meet`], which computes their edge functions again.
//!
//! **Why a hit of a large triangle counts without asking the rule** (`accel/frame.rs`). Moving and
//! shearing the corners shifts them, as the ray sees them, by some roundings of what the ray comes
//! from. The three parts are wrong by 2u of their products each, which are at most 16 times the sum, so
//! each weight by some 64u; so are `t`, and the ray's point there, by that of the triangle's size.
//! That point is therefore within some hundred roundings of the triangle's size, and some ten of the
//! distance, of a point of the triangle, which is in its box. The rule allows 2²⁹ and 2¹⁷. (Of numbers
//! so small that products lose digits, no triangle looks large; directions of more than 10¹⁰⁰ frames,
//! for which `t` could, cross every box by the rule.)

use super::lanes::Eight;
use super::watertight::{Edges, ShearedRay, meeting, outside};
use crate::accel::{Instructions, Kernel, LeafCost, Sifted};
use crate::math::{Point, Span};

/// Triangles of a block at most, and corners.
const SIZE: usize = 8;

/// Four cache lines. Each corner is moved into the ray's coordinates once, for all its triangles.
#[derive(Debug)]
#[repr(C, align(64))]
pub struct Block {
    /// The corners along x, y and z; those not needed repeat the first.
    corners: [[f64; SIZE]; 3],
    /// The corners a, b and c of each triangle.
    numbers: [[u8; SIZE]; 3],
    /// Which triangles of the mesh they are.
    pub indices: [u32; SIZE],
    /// One bit for each triangle.
    used: u8,
}

/// Triangles that are tested as blocks: a block costs the same however full it is.
pub struct Blocks<'a>(pub &'a [[u32; 3]]);

impl LeafCost for Blocks<'_> {
    fn cost(&self, triangles: &[u32]) -> f32 {
        let mut corners = Vertices::default();
        let fits = |&t: &u32| self.0[t as usize].into_iter().all(|v| corners.place(v).is_some());
        if triangles.iter().all(fits) { 1.0 } else { f32::INFINITY }
    }
}

/// The vertices of a block, each once.
#[derive(Default)]
struct Vertices(arrayvec::ArrayVec<u32, SIZE>);

impl Vertices {
    /// Where a vertex stands among them, added if need be; `None` if there are too many.
    fn place(&mut self, vertex: u32) -> Option<u8> {
        let known = self.0.iter().position(|&v| v == vertex);
        let place = match known {
            Some(place) => place,
            None => self.0.try_push(vertex).ok().map(|()| self.0.len() - 1)?,
        };
        Some(place as u8)
    }
}

impl Block {
    /// The block of these triangles, as a leaf lists them (they fit into one).
    pub fn new(indices: [u32; SIZE], triangles: &[[u32; 3]], vertices: &[Point]) -> Self {
        let (corners, numbers) = ([[0.0; SIZE]; 3], [[0; SIZE]; 3]);
        let mut block = Self { corners, numbers, indices, used: 0 };
        let mut corners = Vertices::default();
        let used = indices.into_iter().map_while(|index| triangles.get(index as usize));
        for (slot, &triangle) in used.enumerate() {
            block.used |= 1 << slot;
            for (numbers, vertex) in block.numbers.iter_mut().zip(triangle) {
                numbers[slot] = corners.place(vertex).expect("leaves are chosen to fit");
            }
        }
        for i in 0..SIZE {
            let vertex = corners.0.get(i).or(corners.0.first()).expect("a leaf is not empty");
            for axis in 0..3 {
                block.corners[axis][i] = vertices[*vertex as usize].along(axis);
            }
        }
        block
    }

    /// The corners of one triangle.
    pub fn triangle(&self, slot: usize) -> [Point; 3] {
        let [x, y, z] = &self.corners;
        let corner = |numbers: &[u8; SIZE]| {
            let place = usize::from(numbers[slot]) % SIZE;
            Point::new(x[place], y[place], z[place])
        };
        let [a, b, c] = &self.numbers;
        [corner(a), corner(b), corner(c)]
    }

    /// Tests all triangles.
    #[inline(always)]
    #[allow(unsafe_code, reason = "calls what not every processor can run")]
    pub fn sift(&self, kernel: Kernel, ray: &ShearedRay, span: Span, sifted: &mut Sifted) {
        match kernel.instructions() {
            Instructions::Plain => (sifted.sure, sifted.open) = (0, self.used),
            // SAFETY: a kernel is made only where the processor has its instructions
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 => unsafe { self.sift_by::<super::lanes::Avx2>(ray, span, sifted) },
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => unsafe {
                self.sift_by::<super::lanes::Avx512>(ray, span, sifted);
            },
        }
    }

    /// # Safety
    /// The processor has the instructions of `L`.
    #[inline(always)]
    #[allow(unsafe_code, reason = "instructions that not every processor has")]
    unsafe fn sift_by<L: Eight>(&self, ray: &ShearedRay, span: Span, sifted: &mut Sifted) {
        // SAFETY: the caller's; and a ray has three axes, 0 to 2 in some order
        let corners = unsafe {
            let [x, y, z] = ray.axes.map(|axis| self.corners.get_unchecked(axis));
            [L::load(x), L::load(y), L::load(z)]
        };
        let [x, y, z] = ray.see(corners);
        let [a, b, c] = &self.numbers;
        let edges =
            Edges::of([x.pick(a), y.pick(a)], [x.pick(b), y.pick(b)], [x.pick(c), y.pick(c)]);
        let inside = !outside(edges.parts) & self.used;
        (sifted.sure, sifted.open) = (0, 0);
        if inside == 0 {
            return;
        }
        let met = meeting(edges.parts, [z.pick(a), z.pick(b), z.pick(c)]);
        let within = z.all(span.min).less(met.t) & met.t.less(z.all(span.max));
        let large = edges.large();
        sifted.sure = inside & large & within;
        sifted.open = inside & !large;
        sifted.part = self.indices;
        met.t.store(&mut sifted.t);
        met.beta.store(&mut sifted.parameters[0]);
        met.gamma.store(&mut sifted.parameters[1]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::{Accel, Method};
    use crate::math::{Aabb, Pcg32, Ray, Vector, power};

    /// Five corners, in one box, that may be flat to a needle; half of them at a size between 10⁻¹⁶⁰ and
    /// 10⁶⁰, where products of the least lose their digits.
    fn corners(random: &mut Pcg32) -> Vec<Point> {
        let mut x = || 2.0 * random.uniform() - 1.0;
        let size = power(10.0, [0.0, 110.0 * x() - 50.0][usize::from(x() > 0.0)]);
        let sides = [0, 1, 2].map(|_| size * power(10.0, f64::min(0.0, 12.0 * x())));
        let corner = || Point::from(sides.map(|side| side * x()));
        std::iter::repeat_with(corner).take(5).collect()
    }

    /// A ray at a point of a triangle, or at its edge or corner, from near or far, that may be almost
    /// in its plane.
    fn ray(random: &mut Pcg32, [a, b, c]: [Point; 3]) -> Ray {
        let mut x = || random.uniform();
        let [u, v] = [x(), x()].map(|w| [w, 0.0, 1.0][(3.0 * x()) as usize]);
        let target = a + u * ((b - a) + v * (c - b));
        let size = (b - a).max_abs().max((c - a).max_abs());
        let anywhere = Vector::new(x() - 0.5, x() - 0.5, x() - 0.5);
        let in_plane = ((b - a) + (x() - 0.5) * (c - a)) * (1.0 / size);
        let across = if x() < 0.3 { power(10.0, -16.0 * x()) } else { 1.0 };
        let way = if x() < 0.3 { in_plane + across * anywhere } else { anywhere };
        let origin = target - (size * power(10.0, 14.0 * x() - 2.0)) * way;
        Ray::new(origin, power(10.0, 60.0 * x() - 30.0) * (target - origin))
    }

    /// Law: what a block is sure of is the hit of the triangle alone, to the last bit, and counts; and
    /// it misses no other. Oracles: one triangle at a time, and the counting rule.
    #[test]
    fn a_block_finds_the_hits_of_its_triangles_and_they_count() {
        let mut random = Pcg32::new(2324, 0);
        let triangles = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [0, 2, 4], [4, 1, 0]];
        let indices = [0, 1, 2, 3, 4].map(|i| i as u32);
        let indices = std::array::from_fn(|i| indices.get(i).copied().unwrap_or(u32::MAX));
        let [mut sure, mut open, mut misses] = [0; 3];
        for case in 0..30_000 {
            let vertices = corners(&mut random);
            let block = Block::new(indices, &triangles, &vertices);
            let aim = triangles[case % 5].map(|i| vertices[i as usize]);
            let ray = ray(&mut random, aim);
            let sheared = ShearedRay::new(&ray);
            let end = [f64::INFINITY, 1.0][case % 2];
            let span = Span { min: [0.0, -1e300][case / 2 % 2], max: end };
            for kernel in Kernel::available().into_iter().filter(|&k| k != Kernel::PLAIN) {
                let mut sifted = Sifted::default();
                block.sift(kernel, &sheared, span, &mut sifted);
                for (slot, triangle) in triangles.into_iter().enumerate() {
                    let corners = triangle.map(|i| vertices[i as usize]);
                    assert_eq!(block.triangle(slot), corners);
                    let alone = sheared.meet(&corners).filter(|hit| span.contains(hit.t));
                    if sifted.open >> slot & 1 == 1 {
                        open += 1;
                    } else if sifted.sure >> slot & 1 == 1 {
                        sure += 1;
                        let hit = alone.expect("a hit of the triangle alone");
                        assert_eq!(sifted.t[slot].to_bits(), hit.t.to_bits(), "{ray:?}");
                        let parameters = sifted.parameters.map(|numbers| numbers[slot]);
                        assert_eq!(parameters, hit.barycentric, "{ray:?}, {corners:?}");
                        let bounds = Aabb::around(corners);
                        let rule = Accel::build(Method::List, &[bounds]).counting(&bounds, &ray);
                        let counts = rule.is_some_and(|counts| counts(hit.t));
                        assert!(counts, "{hit:?} of {ray:?} does not count in {corners:?}");
                    } else {
                        misses += 1;
                        assert!(alone.is_none(), "{kernel:?}: {ray:?} misses {corners:?}");
                    }
                }
            }
        }
        assert!(sure > 10_000 && open > 1_000 && misses > 10_000, "{sure} {open} {misses}");
    }
}
