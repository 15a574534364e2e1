//! Scattering where the shading normal leans, by smooth normals or by a bump: what is refracted obeys the true
//! normal, what is glossy follows the shading normal.

use explain::{RecordedHit, RecordedRay};
use groundtruth::bumps;
use groundtruth::lobes::{
    Bsdf, GlossyReflection, GlossySpecular, Lambertian, LobeSet, Lobes, NormalKind, Normals,
};
use groundtruth::materials::Kind as Recipe;
use groundtruth::math::ln_1p;
use testkit::properties::*;

use crate::prelude::*;
use crate::support::optics;
use crate::support::stage::ray;

/// The surface of a triangle in the plane y = 0 whose normals all lean this way, of a bumped plane, and of a
/// ball of smooth triangles, all of one material and around the origin.
fn leaning(recipe: &Recipe, lean: Vector) -> [Scene; 3] {
    let of = || deep_stage(Rgb::WHITE, 1);
    let vertices = [[-9.0, 0.0, -9.0], [0.0, 0.0, 9.0], [9.0, 0.0, -9.0]].map(Point::from);
    let [mut smooth, mut bumped, mut ball] = [of(), of(), of()];
    put(&mut smooth, Triangle { vertices, normals: Some([Vector::Y + lean; 3]) }, recipe.clone());
    put(&mut bumped, Plane { point: Point::ORIGIN, normal: Vector::Y }, recipe.clone());
    let (noise, perturbation) = (Noise::default(), lean.length());
    let bump = bumps::Noise { noise, size: 0.7, perturbation };
    bumped.materials[0].bump = Some(bump.into());
    put(&mut ball, TessellatedSphere::new(7, 5, true), recipe.clone());
    [smooth, bumped, ball]
}

/// Normals that lean by up to some 60°.
fn lean() -> impl Strategy<Value = Vector> {
    (-1.0..1.0_f64, -1.0..1.0_f64).prop_map(|(x, z)| Vector::new(x, 0.0, z))
}

/// The tree of a ray to a point near the origin, and its hit, if the normals there lean apart.
fn met(scene: &Scene, seed: u64, target: Point, to_eye: Normal) -> Option<(RayTree, RecordedHit)> {
    let mut world = built(scene);
    world.reseed(seed);
    let mut tree = RayTree::of(&world);
    let towards = ray(target + 4.0 * to_eye, -Vector::from(to_eye));
    radiance(&world, &towards, world.draws([0, 0], 0), &mut tree);
    let hit = tree.root().hit.clone()?;
    (hit.normal.dot(hit.shading_normal) < 0.999).then_some((tree, hit))
}

fn child(tree: &RayTree, kind: RayKind) -> Option<&RecordedRay> {
    tree.root().children.iter().find(|node| node.kind == kind)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: laws().cases / 2, ..laws() })]

    /// Law: however the shading normal leans, glass refracts by Snell's law about the true normal, from either
    /// side, mirrors about it, and divides light by Fresnel's equations for its angle. Oracle: cross products,
    /// `ω_o × n = −η (t × n)` and `r × n = −(ω_o × n)`; Fresnel by sums of angles.
    #[test]
    fn glass_refracts_about_the_true_normal(
        (lean, target, to_eye) in (lean(), point(0.5), unit()),
        eta in 0.4..2.5_f64,
    ) {
        /// cosθ_t² is divided by η² ≥ 0.16: a few u become about 18 u in the length, which 1/η doubles.
        const ROUNDING: f64 = 128.0 * U;
        let (kr, kt, cr) = (0.3.into(), 0.7.into(), Rgb::WHITE.into());
        let simple = Transparent { phong: Phong::default(), kr, cr, kt, eta };
        let real = Dielectric { inside: Medium::clear(eta), ..Dielectric::default() };
        for (recipe, is_real) in [(Recipe::from(simple), false), (Recipe::from(real), true)] {
            for scene in leaning(&recipe, lean) {
                let Some((tree, hit)) = met(&scene, 1, target, to_eye) else { continue };
                let wo = Vector::from(to_eye);
                let (n, eta) = if hit.front { (hit.normal, eta) } else { (-hit.normal, 1.0 / eta) };
                let sine = wo.cross(n).length();
                prop_assume!((sine - eta).abs() > 1e-6 && n.dot(wo) > 1e-3);
                let refracted = child(&tree, RayKind::Transmitted);
                prop_assert_eq!(refracted.is_some(), sine < eta, "{:?}", hit);
                if let Some(refracted) = refracted {
                    let t = refracted.ray.direction;
                    let off = (wo.cross(n) + eta * t.cross(n)).length();
                    prop_assert!(off < ROUNDING * (1.0 + eta), "off by {off:e}: {hit:?}");
                    prop_assert!(t.dot(n) < 0.0, "{t:?} is on the side of the viewer: {hit:?}");
                }
                let mirrored = child(&tree, RayKind::Reflected).expect("some light is mirrored");
                let r = mirrored.ray.direction;
                let off = (wo.cross(n) + r.cross(n)).length();
                prop_assert!(off < ROUNDING && r.dot(n) > 0.0, "off by {off:e}: {hit:?}");
                if is_real && sine < eta {
                    let share = match eta > 1.0 {
                        true => optics::by_angles(sine, eta),
                        // at the angle of the other side light takes the same share
                        false => optics::by_angles(sine / eta, 1.0 / eta),
                    };
                    near!(mirrored.weight.r, share, 1e-9);
                    let passed = refracted.expect("below the critical angle").weight.r;
                    near!(passed * eta * eta, 1.0 - share, 1e-9);
                }
            }
        }
    }

    /// Law: on either side of a surface, a glossy lobe is about the mirror direction of the shading normal (of the true normal, where the
    /// shading normal would send that behind the surface), and it tends to that direction as its exponent
    /// grows: for the same random numbers its rays have the same `(r·ω)^(e + 1)`, by which they are drawn, and
    /// lie on one side of r or, turned half around, on the other; at 10¹⁵ they are the mirror's. Oracle: r from
    /// the recorded normals; the power, by the sine to r.
    #[test]
    fn a_glossy_lobe_follows_the_shading_normal_and_tends_to_the_mirror(
        (lean, target, to_eye) in (lean(), point(0.5), unit()),
        seed in any::<u32>(),
        kind in 0..4_usize,
    ) {
        /// The sine to r is known to a few u, and of the narrowest lobes about 1e-8.
        const ROUNDING: f64 = 1e-6;
        /// Directions nearer to a horizon than this are not judged.
        const MARGIN: f64 = 0.01;
        let white = || Rgb::WHITE.into();
        let depth = Depth { max_depth: 1 };
        let of = |e: f64| {
            let glossy = |rule| {
                let (phong, kr) = (Phong::default(), 1.0.into());
                Recipe::from(GlossyReflector { phong, kr, cr: white(), exponent: e.into(), rule })
            };
            let highlight = Phong { ks: 1.0.into(), exponent: e.into(), ..Phong::default() };
            match kind {
                0 => (glossy(GlossyRule::Book), Tracer::Whitted(Whitted { max_depth: 1 })),
                1 => (glossy(GlossyRule::Normalised), Tracer::Path(depth)),
                2 => (glossy(GlossyRule::Book), Tracer::PathTrace(depth)),
                _ => (highlight.into(), Tracer::PathTrace(depth)),
            }
        };
        let mut drawn: [Option<(f64, Vector)>; 3] = [None; 3];
        for e in [1e15, 1e12, 1e6, 1e3, 30.0, 3.0] {
            let (recipe, tracer) = of(e);
            for (scene, drawn) in leaning(&recipe, lean).into_iter().zip(&mut drawn) {
                let mut scene = Scene { tracer, ..scene };
                scene.materials[0].two_sided = true;
                let Some((tree, hit)) = met(&scene, seed.into(), target, to_eye) else { continue };
                let wo = Vector::from(to_eye);
                // both normals are turned to a viewer behind the surface
                let [n, shading] = [hit.normal, hit.shading_normal]
                    .map(|n| if hit.front { n } else { -n });
                let about = |n: Normal| 2.0 * n.dot(wo) * n - wo;
                let leans = about(shading);
                let heights = [n.dot(wo), shading.dot(wo), n.dot(leans)];
                if heights.iter().any(|height| height.abs() < MARGIN) {
                    continue;
                }
                let is_leaning = heights.iter().all(|height| *height > 0.0);
                if !is_leaning && kind == 3 {
                    continue; // a highlight has no mirror image to save
                }
                let r = if is_leaning { leans } else { about(n) };
                let Some(reflected) = child(&tree, RayKind::Reflected) else {
                    prop_assert!(e < 1e5, "exponent {e:e}: no ray is reflected; {hit:?}");
                    continue;
                };
                let d = reflected.ray.direction;
                let sine = r.cross(d).length();
                prop_assert!(e < 1e14 || sine < 1e-6, "off the mirror by {sine:e}; {hit:?}");
                if d.dot(r) < MARGIN {
                    continue; // the logarithm of a cosine near 0
                }
                let power = -0.5 * (e + 1.0) * ln_1p(-sine * sine);
                let across = (d - d.dot(r) * r).unit().expect("no ray is exactly the mirror's");
                let (expected, side) = *drawn.get_or_insert((power, across));
                let what = format!("kind {kind}, exponent {e:e}; {hit:?}");
                prop_assert!(
                    (power - expected).abs() <= ROUNDING * (1.0 + expected),
                    "−ln of the power is {power}, at 1e15 it was {expected}; {what}"
                );
                let off = (across - side).length().min((across + side).length());
                prop_assert!(off < 1e-5, "{across:?} across, at 1e15 {side:?}; {what}");
            }
        }
    }
}

/// Lobes that scatter over many directions.
fn wide_lobes(exponent: f64) -> [Lobe; 4] {
    let reflectance = Rgb::new(0.5, 0.25, 0.75);
    let glossy = |rule| GlossyReflection { reflectance, exponent, rule };
    [
        Lambertian { reflectance }.into(),
        GlossySpecular { reflectance, exponent }.into(),
        glossy(GlossyRule::Book).into(),
        glossy(GlossyRule::Normalised).into(),
    ]
}

fn of_path(lobes: &Lobes, normals: Normals, wo: Vector) -> Bsdf<'_> {
    let mut bsdf = Bsdf::new(lobes, normals, wo);
    bsdf.weigh_lobes();
    bsdf
}

proptest! {
    #![proptest_config(laws())]

    /// Law: however the shading normal leans, a direction that a lobe draws has the density that the surface
    /// gives it, and its weight is `f cosθ_i / pdf` of the values with which lights are weighed; the density of
    /// two lobes is the mean of theirs, weighted by the probabilities with which a path takes them. Oracle:
    /// `pdf` and `lit`, which multiple importance sampling compares; each lobe alone.
    #[test]
    fn drawn_directions_have_the_density_and_weight_of_their_lobe(
        (geometry, shading, wo) in (unit(), unit(), unit()),
        u in [0.0..1.0_f64, 0.0..1.0_f64],
        exponent in 0.0..60.0_f64,
    ) {
        /// Powers of cosines above 0.01 to the 60th, and normals that are turned there and back.
        const ROUNDING: f64 = 1e-10;
        let above = |n: Normal| if geometry.dot(n) < 0.0 { -n } else { n };
        let (shading, wo) = (above(shading), Vector::from(above(wo)));
        let normals = Normals { shading, geometry };
        let all = wide_lobes(exponent).map(|lobe| (lobe, NormalKind::Shading));
        let alone = all.map(|lobe| Lobes::from_iter([lobe]));
        let alone = [0, 1, 2, 3].map(|i: usize| of_path(&alone[i], normals, wo));
        for (i, (lobe, kind)) in all.iter().enumerate() {
            let Some(sample) = alone[i].sample(lobe, *kind, u) else { continue };
            let pdf = sample.pdf.expect("it scatters over many directions");
            if pdf < 1e-3 {
                continue; // so far from the middle that a power multiplies roundings
            }
            near!(alone[i].pdf(sample.direction), pdf, ROUNDING * pdf, "{lobe:?}");
            let lit = alone[i].lit(LobeSet::NonDelta, sample.direction);
            let weight: Rgb = lit.iter().map(|lit| (lit.cos_i / pdf) * lit.f).sum();
            close!(sample.weight, weight, ROUNDING, "{lobe:?}");
            for (j, other) in all.iter().enumerate().filter(|(j, _)| *j != i) {
                let both = Lobes::from_iter([(*lobe, *kind), *other]);
                let both = of_path(&both, normals, wo);
                let [p, q] = both.lobe_probabilities() else { panic!("two lobes") };
                let expected = p * pdf + q * alone[j].pdf(sample.direction);
                near!(p + q, 1.0, ROUNDING);
                near!(both.pdf(sample.direction), expected, ROUNDING * (1.0 + expected), "{lobe:?}, {other:?}");
            }
        }
    }
}

/// Law: the scenes above are no empty case: in each of them most rays meet a normal that leans. Oracle: counting
/// such hits.
#[test]
fn the_surfaces_lean() {
    let glossy = Recipe::from(Phong { ks: 1.0.into(), ..Phong::default() });
    let mut random = Pcg32::new(31, 7);
    let mut seen = [0; 3];
    for _ in 0..100 {
        let mut c = || 2.0 * random.uniform() - 1.0;
        let (lean, target) =
            (Vector::new(c(), 0.0, c()), Point::new(0.3 * c(), 0.3 * c(), 0.3 * c()));
        let to_eye = Normal::new(Vector::new(c(), 0.3 + power(c(), 2.0), c())).expect("not zero");
        for (scene, seen) in leaning(&glossy, lean).iter().zip(&mut seen) {
            *seen += u32::from(met(scene, 1, target, to_eye).is_some());
        }
    }
    assert!(seen.iter().all(|count| *count > 50), "{seen:?} of 100 rays meet leaning normals");
}
