//! The plane of incidence, and which section is the first.

use explain::{RecordedHit, RecordedRay};
use groundtruth::math::{Point, Vector};
use groundtruth::world::World;
use space::Section;

use super::borders::near;
use super::section::trees;
use super::support::{WHITE, block, built, light, object, traced};

/// Of a length: products of a few rounded numbers.
const ROUNDING: f64 = 1e-9;

/// Mirrors of meshes with smooth normals, which leave the plane of incidence.
fn smooth() -> Vec<(&'static str, World, RecordedRay)> {
    let name = "ch24/mirror-meshes";
    let scene = (gallery::find(name).expect("a scene").build)();
    let mut found = Vec::new();
    for x in 1..8 {
        let world = World::build(&scene).expect("valid");
        let [width, height] = world.picture_size();
        let root = explain::sample(&scene, &world, [x * width / 8, height / 2], 0).ray;
        found.extend(root.map(|root| (name, world, root)));
    }
    found
}

/// Trees of the gallery, and blocks seen under angles around the borders at which arcs, letters and indices move.
fn all() -> Vec<(&'static str, World, RecordedRay)> {
    let mut all = trees();
    all.extend(smooth());
    all.extend([0.0, 0.05, 0.2, 5.0, 11.9, 12.1, 30.0, 44.9, 45.1, 60.0, 85.0].map(block));
    all
}

/// Each ray of a tree that hits something, but for shadow rays: the tree's name, the ray, its hit and its section.
fn each(mut look: impl FnMut(&str, &RecordedRay, &RecordedHit, &Section)) {
    for (name, world, root) in all() {
        for ray in root.rays().into_iter().filter(|ray| !ray.is_shadow()) {
            let Some(hit) = &ray.hit else { continue };
            let section = Section::of(&world, &root, ray.number).expect("it hits");
            look(name, ray, hit, &section);
        }
    }
}

/// Law: the first section of a tree is that of the camera's ray if its hit sends a ray on, or nothing, and that of its first
/// shadow ray if it sends only such. Oracle: four scenes.
#[test]
fn the_first_section_says_most() {
    let tree = |recipe: &str, lamps: usize| {
        let mut text = format!(
            "image = {{ width = 5, height = 5 }}\ntracer.whitted = {{ max_depth = 1 }}\n\
             camera = {{ eye = [0, 0, 10], lens.orthographic = {{}} }}\n\
             [[materials]]\nname = \"it\"\nrecipe.{recipe}\n\
             [[objects]]\nname = \"ball\"\nmaterial = \"it\"\n\
             shape.sphere = {{ center = [0, 0, 0], radius = 1.5 }}\n"
        );
        for lamp in 0..lamps {
            let source = format!("point = {{ location = [0, {lamp}, 9], ls = 1 }}");
            text += &light(&lamp.to_string(), &source);
        }
        let (scene, world) = built(&text);
        [[2, 2], [0, 0]].map(|pixel| {
            let root = explain::sample(&scene, &world, pixel, 0).ray.expect("a ray");
            let first = Section::first(&root);
            let is_drawn = first.is_some_and(|ray| Section::of(&world, &root, ray).is_some());
            assert_eq!(is_drawn, first.is_some(), "whether the first section is drawn");
            first
        })
    };
    let matte = "matte = { kd = 1, cd = 1 }";
    let mirror = "reflective = { phong = { cd = 1, cs = 1, exponent = 1 }, kr = 1, cr = 1 }";
    let glass = "dielectric = { inside = { eta = 1.5 } }";
    assert_eq!(tree(matte, 0), [Some(0), None], "first sections without lights");
    assert_eq!(tree(matte, 2), [Some(1), None], "first sections with two lamps");
    assert_eq!(tree(mirror, 2), [Some(0), None], "first sections of a mirror");
    assert_eq!(tree(glass, 2), [Some(0), None], "first sections of glass");
}

/// Law: the plane contains hit, normal and ray, its axes are at right angles, and x goes where the ray goes. Where the ray is along
/// the normal x is the world's x axis, or z, if the normal is nearer to x, as far as it is along the surface. Oracle: products.
#[test]
fn the_plane_of_incidence_goes_where_the_ray_goes() {
    let mut straight = 0;
    each(|name, ray, hit, section| {
        let plane = section.plane;
        let [x, y] = [[1.0, 0.0], [0.0, 1.0]].map(|at| plane.vector(at));
        let z = plane.normal();
        let what = format!("ray {} of {name}", ray.number);
        for (a, b, expected) in
            [(x, x, 1.0), (y, y, 1.0), (z, z, 1.0), (x, y, 0.0), (y, z, 0.0), (z, x, 0.0)]
        {
            near(a.dot(b), expected, ROUNDING, &format!("a product of axes of {what}"));
        }
        near((x.cross(y) - z).length(), 0.0, ROUNDING, "x × y, off z");
        assert_eq!(plane.to_space([0.0; 2]), hit.point, "the origin of the plane of {what}");
        let way = ray.ray.direction.unit().expect("a direction");
        let sine = way.cross(hit.normal).length();
        assert_eq!(plane.is_any, sine <= 1e-7, "whether any plane will do for {what}");
        if plane.is_any {
            let n = hit.normal;
            let axis = if n.x().abs() <= n.z().abs() { Vector::X } else { Vector::Z };
            let along = axis - axis.dot(n) * Vector::from(n);
            near(x.cross(along).length(), 0.0, ROUNDING, "the x axis, off");
            assert!(x.dot(along) > 0.0, "the x axis of {what} goes the other way");
            straight += 1;
        } else {
            near(way.dot(x), sine, ROUNDING, "the ray's way to the right");
            let off = if sine > 1e-4 { 1e-9 } else { 1e-5 };
            near(way.dot(z), 0.0, off, "the ray's way out of its plane");
        }
    });
    assert!(straight > 0, "rays along the normal: {straight}");
    let (_, world, root) = block(0.0);
    let section = Section::of(&world, &root, 0).expect("it hits");
    assert_eq!(section.plane.vector([1.0, 0.0]), Vector::X, "the x axis of a block from above");
    assert_eq!(section.plane.origin, Point::ORIGIN, "the origin of a block from above");
    for (wall, axis) in [([1, 0, 0], Vector::Z), ([0, 0, 1], Vector::X)] {
        let shape = format!("shape.plane = {{ point = [0, 0, 0], normal = {wall:?} }}");
        let image = "image = { width = 5, height = 5 }";
        let camera = format!("eye = {wall:?}, look_at = [0, 0, 0], lens.orthographic = {{}}");
        let wall = object("wall", &shape);
        let (world, root) =
            traced(&format!("{image}\ncamera = {{ {camera} }}\n{WHITE}{wall}"), [2, 2]);
        let section = Section::of(&world, &root, 0).expect("it hits");
        assert_eq!(section.plane.vector([1.0, 0.0]), axis, "the x axis of a wall");
    }
}
