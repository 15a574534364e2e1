//! What cannot be said is listed at once, each with its place.

use groundtruth::cameras::{Fisheye, Pinhole, Viewpoint};
use groundtruth::kinds::Specification;
use groundtruth::lights::Spot;
use groundtruth::materials::{Matte, Phong};
use groundtruth::math::Point;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Depth, Image, Light, Material, Object, Scene, Tracer};
use groundtruth::shapes::{Compound, Lattice, Part, Sphere};
use groundtruth::textures::Fbm;
use harness::export::pov;

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
    scene.camera.lens = Fisheye::specimens().remove(0).into();
    scene.lights.push(Light::new("lamp", Spot::specimens().remove(0)));
    scene.lights.push(Light { enabled: false, ..Light::new("off", Spot::specimens().remove(0)) });
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
    let all = pov::write("refused", &scene).expect_err("it cannot be said");
    let paths: Vec<&str> = all.iter().map(|it| it.path.as_str()).collect();
    let expected = [
        "tracer",
        "camera.lens.fisheye",
        "lights[0] \"lamp\": source.spot",
        "materials[0] \"shiny\": recipe.phong.ks",
        "materials[1] \"checked\": recipe.matte.cd.fbm",
        "objects[1] \"two\": shape.compound.parts[1].lattice",
    ];
    assert_eq!(paths, expected);
}
