//! The library's shapes against exact answers, on rays that bite (`/tests/oracle`).
//!
//! A hit is judged against its condition: an error is counted in units of `u · cond`, and 100 of
//! them are allowed, as if the input had been wrong by so much. Whether there is a hit at all must
//! be right unless a relative change of the input by 1e-13 would change the answer. Both are
//! multiplied by the condition number of an instance's matrix.

use std::fmt;
use std::sync::Arc;

use groundtruth::accel::{Accel, Method, Primitives};
use groundtruth::math::{Aabb, Point, Ray, Span, Step, Transform, Vector};
use groundtruth::shapes::{self, Candidate, Context, Instance};
use oracle::hard::{Family, Kind, cases};

use crate::support::U;

/// Answers that a smaller relative change of the input would turn may be wrong.
const LEAST_MARGIN: f64 = 1e-13;
/// Allowed in `t` and in curved normals, in units of `u · cond`.
const ALLOWED: f64 = 100.0;
/// Allowed in the normals of flat shapes, and in the length of all, in units of `u`.
const FLAT_NORMAL: f64 = 4.0;

/// A shape of the library and the same one for the oracle.
pub struct Pair {
    pub ours: Arc<dyn shapes::Shape>,
    pub exact: oracle::Shape,
}

/// The largest errors met, and where.
#[derive(Default)]
pub struct Worst {
    cases: usize,
    judged: usize,
    t: Error,
    normal: Error,
    failures: Vec<String>,
}

/// An error in units of what a relative change by `u` may do, and the case that has it.
#[derive(Default)]
struct Error {
    size: f64,
    case: String,
}

impl Error {
    fn meet(&mut self, size: f64, case: &impl Fn() -> String) {
        if size.is_nan() || size > self.size {
            *self = Self { size: if size.is_nan() { f64::INFINITY } else { size }, case: case() };
        }
    }
}

impl fmt::Display for Worst {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { cases, judged, t, normal, failures } = self;
        write!(f, "{cases} rays, {judged} hits or misses judged; worst in u·cond: ")?;
        writeln!(f, "t {:.2} ({}), normal {:.2} ({})", t.size, t.case, normal.size, normal.case)?;
        failures.iter().take(12).try_for_each(|failure| writeln!(f, "  {failure}"))
    }
}

/// Judges `count` cases of each family; fails with the worst of them.
pub fn sweep(kind: Kind, seed: u64, count: usize) {
    sweep_as(kind, seed, count, |shape, ray, _| pair(shape).map(|pair| (pair, ray.clone())));
}

/// As [`sweep`], each case turned into another by `change`, which also gets its number; `None`
/// where the library refuses the shape.
pub fn sweep_as(
    kind: Kind,
    seed: u64,
    count: usize,
    change: impl Fn(&oracle::Shape, &oracle::Ray, usize) -> Option<(Pair, oracle::Ray)>,
) {
    let families = Family::ALL.into_iter().flat_map(|family| {
        let numbered = cases(kind, family, seed, count).into_iter().enumerate();
        numbered.map(move |(index, case)| (family, index, case))
    });
    judge_all(families.filter_map(|(family, index, (shape, ray))| {
        let name = format!("{kind:?} {family:?} seed {seed} index {index}");
        change(&shape, &ray, index).map(|(pair, ray)| (name, pair, ray))
    }));
}

/// Judges named cases; fails with the worst of them, or if too few have an answer to judge.
pub fn judge_all(cases: impl Iterator<Item = (String, Pair, oracle::Ray)>) {
    let mut worst = Worst::default();
    for (name, pair, ray) in cases {
        worst.judge(&pair, &ray, &|| name.clone());
    }
    println!("{worst}");
    assert!(worst.failures.is_empty(), "{} failures: {worst}", worst.failures.len());
    assert!(2 * worst.judged > worst.cases && worst.cases > 0, "too few to judge: {worst}");
}

impl Worst {
    fn judge(
        &mut self,
        Pair { ours, exact }: &Pair,
        ray: &oracle::Ray,
        case: &impl Fn() -> String,
    ) {
        let answer = oracle::intersect(exact, ray);
        let condition = exact.condition();
        let direction = Vector::from(ray.direction);
        let ray = Ray::new(Point::from(ray.origin), direction);
        let found = ours.roots(&ray, Span::AHEAD);
        self.cases += 1;
        let mut fail = |problem: String| self.failures.push(format!("{}: {problem}", case()));

        let nearest = ours.hit(&ray, Span::AHEAD);
        if nearest != found.first().copied() {
            fail(format!("hit {nearest:?}, but roots {found:?}"));
        }
        if ours.shadow_hit(&ray, Span::AHEAD).is_some() != nearest.is_some() {
            fail("hit and shadow differ".to_owned());
        }
        let ascending = found.windows(2).all(|pair| pair[0].t <= pair[1].t);
        if !ascending || found.iter().any(|hit| !(hit.t.is_finite() && hit.t > 0.0)) {
            fail(format!("no ascending distances: {found:?}"));
        }
        if answer.margin <= LEAST_MARGIN * condition {
            return;
        }
        self.judged += 1;
        if found.len() != answer.roots.len() {
            let exact: Vec<f64> = answer.roots.iter().map(|root| root.t).collect();
            let found: Vec<f64> = found.iter().map(|hit| hit.t).collect();
            fail(format!(
                "found {found:?} for {exact:?}, margin {:e}, κ {condition:e}",
                answer.margin
            ));
            return;
        }
        if through_accelerator(&**ours, &ray) != nearest {
            fail(format!("the rule of the own box loses {nearest:?}"));
        }
        for (hit, root) in found.iter().zip(&answer.roots) {
            let t = root.t_error(hit.t) / (U * condition * root.cond.max(root.t.abs()));
            self.t.meet(t, case);
            if t.is_nan() || t > ALLOWED {
                fail(format!("t {:e}, exactly {:e}: {t:.1} u·cond", hit.t, root.t));
            }
            let normal = ours.surface(&ray, hit).normal;
            let length = (Vector::from(normal).length() - 1.0).abs() / U;
            if length.is_nan() || length > FLAT_NORMAL {
                fail(format!("normal {normal:?} is not unit"));
            }
            if root.face_margin <= LEAST_MARGIN * condition {
                continue; // an edge of a box: either face will do
            }
            let flat = root.size.is_infinite();
            let allowed = if flat { FLAT_NORMAL } else { ALLOWED };
            let moved =
                if flat { 1.0 } else { (root.cond * direction.length() / root.size).max(1.0) };
            let error = root.normal_error(normal.to_array()) / (U * condition * moved);
            self.normal.meet(error, case);
            if error.is_nan() || error > allowed {
                fail(format!("normal {normal:?}, exactly {:?}: {error:.1} u·cond", root.normal));
            }
        }
    }
}

/// The first hit of a scene with this shape alone.
fn through_accelerator(shape: &dyn shapes::Shape, ray: &Ray) -> Option<Candidate> {
    struct Alone<'a>(&'a dyn shapes::Shape, &'a Ray);
    impl Primitives for Alone<'_> {
        fn hit(&self, _: u32, span: Span) -> Option<Candidate> {
            self.0.hit(self.1, span)
        }
        fn bounds(&self, _: u32) -> Aabb {
            self.0.bounds()
        }
    }
    let accel = Accel::build(Method::List, &[shape.bounds()]);
    accel.nearest(&Alone(shape, ray), ray, Span::AHEAD).map(|(_, candidate)| candidate)
}

/// The library's shape of the same data; `None` where it refuses them.
pub fn pair(exact: &oracle::Shape) -> Option<Pair> {
    let (kind, exact) = ours(exact);
    Some(Pair { ours: kind.build(&mut Context::default()).ok()?, exact })
}

/// An instance of the same shape, and the ray moved with it.
pub fn instanced(
    shape: &oracle::Shape,
    ray: &oracle::Ray,
    matrix: [[f64; 4]; 3],
) -> Option<(Pair, oracle::Ray)> {
    let moved = oracle::Shape::Instance { matrix, of: Box::new(shape.clone()) };
    let transform = Transform::from_steps(&steps(&matrix)).expect("not singular");
    let ray = oracle::Ray {
        origin: transform.point(ray.origin.into()).into(),
        direction: transform.vector(ray.direction.into()).into(),
    };
    Some((pair(&moved)?, ray))
}

/// The library's description of a shape; and the oracle's with the matrices that the library has.
fn ours(exact: &oracle::Shape) -> (shapes::Kind, oracle::Shape) {
    let kind = match exact.clone() {
        oracle::Shape::Plane { point, normal } => {
            shapes::Plane { point: point.into(), normal: normal.into() }.into()
        }
        oracle::Shape::Sphere { center, radius } => {
            shapes::Sphere { center: center.into(), radius, inward: false }.into()
        }
        oracle::Shape::Cuboid { min, max } => {
            shapes::Box { min: min.into(), max: max.into() }.into()
        }
        oracle::Shape::Triangle { vertices } => {
            shapes::Triangle { vertices: vertices.map(Point::from), normals: None }.into()
        }
        oracle::Shape::Rectangle { corner, a, b } => {
            shapes::Rectangle { corner: corner.into(), a: a.into(), b: b.into() }.into()
        }
        oracle::Shape::Disk { center, normal, radius } => {
            shapes::Disk { center: center.into(), normal: normal.into(), radius }.into()
        }
        oracle::Shape::OpenCylinder { y0, y1, radius } => {
            shapes::OpenCylinder { y0, y1, radius, inward: false }.into()
        }
        oracle::Shape::Annulus { center, normal, inner, outer } => shapes::Annulus {
            center: center.into(),
            normal: normal.into(),
            inner_radius: inner,
            outer_radius: outer,
        }
        .into(),
        oracle::Shape::PartAnnulus { center, inner, outer, phi } => shapes::PartAnnulus {
            center: center.into(),
            inner_radius: inner,
            outer_radius: outer,
            phi,
            down: false,
        }
        .into(),
        oracle::Shape::Cone { height, radius } => {
            shapes::Cone { height, radius, inward: false }.into()
        }
        oracle::Shape::Paraboloid { height, radius } => {
            shapes::Paraboloid { height, radius, inward: false }.into()
        }
        oracle::Shape::PartSphere { center, radius, phi, theta } => {
            shapes::PartSphere { center: center.into(), radius, phi, theta, inward: false }.into()
        }
        oracle::Shape::PartCylinder { y0, y1, radius, phi } => {
            shapes::PartCylinder { y0, y1, radius, phi, inward: false }.into()
        }
        oracle::Shape::Torus { swept_radius, tube_radius } => {
            shapes::Torus { swept_radius, tube_radius, inward: false }.into()
        }
        oracle::Shape::PartTorus { swept_radius, tube_radius, phi, theta } => {
            let ([phi_min, phi_max], [theta_min, theta_max]) = (phi, theta);
            shapes::PartTorus {
                swept_radius,
                tube_radius,
                phi_min,
                phi_max,
                theta_min,
                theta_max,
                inward: false,
            }
            .into()
        }
        oracle::Shape::Algebraic { terms, min, max } => {
            let term = |(coefficient, powers)| shapes::Term { coefficient, powers };
            let terms = terms.into_iter().map(term).collect();
            shapes::Algebraic { terms, min: min.into(), max: max.into() }.into()
        }
        oracle::Shape::Instance { matrix, of } => {
            let (inner, exact_inner) = ours(&of);
            let transform = steps(&matrix);
            let rows = Transform::from_steps(&transform).expect("not singular").rows();
            let instance = Instance::new(inner, transform);
            return (
                instance.into(),
                oracle::Shape::Instance { matrix: rows, of: Box::new(exact_inner) },
            );
        }
    };
    (kind, exact.clone())
}

/// Steps whose product is this matrix but for rounding: shear, scale, rotation, translation, by
/// Gram and Schmidt's process on the columns.
pub fn steps(matrix: &[[f64; 4]; 3]) -> Vec<Step> {
    let [c0, c1, c2, shift] =
        [0, 1, 2, 3].map(|j| Vector::new(matrix[0][j], matrix[1][j], matrix[2][j]));
    let unit = |v: Vector| v.unit().expect("the columns span space");
    let x = unit(c0);
    let y = unit(c1 - c1.dot(x) * x);
    let z = x.cross(y);
    let (sx, sy, sz) = (c0.dot(x), c1.dot(y), c2.dot(z));
    let shear = [c1.dot(x) / sx, c2.dot(x) / sx, 0.0, c2.dot(y) / sy, 0.0, 0.0];
    // the rotation with these columns: its axis from the skew part, its angle from that and the
    // trace
    let axis = Vector::new(y.z() - z.y(), z.x() - x.z(), x.y() - y.x());
    let angle = groundtruth::math::atan2(axis.length(), x.x() + y.y() + z.z() - 1.0);
    vec![
        Step::Shear(shear),
        Step::Scale(Vector::new(sx, sy, sz)),
        Step::RotateAbout {
            point: Point::ORIGIN,
            direction: axis,
            degrees: groundtruth::math::to_degrees(angle),
        },
        Step::Translate(shift),
    ]
}
