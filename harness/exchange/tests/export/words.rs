//! Whole scenes as each target says them, and what it refuses: goldens of words, written anew by
//! `scripts/renew-texts.sh`. Laws about the numbers in them are in the other files.

use std::collections::HashSet;
use std::fs;
use std::path::PathBuf;

use exchange::export::{AnyKind, Target, Term};
use groundtruth::cameras::{Fisheye, ThinLens};
use groundtruth::kinds::Specification;
use groundtruth::lights::{Ambient, Area, Environment, Spot};
use groundtruth::materials::{self, Dielectric, Emissive, Medium, Phong, Transparent};
use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::{
    add, checker3d, directional, matte, mirror, moved, phong, pinhole, point, point_light, rgb,
    sphere, vector,
};
use groundtruth::scene::{
    Depth, Light, Object, Scene, Tracer, Transparency, TransparentShadows, Whitted,
};
use groundtruth::shapes::{
    Algebraic, Compound, Instance, Kind, Lattice, OpenCylinder, Part, Rectangle, Sphere,
    TessellatedSphere,
};
use groundtruth::textures::Fbm;

use super::kinds::{self, combined};

const WHITTED: Tracer = Tracer::Whitted(Whitted { max_depth: 7 });
const PATH: Tracer = Tracer::Path(Depth { max_depth: 7 });

/// Of a longer run of lines that begin with the same words, or with a number, a golden has the first few: of meshes.
const LONGEST: usize = 20;
const FEW: usize = 4;
/// How a line begins that says what is refused.
const REFUSED: &str = "refused";

/// Everything that a target writes of a scene, or the lines of what it refuses.
fn written(target: Target, scene: &Scene) -> Result<String, String> {
    let exported = target
        .write("scene", "scene", scene, "".as_ref())
        .map_err(|all| all.iter().map(|it| format!("{REFUSED}: {it}\n")).collect::<String>())?;
    let file = |(name, bytes)| format!("{name}:\n{}", String::from_utf8(bytes).expect("text"));
    let files: String = exported.files.into_iter().map(file).collect();
    Ok(exported.text + &files)
}

/// A golden of several texts: of each the lines that none before it has, with their long runs shortened.
#[derive(Default)]
struct Golden {
    text: String,
    seen: HashSet<String>,
}

impl Golden {
    fn add(&mut self, name: &str, text: &str) {
        let words = |line: &&str| {
            let words: Vec<&str> = line.split_whitespace().take(2).collect();
            let is_number = words.first().is_some_and(|it| it.parse::<f64>().is_ok());
            if is_number { "number".to_owned() } else { words.join(" ") }
        };
        let is_new = |it: &&str| self.seen.insert((*it).to_owned()) || it.starts_with(REFUSED);
        let new: Vec<&str> = text.lines().filter(is_new).collect();
        let above = text.lines().count() - new.len();
        self.text += &format!("\n== {name} ({above} lines stand above)\n");
        for run in new.chunk_by(|a, b| words(a) == words(b)) {
            let count = run.len();
            self.text += &match count > LONGEST {
                true => format!("{}\n({count} lines)\n", run[..FEW].join("\n")),
                false => run.join("\n") + "\n",
            };
        }
    }
}

/// Holds a golden to the text that it should be; with `RENEW_TEXTS` in the environment it is written instead.
fn hold(name: &str, found: &str) {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/export/words").join(name);
    if std::env::var_os("RENEW_TEXTS").is_some() {
        return fs::write(file, found).expect("it can be written");
    }
    let expected = fs::read_to_string(&file).unwrap_or_default();
    let differs = found.lines().zip(expected.lines()).find(|(found, expected)| found != expected);
    assert!(
        found == expected,
        "{}: found and expected {differs:?}\nif that is right, renew it: scripts/renew-texts.sh",
        file.display()
    );
}

fn extension(target: Target) -> &'static str {
    match target {
        Target::Pov => "pov",
        Target::Mitsuba => "xml",
    }
}

/// Golden: of each kind that a target can say the specimens with the shortest texts, in one scene for each list; of
/// cameras, in one for each.
#[test]
fn kinds_read_as_before() {
    let text = |target, all: &[AnyKind]| written(target, &combined(target, all));
    for target in Target::ALL {
        let mut golden = Golden::default();
        for (list, kinds) in kinds::lists() {
            let is_camera = list == "camera";
            let shortest = |kind: Vec<AnyKind>| {
                let length = |it| Some((text(target, std::slice::from_ref(&it)).ok()?.len(), it));
                let mut all: Vec<_> = kind.into_iter().filter_map(length).collect();
                all.sort_by_key(|(length, _)| *length);
                all.into_iter().take(if is_camera { 1 } else { 2 }).map(|(_, it)| it)
            };
            let specimens: Vec<AnyKind> = kinds.into_iter().flat_map(shortest).collect();
            for all in specimens.chunks(if is_camera { 1 } else { specimens.len() }) {
                golden.add(list, &text(target, all).expect("as each alone"));
            }
        }
        hold(&format!("kinds.{}", extension(target)), &golden.text);
    }
}

/// Golden: what each target writes of each case, or refuses, with its place, all at once.
#[test]
fn cases_read_as_before() {
    for target in Target::ALL {
        let mut golden = Golden::default();
        for (name, scene) in cases() {
            let (Ok(text) | Err(text)) = written(target, &scene);
            golden.add(name, &text);
        }
        hold(&format!("cases.{}", extension(target)), &golden.text);
    }
}

fn cases() -> Vec<(&'static str, Scene)> {
    let (dark, unshadowed) = (shadows(), without(Term::Unshadowed, shadows()));
    let [lit, lit_by_paths] = [two_suns(), Scene { tracer: PATH, ..two_suns() }];
    vec![
        ("sides", sides(WHITTED)),
        ("sides, path", sides(PATH)),
        ("shadows", dark),
        ("unshadowed", unshadowed),
        ("still texture", still_texture()),
        ("two suns", lit),
        ("two suns, path", lit_by_paths),
        ("sky", sky(WHITTED)),
        ("sky, path", sky(PATH)),
        ("glass", glass(TransparentShadows::Opaque)),
        ("attenuated shadows of glass", glass(TransparentShadows::Attenuated)),
        ("clear glass", Scene { tracer: PATH, ..one(dielectric(1.5, 0.0), ball(1.0)) }),
        ("glass in glass", in_glass(Medium::clear(1.5), dielectric(1.5, 0.0))),
        ("camera in glass", one(transparent(), ball(6.0))),
        ("glass in itself", in_itself()),
        ("surface behind glass", red_at(-5.0, one(dielectric(1.5, 0.0), ball(1.0)))),
        ("surface in glass", red_at(0.0, one(dielectric(1.5, 0.0), ball(1.0)))),
        ("surface in glass, unscaled", {
            without(Term::Scaling, red_at(0.0, one(dielectric(1.5, 0.0), ball(1.0))))
        }),
        ("bubble in tint", bubble()),
        ("bubble, no absorption", without(Term::Absorption, bubble())),
        ("glass that is matte", one(matte_glass(), moved(ball(1.0), Vector::X))),
        ("glass that is matte, ray_cast", {
            let scene = without(Term::Phong, one(matte_glass(), moved(ball(1.0), Vector::X)));
            Scene { tracer: Tracer::RayCast, ..scene }
        }),
        ("smooth", smooth()),
        ("flat", without(Term::Smooth, smooth())),
        ("too many", one(matte(0.0, 0.5, Rgb::WHITE), many())),
        ("lens and path", refused(PATH, ThinLens::specimens().remove(0).into())),
        ("fisheye and ray_cast", refused(Tracer::RayCast, Fisheye::specimens().remove(0).into())),
    ]
}

fn without(term: Term, mut scene: Scene) -> Scene {
    term.remove(&mut scene);
    scene
}

/// A scene with a sun and a white background.
fn empty(tracer: Tracer) -> Scene {
    let mut scene = pinhole("-- <&", [1, 1], [point(0.0, 0.0, 5.0), Point::ORIGIN], 1000.0);
    scene.image.samples = 1;
    scene.tracer = tracer;
    scene.lights.push(directional("sun", vector(1.0, 2.0, 3.0), 1.0));
    scene
}

/// One object, seen with its mirror images under a white background.
fn one(recipe: impl Into<materials::Kind>, shape: impl Into<Kind>) -> Scene {
    let mut scene = Scene { background: Rgb::WHITE.into(), ..empty(WHITTED) };
    scene.lights.clear();
    add(&mut scene, "it", shape, recipe);
    scene
}

fn ball(radius: f64) -> Sphere {
    sphere(Point::ORIGIN, radius)
}

fn tube(inward: bool) -> OpenCylinder {
    OpenCylinder { y0: -1.0, y1: 2.5, radius: 0.5, inward }
}

fn rectangle(corner: Point) -> Rectangle {
    Rectangle { corner, a: vector(2.0, 1.0, 0.0), b: vector(0.0, 0.0, 3.0) }
}

fn tint(eta: f64) -> Medium {
    Medium { eta, absorption: Rgb::grey(0.5) }
}

fn dielectric(eta: f64, absorption: f64) -> Dielectric {
    let inside = Medium { eta, absorption: Rgb::grey(absorption) };
    Dielectric { inside, ..Dielectric::default() }
}

fn transparent() -> Transparent {
    let cr = rgb(1.0, 0.5, 0.25).into();
    Transparent { phong: Phong::default(), kr: 0.125.into(), cr, kt: 0.75.into(), eta: 1.5 }
}

fn matte_glass() -> Transparent {
    let cells = checker3d(2.0, Rgb::WHITE, Rgb::BLACK);
    Transparent { phong: phong(0.0, 0.5, cells, 0.25, 10.0), ..transparent() }
}

/// One-sided and two-sided surfaces, inward ones, mirrors with and without a base, and a lamp whose light is off.
fn sides(tracer: Tracer) -> Scene {
    let mut scene = empty(tracer);
    let cr = rgb(1.0, 0.5, 0.25);
    add(&mut scene, "outside", tube(false), matte(0.25, 0.5, Rgb::WHITE));
    add(&mut scene, "inside", tube(true), matte(0.25, 0.5, Rgb::WHITE));
    scene.materials[1].two_sided = true;
    add(&mut scene, "mirror", ball(1.0), mirror(Phong::default(), 0.5, cr));
    add(&mut scene, "blend", ball(2.0), mirror(phong(0.0, 0.25, cr, 0.0, 1.0), 0.5, cr));
    add(&mut scene, "lamp", rectangle(Point::ORIGIN), Emissive::new(4.0, cr));
    let area = Area { object: "lamp".into(), sampling: None };
    scene.lights.push(Light { enabled: false, ..Light::new("off", area) });
    scene
}

/// What casts no shadow: by its light, its object and its material.
fn shadows() -> Scene {
    let mut scene = empty(Tracer::RayCast);
    scene.lights[0].shadows = false;
    add(&mut scene, "red", ball(1.0), matte(0.0, 0.5, Rgb::WHITE));
    add(&mut scene, "air", ball(2.0), matte(0.0, 0.5, Rgb::WHITE));
    scene.objects.push(Object { casts_shadows: false, ..Object::new("no", "red", ball(3.0)) });
    scene.materials[1].casts_shadows = false;
    scene
}

/// A texture that does not move with the inner of two instances, and one on a slope, which no axis goes along.
fn still_texture() -> Scene {
    let mut scene = empty(Tracer::RayCast);
    let cells = || matte(0.0, 0.5, checker3d(2.0, Rgb::WHITE, Rgb::BLACK));
    let Kind::Instance(inner) = moved(ball(1.0), Vector::X) else { unreachable!() };
    let still = Instance { transform_texture: false, ..inner };
    add(&mut scene, "ball", moved(still, 10.0 * Vector::X), cells());
    add(&mut scene, "slope", rectangle(Point::ORIGIN), cells());
    scene
}

/// Two lights, and a background that lights nothing.
fn two_suns() -> Scene {
    let mut scene = empty(Tracer::RayCast);
    scene.background = rgb(0.5, 0.25, 0.125).into();
    scene.camera.exposure_time = 2.0;
    scene.lights.push(directional("second", Vector::Y, 2.0));
    add(&mut scene, "ball", ball(1.0), matte(0.0, 0.5, Rgb::WHITE));
    scene
}

fn sky(tracer: Tracer) -> Scene {
    let mut scene = empty(tracer);
    scene.background = Rgb::WHITE.into();
    scene.lights = vec![Light::new("sky", Environment {})];
    add(&mut scene, "ball", ball(1.0), matte(0.0, 0.5, Rgb::WHITE));
    scene
}

/// Glass that blocks light, and glass that does not.
fn glass(shadows: TransparentShadows) -> Scene {
    let mut scene = one(dielectric(1.5, 0.0), ball(1.0));
    scene.transparency = Transparency { shadows, ..scene.transparency };
    let clear = Object::new("clear", "it", sphere(point(3.0, 0.0, 0.0), 1.0));
    scene.objects.push(Object { casts_shadows: false, ..clear });
    scene
}

/// A ball of index 2 in a larger one, which takes `outside` for what is around it.
fn in_glass(outside: Medium, outer: Dielectric) -> Scene {
    let mut scene = one(outer, ball(2.0));
    let inner = Dielectric { inside: Medium::clear(2.0), outside, phong: Phong::default() };
    add(&mut scene, "inner", ball(1.0), inner);
    scene
}

fn in_itself() -> Scene {
    let mut scene = one(transparent(), ball(2.0));
    scene.objects.push(Object::new("inner", "it", ball(1.0)));
    scene
}

fn red_at(z: f64, mut scene: Scene) -> Scene {
    add(&mut scene, "red", sphere(point(0.0, 0.0, z), 0.25), matte(0.0, 0.8, rgb(0.9, 0.2, 0.1)));
    scene.lights.push(directional("sun", Vector::Z, 1.0));
    scene
}

fn bubble() -> Scene {
    let mut scene = one(dielectric(1.0, 0.5), ball(2.0));
    add(
        &mut scene,
        "bubble",
        ball(1.0),
        Dielectric { outside: tint(1.0), ..Dielectric::default() },
    );
    red_at(0.0, scene)
}

/// Meshes with interpolated normals, one of them moved.
fn smooth() -> Scene {
    let mesh = || TessellatedSphere::new(3, 2, true);
    let mut scene = empty(Tracer::RayCast);
    add(&mut scene, "mesh", mesh(), matte(0.0, 0.5, Rgb::WHITE));
    add(&mut scene, "moved", moved(mesh(), Vector::X), matte(0.0, 0.5, Rgb::WHITE));
    scene
}

/// 10¹⁶ balls.
fn many() -> Kind {
    (0..8).fold(ball(1.0).into(), |of, _| {
        let (counts, spacing) = ([10, 1, 10], vector(3.0, 1.0, 3.0));
        Lattice { counts, spacing, of: Box::new(of), accel: None }.into()
    })
}

/// Kinds that a target cannot export. A light that is off and a material that no object has must not be refused.
fn refused(tracer: Tracer, lens: groundtruth::cameras::Kind) -> Scene {
    let mut scene = empty(tracer);
    scene.camera.lens = lens;
    let spot = || Spot::specimens().remove(0);
    scene.lights.push(Light::new("lamp", spot()));
    scene.lights.push(Light { enabled: false, ..Light::new("off", spot()) });
    scene.lights.push(Light::new("everywhere", Ambient::specimens().remove(0)));
    scene.lights.push(point_light("constant", point(0.0, 2.0, 0.0), 1.0));
    let clouds = || matte(0.1, 0.5, Fbm::specimens().remove(0));
    add(&mut scene, "shiny", ball(1.0), phong(0.0, 0.5, Rgb::WHITE, 0.5, 1.0));
    add(&mut scene, "unused", ball(1.0), clouds());
    scene.objects.pop();
    let [tangle, lattice]: [Kind; 2] =
        [Algebraic::specimens().remove(0).into(), Lattice::specimens().remove(0).into()];
    let parts =
        vec![Part::new(ball(1.0)).of_material("clouds"), Part::new(tangle), Part::new(lattice)];
    add(&mut scene, "clouds", Compound { accel: None, parts }, clouds());
    scene
}
