//! Compounds of which some parts cast shadows and others do not, in a scene with a light.

use groundtruth::scene::{Transparency, TransparentShadows};
use groundtruth::shapes::Part;

use crate::prelude::*;

/// The materials that a part may have, and whether they cast shadows. Of the last two one is opaque and one a
/// boundary between media, for which shadow rays have ways of their own.
const MATERIALS: [(&str, bool); 3] = [("stone", true), ("veil", false), ("bubble", false)];

/// Where the balls are.
const AT: [f64; 3] = [-3.0, 0.0, 3.0];

/// A white floor in the sun, which is straight above, and the materials.
fn floor() -> Scene {
    let mut scene = stage(Rgb::BLACK);
    let white = Matte { ka: 0.0.into(), kd: 1.0.into(), cd: Rgb::WHITE.into() };
    put(&mut scene, Plane { point: Point::ORIGIN, normal: Vector::Y }, white.clone());
    let glass = Dielectric { inside: Medium::clear(1.5), ..Dielectric::default() };
    for (name, casts_shadows) in MATERIALS {
        let mut material = Material::new(name, white.clone());
        if name == "bubble" {
            material.recipe = glass.clone().into();
        }
        scene.materials.push(Material { casts_shadows, ..material });
    }
    shine(&mut scene, Directional { ls: 1.0, color: Rgb::WHITE, direction: Vector::Y });
    scene
}

/// All choices of a material for each of three parts: the object's, or its own.
fn choices() -> Vec<[Option<&'static str>; 3]> {
    let one = [None, Some("stone"), Some("veil"), Some("bubble")];
    let of = |i: usize| [one[i / 16], one[i / 4 % 4], one[i % 4]];
    (0..64).map(of).collect()
}

/// Three balls in a compound, each of one of these materials or of the object's: in a list, searched by a grid,
/// turned to their places by an instance, and each in a compound of its own that has the material.
fn compounds(own: [Option<&str>; 3]) -> [Kind; 4] {
    let part = |x: f64, material: Option<&str>, is_nested: bool| {
        let ball = Sphere { center: Point::new(x, 2.0, 0.0), radius: 1.0, inward: false };
        let part = match is_nested {
            true => Part::new(Compound::of([ball])),
            false => Part::new(ball),
        };
        match material {
            Some(name) => part.of_material(name),
            None => part,
        }
    };
    let balls = |is_nested: bool, sign: f64, accel| Compound {
        accel,
        parts: AT.into_iter().zip(own).map(|(x, own)| part(sign * x, own, is_nested)).collect(),
    };
    [
        balls(false, 1.0, None).into(),
        balls(false, 1.0, Some(Method::Grid)).into(),
        Instance::new(balls(false, -1.0, None), vec![Step::RotateY(180.0)]).into(),
        balls(true, 1.0, None).into(),
    ]
}

/// Law: of a compound exactly the parts whose material casts shadows cast one, whichever parts those are,
/// whatever the material of the whole object is, and however shadow rays treat what is transparent; the shadow
/// of a part is as dark as that of a whole object, and beside it the floor is as bright as without the
/// compound. Oracle: the truth table; black, and the floor alone.
#[test]
fn each_part_of_a_compound_casts_its_own_shadow() {
    let look_down = |scene: &Scene| {
        let world = built(scene);
        AT.map(|x| look(&world, Point::new(x, 0.5, 0.0), -Vector::Y))
    };
    let free = look_down(&floor())[0];
    assert!(!free.is_black(), "the floor alone is {free:?}");
    for (whole, whole_casts) in MATERIALS {
        for own in choices() {
            let casts =
                own.map(|own| own.map_or(whole_casts, |own| MATERIALS.contains(&(own, true))));
            for (compound, shadows) in compounds(own).into_iter().flat_map(|compound| {
                [TransparentShadows::Opaque, TransparentShadows::Attenuated]
                    .map(|shadows| (compound.clone(), shadows))
            }) {
                let mut scene = floor();
                scene.transparency = Transparency { shadows, ..scene.transparency };
                scene.objects.push(Object::new("balls", whole, compound));
                let expected = casts.map(|casts| if casts { Rgb::BLACK } else { free });
                let found = look_down(&scene);
                scene.objects[1].casts_shadows = false;
                let switched_off = look_down(&scene);
                assert_eq!(
                    (found, switched_off),
                    (expected, [free; 3]),
                    "{own:?} in {whole}, {shadows:?}, and without the object's shadow: {:?}",
                    scene.objects[1].shape
                );
            }
        }
    }
}

/// Law: in the light of the sky, which paths can hit, every part of a compound is in the way of light samples,
/// whether or not its material casts shadows: what passed would count twice. Oracle: the same picture, bit for
/// bit, as of materials that all cast shadows.
#[test]
fn paths_are_stopped_by_every_part() {
    let depth = Depth { max_depth: 2 };
    for (whole, own, tracer) in MATERIALS.into_iter().flat_map(|(whole, _)| {
        let both = move |own| {
            [Tracer::GlobalTrace(depth), Tracer::Path(depth)].map(|tracer| (whole, own, tracer))
        };
        choices().into_iter().flat_map(both)
    }) {
        let mut scene = Scene { tracer, ..with_samples(floor(), 4) };
        scene.background = Rgb::grey(0.5).into();
        scene.lights[0].source = Environment {}.into();
        let [compound, ..] = compounds(own);
        scene.objects.push(Object::new("balls", whole, compound));
        let mut casting = scene.clone();
        casting.materials.iter_mut().for_each(|material| material.casts_shadows = true);
        let [found, expected] = [scene, casting].map(|scene| {
            let world = built(&scene);
            AT.map(|x| view(&world, Point::new(x, 0.5, 0.0), -Vector::Y))
        });
        assert_eq!(found, expected, "{own:?} in {whole}, {}", tracer.name());
        assert!(found.iter().all(|seen| seen.g > 0.0), "{own:?} in {whole}: {found:?}");
    }
}

/// Law: light reaches a surface in a part of absorbing glass that casts no shadow, absorbed on its way in the
/// glass alone, whatever else the compound has. Oracle: `exp(−σ/2)` twice, from the sun and to the eye, for a
/// ball of half the radius.
#[test]
fn a_part_of_shadowless_glass_absorbs_inside_only() {
    /// The ends of a ray are offset by some error bounds.
    const OFFSETS: f64 = 1e-12;
    let sigma = Rgb::new(0.3, 0.7, 0.0);
    let glass = Dielectric { inside: Medium { eta: 1.0, absorption: sigma }, ..Default::default() };
    let ball = |x: f64, radius| Sphere { center: Point::new(x, 2.0, 0.0), radius, inward: false };
    let parts = [
        Part::new(ball(0.0, 1.0)).of_material("tinted"),
        Part::new(ball(6.0, 1.0)).of_material("stone"),
        Part::new(ball(3.0, 1.0)),
    ];
    for (whole, order) in MATERIALS
        .into_iter()
        .flat_map(|(whole, _)| [[0, 1, 2], [1, 0, 2], [2, 1, 0]].map(|order| (whole, order)))
    {
        let mut scene = floor();
        scene.tracer = Tracer::Whitted(Whitted { max_depth: 3 });
        let tinted = Material { casts_shadows: false, ..Material::new("tinted", glass.clone()) };
        scene.materials.push(tinted);
        let parts = order.map(|i: usize| parts[i].clone()).to_vec();
        scene.objects.push(Object::new("balls", whole, Compound { accel: None, parts }));
        scene.objects.push(Object::new("inside", "stone", ball(0.0, 0.5)));
        let seen = look(&built(&scene), Point::new(0.0, 6.0, 0.0), -Vector::Y);
        close!(seen, FRAC_1_PI * sigma.map(|sigma| exp(-sigma)), OFFSETS, "{whole}, {order:?}");
    }
}
