//! What cannot be said to pbrt is listed, each with its place; and what is refused for the sake of others only where these are.

use groundtruth::background::Background;
use groundtruth::cameras::{Fisheye, Pinhole, Viewpoint};
use groundtruth::kinds::Specification;
use groundtruth::lights::{Ambient, Directional, Environment, Spot};
use groundtruth::materials::{Matte, Phong, Reflective};
use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Depth, Image, Light, Material, Object, Scene, Tracer, Whitted};
use groundtruth::shapes::{Compound, Cone, Part, Plane, Rectangle, Sphere, TessellatedSphere};
use harness::export::Term;

use super::pbrt_parsed::written;

fn scene() -> Scene {
    let lens = Pinhole { distance: 10.0, zoom: 1.0 };
    let eye = Viewpoint::new(Point::new(0.0, 0.0, 5.0), Point::ORIGIN, lens);
    Scene::new("refused", Image::new(4, 4), eye)
}

fn matte(name: &str, cd: Rgb) -> Material {
    Material::new(name, Matte { ka: 0.1.into(), kd: 0.5.into(), cd: cd.into() })
}

fn ball() -> Sphere {
    Sphere { center: Point::ORIGIN, radius: 1.0, inward: false }
}

fn sun(color: Rgb, direction: Vector) -> Directional {
    Directional { ls: 2.0, color, direction }
}

/// The paths of all that cannot be said; none if it can.
fn paths(scene: &Scene) -> Vec<String> {
    let all = written(scene).err().unwrap_or_default();
    all.into_iter().map(|it| it.path).collect()
}

/// Law: all that cannot be said is listed with its path, once. Oracle: the list of what was put in.
#[test]
fn all_that_cannot_be_said_is_listed_at_once() {
    let mut scene = scene();
    scene.tracer = Tracer::GlobalTrace(Depth { max_depth: 3 });
    scene.background = Background::Color(Rgb::new(0.5, 0.25, 0.5));
    scene.camera.lens = Fisheye::specimens().remove(0).into();
    scene.lights.push(Light::new("all", Ambient { ls: 1.0, color: Rgb::WHITE }));
    scene.lights.push(Light::new("lamp", Spot::specimens().remove(0)));
    scene.lights.push(Light { enabled: false, ..Light::new("off", Spot::specimens().remove(0)) });
    let shiny = Phong { ks: 0.5.into(), kd: 2.5.into(), cd: Rgb::WHITE.into(), ..Phong::default() };
    scene.materials.push(Material::new("shiny", shiny));
    scene.materials.push(matte("unused", Rgb::new(1.0, 0.0, 0.0)));
    scene.materials.push(matte("red", Rgb::new(1.0, 0.0, 0.0)));
    let cone = Cone { height: 2.0, radius: 1.0, inward: false };
    let parts = vec![Part::new(ball()).of_material("red"), Part::new(cone)];
    scene.objects.push(Object::new("ball", "shiny", ball()));
    scene.objects.push(Object::new("two", "shiny", Compound { accel: None, parts }));
    let expected = [
        "tracer",
        "camera.lens.fisheye",
        "lights[0] \"all\": source.ambient",
        "lights[1] \"lamp\": source.spot",
        "materials[0] \"shiny\": recipe.phong.ks",
        "materials[0] \"shiny\": recipe.phong",
        "materials[2] \"red\": recipe.matte",
        "objects[1] \"two\": shape.compound.parts[1].cone",
    ];
    assert_eq!(paths(&scene), expected);
}

/// Law: a coloured surface can be said under grey lights and a coloured light on grey surfaces, both not together, and a
/// coloured surface not where light is reflected again. Oracle: the product of two spectra has the product of their colours if
/// one is constant.
#[test]
fn two_colours_do_not_meet() {
    let (grey, red) = (Rgb::grey(0.5), Rgb::new(1.0, 0.5, 0.25));
    let light = "lights[0] \"sun\": source.directional";
    let surface = "materials[0] \"it\": recipe.matte";
    let path = Tracer::Path(Depth { max_depth: 3 });
    let cases: [(Rgb, Rgb, Tracer, &[&str]); 6] = [
        (grey, grey, path, &[]),
        (red, grey, path, &[]),
        (red, grey, Tracer::RayCast, &[]),
        (grey, red, Tracer::RayCast, &[]),
        (red, red, Tracer::RayCast, &[light]),
        (grey, red, path, &[surface]),
    ];
    for (light, surface, tracer, expected) in cases {
        let mut scene = scene();
        scene.tracer = tracer;
        scene.lights.push(Light::new("sun", sun(light, Vector::new(1.0, 1.0, 1.0))));
        scene.materials.push(matte("it", surface));
        scene.objects.push(Object::new("ball", "it", ball()));
        assert_eq!(paths(&scene), expected, "{light:?} {surface:?} {tracer:?}");
    }
}

/// Law: a background that is seen but lights nothing here is refused where something reflects.
#[test]
fn a_background_is_a_light() {
    let mut scene = scene();
    scene.background = Background::Color(Rgb::grey(0.5));
    scene.materials.push(matte("it", Rgb::WHITE));
    assert_eq!(paths(&scene), [] as [&str; 0]);
    scene.objects.push(Object::new("ball", "it", ball()));
    assert_eq!(paths(&scene), ["background"]);
}

/// Law: a one-sided surface is refused if the camera sees its back. A closed surface seen from outside is written, and so
/// is a two-sided one.
#[test]
fn backs_that_are_seen_are_refused() {
    let mut scene = scene();
    scene.lights.push(Light::new("sun", sun(Rgb::WHITE, Vector::new(1.0, 1.0, 1.0))));
    scene.materials.push(matte("it", Rgb::WHITE));
    let (corner, a) = (Point::new(-9.0, -9.0, 0.0), Vector::new(18.0, 0.0, 0.0));
    let wall = |b| Rectangle { corner, a, b: Vector::new(0.0, b, 0.0) };
    let (front, back) =
        (wall(18.0), Rectangle { corner: Point::new(-9.0, 9.0, 0.0), ..wall(-18.0) });
    for (shape, two_sided, is_said) in
        [(front.clone(), false, true), (back.clone(), false, false), (back, true, true)]
    {
        scene.materials[0].two_sided = two_sided;
        scene.objects = vec![Object::new("wall", "it", shape)];
        assert_eq!(paths(&scene).is_empty(), is_said);
    }
    scene.materials[0].two_sided = false;
    scene.objects = vec![Object::new("ball", "it", ball())];
    assert_eq!(paths(&scene), [] as [&str; 0]);
    scene.objects = vec![Object::new("hollow", "it", Sphere { inward: true, ..ball() })];
    assert_eq!(paths(&scene), ["materials[0] \"it\""]);
}

/// Law: a light without shadows is refused where a shadow would be seen, and only there.
#[test]
fn missing_shadows_that_would_be_seen_are_refused() {
    let mut scene = scene();
    let light = Light::new("sun", sun(Rgb::WHITE, Vector::new(0.0, 0.0, 1.0))).without_shadows();
    scene.lights.push(light);
    scene.materials.push(matte("it", Rgb::WHITE));
    scene.objects.push(Object::new("ball", "it", ball()));
    assert_eq!(paths(&scene), [] as [&str; 0]);
    // behind the camera, in front of the light
    let cloud = Sphere { center: Point::new(0.0, 0.0, 10.0), ..ball() };
    scene.objects.push(Object::new("cloud", "it", cloud));
    assert_eq!(paths(&scene), ["lights[0] \"sun\": shadows"]);
    scene.lights[0].shadows = true;
    assert_eq!(paths(&scene), [] as [&str; 0]);
    scene.objects[1].casts_shadows = false;
    assert_eq!(paths(&scene), ["objects[1] \"cloud\": casts_shadows"]);
}

/// Law: a plane is refused with its horizon in a pixel of several samples, and with a light below it.
#[test]
fn planes_are_refused_where_no_disk_can_stand_for_them() {
    let mut scene = scene();
    let above = Vector::new(1.0, 1.0, 1.0);
    scene.lights.push(Light::new("sun", sun(Rgb::WHITE, above)));
    scene.materials.push(Material { two_sided: true, ..matte("it", Rgb::WHITE) });
    let plane = Plane { point: Point::new(0.0, -1.0, 0.0), normal: Vector::Y };
    scene.objects.push(Object::new("floor", "it", plane));
    scene.image = Image::new(4, 5); // the horizon is in the middle row
    let refused = ["objects[0] \"floor\": shape.plane"];
    assert_eq!(paths(&scene), [] as [&str; 0]);
    scene.image.samples = 4;
    assert_eq!(paths(&scene), refused);
    scene.image = Image::new(4, 4); // between two rows
    scene.image.samples = 4;
    scene.camera.look_at = Point::new(0.0, -5.0, 0.0);
    assert_eq!(paths(&scene), [] as [&str; 0]);
    scene.lights[0].source = sun(Rgb::WHITE, -above).into();
    assert_eq!(paths(&scene), refused);
}

/// Law: a mirror is refused where it is seen: not by `ray_cast`.
#[test]
fn mirrors_are_refused_where_they_are_seen() {
    let mut scene = scene();
    let mirror = Reflective { phong: Phong::default(), kr: 0.5.into(), cr: Rgb::WHITE.into() };
    scene.materials.push(Material::new("mirror", mirror));
    scene.objects.push(Object::new("ball", "mirror", ball()));
    assert_eq!(paths(&scene), [] as [&str; 0]);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 3 });
    assert_eq!(paths(&scene), ["materials[0] \"mirror\": recipe.reflective.kr"]);
}

/// Law: a smooth mesh is refused where an interpolated normal faces away from the camera. Oracle: the outline of a coarse sphere
/// has such points; seen from near by, its middle has none.
#[test]
fn smooth_outlines_are_refused() {
    let mut scene = scene();
    scene.image = Image::new(64, 64);
    scene.image.pixel_size = 0.25;
    scene.materials.push(matte("it", Rgb::WHITE));
    scene.objects.push(Object::new("ball", "it", TessellatedSphere::new(8, 4, true)));
    assert!(!paths(&scene).is_empty());
    scene.image.pixel_size = 0.01;
    assert_eq!(paths(&scene), [] as [&str; 0]);
}

/// Law: `--without` leaves out what its name says: a background that lights nothing, but none that is a light; and missing
/// shadows. Oracle: the scene.
#[test]
fn terms_are_left_out() {
    let mut scene = scene();
    scene.background = Background::Color(Rgb::grey(0.5));
    scene.lights.push(Light::new("sun", sun(Rgb::WHITE, Vector::Z)).without_shadows());
    scene.materials.push(Material { casts_shadows: false, ..matte("it", Rgb::WHITE) });
    scene.objects.push(Object { casts_shadows: false, ..Object::new("ball", "it", ball()) });
    let background = |scene: &Scene| match scene.background {
        Background::Color(color) => color,
        Background::Pattern(_) => panic!("a colour"),
    };
    let without = |scene: &Scene, name: &str| {
        let mut scene = scene.clone();
        name.parse::<Term>().expect("there is one").remove(&mut scene);
        scene
    };
    assert!(background(&without(&scene, "background")).is_black());
    assert_eq!(background(&without(&scene, "unshadowed")), Rgb::grey(0.5));
    let shaded = without(&scene, "unshadowed");
    assert!(
        shaded.lights[0].shadows
            && shaded.materials[0].casts_shadows
            && shaded.objects[0].casts_shadows
    );
    scene.tracer = Tracer::Path(Depth { max_depth: 2 });
    assert_eq!(background(&without(&scene, "background")), Rgb::grey(0.5));
    scene.tracer = Tracer::RayCast;
    scene.lights.push(Light::new("sky", Environment {}));
    assert_eq!(background(&without(&scene, "background")), Rgb::grey(0.5));
    scene.lights[1].enabled = false;
    assert!(background(&without(&scene, "background")).is_black());
}
