//! A glass of water and a fish bowl: one surface for each boundary between two media.

use std::collections::BTreeSet;

use groundtruth::materials::Boundary;
use groundtruth::shapes::{BoundaryMaterials, FishBowl, GlassOfWater};

use crate::prelude::*;
use crate::support::stage::ray;

const AIR: Medium = Medium::clear(1.0);
const WATER: Medium = Medium::clear(1.33);
const GLASS: Medium = Medium::clear(1.5);

/// A scene of one vessel, whose boundaries lie between these media.
fn vessel(
    shape: impl Fn(BoundaryMaterials) -> Kind,
    [air, water, glass]: [Medium; 3],
    background: Rgb,
) -> Scene {
    let mut scene = deep_stage(background, 40);
    let names = ["glass-air", "water-air", "water-glass"];
    for (name, [inside, outside]) in
        names.into_iter().zip([[glass, air], [water, air], [water, glass]])
    {
        let recipe = Dielectric { inside, outside, ..Dielectric::default() };
        scene.materials.push(Material::new(name, recipe));
    }
    let [glass_air, water_air, water_glass] = names.map(|name| Some(name.to_owned()));
    let shape = shape(BoundaryMaterials { glass_air, water_air, water_glass });
    scene.objects.push(Object::new("vessel", names[0], shape));
    scene
}

fn glass_of_water(materials: BoundaryMaterials) -> Kind {
    GlassOfWater { materials, ..GlassOfWater::default() }.into()
}

fn fish_bowl(materials: BoundaryMaterials) -> Kind {
    FishBowl { materials, ..FishBowl::default() }.into()
}

/// The boundaries along a ray, in order: the name of the part, and the media before and behind it.
fn crossed(world: &World, mut ray: Ray) -> Vec<(String, [Medium; 2])> {
    let mut crossed = Vec::new();
    while let Some(hit) = world.hit(&ray, Span::AHEAD) {
        let Boundary { inside, outside } =
            hit.material.recipe.boundary().expect("all are dielectrics");
        let media = if hit.front { [outside, inside] } else { [inside, outside] };
        crossed.push((hit.path().to_string(), media));
        ray = Ray::new(hit.surface.leave(ray.direction), ray.direction);
    }
    crossed
}

/// Rays from a sphere around the vessel to points in it.
fn rays(seed: u64) -> impl Iterator<Item = Ray> {
    let mut random = Pcg32::new(28, seed);
    std::iter::repeat_with(move || {
        let mut c = || 2.0 * random.uniform() - 1.0;
        let from = Vector::new(c(), c(), c()).unit().expect("not zero");
        let to = Point::new(1.1 * c(), 2.0 * c(), 1.1 * c());
        ray(Point::ORIGIN + 9.0 * from, to - (Point::ORIGIN + 9.0 * from))
    })
}

/// Law: along every ray through a glass of water, which has 8 parts, or a fish bowl, which has 7, the
/// medium behind a boundary is the one before the next, from air to air: no gap, no overlap, no normal on
/// the wrong side. Oracle: topology, over 10⁵ random rays for each vessel; and each part is met.
/// Book: 28.7 and 28.8, a glass of water and a fish bowl.
#[test]
fn media_follow_one_another_along_every_ray() {
    type Build = fn(BoundaryMaterials) -> Kind;
    let vessels: [(Build, usize); 5] = [
        (glass_of_water, 8),
        // a tall thin glass, filled almost to the rim
        (
            |materials| {
                let (height, inner_radius, water_height) = (4.0, 0.5, 3.7);
                GlassOfWater {
                    height,
                    inner_radius,
                    water_height,
                    materials,
                    ..GlassOfWater::default()
                }
                .into()
            },
            8,
        ),
        (fish_bowl, 7),
        // a narrow opening: here the book's angles of the rim would not fit the spheres
        (|materials| FishBowl { opening: 60.0, materials, ..FishBowl::default() }.into(), 7),
        // less than half full, with a wide opening
        (
            |materials| {
                FishBowl { water_depth: 0.6, opening: 200.0, materials, ..FishBowl::default() }
                    .into()
            },
            6,
        ),
    ];
    for (index, (shape, parts)) in vessels.into_iter().enumerate() {
        let world = built(&vessel(shape, [AIR, WATER, GLASS], Rgb::BLACK));
        let mut met = BTreeSet::new();
        for ray in rays(index as u64).take(100_000) {
            let mut medium = AIR;
            for (part, [before, behind]) in crossed(&world, ray) {
                assert_eq!(before, medium, "vessel {index}, {part}, {ray:?}");
                medium = behind;
                met.insert(part);
            }
            assert_eq!(medium, AIR, "vessel {index}, after the last boundary of {ray:?}");
        }
        assert_eq!(met.len(), parts, "vessel {index}: {met:?}");
    }
}

/// Law: straight down through the water of the glass, light passes 1.2 of water and, in the base, .3 of
/// glass, and the reflections are those of water, water to glass, and glass to air. Oracle:
/// `(1 − R₁)(1 − R₂)(1 − R₃) exp(−1.2 σ_w − .3 σ_g)`, and what the level and the base reflect at depth 3,
/// from the table of ch. 28.
/// Book: 28.7 and 28.8, a glass of water and a fish bowl.
#[test]
fn straight_down_a_glass_of_water_light_passes_three_boundaries() {
    let absorbing = |eta, sigma: f64| Medium { eta, absorption: Rgb::grey(sigma) };
    let media = [AIR, absorbing(1.33, 0.5), absorbing(1.5, 1.0)];
    let mut scene = vessel(glass_of_water, media, Rgb::WHITE);
    *scene.tracer.max_depth().expect("whitted") = 3;
    let found = look(&built(&scene), Point::new(0.1, 5.0, 0.2), -Vector::Y).r;
    let transmitted = [0.020059, 0.003608, 0.04].iter().map(|r| 1.0 - r).product::<f64>();
    let through = transmitted * exp(-(1.2 * 0.5 + 0.3 * 1.0));
    // light from above reflected by the water surface, and by the base after passing the water twice
    let base = 0.003608 * power(1.0 - 0.020059, 2.0) * exp(-2.0 * 1.2 * 0.5);
    let expected = 0.020059 + base + through;
    assert!((found - expected).abs() < 1e-5, "{found} instead of {expected}");
}

/// Law: the meniscus of the fish bowl is tangent to the water's level and to the glass: x_c = .901388,
/// y_c = .3, β = 18.408°. Oracle: those numbers (ch. 28), from the surface's heights and normals along
/// vertical rays at both ends.
/// Book: 28.7 and 28.8, a glass of water and a fish bowl.
#[test]
fn the_meniscus_touches_level_and_glass_without_an_angle() {
    /// The distance from a seam, as small as the precision of the book's numbers allows.
    const NEAR: f64 = 1e-6;
    let world = built(&vessel(fish_bowl, [AIR, WATER, GLASS], Rgb::BLACK));
    let (xc, yc, m, beta) = (0.901388, 0.3, 0.05, to_radians(18.408));
    let below = |x: f64| {
        let hit = world.hit(&ray(Point::new(x, 0.301, 0.0), -Vector::Y), Span::AHEAD);
        let hit = hit.expect("water is below");
        (hit.path().to_string(), hit.surface.point.y(), Vector::from(hit.surface.normal))
    };
    let (part, height, normal) = below(xc - NEAR);
    assert!(part.contains("level"), "{part} is not level");
    near!(height, 0.25, 1e-15);
    assert_eq!(normal, Vector::Y);
    let (part, height, normal) = below(xc + NEAR);
    assert!(part.contains("meniscus") && (height - 0.25).abs() < 1e-9, "{part} at {height}");
    assert!((normal - Vector::Y).length() < 1e-4, "{normal:?}");
    // from the middle of the tube outward, at both sides of the line of contact
    let outward = |angle: f64| {
        let direction = Vector::new(cos(angle), sin(angle), 0.0);
        let from = Point::new(xc, yc, 0.0);
        let hit = world.hit(&ray(from, direction), Span::AHEAD).expect("glass or water");
        assert!((hit.t - m).abs() < 1e-5, "at {} from the middle of the tube", hit.t);
        let n = Vector::from(hit.surface.normal);
        assert!(n.dot(direction) < -1.0 + 1e-7, "{n:?} is not across");
        (hit.path().to_string(), hit.surface.point)
    };
    let (part, contact) = outward(beta - 1e-4);
    assert!(part.contains("meniscus"), "{part}");
    let (part, _) = outward(beta + 1e-4);
    assert!(part.contains("inside"), "{part}");
    assert!((to_degrees(atan2(contact.y(), contact.x())) - 18.408).abs() < 0.01, "{contact:?}");
    assert!((contact.to_vector().length() - 1.0).abs() < 1e-6, "{contact:?}");
}

/// Law: a glass of water and a fish bowl whose media are all of index 1 and clear cannot be seen. Oracle: the
/// background, exactly.
/// Book: 28.7 and 28.8, a glass of water and a fish bowl.
#[test]
fn vessels_of_one_medium_cannot_be_seen() {
    let background = Rgb::new(0.25, 0.5, 1.0);
    for shape in [glass_of_water, fish_bowl] {
        let world = built(&vessel(shape, [AIR; 3], background));
        for ray in rays(9).take(2_000) {
            assert_eq!(look(&world, ray.origin, ray.direction), background, "{ray:?}");
        }
    }
}
