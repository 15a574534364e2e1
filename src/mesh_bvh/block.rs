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
    pub fn triangle(&self, slot: usize) -> [Point; 3] {
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
