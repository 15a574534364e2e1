//! Quadrics of revolution: their equations, and convex functions that are negative inside.

use crate::{
    margin::Gate,
    real::{Real, V, magnitude, nearest, real, sign},
};

/// The whole surface, with its centre, vertex or the centre of its base at the origin.
pub(super) enum Whole<'a> {
    /// `|p| = r`.
    Sphere { r: &'a Real },
    /// `ρ = r`.
    Cylinder { r: &'a Real },
    /// `ρ/r = (h − y)/h`.
    Cone { r: &'a Real, h: &'a Real },
    /// `y/h = ρ²/r²`.
    Paraboloid { r: &'a Real, h: &'a Real },
    /// `κ |p|² = 2 y`, with `κ = 2 h/(h² + r²)` such that the circle of radius r at the height h ≤ r
    /// is on it.
    Dish { r: &'a Real, h: &'a Real },
}

pub(super) fn origin() -> V {
    V([(); 3].map(|()| real(0.0)))
}

pub(super) fn with_height(v: &V, y: &Real) -> V {
    V([v.0[0].clone(), y.clone(), v.0[2].clone()])
}

fn curvature(r: &Real, h: &Real) -> Real {
    real(2.0) * h / (h * h + r * r)
}

fn rho(p: &V) -> Real {
    (&p.0[0] * &p.0[0] + &p.0[2] * &p.0[2]).sqrt()
}

/// `F(p) = (p·S p)/2 + s·p + s₀`: the diagonal of S, s and s₀.
pub(super) struct Quadric {
    pub(super) square: V,
    pub(super) linear: V,
    pub(super) constant: Real,
}

impl Whole<'_> {
    pub(super) fn quadric(&self) -> Quadric {
        let v = |x: Real, y: Real, z: Real| V([x, y, z]);
        let (zero, one) = (|| real(0.0), || real(1.0));
        let half = real(0.5);
        match self {
            Whole::Sphere { r } => Quadric {
                square: v(one(), one(), one()),
                linear: origin(),
                constant: -half * *r * *r,
            },
            Whole::Cylinder { r } => Quadric {
                square: v(one(), zero(), one()),
                linear: origin(),
                constant: -half * *r * *r,
            },
            // (ρ² − k² (h − y)²)/2
            Whole::Cone { r, h } => {
                let k2 = *r * *r / (*h * *h);
                Quadric {
                    square: v(one(), -k2.clone(), one()),
                    linear: v(zero(), &k2 * *h, zero()),
                    constant: -half * *r * *r,
                }
            }
            // (h/r²) ρ² − y
            Whole::Paraboloid { r, h } => {
                let two = real(2.0) * *h / (*r * *r);
                Quadric {
                    square: v(two.clone(), zero(), two),
                    linear: v(zero(), -one(), zero()),
                    constant: zero(),
                }
            }
            // κ |p|²/2 − y
            Whole::Dish { r, h } => {
                let bend = curvature(r, h);
                Quadric {
                    square: v(bend.clone(), bend.clone(), bend),
                    linear: v(zero(), -one(), zero()),
                    constant: zero(),
                }
            }
        }
    }

    /// The sum over the shape's inputs of `|∂F/∂x| |x|` at a point of the surface.
    pub(super) fn inputs(&self, p: &V) -> f64 {
        match self {
            Whole::Sphere { r } | Whole::Cylinder { r } => nearest(&(*r * *r)),
            Whole::Cone { r, h } => {
                let k2 = *r * *r / (*h * *h);
                let down = *h - &p.0[1];
                nearest(&(rho(p) * rho(p) + k2 * down * &p.0[1]))
            }
            Whole::Paraboloid { .. } => 3.0 * magnitude(&p.0[1]),
            // a relative change of h changes κ by (r² − h²)/(r² + h²) of it, one of r by 2 r²/(r² + h²)
            Whole::Dish { r, h } => {
                let (r2, h2) = (*r * *r, *h * *h);
                nearest(&((real(3.0) * &r2 - &h2) / (r2 + h2))) * magnitude(&p.0[1])
            }
        }
    }

    /// A convex function of the point, negative inside; with a bound on its change when the point moves by
    /// `reach·ε + second·ε²` and a change of the shape moves the surface by `own·ε`.
    pub(super) fn excess(&self, p: &V, reach: f64, own: f64, second: f64) -> Gate {
        let moved = reach + own;
        match self {
            Whole::Sphere { r } => Gate::new(&(p.norm() - *r), moved, second),
            Whole::Cylinder { r } => Gate::new(&(rho(p) - *r), moved, second),
            Whole::Cone { r, h } => {
                let slant = (*r * *r + *h * *h).sqrt();
                let off = (rho(p) * *h + (&p.0[1] - *h) * *r) / slant;
                Gate::new(&off, moved, second)
            }
            Whole::Paraboloid { r, h } => {
                let bend = *h / (*r * *r);
                let rho = rho(p);
                let value = &bend * &rho * &rho - &p.0[1];
                let (bend, rho) = (nearest(&bend), nearest(&rho));
                let steep = 2.0 * bend * rho;
                let first = (steep * steep + 1.0).sqrt() * reach + 3.0 * bend * rho * rho;
                let reach = reach + 3.0 * rho;
                Gate::new(&value, first, second + 2.0 * bend * reach * reach)
            }
            Whole::Dish { r, h } => {
                let bend = curvature(r, h);
                let square = p.dot(p);
                let value = &bend * &square / real(2.0) - &p.0[1];
                let [bend, far] = [bend, square.sqrt()].map(|x| nearest(&x));
                let up = with_height(&origin(), &real(1.0));
                let slope = (&(p * &real(bend)) - &up).len();
                let first = slope * reach + 1.5 * bend * far * far;
                let reach = reach + 3.0 * far;
                Gate::new(&value, first, slope * second + 2.0 * bend * reach * reach)
            }
        }
    }

    /// Where the excess is least along the line.
    pub(super) fn closest(&self, o: &V, d: &V) -> Option<Real> {
        let (ox, dx) = (with_height(o, &real(0.0)), with_height(d, &real(0.0)));
        let (a, b) = (dx.dot(&dx), ox.dot(&dx));
        let flat = || sign(&a).is_gt();
        match self {
            Whole::Sphere { .. } => Some(-(o.dot(d) / d.dot(d))),
            Whole::Dish { r, h } => Some((&d.0[1] / curvature(r, h) - o.dot(d)) / d.dot(d)),
            Whole::Cylinder { .. } => flat().then(|| -&b / &a),
            Whole::Paraboloid { r, h } => {
                flat().then(|| (*r * *r / *h * &d.0[1] / real(2.0) - &b) / &a)
            }
            // ρ' = −k d_y with ρ² = a τ² + q at τ = t + b/a
            Whole::Cone { r, h } => {
                let m = *r / *h * &d.0[1];
                let rest = &a - &m * &m;
                if sign(&rest).is_le() {
                    return None;
                }
                let across = &ox.0[2] * &dx.0[0] - &ox.0[0] * &dx.0[2];
                let q = &across * &across / &a;
                Some(-(&b / &a) - m * (q / (&a * rest)).sqrt())
            }
        }
    }
}
