//! The points at which textures are evaluated, and the memory of copies of one mesh.

use crate::prelude::*;

fn sphere() -> Kind {
    Sphere { center: Point::ORIGIN, radius: 1.0, inward: false }.into()
}

fn steps(draw: &mut Draw) -> Vec<Step> {
    let factors = [(); 3].map(|()| draw.between(0.5, 2.0));
    vec![
        Step::Scale(factors.into()),
        Step::RotateX(draw.between(-180.0, 180.0)),
        Step::RotateY(draw.between(-180.0, 180.0)),
        Step::Translate(draw.vector(2.0)),
    ]
}

fn instance(of: Kind, transform: &[Step], transform_texture: bool) -> Kind {
    Instance { transform_texture, ..Instance::new(of, transform.to_vec()) }.into()
}

/// The surface at the ray's first hit of this shape.
fn seen(kind: &Kind, ray: &Ray) -> Surface {
    first(&*shape_of(kind.clone()), ray).expect("aimed inside").1
}

fn map(steps: &[Step]) -> Transform {
    Transform::from_steps(steps).expect("not singular")
}

/// A ray aimed near the centre of the image of the unit sphere under this map.
fn ray_at(draw: &mut Draw, map: &Transform) -> Ray {
    let target = map.point(draw.point(0.4));
    let away = 20.0 * draw.direction();
    Ray::new(target + away, -away)
}

/// Points are within 50 of the origin and pass two maps that stretch at most fourfold.
const CLOSE: f64 = 50.0 * 256.0 * U;

/// Law: with and without `transform_texture` only the local point differs, and that by `M⁻¹` exactly.
/// Oracle: the forward map.
/// Book: the texture of an instance.
#[test]
fn untransformed_textures_differ_by_the_map_of_the_local_point_alone() {
    let mut draw = Draw::new(2190);
    for _ in 0..1_000 {
        let steps = steps(&mut draw);
        let map = map(&steps);
        let ray = ray_at(&mut draw, &map);
        let [on, off] = [true, false].map(|on| seen(&instance(sphere(), &steps, on), &ray));
        assert_eq!(Surface { local: on.local, ..off }, on);
        assert_eq!(off.local, off.point);
        assert_eq!(map.point(on.local), off.local, "the point is the map of the local one");
        near!(on.local.to_vector().length(), 1.0, CLOSE);
    }
}

/// Law: a million copies share one mesh. Oracle: the reference count of the mesh; and the budget of
/// triangles, which 10³ separate meshes of 9800 triangles would exceed.
/// Book: 21.4, instances.
#[test]
fn a_million_copies_hold_one_mesh() {
    let mesh = Kind::from(TessellatedSphere::new(20, 10, false));
    let mesh = mesh.build(&mut Context::default()).expect("valid");
    let custom = || Kind::Custom(Custom(Arc::clone(&mesh)));
    let counts = [100, 100, 1];
    let spacing = Vector::new(3.0, 3.0, 3.0);
    let plate = Lattice { of: Box::new(custom()), counts, spacing, accel: None };
    let cube = Lattice { of: Box::new(plate.into()), counts: [1, 1, 100], spacing, accel: None };
    let built = Kind::from(cube).build(&mut Context::default()).expect("valid");
    assert_eq!((built.leaves(), Arc::strong_count(&mesh)), (1_000_000, 2));

    let transform = |i: u32| vec![Step::Translate(f64::from(i) * Vector::X)];
    let same =
        (0..1000).map(|i| Instance::new(TessellatedSphere::new(100, 50, false), transform(i)));
    Kind::from(Compound::of(same)).build(&mut Context::default()).expect("the parts are alike");
    let other = |i: u32| TessellatedSphere {
        radius: f64::from(i + 1),
        ..TessellatedSphere::new(1000, 500, false)
    };
    let others = (0..5).map(|i| Instance::new(other(i), transform(i)));
    assert!(Kind::from(Compound::of(others)).build(&mut Context::default()).is_err());
}
