//! Up to eight triangles on up to eight corners, tested at once: the leaves of a mesh's tree.
//!
//! The formulas are those of `watertight.rs`, the same for eight triangles as for one. For a
//! triangle that the ray sees at a large area the result is certain: its hit, to the last bit. The
//! others are undecided; [`ShearedRay::meet`] computes their edge functions again.

use arrayvec::ArrayVec;

use super::kernel::{Instructions, Kernel};
use super::lanes64::Eight;
use crate::candidate::Candidate;
use crate::math::watertight::{Edges, ShearedRay, meeting, outside};
use crate::math::{Point, Span};

/// The most triangles of a block, and the most corners.
pub const SIZE: usize = 8;

/// Triangles on shared corners, in four cache lines. Each corner is transformed into the ray's
/// coordinates once, for all its triangles.
#[derive(Debug)]
#[repr(C, align(64))]
pub struct Block {
    /// The x, y and z coordinates of the corners; unused ones repeat the first.
    corners: [[f64; SIZE]; 3],
    /// The corners a, b and c of each triangle.
    numbers: [[u8; SIZE]; 3],
    /// The indices of the triangles in the mesh.
    indices: [u32; SIZE],
    /// One bit for each slot with a triangle.
    used: u8,
}

/// The result of the test of a block. The masks have one bit for each slot.
#[derive(Clone, Copy, Default)]
pub struct Found {
    /// Those with a hit inside the span.
    pub certain: u8,
    /// Those that must still be tested one by one.
    pub undecided: u8,
    /// The hit of each certain one: triangle of the mesh, distance, β and γ.
    part: [u32; SIZE],
    t: [f64; SIZE],
    parameters: [[f64; SIZE]; 2],
}

impl Found {
    /// The hit of a certain one.
    #[inline(always)]
    pub fn hit(&self, slot: usize) -> Candidate {
        let slot = slot % SIZE; // no check of bounds
        let parameters = [self.parameters[0][slot], self.parameters[1][slot]];
        Candidate { part: self.part[slot], parameters, ..Candidate::at(self.t[slot]) }
    }
}

/// The vertices of a block, each once.
#[derive(Default)]
struct Vertices(ArrayVec<u32, SIZE>);

impl Vertices {
    /// The index of a vertex in the block, which is added if it is new; `None` if the block is
    /// full.
    fn index(&mut self, vertex: u32) -> Option<u8> {
        let known = self.0.iter().position(|&v| v == vertex);
        let index = match known {
            Some(index) => index,
            None => self.0.try_push(vertex).ok().map(|()| self.0.len() - 1)?,
        };
        Some(index as u8)
    }
}

impl Block {
    /// Whether these triangles fit into one block.
    pub fn fits(indices: &[u32], triangles: &[[u32; 3]]) -> bool {
        let mut corners = Vertices::default();
        let mut fits = |&vertex: &u32| corners.index(vertex).is_some();
        indices.len() <= SIZE
            && indices.iter().all(|&t| triangles[t as usize].iter().all(&mut fits))
    }

    /// The block of these triangles of a mesh, which fit into one.
    pub fn new(indices: &[u32], triangles: &[[u32; 3]], vertices: &[Point]) -> Self {
        let (corners, numbers) = ([[0.0; SIZE]; 3], [[0; SIZE]; 3]);
        let mut block = Self { corners, numbers, indices: [u32::MAX; SIZE], used: 0 };
        block.indices[..indices.len()].copy_from_slice(indices);
        block.indices.sort_unstable(); // of equal hits the first triangle's counts
        let mut corners = Vertices::default();
        for (slot, &index) in block.indices[..indices.len()].iter().enumerate() {
            block.used |= 1 << slot;
            for (numbers, vertex) in block.numbers.iter_mut().zip(triangles[index as usize]) {
                numbers[slot] = corners.index(vertex).expect("leaves are chosen to fit");
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
    fn triangle(&self, slot: usize) -> [Point; 3] {
        let [x, y, z] = &self.corners;
        let corner = |numbers: &[u8; SIZE]| {
            let corner = usize::from(numbers[slot]) % SIZE;
            Point::new(x[corner], y[corner], z[corner])
        };
        let [a, b, c] = &self.numbers;
        [corner(a), corner(b), corner(c)]
    }

    /// Tests one triangle.
    #[cold] // rarely called: the test of all triangles finds nearly all hits and needs the registers
    pub fn hit(&self, slot: usize, ray: &ShearedRay, span: Span) -> Option<Candidate> {
        let meeting = ray.meet(&self.triangle(slot))?;
        let (part, parameters) = (self.indices[slot], meeting.barycentric);
        span.contains(meeting.t).then_some(Candidate {
            part,
            parameters,
            ..Candidate::at(meeting.t)
        })
    }

    /// Tests all triangles.
    #[inline(always)]
    #[allow(unsafe_code, reason = "calls what not every processor can run")]
    pub fn test(&self, kernel: Kernel, ray: &ShearedRay, span: Span, found: &mut Found) {
        match kernel.instructions() {
            Instructions::Plain => (found.certain, found.undecided) = (0, self.used),
            // SAFETY: a kernel is made only where the processor has its instructions
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 => unsafe { self.test_by::<super::lanes64::Avx2>(ray, span, found) },
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => unsafe {
                self.test_by::<super::lanes64::Avx512>(ray, span, found);
            },
        }
    }

    /// # Safety
    /// The processor has the instructions of `L`.
    #[inline(always)]
    #[allow(unsafe_code, reason = "instructions that not every processor has")]
    unsafe fn test_by<L: Eight>(&self, ray: &ShearedRay, span: Span, found: &mut Found) {
        // SAFETY: the caller guarantees the instructions; the three axes of a ray are 0 to 2 in some order
        let corners = unsafe {
            let [x, y, z] = ray.axes.map(|axis| self.corners.get_unchecked(axis));
            [L::load(x), L::load(y), L::load(z)]
        };
        let [x, y, z] = ray.see(corners);
        let [a, b, c] = &self.numbers;
        let edges =
            Edges::of([x.pick(a), y.pick(a)], [x.pick(b), y.pick(b)], [x.pick(c), y.pick(c)]);
        let inside = !outside(edges.parts) & self.used;
        (found.certain, found.undecided) = (0, 0);
        if inside == 0 {
            return;
        }
        let met = meeting(edges.parts, [z.pick(a), z.pick(b), z.pick(c)]);
        let within = z.all(span.min).less(met.t) & met.t.less(z.all(span.max));
        let large = edges.large();
        found.certain = inside & large & within;
        found.undecided = inside & !large;
        found.part = self.indices;
        met.t.store(&mut found.t);
        met.beta.store(&mut found.parameters[0]);
        met.gamma.store(&mut found.parameters[1]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Pcg32, Ray, Vector, power};

    /// Five corners in one box, which may be flat or thin as a needle. In half of the cases its
    /// size is between 10⁻¹⁶⁰ and 10⁶⁰; products of the smallest numbers underflow.
    fn corners(random: &mut Pcg32) -> Vec<Point> {
        let mut x = || 2.0 * random.uniform() - 1.0;
        let size = power(10.0, [0.0, 110.0 * x() - 50.0][usize::from(x() > 0.0)]);
        let sides = [0, 1, 2].map(|_| size * power(10.0, f64::min(0.0, 12.0 * x())));
        let corner = || Point::from(sides.map(|side| side * x()));
        std::iter::repeat_with(corner).take(5).collect()
    }

    /// A ray towards a point, an edge or a corner of a triangle, from near or far, perhaps almost
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

    /// Law: a certain hit of a block is the hit of the triangle alone, to the last bit, and no hit
    /// is missed. Oracle: one triangle at a time.
    #[test]
    fn a_block_finds_the_hits_of_its_triangles() {
        let mut random = Pcg32::new(2324, 0);
        let triangles = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [0, 2, 4], [4, 1, 0]];
        let [mut certain, mut undecided, mut misses] = [0; 3];
        for case in 0..30_000 {
            let vertices = corners(&mut random);
            let block = Block::new(&[0, 1, 2, 3, 4], &triangles, &vertices);
            let aim = triangles[case % 5].map(|i| vertices[i as usize]);
            let ray = ray(&mut random, aim);
            let sheared = ShearedRay::new(&ray);
            let end = [f64::INFINITY, 1.0][case % 2];
            let span = Span { min: [0.0, -1e300][case / 2 % 2], max: end };
            for kernel in Kernel::available().into_iter().filter(|&k| k != Kernel::PLAIN) {
                let mut found = Found::default();
                block.test(kernel, &sheared, span, &mut found);
                for (slot, triangle) in triangles.into_iter().enumerate() {
                    let corners = triangle.map(|i| vertices[i as usize]);
                    assert_eq!(block.triangle(slot), corners);
                    let alone = sheared.meet(&corners).filter(|hit| span.contains(hit.t));
                    if found.undecided >> slot & 1 == 1 {
                        undecided += 1;
                    } else if found.certain >> slot & 1 == 1 {
                        certain += 1;
                        let hit = alone.expect("a hit of the triangle alone");
                        assert_eq!(found.t[slot].to_bits(), hit.t.to_bits(), "{ray:?}");
                        let parameters = found.parameters.map(|numbers| numbers[slot]);
                        assert_eq!(parameters, hit.barycentric, "{ray:?}, {corners:?}");
                    } else {
                        misses += 1;
                        assert!(alone.is_none(), "{kernel:?}: {ray:?} misses {corners:?}");
                    }
                }
            }
        }
        assert!(
            certain > 10_000 && undecided > 1_000 && misses > 10_000,
            "{certain} certain, {undecided} undecided, {misses} misses"
        );
    }
}
