//! A generated mesh about as large and as uneven as the Stanford bunny.

use groundtruth::math::{Point, cos, sin};

/// Steps around and from pole to pole: 2 · 264 · 132 = 69 696 triangles.
pub const STEPS: [u32; 2] = [264, 133];

/// A unit sphere with bumps of 15 %: vertices and triangles, wound outward.
pub fn bumpy_sphere([around, down]: [u32; 2]) -> (Vec<Point>, Vec<[u32; 3]>) {
    let mut vertices = Vec::new();
    for k in 0..=down {
        let theta = std::f64::consts::PI * f64::from(k) / f64::from(down);
        for j in 0..around {
            let phi = 2.0 * std::f64::consts::PI * f64::from(j) / f64::from(around);
            let r = 1.0 + 0.1 * sin(9.0 * phi) * sin(7.0 * theta) + 0.05 * sin(31.0 * theta);
            let (s, c) = (r * sin(theta), r * cos(theta));
            vertices.push(Point::new(s * sin(phi), c, s * cos(phi)));
        }
    }
    let mut triangles = Vec::new();
    for k in 0..down {
        for j in 0..around {
            let at = |j: u32, k: u32| k * around + j % around;
            let [a, b] = [at(j, k), at(j + 1, k)];
            let [c, d] = [at(j, k + 1), at(j + 1, k + 1)];
            // at a pole one of the two has no area
            if k + 1 < down {
                triangles.push([a, c, d]);
            }
            if k > 0 {
                triangles.push([a, d, b]);
            }
        }
    }
    (vertices, triangles)
}

/// Rays of a camera in front of the unit sphere, row by row: neighbouring rays are almost parallel.
pub fn coherent_rays(side: u32) -> Vec<groundtruth::math::Ray> {
    let eye = Point::new(0.5, 1.0, 4.0);
    let position = |i: u32| 2.4 * (f64::from(i) + 0.5) / f64::from(side) - 1.2;
    let through = |i: u32| Point::new(position(i % side), position(i / side), 0.0) - eye;
    (0..side * side)
        .map(|i| groundtruth::math::Ray::new(eye, through(i).unit().expect("not the eye")))
        .collect()
}

/// Rays between random points of the box around the unit sphere: their directions are unrelated.
pub fn incoherent_rays(count: u32) -> Vec<groundtruth::math::Ray> {
    let mut random = groundtruth::math::Pcg32::new(2007, 0);
    let mut point = || {
        let mut x = || 2.0 * random.uniform() - 1.0;
        Point::new(x(), x(), x())
    };
    (0..count)
        .map(|_| {
            let (from, to) = (point(), point());
            groundtruth::math::Ray::new(from, (to - from).unit().expect("two points"))
        })
        .collect()
}
