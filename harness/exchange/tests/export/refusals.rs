//! What cannot be said is listed at once, each with its place.

use exchange::export::{mitsuba, pov};
use groundtruth::cameras::{Fisheye, Pinhole, ThinLens, Viewpoint};
use groundtruth::kinds::Specification;
use groundtruth::lights::{Ambient, Directional, Spot};
use groundtruth::materials::{Matte, Phong, Reflective};
use groundtruth::math::Point;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Depth, Image, Light, Material, Object, Scene, Tracer, Whitted};
use groundtruth::shapes::{Algebraic, Compound, Lattice, Part, Sphere};
use groundtruth::textures::Fbm;

fn scene() -> Scene {
    let eye = Viewpoint::new(
        Point::new(0.0, 0.0, 5.0),
        Point::ORIGIN,
        Pinhole { distance: 10.0, zoom: 1.0 },
    );
    Scene::new("refused", Image::new(4, 4), eye)
}

/// Law: all that cannot be said is listed with its path, once. Oracle: the list of what was put in.
#[test]
fn all_that_cannot_be_said_is_listed_at_once() {
    let mut scene = scene();
    scene.tracer = Tracer::Path(Depth { max_depth: 3 });
    scene.camera.lens = ThinLens::specimens().remove(0).into();
    scene.lights.push(Light::new("lamp", Spot::specimens().remove(0)));
    scene.lights.push(Light { enabled: false, ..Light::new("off", Spot::specimens().remove(0)) });
    let shiny = Phong { ks: 0.5.into(), kd: 0.5.into(), cd: Rgb::WHITE.into(), ..Phong::default() };
    scene.materials.push(Material::new("shiny", shiny));
    let clouds = Fbm::specimens().remove(0);
    let checked = Matte { ka: 0.1.into(), kd: 0.5.into(), cd: clouds.into() };
    scene.materials.push(Material::new("checked", checked.clone()));
    scene.materials.push(Material::new("unused", checked));
    let sphere = || Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
    let tangle = Algebraic::specimens().remove(0);
    let parts = vec![Part::new(sphere()).of_material("checked"), Part::new(tangle)];
    scene.objects.push(Object::new("ball", "shiny", sphere()));
    scene.objects.push(Object::new("two", "shiny", Compound { accel: None, parts }));
    let all = pov::write("refused", &scene, "".as_ref()).expect_err("it cannot be said");
    let paths: Vec<&str> = all.iter().map(|it| it.path.as_str()).collect();
    let expected = [
        "tracer",
        "camera.lens.thin_lens",
        "lights[0] \"lamp\": source.spot",
        "materials[0] \"shiny\": recipe.phong.ks",
        "materials[1] \"checked\": recipe.matte.cd.fbm",
        "objects[1] \"two\": shape.compound.parts[1].algebraic",
    ];
    assert_eq!(paths, expected);
}

/// Law: so for Mitsuba. Oracle: the list of what was put in.
#[test]
fn all_that_mitsuba_cannot_say_is_listed_at_once() {
    let mut scene = scene();
    scene.camera.lens = Fisheye::specimens().remove(0).into();
    scene.lights.push(Light::new("lamp", Spot::specimens().remove(0)));
    scene.lights.push(Light { enabled: false, ..Light::new("off", Spot::specimens().remove(0)) });
    scene.lights.push(Light::new("everywhere", Ambient::specimens().remove(0)));
    let shiny = Phong { ks: 0.5.into(), kd: 0.5.into(), cd: Rgb::WHITE.into(), ..Phong::default() };
    scene.materials.push(Material::new("shiny", shiny));
    let clouds = Fbm::specimens().remove(0);
    let checked = Matte { ka: 0.1.into(), kd: 0.5.into(), cd: clouds.into() };
    scene.materials.push(Material::new("checked", checked.clone()));
    scene.materials.push(Material::new("unused", checked));
    let sphere = || Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
    let lattice = Lattice::specimens().remove(0);
    let parts = vec![Part::new(sphere()).of_material("checked"), Part::new(lattice)];
    scene.objects.push(Object::new("ball", "shiny", sphere()));
    scene.objects.push(Object::new("two", "shiny", Compound { accel: None, parts }));
    let all =
        mitsuba::write("refused", "refused", &scene, "".as_ref()).expect_err("it cannot be said");
    let paths: Vec<&str> = all.iter().map(|it| it.path.as_str()).collect();
    let expected = [
        "camera.lens.fisheye",
        "lights[0] \"lamp\": source.spot",
        "lights[2] \"everywhere\": source.ambient",
        "materials[0] \"shiny\": recipe.phong.ks",
        "materials[1] \"checked\": recipe.matte.cd.fbm",
        "objects[1] \"two\": shape.compound.parts[1].lattice",
    ];
    assert_eq!(paths, expected);
}

/// Law: a tracer that Mitsuba has no counterpart of is refused: whitted follows both rays of glass, and leaves out light that
/// matte surfaces reflect to each other. A scene of one of both can be said.
#[test]
fn mirrors_beside_matte_surfaces_are_refused_for_whitted() {
    let with = |tracer, has_matte: bool| {
        let mut scene = scene();
        scene.tracer = tracer;
        scene.background = Rgb::WHITE.into();
        scene.lights.push(Light::new("sun", Directional::specimens().remove(0)));
        let mirror = Reflective { phong: Phong::default(), kr: 0.5.into(), cr: Rgb::WHITE.into() };
        scene.materials.push(Material::new("mirror", mirror));
        let matte = Matte { ka: 0.0.into(), kd: 0.5.into(), cd: Rgb::WHITE.into() };
        scene.materials.push(Material::new("matte", matte));
        let sphere = || Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
        scene.objects.push(Object::new("mirror", "mirror", sphere()));
        if has_matte {
            scene.objects.push(Object::new("matte", "matte", sphere()));
        }
        mitsuba::write("", "", &scene, "".as_ref()).map_err(|all| all[0].path.clone())
    };
    let whitted = Tracer::Whitted(Whitted { max_depth: 3 });
    assert_eq!(with(whitted, true).err().as_deref(), Some("tracer"));
    assert_eq!(with(whitted, false).map(|said| said.scenes.len()), Ok(1));
    assert_eq!(with(Tracer::Path(Depth { max_depth: 3 }), true).map(|it| it.scenes.len()), Ok(1));
}
