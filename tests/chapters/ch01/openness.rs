//! User-defined kinds, unknown to the library, work like the built-in ones.

use groundtruth::cameras::{self, Camera};
use groundtruth::lights::{Light as LightKind, LightContext, LightSample};
use groundtruth::materials::{Emission, Material as MaterialKind, Response};
use groundtruth::samplers::{self, Sampler};
use groundtruth::textures::{self, Color, Texture, Value};
use scenefile::to_toml;

use crate::prelude::*;

/// The square |x| < 1, |y| < 1 of the plane z = 0, facing +z.
#[derive(Debug)]
struct Tile;

impl Shape for Tile {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let t = -ray.origin.z() / ray.direction.z();
        let p = ray.at(t);
        let inside = span.contains(t) && p.x().abs() < 1.0 && p.y().abs() < 1.0;
        inside.then(|| Candidate::at(t))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        Surface::flat(ray.at(at.t), Point::ORIGIN, Normal::Z)
    }

    fn bounds(&self) -> Aabb {
        Aabb::around([Point::new(-1.0, -1.0, 0.0), Point::new(1.0, 1.0, 0.0)])
    }
}

fn tile() -> shapes::Kind {
    shapes::Kind::Custom(Custom(Arc::new(Tile)))
}

/// Whether the centre of pixel (x, y), in a picture of 16 × 16 pixels of side ¼, is within these bounds; the
/// centres are at odd multiples of ⅛.
fn center_within([x, y]: [u32; 2], xs: [f64; 2], ys: [f64; 2]) -> bool {
    let at = [(f64::from(x) - 7.5) / 4.0, (7.5 - f64::from(y)) / 4.0];
    xs[0] < at[0] && at[0] < xs[1] && ys[0] < at[1] && at[1] < ys[1]
}

/// Law: a user-defined shape, which no code of the library names, appears where it is. Oracle: the pixels'
/// centres, counted by hand.
/// Book: an extensible design: kinds that the core does not know.
#[test]
fn a_shape_defined_here_is_rendered() {
    let mut scene = from_front(16, 16, 0.25);
    add_flat(&mut scene, "tile", tile(), RED);
    let film = render::render(&built(&scene));
    for at in pixels(16, 16) {
        let seen = center_within(at, [-1.0, 1.0], [-1.0, 1.0]);
        assert_eq!(film.get(at), if seen { RED } else { Rgb::BLACK }, "{at:?}");
    }
}

/// Law: a user-defined shape can be transformed like any other: moved, stretched, turned; its normal too.
/// Oracle: the transformed rectangle and normal, calculated by hand.
/// Book: an extensible design: kinds that the core does not know.
#[test]
fn a_shape_defined_here_sits_in_an_instance() {
    let mut scene = from_front(16, 16, 0.25);
    let transform = vec![
        Step::Scale(Vector::new(0.5, 1.0, 3.0)),
        Step::RotateZ(90.0),
        Step::Translate(Vector::new(0.5, 1.0, -2.0)),
    ];
    add_flat(&mut scene, "tile", Instance::new(tile(), transform), RED);
    let film = render::render(&built(&scene));
    for at in pixels(16, 16) {
        // half as wide in x, then x and y change places
        let seen = center_within(at, [-0.5, 1.5], [0.5, 1.5]);
        assert_eq!(film.get(at), if seen { RED } else { Rgb::BLACK }, "{at:?}");
    }

    // counter-clockwise about x by −60°: z turns towards +y; sheared, the tile lies in z = x/2
    let turned = (Step::RotateX(-60.0), Vector::new(0.0, 0.75_f64.sqrt(), 0.5));
    let sheared = Step::Shear([0.0, 0.0, 0.0, 0.0, 0.5, 0.0]);
    let sheared = (sheared, Vector::new(-0.5, 0.0, 1.0) / 1.25_f64.sqrt());
    for (step, normal) in [turned, sheared] {
        let mut scene = from_front(1, 1, 1.0);
        let instance = Instance::new(tile(), vec![step]);
        add_flat(&mut scene, "tile", instance, RED);
        let world = built(&scene);
        let mut tree = RayTree::of(&world);
        render::sample(&world, [0, 0], 0, &mut tree);
        let Some(hit) = &tree.root().hit else { panic!("the tile is ahead") };
        assert!((Vector::from(hit.normal) - normal).length() < 1e-15, "{:?}", hit.normal);
    }
}

/// Law: a user-defined shape casts shadows. Oracle: the tile is at height 0, the direction of the light is
/// (0, 1, 1)/√2 and the wall is at z = −2, so the shadow is two units lower.
/// Book: an extensible design: kinds that the core does not know.
#[test]
fn a_shape_defined_here_casts_shadows() {
    let mut scene = from_front(16, 16, 0.25);
    let sun = Directional { ls: 1.0, color: Rgb::WHITE, direction: Vector::new(0.0, 1.0, 1.0) };
    scene.lights.push(Light::new("sun", sun));
    scene.materials.push(Material::new(
        "white",
        Matte { ka: 0.0.into(), kd: 1.0.into(), cd: Rgb::WHITE.into() },
    ));
    let wall = Plane { point: Point::new(0.0, 0.0, -2.0), normal: Vector::Z };
    scene.objects.push(Object::new("wall", "white", wall));
    scene.objects.push(Object::new("tile", "white", tile()));
    let film = render::render(&built(&scene));
    for at in pixels(16, 16) {
        let tile = center_within(at, [-1.0, 1.0], [-1.0, 1.0]);
        let shadow = !tile && center_within(at, [-1.0, 1.0], [-3.0, -1.0]);
        assert_eq!(film.get(at).is_black(), shadow, "{at:?}");
    }
}

/// Parallel rays along −z, upside down.
#[derive(Debug)]
struct UpsideDown;

impl Camera for UpsideDown {
    fn ray(&self, [x, y]: [f64; 2], _: [f64; 2]) -> Option<(Point, Vector)> {
        Some((Point::new(x, -y, 0.0), -Vector::Z))
    }

    fn project(&self, point: Point) -> Option<[f64; 2]> {
        Some([point.x(), -point.y()])
    }
}

/// Every sample in the lower left quarter of the pixel.
#[derive(Debug)]
struct Quarter;

impl Sampler for Quarter {
    fn fill(&self, n: u32, _: &mut Pcg32) -> Vec<[f64; 2]> {
        vec![[0.25, 0.25]; n as usize]
    }

    fn round_up(&self, n: u32) -> u32 {
        n
    }
}

/// A red light from everywhere.
#[derive(Debug)]
struct RedSky;

impl LightKind for RedSky {
    fn is_ambient(&self) -> bool {
        true
    }

    fn sample(&self, from: &LightContext, _: &[[f64; 2]]) -> Option<LightSample> {
        let direction = from.normal.into();
        Some(LightSample { direction, segment: None, radiance: RED, blocked: RED, pdf: None })
    }
}

/// Reflects a quarter of the ambient light, and emits the colour of its texture.
#[derive(Debug)]
struct Glow(Emission);

impl MaterialKind for Glow {
    fn respond(&self, _: &TexturePoint<'_>, _: f64, response: &mut Response) {
        response.ambient = Rgb::grey(0.25);
    }

    fn emission(&self) -> Option<&Emission> {
        Some(&self.0)
    }
}

/// The colour of a point is its y coordinate, in the green channel alone.
#[derive(Debug)]
struct Coordinates;

impl Texture for Coordinates {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        Rgb::new(0.0, at.local.y(), 0.0)
    }
}

/// A scene whose parts are all defined here.
fn all_my_own() -> Scene {
    let mut scene = from_front(2, 2, 0.5);
    scene.camera.lens = cameras::Kind::Custom(Custom(Arc::new(UpsideDown)));
    scene.image.sampler = Some(samplers::Kind::Custom(Custom(Arc::new(Quarter))));
    let sky = lights::Kind::Custom(Custom(Arc::new(RedSky)));
    scene.lights.push(Light::new("sky", sky));
    let glow = materials::Kind::Custom(Custom(Arc::new(Glow(Emission {
        ls: Value::Plain(1.0),
        ce: Color::Textured(Arc::new(Coordinates)),
    }))));
    scene.materials.push(Material::new("glow", glow));
    scene.objects.push(Object::new("tile", "glow", tile()));
    scene
}

/// Law: shape, camera, sampler, light, material and texture can all be user-defined at once. Oracle: one
/// pixel, calculated by hand: the top left pixel spans x from −½ to 0 and y from 0 to ½; its sample at (¼, ¼)
/// is the point (−⅜, ⅛), where the inverted camera sees y = −⅛.
/// Book: an extensible design: kinds that the core does not know.
#[test]
fn every_kind_of_thing_can_be_a_users_own() {
    let film = render::render(&built(&all_my_own()));
    assert_eq!(film.get([0, 0]), Rgb::new(0.25, -0.125, 0.0));
    assert_eq!(film.get([1, 1]), Rgb::new(0.25, 0.375, 0.0));
}

/// Law: a scene that a file cannot hold is refused, and the message names the custom part, also inside instances.
/// Oracle: each custom part in turn is replaced by a built-in one; then the next one is named.
#[test]
fn export_of_a_users_own_kind_names_it() {
    let mut scene = all_my_own();
    scene.objects[0].shape =
        Instance::new(Instance::new(tile(), vec![Step::RotateZ(10.0)]), vec![]).into();
    let texture = Paint::from(textures::Kind::Custom(Custom(Arc::new(Coordinates))));
    type Edit<'a> = &'a dyn Fn(&mut Scene);
    let changes: [(&str, Edit<'_>); 6] = [
        ("objects[0] \"tile\", shape", &|scene| {
            scene.objects[0].shape = Plane { point: Point::ORIGIN, normal: Vector::Z }.into();
        }),
        ("lights[0] \"sky\", source: ", &|scene| scene.lights.clear()),
        ("materials[0] \"glow\", recipe: ", &|scene| {
            let (ka, kd, cd) = (1.0.into(), 1.0.into(), texture.clone());
            scene.materials[0].recipe = Matte { ka, kd, cd }.into();
        }),
        ("materials[0] \"glow\", recipe: ", &|scene| {
            scene.materials[0].recipe = Emissive::new(1.0, RED).into();
        }),
        ("camera.lens: ", &|scene| scene.camera = from_front(2, 2, 0.5).camera),
        ("image.sampler: ", &|scene| scene.image = Image::new(2, 2)),
    ];
    for (named, change) in changes {
        let text = to_toml(&scene).expect_err("it is not plain data").to_string();
        assert!(text.starts_with(named) && text.contains("custom"), "{text}");
        change(&mut scene);
    }
    to_toml(&scene).expect("without custom parts it can be written");
}
