//! The light of disks and spheres, in closed form.

use std::f64::consts::FRAC_PI_2;

use groundtruth::lights::Kind as Light;

use super::*;
use crate::prelude::*;

const SAMPLES: u32 = 1024;
const POWER: f64 = 4e-3;

/// Law: a disk parallel to the surface, of radius R at height h on its axis, lights it with `R²/(R² + h²)` of
/// the cosine-weighted sky; displaced sideways by a, with `½ (1 − (h² + a² − R²)/√((h² + a² + R²)² − 4 R²
/// a²))`. So the floor has the radiance `k_d c_d L` times that. Oracle: the closed form (ch. 18; off the axis
/// Howell's catalogue, B-13).
/// Book: fig. 18.5, lights that are disks and spheres.
#[test]
fn a_parallel_disk_gives_its_closed_form() {
    for (radius, h, a) in
        [(1.0, 1.0, 0.0), (0.3, 2.0, 0.0), (2.0, 1.0, 0.0), (1.0, 1.0, 1.5), (2.0, 0.7, 1.0)]
    {
        let t: f64 = h * h + a * a;
        let (sum, r) = (t + radius * radius, 4.0 * radius * radius * a * a);
        let share = 0.5 * (1.0 - (t - radius * radius) / (sum * sum - r).sqrt());
        let n = Normal::new(Vector::new(0.3, 1.0, -0.6)).expect("not zero");
        let across = at_angle(n, 0.0, 2.0);
        let mut scene = floor(n);
        let center = Point::ORIGIN + h * n + a * across;
        hang(&mut scene, Disk { center, normal: -Vector::from(n), radius }, None);
        let values = seen(&scene, SAMPLES, Point::ORIGIN, n);
        assert_color(
            &format!("radius {radius}, height {h}, off by {a}"),
            &values,
            lit(share),
            5,
            POWER,
        );
    }
}

/// The share of the cosine-weighted sky that is filled by a sphere whose centre is `distance` radii away at
/// this angle from the normal: `cosθ/H²` above the horizon; cut by the horizon, Howell's catalogue, B-43.
pub fn sphere_share(distance: f64, angle: f64) -> f64 {
    let (h, half) = (distance, FRAC_PI_2 - acos(1.0 / distance));
    if angle <= FRAC_PI_2 - half {
        return cos(angle) / (h * h);
    }
    if angle >= FRAC_PI_2 + half {
        return 0.0;
    }
    let s = (h * h - 1.0).sqrt();
    let asin = |x: f64| FRAC_PI_2 - acos(x);
    let cut = (1.0 - (h * cos(angle)) * (h * cos(angle))).sqrt();
    let above = cos(angle) * acos(-s * cos(angle) / sin(angle)) - s * cut;
    0.5 - asin(s / (h * sin(angle))) / PI + above / (PI * h * h)
}

/// Law: the closed form for a sphere is right. Oracle: its cone of directions, integrated in rings around the
/// axis, of each ring the arc above the horizon; the midpoint rule with 4000 rings has an error of some
/// `1e-7`.
#[test]
fn the_share_of_a_sphere_is_the_integral_over_its_cap() {
    const RINGS: u32 = 4000;
    for (distance, angle) in
        [(2.0, 0.5), (2.0, 1.3), (2.0, 1.7), (1.2, 1.0), (1.2, 2.0), (5.0, 1.5_f64)]
    {
        let step = (FRAC_PI_2 - acos(1.0 / distance)) / f64::from(RINGS);
        let ring = |i: u32| {
            let theta = step * (f64::from(i) + 0.5);
            let (along, across) = (cos(angle) * cos(theta), sin(angle) * sin(theta));
            let sum = if along >= across {
                PI * along
            } else if along <= -across {
                0.0
            } else {
                let phi = acos(-along / across);
                along * phi + across * sin(phi)
            };
            2.0 * sum * sin(theta) * step / PI
        };
        let (integral, share) = ((0..RINGS).map(ring).sum::<f64>(), sphere_share(distance, angle));
        assert!(
            (integral - share).abs() < 1e-6,
            "{distance}, {angle}: {integral}, expected {share}"
        );
    }
}

/// Law: a sphere of radius R at the distance D and at the angle θ from the normal gives `E = π L (R/D)² cosθ`
/// above the horizon, and the closed form where the horizon cuts it; sampled by area, where half the samples
/// face away, and by solid angle. Oracle: the closed forms (ch. 18).
/// Book: fig. 18.5, lights that are disks and spheres.
#[test]
fn a_sphere_gives_its_closed_form_however_it_is_sampled() {
    for sampling in [Sampling::Area, Sampling::SolidAngle] {
        for (radius, distance, angle) in [
            (1.0, 2.0, 0.0),
            (0.2, 3.0, 0.9),
            (2.0, 2.5, 0.3),
            (1.0, 2.0, 1.4),
            (1.0, 1.5, 1.9),
            (1.0, 1.2, 1.0),
        ] {
            let n = Normal::new(Vector::new(-0.5, 1.0, 0.2)).expect("not zero");
            let mut scene = floor(n);
            let center = Point::ORIGIN + distance * at_angle(n, cos(angle), 1.0);
            hang(&mut scene, ball(center, radius), Some(sampling));
            // near a lamp, samples by area vary most
            let values = seen(&scene, 2 * SAMPLES, Point::ORIGIN, n);
            let share = sphere_share(distance / radius, angle);
            let what = format!("{sampling:?}: radius {radius}, distance {distance}, angle {angle}");
            assert_color(&what, &values, lit(share), 12, 4.0 * POWER);
        }
    }
}

/// Law: a lamp all around gives `k_d c_d L`, like the furnace. Oracle: the reflection equation in uniform
/// light; the lamp's front is its inner side.
#[test]
fn a_lamp_all_around_is_a_furnace() {
    for sampling in [Sampling::Area, Sampling::SolidAngle] {
        let mut scene = floor(up());
        let around = Sphere { center: Point::new(0.1, 0.2, -0.1), radius: 2.0, inward: true };
        hang(&mut scene, around, Some(sampling));
        let values = seen(&scene, SAMPLES, Point::ORIGIN, up());
        assert_color(&format!("{sampling:?}"), &values, lit(1.0), 2, 2.0 * POWER);
    }
}

/// Law: near a lamp, the variance of samples by solid angle is at most a tenth of that by area: samples by
/// area fall on parts that face away, and vary with `cosθ'/d²`. Both have the same mean (the laws above).
/// Oracle: the variance over replicas.
#[test]
fn sampling_by_solid_angle_varies_less_near_a_lamp() {
    for shape in [
        shapes::Kind::from(ball(Point::new(0.0, 1.2, 0.0), 1.0)),
        panel(Point::new(0.0, 0.4, 0.0), 4.0 * Vector::X, 4.0 * Vector::Z).into(),
    ] {
        let variance = |sampling| {
            let mut scene = floor(up());
            hang(&mut scene, shape.clone(), Some(sampling));
            let values = seen(&scene, 64, Point::ORIGIN, up());
            let mean = values.iter().map(|v| v.r).sum::<f64>() / values.len() as f64;
            values.iter().map(|v| (v.r - mean) * (v.r - mean)).sum::<f64>()
        };
        let (area, angle) = (variance(Sampling::Area), variance(Sampling::SolidAngle));
        assert!(10.0 * angle < area, "{shape:?}: {angle:e} by solid angle, {area:e} by area");
        let mut scene = floor(up());
        hang(&mut scene, shape, None);
        let Light::Area(area) = &scene.lights[0].source else { panic!("an area light") };
        assert_eq!(area.sampling, None);
        // by default, the light samples by solid angle
        let mut by_name = scene.clone();
        by_name.lights[0].source =
            Area { sampling: Some(Sampling::SolidAngle), ..area.clone() }.into();
        assert_eq!(seen(&scene, 16, Point::ORIGIN, up()), seen(&by_name, 16, Point::ORIGIN, up()));
    }
}

/// Law: an emissive surface with a matte base emits its own light and reflects the incident light. Oracle:
/// the sum of `l_s c_e` and the closed form of a parallel disk; the back does not emit, and reflects nothing,
/// as no light falls on it.
#[test]
fn an_emissive_surface_with_a_base_shines_and_reflects() {
    let base = Matte { ka: 0.0.into(), kd: 0.5.into(), cd: Rgb::new(0.2, 0.4, 1.0).into() };
    let own = Rgb::new(0.3, 0.1, 0.0);
    let mut scene = stage(Rgb::BLACK);
    let glow = Emissive { matte: Some(base), ..Emissive::new(2.0, own) };
    put(&mut scene, Plane { point: Point::ORIGIN, normal: Vector::Y }, glow);
    hang(
        &mut scene,
        Disk { center: Point::new(0.0, 1.5, 0.0), normal: -Vector::Y, radius: 1.0 },
        None,
    );
    let share = 1.0 / (1.0 + 1.5 * 1.5);
    let reflected = (0.5 * Rgb::new(0.2, 0.4, 1.0)) * lit(share);
    let values = seen(&scene, SAMPLES, Point::ORIGIN, up());
    assert_color("from above", &values, 2.0 * own + reflected, 1, POWER);
    let behind = seen(&scene, 16, Point::ORIGIN, -Vector::Y);
    assert!(behind.iter().all(|seen| seen.is_black()), "from below: {behind:?}");
}
