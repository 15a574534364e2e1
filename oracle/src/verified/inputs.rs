//! The inputs of a case in groups (a point, a vector, a radius, a matrix), which the tests move.

use crate::{
    hard::SplitMix64,
    real::{Real, real},
    shape::{Ray, Shape},
};

pub(super) struct Case {
    pub(super) shape: Shape<Real>,
    pub(super) ray: Ray<Real>,
}

impl Case {
    pub(super) fn new(shape: &Shape, ray: &Ray) -> Case {
        Case { shape: shape.exact(), ray: ray.exact() }
    }

    pub(super) fn groups(&mut self) -> Vec<Vec<&mut Real>> {
        let Ray { origin, direction } = &mut self.ray;
        let mut groups = vec![origin.iter_mut().collect(), direction.iter_mut().collect()];
        of_shape(&mut self.shape, &mut groups);
        groups
    }

    /// Moves every group by `epsilon` times its length, each in its own random direction.
    pub(super) fn shaken(&self, epsilon: &Real, rng: &mut SplitMix64) -> Case {
        let mut case = Case { shape: self.shape.clone(), ray: self.ray.clone() };
        for group in case.groups() {
            let random =
                |rng: &mut SplitMix64| (rng.next_u64() >> 11) as f64 - (1_u64 << 52) as f64;
            // one component or all of them: some bounds are attained only by moves along an axis
            let only = rng.next_u64() as usize % (2 * group.len());
            let direction: Vec<Real> = (0..group.len())
                .map(|i| real(if only < group.len() && i != only { 0.0 } else { random(rng) }))
                .collect();
            let step = epsilon * length(group.iter().map(|x| &**x)) / length(direction.iter());
            for (x, d) in group.into_iter().zip(&direction) {
                *x += &step * d;
            }
        }
        case
    }

    /// Moves every group by `epsilon` times its length along its part of a gradient, which has one
    /// number for each component of each group.
    pub(super) fn pushed(&self, epsilon: &Real, gradient: &[Vec<Real>]) -> Case {
        let mut case = Case { shape: self.shape.clone(), ray: self.ray.clone() };
        for (group, along) in case.groups().into_iter().zip(gradient) {
            let steepness = length(along.iter());
            if steepness == real(0.0) {
                continue;
            }
            let step = epsilon * length(group.iter().map(|x| &**x)) / steepness;
            for (x, g) in group.into_iter().zip(along) {
                *x += &step * g;
            }
        }
        case
    }
}

pub(super) fn length<'a>(group: impl Iterator<Item = &'a Real>) -> Real {
    group.fold(real(0.0), |sum, x| sum + x * x).sqrt()
}

fn of_shape<'a>(shape: &'a mut Shape<Real>, groups: &mut Vec<Vec<&'a mut Real>>) {
    match shape {
        Shape::Plane { point: p, normal: q } | Shape::Cuboid { min: p, max: q } => {
            groups.extend([p, q].map(|g| g.iter_mut().collect()));
        }
        Shape::Sphere { center, radius } => {
            groups.extend([center.iter_mut().collect(), vec![radius]]);
        }
        Shape::Triangle { vertices } => {
            groups.extend(vertices.iter_mut().map(|v| v.iter_mut().collect()));
        }
        Shape::Rectangle { corner, a, b } => {
            groups.extend([corner, a, b].map(|g| g.iter_mut().collect()));
        }
        Shape::Disk { center, normal, radius } => {
            groups.extend([center, normal].map(|g| g.iter_mut().collect()));
            groups.push(vec![radius]);
        }
        Shape::OpenCylinder { y0, y1, radius } => groups.extend([vec![y0], vec![y1], vec![radius]]),
        Shape::Annulus { center, normal, inner, outer } => {
            groups.extend([center, normal].map(|g| g.iter_mut().collect()));
            groups.extend([vec![inner], vec![outer]]);
        }
        Shape::PartAnnulus { center, inner, outer, phi } => {
            groups.push(center.iter_mut().collect());
            groups.extend([inner, outer].map(|x| vec![x]));
            azimuths(phi, groups);
        }
        Shape::Cone { height, radius } | Shape::Paraboloid { height, radius } => {
            groups.extend([vec![height], vec![radius]]);
        }
        Shape::PartSphere { center, radius, phi, theta } => {
            groups.push(center.iter_mut().collect());
            groups.push(vec![radius]);
            azimuths(phi, groups);
            // 180° means "up to the pole", as 360° means "all around": neither is moved
            groups.extend(theta.iter_mut().filter(|x| **x != real(180.0)).map(|x| vec![x]));
        }
        Shape::PartCylinder { y0, y1, radius, phi } => {
            groups.extend([y0, y1, radius].map(|x| vec![x]));
            azimuths(phi, groups);
        }
        Shape::CutFace { size, radius } => groups.extend([vec![size], vec![radius]]),
        Shape::Solid(solid) => groups.extend(solid.numbers().into_iter().map(|x| vec![x])),
        Shape::Torus { swept_radius, tube_radius } => {
            groups.extend([vec![swept_radius], vec![tube_radius]]);
        }
        Shape::PartTorus { swept_radius, tube_radius, phi, theta } => {
            groups.extend([vec![swept_radius], vec![tube_radius]]);
            groups.extend(phi.iter_mut().chain(theta).map(|angle| vec![angle]));
        }
        Shape::Algebraic { terms, min, max } => {
            groups.extend(terms.iter_mut().map(|(c, _)| vec![c]));
            groups.extend([min, max].map(|corner| corner.iter_mut().collect()));
        }
        Shape::Instance { matrix, of } => {
            let (mut linear, mut shift) = (Vec::new(), Vec::new());
            for [x, y, z, b] in matrix {
                linear.extend([x, y, z]);
                shift.push(b);
            }
            groups.extend([linear, shift]);
            of_shape(of, groups);
        }
    }
}

fn azimuths<'a>(phi: &'a mut [Real; 2], groups: &mut Vec<Vec<&'a mut Real>>) {
    if &phi[1] - &phi[0] < real(360.0) {
        groups.extend(phi.iter_mut().map(|x| vec![x]));
    }
}
