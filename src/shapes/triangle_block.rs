//! Up to eight triangles on up to eight corners, tested at once: what a leaf of a mesh's bvh holds.
//!
//! The kernels do the first pass of the watertight test only: the plain edge functions, by the same
//! operations in the same order as [`ShearedRay::meet`], and whether the depths of the corners,
//! between which `t` lies, reach into the span. What passes is then tested by `meet` itself, so the
//! kernels decide nothing but what need not be tested. A number that is none (from an overflow)
//! fails in `meet` whatever is decided here.

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
        let [x, y, z] = ray.axes;
        let corners = [&self.corners[x], &self.corners[y], &self.corners[z]];
        // SAFETY: the caller's
        let corners = unsafe { [L::load(corners[0]), L::load(corners[1]), L::load(corners[2])] };
        let [x, y, z] = ray.see(corners);
        let [a, b, c] = &self.numbers;
        let edges = Edges::of([x.pick(a), y.pick(a)], [x.pick(b), y.pick(b)], [x.pick(c), y.pick(c)]);
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
