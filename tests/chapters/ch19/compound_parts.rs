//! The parts of solids: their materials.

use groundtruth::shapes::{PartMaterial, ThickRing};

use crate::prelude::*;

/// A ring whose parts may have the materials `red` (index 0) or `glass` (index 1), which casts no
/// shadows.
fn ring(materials: &[(&str, &str)]) -> Arc<dyn Shape> {
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
    Kind::from(ring).build(&mut context).expect("parts and materials that are there")
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
/// whole solid (`None`). It blocks light unless its material casts no shadows. Oracle: the list itself.
/// Book: compound objects.
#[test]
fn each_part_of_a_solid_has_its_material() {
    for (part, _) in at_parts() {
        for (material, index) in [("red", 0), ("glass", 1)] {
            let shape = ring(&[(part, material)]);
            for (name, ray) in at_parts() {
                let at = shape.hit(&ray, Span::AHEAD).expect("aimed at");
                let expected = (name == part).then_some(index);
                assert_eq!(shape.surface(&ray, &at).material, expected, "{part}, {name}");
                let near = Span { min: 0.0, max: 1.25 };
                let blocks = shape.shadow_hit(&ray, near).is_some();
                assert_eq!(blocks, expected != Some(1), "{part}, {name}: shadow");
            }
        }
    }
    let plain = ring(&[]);
    for (name, ray) in at_parts() {
        let at = plain.hit(&ray, Span::AHEAD).expect("aimed at");
        assert_eq!(plain.surface(&ray, &at).material, None, "{name}");
    }
}
