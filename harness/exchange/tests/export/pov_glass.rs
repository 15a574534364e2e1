//! POV-Ray: glass, whose interiors its rays enter and leave.

use exchange::export::{Term, pov};
use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::lights::Directional;
use groundtruth::materials::{Dielectric, Kind, Medium, Phong, Transparent};
use groundtruth::math::{self, Point, Step, Vector};
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{
    Image, Light, Material, Object, Scene, Tracer, TransparentShadows, Whitted,
};
use groundtruth::shapes::{self, Cuboid, Instance, SolidCylinder, Sphere};
use groundtruth::textures::Checker3d;
use groundtruth::world::World;

use super::parsed::{Parsed, Statement, said};
use super::pov::{matte, near, near_all};

const SKY: [f64; 3] = [0.5, 0.25, 1.0];

/// One pixel that looks at the origin from 5 before it, under a sky of one colour.
fn scene(depth: u32) -> Scene {
    let lens = Pinhole { distance: 1000.0, zoom: 1.0 };
    let eye = Viewpoint::new(Point::new(0.0, 0.0, 5.0), Point::ORIGIN, lens);
    let mut scene = Scene::new("glass", Image::new(1, 1), eye);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: depth });
    let [r, g, b] = SKY;
    scene.background = Rgb::new(r, g, b).into();
    scene
}

fn add(scene: &mut Scene, name: &str, recipe: impl Into<Kind>, shape: impl Into<shapes::Kind>) {
    scene.materials.push(Material::new(name, recipe));
    scene.objects.push(Object::new(name, name, shape));
}

/// From −1 to 1 along z.
fn pane() -> Cuboid {
    Cuboid { min: Point::new(-9.0, -9.0, -1.0), max: Point::new(9.0, 9.0, 1.0) }
}

fn ball(radius: f64) -> Sphere {
    Sphere { center: Point::ORIGIN, radius, inward: false }
}

fn dielectric(eta: f64, absorption: Rgb) -> Dielectric {
    Dielectric { inside: Medium { eta, absorption }, ..Dielectric::default() }
}

fn transparent(eta: f64) -> Transparent {
    let (kr, kt) = (0.125.into(), 0.75.into());
    let cr = Rgb::new(1.0, 0.5, 0.25).into();
    Transparent { phong: Phong::default(), kr, cr, kt, eta }
}

/// The statement with the interior of a material.
fn body(parsed: &Parsed, material: usize) -> &Statement {
    let front = format!("front_{material}");
    let found = parsed.statements.iter().find(|(_, it)| it.has("interior") && it.has(&front));
    &found.expect("a body of glass").1
}

/// The paths of what cannot be said, each with its problem.
fn refused(scene: &Scene) -> Vec<(String, String)> {
    let all = pov::write("refused", scene, "".as_ref()).expect_err("it cannot be said");
    all.into_iter().map(|it| (it.path, it.problem)).collect()
}

/// The radiance seen through a pane of thickness 2, at depth 2, by the formulas of POV-Ray's source on what is written:
/// reflection · sky + (pass · pass) · sky · exp(−absorption · 2).
fn their_pane(parsed: &Parsed) -> [f64; 3] {
    let (texture, body) = (&parsed.textures["front_0"], body(parsed, 0));
    assert_eq!(texture, &parsed.textures["back_0"]);
    near(texture.number("ambient"), 0.0);
    near(texture.number("diffuse"), 0.0);
    let colors: Vec<Vec<f64>> = texture
        .words
        .iter()
        .filter(|(word, _)| word == "rgb")
        .map(|(_, it)| it[0].clone())
        .collect();
    assert_eq!(colors[0], [0.0], "the pigment");
    let (reflected, passed): ([f64; 3], f64) = match texture.has("fresnel") {
        true => {
            assert!(texture.has("conserve_energy"));
            assert_eq!(colors[1..], [[0.0], [1.0]], "the reflection for R of 0 and of 1");
            let ior = body.number("ior");
            let r = (ior - 1.0) * (ior - 1.0) / ((ior + 1.0) * (ior + 1.0));
            ([r; 3], texture.number("transmit") * (1.0 - r))
        }
        false => {
            assert!(!texture.has("conserve_energy"));
            (colors[1].clone().try_into().expect("a colour"), texture.number("transmit"))
        }
    };
    let absorption = match body.has("media") {
        true => body.vector("absorption"),
        false => vec![0.0; 3],
    };
    assert!(body.has("hollow"), "only then it has a medium");
    std::array::from_fn(|i| {
        SKY[i] * (reflected[i] + passed * passed * math::exp(-2.0 * absorption[i]))
    })
}

/// Law: a pane of glass reflects, lets pass and absorbs what ours does. Oracle: our picture beside POV-Ray's formulas on the
/// written numbers, and these numbers by hand: R = 1/25 for η = 1.5.
#[test]
fn a_pane_of_glass_has_its_radiance() {
    let clear = Rgb::BLACK;
    let green = Rgb::new(0.5, 0.125, 0.25);
    let kinds: [Kind; 3] =
        [dielectric(1.5, clear).into(), dielectric(1.5, green).into(), transparent(1.5).into()];
    let hand = [
        SKY.map(|sky| sky * (0.04 + 0.96 * 0.96)),
        [0, 1, 2].map(|i| SKY[i] * (0.04 + 0.96 * 0.96 * math::exp(-[1.0, 0.25, 0.5][i]))),
        [0, 1, 2].map(|i| SKY[i] * (0.125 * [1.0, 0.5, 0.25][i] + 0.75 * 0.75)),
    ];
    for (kind, hand) in kinds.into_iter().zip(hand) {
        let mut scene = scene(2);
        add(&mut scene, "glass", kind, pane());
        let ours = render::pixel(&World::build(&scene).expect("it is valid"), [0, 0]).to_array();
        near_all(&ours, hand);
        let parsed = said(&scene);
        near(body(&parsed, 0).number("ior"), 1.5);
        near_all(&their_pane(&parsed), ours);
    }
}

/// Law: glass that blocks light does so as an opaque body that nothing else sees; the other casts no shadow. Oracle: the
/// words of POV-Ray's documentation.
#[test]
fn glass_casts_full_shadows() {
    for casts_shadows in [true, false] {
        let mut scene = scene(4);
        add(&mut scene, "glass", dielectric(1.5, Rgb::BLACK), ball(1.0));
        scene.objects[0].casts_shadows = casts_shadows;
        let parsed = said(&scene);
        let spheres = parsed.all("sphere");
        assert_eq!(spheres.len(), if casts_shadows { 2 } else { 1 });
        assert!(spheres[0].has("interior") && spheres[0].has("no_shadow"));
        assert!(!spheres[0].has("no_image"));
        for shade in &spheres[1..] {
            assert!(shade.has("no_image") && shade.has("no_reflection"));
            assert!(!shade.has("no_shadow") && !shade.has("interior") && !shade.has("transmit"));
            assert_eq!(shade.values, spheres[0].values);
        }
        scene.transparency.shadows = TransparentShadows::Attenuated;
        assert_eq!(pov::write("it", &scene, "".as_ref()).is_err(), casts_shadows);
    }
}

/// Law: all surfaces of a material are one body, so that a ray may leave by another than it entered; the index of a body is
/// that of what is around it times its η, or its η if it is not seen. Oracle: 1.5 · 1.2 and 1.5 / 1.2 by hand.
#[test]
fn bodies_are_of_one_interior_and_their_indices_multiply() {
    let mut scene = scene(8);
    let can = SolidCylinder { y0: -2.0, y1: 2.0, radius: 2.0, materials: Default::default() };
    add(&mut scene, "can", transparent(1.5), can);
    add(&mut scene, "ball", transparent(1.2), ball(1.0));
    let (inside, outside) = (Medium::clear(1.5), Medium::clear(1.2));
    let unseen = Sphere { center: Point::new(100.0, 0.0, 0.0), ..ball(1.0) };
    add(&mut scene, "far", Dielectric { inside, outside, phong: Phong::default() }, unseen);
    let parsed = said(&scene);
    let can = body(&parsed, 0);
    for word in ["disc", "cylinder"] {
        assert!(can.has(word), "{word}");
    }
    assert_eq!(can.words.iter().filter(|(word, _)| word == "interior").count(), 1);
    near(can.number("ior"), 1.5);
    near(body(&parsed, 1).number("ior"), 1.8);
    near(body(&parsed, 2).number("ior"), 1.25);
}

/// Law: a surface between equal indices still counts as an edge there: POV-Ray takes indices in single precision, and does
/// not count if their ratio is 1 up to 10⁻¹⁰.
#[test]
fn an_index_of_one_is_an_edge() {
    let mut scene = scene(4);
    add(&mut scene, "glass", transparent(1.0), ball(1.0));
    let ior = body(&said(&scene), 0).number("ior");
    #[expect(clippy::cast_possible_truncation, reason = "as POV-Ray")]
    let single = f64::from(ior as f32);
    assert!(single - 1.0 > 1e-10, "{ior}");
    assert!(single - 1.0 < 1e-6, "{ior}");
}

/// Law: what POV-Ray's interiors cannot say is refused, with the material and the pixel: reflection where light leaves glass for
/// glass around it, absorption that is not that of the glass around, and a camera that may be inside.
#[test]
fn glass_that_differs_is_refused() {
    let nested = |outside: Medium| {
        let mut scene = scene(8);
        add(&mut scene, "outer", dielectric(1.5, Rgb::BLACK), ball(2.0));
        let inside = Medium::clear(2.0);
        add(
            &mut scene,
            "inner",
            Dielectric { inside, outside, phong: Phong::default() },
            ball(1.0),
        );
        refused(&scene)
    };
    let problems = |all: Vec<(String, String)>| -> Vec<String> {
        assert!(all.iter().all(|(path, _)| path.starts_with("materials[")), "{all:?}");
        assert!(all.iter().any(|(path, _)| path == "materials[1] \"inner\""), "{all:?}");
        assert!(all.iter().all(|(_, problem)| problem.ends_with("(pixel 0,0)")), "{all:?}");
        all.into_iter().map(|(_, problem)| problem).collect()
    };
    let right = problems(nested(Medium::clear(1.5)));
    assert_eq!(right.len(), 1);
    assert!(right[0].contains("reflects nothing"), "{right:?}");
    let tinted = Medium { eta: 1.5, absorption: Rgb::grey(0.5) };
    let tinted = problems(nested(tinted));
    assert!(tinted.iter().any(|it| it.contains("--without absorption")), "{tinted:?}");

    let mut inside = scene(4);
    add(&mut inside, "glass", transparent(1.5), ball(6.0));
    assert!(refused(&inside)[0].1.contains("the camera is in its bounding box"));
}

/// Law: two balls of one material in each other are refused, as POV-Ray leaves the one body where the second begins.
#[test]
fn a_body_in_itself_is_refused() {
    let mut scene = scene(8);
    add(&mut scene, "glass", transparent(1.5), ball(2.0));
    scene.objects.push(Object::new("inner", "glass", ball(1.0)));
    let all = refused(&scene);
    assert_eq!(all[0].0, "materials[0] \"glass\"");
    assert!(all[0].1.contains("the index on the other side"), "{all:?}");
}

/// Law: POV-Ray's radiance has no 1/η²: a surface in glass is refused, unless that factor is left out, and so is one in glass
/// that absorbs. One behind the glass is not: there the factors cancel.
#[test]
fn surfaces_in_glass_are_refused_or_unscaled() {
    let with = |z: f64, absorption: Rgb| {
        let mut scene = scene(4);
        add(&mut scene, "glass", dielectric(1.5, absorption), ball(1.0));
        scene.materials.push(matte("red", 0.0, 0.8, [0.9, 0.2, 0.1]));
        let sphere = Sphere { center: Point::new(0.0, 0.0, z), radius: 0.25, inward: false };
        scene.objects.push(Object::new("red", "red", sphere));
        let sun = Directional { ls: 1.0, color: Rgb::WHITE, direction: Vector::Z };
        scene.lights.push(Light::new("sun", sun));
        scene
    };
    said(&with(-5.0, Rgb::grey(0.5)));
    let mut inside = with(0.0, Rgb::BLACK);
    let all = refused(&inside);
    assert_eq!(all.len(), 1);
    assert!(all[0].1.contains("--without scaling"), "{all:?}");
    Term::Scaling.remove(&mut inside);
    said(&inside);
    let mut tinted = with(0.0, Rgb::grey(0.5));
    Term::Scaling.remove(&mut tinted);
    assert!(refused(&tinted)[0].1.contains("--without absorption"));
}

/// Law: a bubble in tinted glass is refused, because POV-Ray's ray in it is in the glass, too. Without refraction nothing
/// is scaled. Oracle: the one difference.
#[test]
fn bubbles_in_tinted_glass_are_refused() {
    let mut scene = scene(4);
    let tinted = Medium { eta: 1.0, absorption: Rgb::grey(0.5) };
    add(&mut scene, "outer", Dielectric { inside: tinted, ..Dielectric::default() }, ball(2.0));
    add(&mut scene, "bubble", Dielectric { outside: tinted, ..Dielectric::default() }, ball(1.0));
    scene.materials.push(matte("red", 0.0, 0.8, [0.9, 0.2, 0.1]));
    scene.objects.push(Object::new("red", "red", ball(0.25)));
    let all = refused(&scene);
    assert_eq!(all.len(), 1, "{all:?}");
    assert_eq!(all[0].0, "materials[1] \"bubble\"");
    assert!(all[0].1.contains("--without absorption"), "{all:?}");
    Term::Absorption.remove(&mut scene);
    said(&scene);
}

/// Law: glass is not matte as well, and has no highlight; `ray_cast`, which follows no ray through it, sees what is matte.
#[test]
fn glass_is_not_matte() {
    let mut scene = scene(4);
    let cells = Checker3d { size: 2.0, color1: Rgb::WHITE.into(), color2: Rgb::BLACK.into() };
    let phong = Phong { kd: 0.5.into(), ks: 0.25.into(), cd: cells.into(), ..Phong::default() };
    let moved = Instance::new(ball(1.0), vec![Step::Translate(Vector::X)]);
    add(&mut scene, "glass", Transparent { phong, ..transparent(1.5) }, moved);
    let paths: Vec<String> = refused(&scene).into_iter().map(|(path, _)| path).collect();
    let of = |field| format!("materials[0] \"glass\": recipe.transparent.phong.{field}");
    assert_eq!(paths, [of("kd"), of("ks")]);
    scene.tracer = Tracer::RayCast;
    Term::Phong.remove(&mut scene);
    let parsed = said(&scene);
    near(parsed.textures["front_0"].number("diffuse"), 0.5 / std::f64::consts::PI);
    let ball = parsed.one("sphere");
    assert!(!ball.has("interior"));
    let matrices = ball.words.iter().filter(|(word, _)| word == "matrix").count();
    assert_eq!(matrices, 3, "of the shape, and of the cells on its sides");
}
