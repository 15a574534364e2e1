//! Textures that are moved relative to their objects, and objects that move while their texture stays.

use std::sync::atomic::{AtomicU32, Ordering};

use groundtruth::textures::{
    CylinderChecker, Lines, Ramp, SphereChecker, SphereTextures, Stripes, Texture as Asked,
    TextureInstance, Wireframe, Wrap,
};

use super::*;
use crate::prelude::*;

/// A texture whose colour is the local point at which it is evaluated.
#[derive(Debug)]
struct LocalPoint;

impl Asked for LocalPoint {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        Rgb::from(at.local.to_array())
    }
}

/// The texture of local points.
pub fn local_point() -> Texture {
    Texture::Custom(Custom(Arc::new(LocalPoint)))
}

/// The local point at which a texture is evaluated for p, after these steps.
fn evaluated_at(texture: impl Into<Texture>, steps: Vec<Step>, p: Point) -> Point {
    Point::from(at(&TextureInstance::new(texture.into(), steps).into(), p).to_array())
}

/// Coordinates up to 10 times factors up to 4, and a few roundings.
const CLOSE: f64 = 100.0 * 64.0 * U;

fn assert_close(what: &str, found: Point, expected: Point) -> Result<(), TestCaseError> {
    prop_assert!(
        found.distance(expected) <= CLOSE,
        "{what}: evaluated at {found:?}, expected {expected:?}"
    );
    Ok(())
}

fn factor() -> impl Strategy<Value = f64> {
    prop_oneof![0.25..4.0_f64, -4.0..-0.25_f64]
}

fn steps() -> impl Strategy<Value = Vec<Step>> {
    let step = prop_oneof![
        (factor(), factor(), factor()).prop_map(|(x, y, z)| Step::Scale(Vector::new(x, y, z))),
        (-180.0..180.0_f64).prop_map(Step::RotateX),
        (-180.0..180.0_f64).prop_map(Step::RotateY),
        point(2.0).prop_map(|p| Step::Translate(p.to_vector())),
        (-1.0..1.0_f64).prop_map(|a| Step::Shear([a, 0.0, 0.0, 0.5 * a, 0.0, 0.0])),
    ];
    prop::collection::vec(step, 1..4)
}

/// Specimens of all kinds of textures.
fn textures() -> Vec<Texture> {
    Texture::ENTRIES.iter().flat_map(|entry| (entry.specimens)()).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: laws().cases / 8, ..laws() })]

    /// Law: without steps, or with steps that do nothing, a texture instance is the texture itself, bit
    /// for bit. Oracle: every kind of texture, without an instance.
    /// Book: intrinsic transformations: texture instances.
    #[test]
    fn an_identical_instance_is_the_texture(p in point(10.0)) {
        for texture in textures() {
            let expected = at(&texture, p);
            for steps in [vec![], vec![Step::Scale(Vector::new(1.0, 1.0, 1.0)), Step::RotateY(0.0)]]
            {
                let same = TextureInstance::new(texture.clone(), steps);
                prop_assert_eq!(at(&same.into(), p), expected, "{:?}", texture);
            }
        }
    }
}

proptest! {
    #![proptest_config(laws())]

    /// Law: a texture instance of f has `g(p) = f(M⁻¹ p)`: scaled by s, f(p/s) component-wise; moved by
    /// t, f(p − t); turned and sheared likewise. Oracle: each inverse written out by hand (ch. 30).
    /// Book: intrinsic transformations: texture instances.
    #[test]
    fn each_step_is_undone(
        p in point(10.0),
        by in point(10.0),
        (sx, sy, sz) in (factor(), factor(), factor()),
        (degrees, a) in (-360.0..360.0_f64, -2.0..2.0_f64),
    ) {
        let [x, y, z] = p.to_array();
        let asked = |step: Step| evaluated_at(local_point(), vec![step], p);
        let scaled = Step::Scale(Vector::new(sx, sy, sz));
        assert_close("scale", asked(scaled), Point::new(x / sx, y / sy, z / sz))?;
        assert_close(
            "translate",
            asked(Step::Translate(by.to_vector())),
            Point::ORIGIN + (p - by),
        )?;
        let (s, c) = (sin(to_radians(degrees)), cos(to_radians(degrees)));
        assert_close(
            "rotate_x",
            asked(Step::RotateX(degrees)),
            Point::new(x, c * y + s * z, c * z - s * y),
        )?;
        assert_close(
            "rotate_y",
            asked(Step::RotateY(degrees)),
            Point::new(c * x - s * z, y, s * x + c * z),
        )?;
        assert_close(
            "rotate_z",
            asked(Step::RotateZ(degrees)),
            Point::new(c * x + s * y, c * y - s * x, z),
        )?;
        let sheared = Step::Shear([a, 0.0, 0.0, 0.0, 0.0, 0.0]);
        assert_close("shear x by y", asked(sheared), Point::new(x - a * y, y, z))?;
        let sheared = Step::Shear([0.0, 0.0, 0.0, 0.0, 0.0, a]);
        assert_close("shear z by y", asked(sheared), Point::new(x, y, z - a * y))?;
    }

    /// Law: the step of a texture instance that is applied last is outermost, whether the steps are in
    /// one list or in nested instances. Oracle: two steps that do not commute, by hand; each instance's
    /// own map, undone from outside in.
    /// Book: intrinsic transformations: texture instances.
    #[test]
    fn the_last_step_is_outermost(
        (p, by) in (point(10.0), point(10.0)),
        (s, first, second) in (factor(), steps(), steps()),
    ) {
        let (scale, shift) = (Step::Scale(Vector::new(s, s, s)), Step::Translate(by.to_vector()));
        let asked = evaluated_at(local_point(), vec![scale.clone(), shift.clone()], p);
        assert_close("scaled, then moved", asked, Point::ORIGIN + (1.0 / s) * (p - by))?;
        let asked = evaluated_at(local_point(), vec![shift, scale], p);
        assert_close(
            "moved, then scaled",
            asked,
            Point::ORIGIN + ((1.0 / s) * p.to_vector() - by.to_vector()),
        )?;

        let inner = TextureInstance::new(local_point(), first.clone());
        let nested = evaluated_at(inner, second.clone(), p);
        let maps =
            [&second, &first].map(|steps| Transform::from_steps(steps).expect("not singular"));
        let forward = maps[0].point(maps[1].point(nested));
        prop_assert!(forward.distance(p) < 1e-9, "nested: {forward:?} is what {p:?} was asked as");
        let together: Vec<Step> = first.into_iter().chain(second).collect();
        let asked = evaluated_at(local_point(), together, p);
        prop_assert!(asked.distance(nested) < 1e-9, "in one list: {asked:?}, nested: {nested:?}");
    }

    /// Law: an object with `transform_texture = false` moves through its texture, which stays fixed in
    /// the world: the texture is evaluated at the world point, whatever the object's transformation is;
    /// inside another instance it stays fixed in that one's coordinates. Oracle: the point of the world's
    /// own hit.
    /// Book: extrinsic transformations: textures of instances.
    #[test]
    fn a_texture_stays_in_the_world_while_the_object_moves(
        (moves, outer) in (steps(), steps()),
        (eye, target) in (unit(), point(0.3)),
    ) {
        let ball = Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
        let still = |transform| Instance {
            transform_texture: false,
            ..Instance::new(ball.clone(), transform)
        };
        let map = Transform::from_steps(&moves).expect("not singular");
        let around = Transform::from_steps(&outer).expect("not singular");
        let ray = |map: &Transform| {
            let (from, to) = (map.point(Point::ORIGIN + 3.0 * eye), map.point(target));
            ray(from, to - from)
        };
        for (shape, map, inside) in [
            (Kind::from(still(moves.clone())), map, Transform::IDENTITY),
            (Instance::new(still(moves.clone()), outer.clone()).into(), around.after(&map), around),
        ] {
            let mut scene = gallery();
            painted(&mut scene, shape, local_point());
            let (world, ray) = (built(&scene), ray(&map));
            let hit = world.hit(&ray, groundtruth::math::Span::AHEAD).expect("aimed at");
            let expected = inside.inverse().point(hit.surface.point);
            let mut response = groundtruth::materials::Response::default();
            hit.material.recipe.respond(&hit.texture_point(), 1.0, &mut response);
            let found = Point::from(response.ambient.to_array());
            prop_assert!(
                found.distance(expected) <= 1e-10,
                "the texture is evaluated at {found:?}, the point is {expected:?}"
            );
        }
    }
}

/// Law: a box stretched twofold along x, with its texture halved along x, has the checker of an
/// unstretched one. Oracle: the long box with the plain texture, pixel by pixel, bit for bit.
/// Book: fig. 30.11, a stretched box with an unstretched checker.
#[test]
fn a_texture_instance_undoes_the_stretch_of_its_object() {
    let picture = |shape: Kind, texture: Texture| {
        let mut scene = gallery();
        painted(&mut scene, shape, texture);
        scene.camera.eye = Point::new(4.0, 5.0, 9.0);
        (scene.image.width, scene.image.height, scene.image.pixel_size) = (60, 40, 0.1);
        let world = built(&scene);
        (0..60 * 40).map(|i| pixel(&world, [i % 60, i / 60])).collect::<Vec<Rgb>>()
    };
    let block = |x: f64| Cuboid { min: Point::new(-x, -0.9, -0.9), max: Point::new(x, 0.9, 0.9) };
    let along_x = |factor| vec![Step::Scale(Vector::new(factor, 1.0, 1.0))];
    let long = picture(block(1.8).into(), solid(0.25));
    let stretched = Instance::new(block(0.9), along_x(2.0));
    let halved = TextureInstance::new(solid(0.25), along_x(0.5));
    let undone = picture(stretched.clone().into(), halved.into());
    let differing = long.iter().zip(&undone).filter(|(a, b)| a != b).count();
    assert_eq!(differing, 0, "pixels of 2400 that differ");
    let seen = |color: Rgb| long.iter().filter(|&&c| c == color).count();
    assert!(seen(ONE) > 300 && seen(TWO) > 300, "{} and {} pixels", seen(ONE), seen(TWO));
    let carried = picture(stretched.into(), solid(0.25));
    let differing = long.iter().zip(&carried).filter(|(a, b)| a != b).count();
    assert!(differing > 200, "{differing} pixels show that the checker is stretched");
}

/// A texture of one colour that counts its evaluations.
#[derive(Debug)]
struct Counted(AtomicU32, Rgb);

impl Asked for Counted {
    fn color(&self, _: &TexturePoint<'_>) -> Rgb {
        self.0.fetch_add(1, Ordering::Relaxed);
        self.1
    }
}

/// Law: a texture of textures evaluates only the one that is seen, and a ramp the two around the point; if
/// all have one colour, it has that colour everywhere, bit for bit. Oracle: the count.
#[test]
fn a_texture_asks_for_the_colour_that_is_seen() {
    let counter = Arc::new(Counted(AtomicU32::new(0), ONE));
    let c = || Paint::from(Texture::Custom(Custom(Arc::clone(&counter) as Arc<dyn Asked>)));
    let lines = || Lines { horizontal: 0.25, vertical: 0.25, color: c() };
    let (size, outline_width, num_horizontal, num_vertical) = (0.7, 0.2, 4, 2);
    let (color1, color2, outline_color) = (c(), c(), c());
    let sphere = SphereChecker { color1: c(), color2: c(), lines: lines(), ..Default::default() };
    let cylinder =
        CylinderChecker { color1: c(), color2: c(), lines: lines(), ..Default::default() };
    let textures = vec![c(); 3];
    let nested: Vec<Texture> = vec![
        Checker3d { size, color1: c(), color2: c() }.into(),
        Stripes { axis: Axis::X, size, color1: c(), color2: c() }.into(),
        PlaneChecker { size, color1, color2, outline_width, outline_color }.into(),
        sphere.into(),
        cylinder.into(),
        SphereTextures { num_horizontal, num_vertical, textures, lines: lines() }.into(),
        Wireframe { line_width: 0.1, line_color: c(), color: c() }.into(),
        TextureInstance { of: c(), transform: vec![Step::RotateX(30.0)] }.into(),
        Ramp { axis: Axis::Z, from: -1.0, to: 1.0, colors: vec![c(); 5], wrap: Wrap::Repeat }
            .into(),
    ];
    let mut random = Pcg32::new(30, 5);
    for texture in nested {
        let expected = if matches!(texture, Texture::Ramp(_)) { 2 } else { 1 };
        for _ in 0..100 {
            let mut c = || 4.0 * random.uniform() - 2.0;
            counter.0.store(0, Ordering::Relaxed);
            assert_eq!(at(&texture, Point::new(c(), c(), c())), ONE, "{texture:?}");
            assert_eq!(counter.0.load(Ordering::Relaxed), expected, "evaluations by {texture:?}");
        }
    }
}
