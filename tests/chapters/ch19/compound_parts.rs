//! The parts of solids: their materials, and the error messages for wrong input.

use groundtruth::shapes::{
    ConcaveLens, CutFace, FlatRimmedBowl, Materials, PartMaterial, RoundRimmedBowl, SolidCone,
    ThickRing,
};

use crate::prelude::*;

/// A ring whose parts may have the materials `red` (index 0) or `glass` (index 1), which casts no
/// shadows.
fn ring(materials: &[(&str, &str)]) -> Result<Arc<dyn Shape>, String> {
    let defined = [("red", 0, true), ("glass", 1, false)];
    let defined = defined.map(|(name, index, casts_shadows)| {
        (name.to_owned(), PartMaterial { index, casts_shadows })
    });
    let materials = materials.iter().map(|&(part, name)| (part.to_owned(), name.to_owned()));
    let ring = ThickRing {
        y0: 0.0,
        y1: 1.0,
        inner_radius: 1.0,
        outer_radius: 2.0,
        materials: materials.collect(),
    };
    let mut context = Context::default().with_materials(defined.into());
    Kind::from(ring).build(&mut context).map_err(|e| e.to_string())
}

/// Rays at the bottom, the top, the inner and the outer wall of the ring.
fn at_parts() -> [(&'static str, Ray); 4] {
    let ray = |x, y, dx, dy| Ray::new(Point::new(x, y, 0.0), Vector::new(dx, dy, 0.0));
    [
        ("bottom", ray(1.5, -1.0, 0.0, 1.0)),
        ("top", ray(1.5, 2.0, 0.0, -1.0)),
        ("inner_wall", ray(0.0, 0.5, 1.0, 0.0)),
        ("outer_wall", ray(3.0, 0.5, -1.0, 0.0)),
    ]
}

/// Law: a part that is named in `materials` has that material; every other part has the material of the
/// whole solid (`None`). Oracle: the list itself.
/// Book: compound objects.
#[test]
fn each_part_of_a_solid_has_its_material() {
    for (part, _) in at_parts() {
        for (material, index) in [("red", 0), ("glass", 1)] {
            let shape = ring(&[(part, material)]).expect("a part's name");
            for (name, ray) in at_parts() {
                let at = shape.hit(&ray, Span::AHEAD).expect("aimed at");
                let expected = (name == part).then_some(index);
                assert_eq!(shape.surface(&ray, &at).material, expected, "{part}, {name}");
            }
        }
    }
    let plain = ring(&[]).expect("no materials");
    for (name, ray) in at_parts() {
        let at = plain.hit(&ray, Span::AHEAD).expect("aimed at");
        assert_eq!(plain.surface(&ray, &at).material, None, "{name}");
    }
}

/// Law: a part whose material casts no shadows does not block light; the other parts do. Oracle: which
/// part the ray is aimed at.
#[test]
fn a_part_whose_material_casts_no_shadows_lets_light_pass() {
    for (part, _) in at_parts() {
        let shape = ring(&[(part, "glass")]).expect("a part's name");
        for (name, ray) in at_parts() {
            let first = Span { min: 0.0, max: 1.25 };
            assert!(shape.hit(&ray, first).is_some(), "{part}, {name}: missed");
            assert_eq!(shape.shadow_hit(&ray, first).is_some(), name != part, "{part}, {name}");
        }
    }
}

/// Law: an unknown part or material is an error, and the message lists the known ones.
#[test]
fn an_unknown_part_is_an_error_that_lists_the_known_ones() {
    assert_eq!(
        ring(&[("lid", "red")]).expect_err("no lid"),
        "thick_ring.materials: no part `lid`; there are: bottom, inner_wall, outer_wall, top"
    );
    assert_eq!(
        ring(&[("top", "blue")]).expect_err("no blue"),
        "thick_ring.materials.top: no material `blue`; defined are: glass, red"
    );
}

/// Law: invalid numbers are refused, and the message names the field as it is written in the scene.
#[test]
fn solids_name_the_field_that_does_not_fit() {
    let m = Materials::new;
    let flat = |inner_radius, outer_radius, opening| {
        Kind::from(FlatRimmedBowl { inner_radius, outer_radius, opening, materials: m() })
    };
    let round = |inner_radius, outer_radius, opening| {
        Kind::from(RoundRimmedBowl { inner_radius, outer_radius, opening, materials: m() })
    };
    let lens = |radius, thickness, min_distance| {
        Kind::from(ConcaveLens { radius, thickness, min_distance, materials: m() })
    };
    let ring = |y1, inner_radius, outer_radius| {
        Kind::from(ThickRing { y0: 0.0, y1, inner_radius, outer_radius, materials: m() })
    };
    let cone = |height, radius| Kind::from(SolidCone { height, radius, materials: m() });
    for (kind, problem) in [
        (cone(0.0, 1.0), "solid_cone.height: found 0, but a positive, finite number is needed"),
        (
            cone(1.0, f64::NAN),
            "solid_cone.radius: found NaN, but a positive, finite number is needed",
        ),
        (ring(0.0, 1.0, 2.0), "thick_ring.y1: found 0, but it must be above y0, 0"),
        (
            ring(1.0, 0.0, 2.0),
            "thick_ring.inner_radius: found 0, but a positive, finite number is needed",
        ),
        (
            ring(1.0, 2.0, 2.0),
            "thick_ring.outer_radius: found 2, but it must be above inner_radius, 2",
        ),
        (
            flat(0.0, 1.0, 180.0),
            "flat_rimmed_bowl.inner_radius: found 0, but a positive, finite number is needed",
        ),
        (
            flat(2.0, 1.0, 180.0),
            "flat_rimmed_bowl.outer_radius: found 1, but it must be above inner_radius, 2",
        ),
        (
            flat(0.9, 1.0, 360.0),
            "flat_rimmed_bowl.opening: found 360, but degrees above 0 and below 360 are needed",
        ),
        (
            round(0.9, 1.0, f64::NAN),
            "round_rimmed_bowl.opening: found NaN, but degrees above 0 and below 360 are needed",
        ),
        (
            round(0.1, 1.0, 30.0),
            "round_rimmed_bowl.opening: found 30, but so thick a rim would close the bowl",
        ),
        (
            lens(1.0, 1.0, 1.0),
            "concave_lens.min_distance: found 1, but it must be less than the thickness, 1",
        ),
        (
            lens(1.0, 3.0, 0.5),
            "concave_lens.thickness: found 3, but it must be at most 2.5: hollows deeper than the \
             radius would be wider inside than at the rim",
        ),
        (
            CutFace { size: 2.0, radius: 1.5 }.into(),
            "cut_face.radius: found 1.5, but it must be less than 1.4142135623730951: nothing is left \
             of size 2",
        ),
    ] {
        let found = kind.build(&mut Context::default()).expect_err("refused").to_string();
        assert!(found == problem, "{found}\ninstead of\n{problem}");
    }
}
