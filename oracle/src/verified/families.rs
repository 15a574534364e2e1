//! The hard cases are as hard as documented.

use crate::{
    Shape,
    hard::{Family, Kind, cases},
    intersect,
};

fn length(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[test]
fn the_same_seed_gives_the_same_cases_and_another_others() {
    let debug = |seed| format!("{:?}", cases(Kind::Instance, Family::Scaled, seed, 5));
    assert_eq!(debug(1), debug(1));
    assert_ne!(debug(1), debug(2));
}

#[test]
fn about_half_of_the_rays_hit() {
    let n = testkit::as_many(50, 200);
    for kind in Kind::ALL {
        let level = matches!(kind, Kind::PartAnnulus | Kind::CutFace);
        for family in Family::ALL {
            let cases = cases(kind, family, 11, n);
            let hits = cases.iter().filter(|(s, r)| !intersect(s, r).roots.is_empty()).count();
            let (least, most) = match family {
                Family::EdgesAndCorners => (40, 185), // the border belongs to the shape
                Family::Degenerate if level => (5, 170), // most of these are level, too
                Family::Degenerate => (15, 170),      // a ray in a plane misses it
                // points of a level plane are exact: t is 0 there, which is not a hit
                Family::OnSurface if level => (0, 0),
                Family::AxisParallel if level => (15, 170), // most are level, too
                _ if kind.is_solid() => (25, 195), // from inside, every ray hits a closed surface
                Family::OnSurface => (40, 185),    // a ray may hit another sheet of the surface
                _ => (40, 170),
            };
            let hits = hits * 200 / cases.len();
            assert!((least..=most).contains(&hits), "{kind:?} {family:?}: {hits} of 200 hit");
        }
    }
}

#[test]
fn far_origins_are_far() {
    let far = cases(Kind::Sphere, Family::FarOrigin, 1, 200);
    let count = far.iter().filter(|(_, ray)| length(ray.origin) > 1e6).count();
    assert!(count > 50, "{count} of 200 beyond 1e6");
}

/// The sine of the angle between ray and surface is `|d·n|/|d|`.
#[test]
fn grazing_rays_graze() {
    for kind in [Kind::Plane, Kind::Sphere, Kind::Triangle, Kind::Disk, Kind::OpenCylinder] {
        let mut flattest = f64::INFINITY;
        for (shape, ray) in cases(kind, Family::Grazing, 1, 200) {
            for root in intersect(&shape, &ray).roots {
                let cos: f64 = (0..3).map(|i| root.normal[i] * ray.direction[i]).sum();
                flattest = flattest.min(cos.abs() / length(ray.direction));
            }
        }
        assert!(flattest < 1e-8, "{kind:?}: {flattest:e}");
    }
}

#[test]
fn tangents_pass_within_1e_12_on_both_sides() {
    for kind in Kind::ALL {
        let answers = cases(kind, Family::Tangent, 1, testkit::as_many(160, 400));
        let answers: Vec<_> = answers.iter().map(|(s, r)| intersect(s, r)).collect();
        let close = |hit: bool| {
            let close = answers.iter().filter(|a| a.margin < 1e-12 && a.roots.is_empty() != hit);
            close.count()
        };
        assert!(
            close(true) >= 5 && close(false) >= 5,
            "{kind:?}: {} {}",
            close(true),
            close(false)
        );
    }
}

/// A needle has one very short side; a cap has three long sides.
#[test]
fn thin_triangles_are_needles_and_caps_of_aspect_1e5_and_more() {
    let (mut needles, mut caps) = (0, 0);
    for (shape, _) in cases(Kind::Triangle, Family::Thin, 1, 200) {
        let Shape::Triangle { vertices: v } = shape else { unreachable!() };
        let side = |i: usize, j: usize| length(std::array::from_fn(|k| v[i][k] - v[j][k]));
        let mut sides = [side(0, 1), side(1, 2), side(2, 0)];
        sides.sort_by(f64::total_cmp);
        needles += usize::from(sides[0] < 1e-5 * sides[2]);
        caps += usize::from(sides[0] > 0.1 * sides[2]);
    }
    assert!(needles > 20 && caps > 50, "{needles} needles, {caps} caps");
}

#[test]
fn sizes_reach_from_a_millionth_to_a_million() {
    let radii = |family| {
        let radii = cases(Kind::Sphere, family, 1, 200).into_iter().map(|(shape, _)| {
            let Shape::Sphere { radius, .. } = shape else { unreachable!() };
            radius
        });
        radii.collect::<Vec<_>>()
    };
    let least = |values: Vec<f64>| values.into_iter().fold(f64::INFINITY, f64::min);
    let most = |values: Vec<f64>| values.into_iter().fold(0.0, f64::max);
    let tiny = least(radii(Family::TinyShape));
    assert!(tiny < 3e-6, "the least radius is {tiny:e}");
    let huge = most(radii(Family::HugeShape));
    assert!(huge > 3e5, "the largest radius is {huge:e}");
    let scaled = cases(Kind::Disk, Family::Scaled, 1, 200);
    let lengths: Vec<f64> = scaled.iter().map(|(_, ray)| length(ray.direction)).collect();
    let (short, long) = (least(lengths.clone()), most(lengths));
    assert!(short < 1e-5 && long > 1e5, "directions are from {short:e} to {long:e} long");
}

#[test]
fn degenerate_rays_have_zeros_of_both_signs() {
    for family in [Family::Degenerate, Family::AxisParallel] {
        let cases = cases(Kind::Cuboid, family, 1, 100);
        let components = || cases.iter().flat_map(|(_, ray)| ray.direction);
        assert!(components().any(|x| x == 0.0 && x.is_sign_negative()));
        assert!(components().any(|x| x == 0.0 && x.is_sign_positive()));
    }
}

/// The margin of a ray through an edge is 0 or a few roundings.
#[test]
fn rays_through_edges_meet_them() {
    for kind in [Kind::Triangle, Kind::Rectangle] {
        let cases = cases(kind, Family::EdgesAndCorners, 1, 200);
        let exact = cases.iter().filter(|(s, r)| intersect(s, r).margin == 0.0).count();
        assert!(exact > 50, "{kind:?}: {exact} exact");
        let answers = cases.iter().map(|(s, r)| intersect(s, r));
        let hits = answers.filter(|answer| !answer.roots.is_empty());
        let most = hits.map(|answer| answer.margin).fold(0.0, f64::max);
        assert!(most < 1e-14, "{kind:?}: a margin of {most:e}");
    }
}

/// The oracle takes the sides as given; its inside test by projections is right only if this holds.
#[test]
fn sides_of_rectangles_are_perpendicular_to_rounding() {
    for family in Family::ALL {
        for (shape, _) in cases(Kind::Rectangle, family, 1, 100) {
            let Shape::Rectangle { a, b, .. } = shape else { unreachable!() };
            let dot: f64 = (0..3).map(|i| a[i] * b[i]).sum();
            assert!(dot.abs() <= 4.0 * f64::EPSILON * length(a) * length(b), "{family:?}");
        }
    }
}
