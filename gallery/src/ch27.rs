//! Chapter 27: simple transparency.

use super::List;
use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::materials::{Dielectric, Kind as MaterialKind, Medium, Reflective, Transparent};
use groundtruth::math::{Point, Step, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Light, Object, Scene, Tracer, Whitted};
use groundtruth::shapes::{
    BeveledBox, Disk, FlatRimmedBowl, Kind, Materials, Rectangle, SolidCylinder, TessellatedSphere,
    ThickRing, Torus,
};
use groundtruth::textures::{Checker3d, Paint};

pub const SCENES: List = &[
    ("ch27/common-set", || {
        let about = "the common set of chapter 27: a glass sphere over a checker, in front of a red \
                     mirror sphere";
        with_sphere(about, glass(1.5))
    }),
    ("ch27/from-above", || {
        let about = "figure 27.12: from above: the ball is filled with a dark spot of the ground at its focus";
        let mut scene = with_sphere(about, glass(1.5));
        scene.camera.eye = point(2.0, 50.0, -3.0);
        scene.camera.lens = Pinhole { distance: 1800.0, zoom: 1.0 }.into();
        scene
    }),
    ("ch27/no-refraction", || {
        let about = "figure 27.13: η = 1, no refraction: only reflections show the sphere";
        with_sphere(about, glass(1.0))
    }),
    ("ch27/slight-refraction", || {
        with_sphere(
            "figure 27.14: η = 1.1: the red sphere is upright, the ground upside down",
            glass(1.1),
        )
    }),
    ("ch27/mirror-ring", || {
        let about = "figure 27.15b: η = 0.75: total internal reflection outside 3/4 of the radius: a mirror ring";
        with_sphere(about, glass(0.75))
    }),
    ("ch27/cylinder", cylinder),
    ("ch27/ring", || {
        let mut scene = ring("figure 27.19b: a thick ring of glass on the checker");
        scene.camera = from(point(0.0, 1.0, 4.0), point(0.25, 1.25, 0.0), 700.0);
        scene
    }),
    ("ch27/bowl", bowl),
    ("ch27/beveled-box", beveled_box),
    ("ch27/disks", || {
        disks("figure 27.21: two disks with outward normals: the factors η² cancel", -Vector::Z)
    }),
    ("ch27/disks-same-normals", || {
        let about = "figure 27.26: both normals to the front: darker by 1/η² twice";
        disks(about, Vector::Z)
    }),
    ("ch27/far-sphere", || {
        let about = "figure 27.23: from far away, a ball of green glass inverts the checker";
        tinted_sphere(about, 20.0, 4500.0)
    }),
    ("ch27/near-sphere", || {
        let about = "figure 27.23: close to the ball: upright in the middle, inverted around it";
        tinted_sphere(about, 1.25, 180.0)
    }),
    ("ch27/ellipsoid", || {
        with_ellipsoid("figure 27.24a: an ellipsoid of glass on the ground", 1.5)
    }),
    ("ch27/ellipsoid-of-air", || {
        with_ellipsoid(
            "figure 27.28: the ellipsoid with η = 0.75: a mirror around its middle",
            0.75,
        )
    }),
    ("ch27/torus", || {
        let about = "figure 27.29: a torus of glass; black strips where paths end at depth 5";
        let torus = Torus { swept_radius: 3.0, tube_radius: 0.8, inward: false };
        let steps = vec![Step::RotateX(90.0), Step::RotateY(20.0), RAISED];
        common_set_of(about, "glass torus", transformed(torus, steps), glass(1.5))
    }),
    ("ch27/mesh", || {
        let about = "as figure 27.30: a closed mesh of glass; each facet refracts differently";
        let mesh = TessellatedSphere { radius: 3.0, ..TessellatedSphere::new(16, 8, false) };
        common_set_of(about, "glass mesh", transformed(mesh, vec![RAISED]), glass(1.5))
    }),
    ("ch27/ring-on-white", || {
        let about = "figure 27.32: the ring on white, at depth 3: black where paths end inside it";
        let mut scene = ring(about);
        scene.camera = from(point(0.0, 1.0, 4.0), point(0.0, 1.25, 0.0), 700.0);
        scene.background = Rgb::WHITE.into();
        scene.objects.truncate(1);
        scene.tracer = Tracer::Whitted(Whitted { max_depth: 3 });
        scene
    }),
];

/// The translation to the position of the glass sphere.
const RAISED: Step = Step::Translate(Vector::new(0.0, 4.5, 0.0));

/// The material of most figures; its highlights are those of Phong.
fn glass(eta: f64) -> MaterialKind {
    let phong = phong(0.0, 0.0, Rgb::BLACK, 0.2, 2000.0);
    Transparent { phong, kr: 0.1.into(), cr: Rgb::WHITE.into(), kt: 0.9.into(), eta }.into()
}

fn from(eye: Point, look_at: Point, distance: f64) -> Viewpoint {
    Viewpoint::new(eye, look_at, Pinhole { distance, zoom: 1.0 })
}

/// The chapter's set with a sphere of this glass; chapter 28 uses it again.
pub(super) fn with_sphere(about: &str, glass: MaterialKind) -> Scene {
    common_set_of(about, "glass sphere", sphere(point(0.0, 4.5, 0.0), 3.0), glass)
}

/// The chapter's set with this glass object.
fn common_set_of(about: &str, name: &str, shape: impl Into<Kind>, glass: MaterialKind) -> Scene {
    let camera = from(point(-8.0, 5.5, 40.0), point(1.0, 4.0, 0.0), 2400.0);
    let image = Image { samples: 16, ..Image::new(600, 600) };
    let mut scene = Scene::new(about, image, camera);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 5 });
    scene.background = rgb(0.0, 0.3, 0.25).into();
    scene.lights.extend(lights());
    add(&mut scene, name, shape, glass);
    let red = Reflective {
        phong: phong(0.3, 0.3, rgb(1.0, 0.0, 0.0), 0.2, 2000.0),
        kr: 0.25.into(),
        cr: Rgb::WHITE.into(),
    };
    add(&mut scene, "red sphere", sphere(point(4.0, 4.0, -6.0), 3.0), red);
    let checker = Checker3d { size: 4.0, color1: grey(0.75).into(), color2: Rgb::WHITE.into() };
    add(&mut scene, "ground", rectangle(0.0), matte(0.5, 0.35, Paint::from(checker)));
    scene
}

/// The ground of the chapter's set, at this height.
fn rectangle(y: f64) -> Rectangle {
    let corner = point(-20.0, y, -100.0);
    Rectangle { corner, a: 120.0 * Vector::Z, b: 40.0 * Vector::X }
}

/// The lights of the chapter's set; chapter 28 uses them again.
pub(super) fn lights() -> [Light; 4] {
    [
        ambient(0.25),
        point_light("high lamp", point(40.0, 50.0, 0.0), 4.5),
        point_light("front lamp", point(-10.0, 20.0, 10.0), 4.5),
        directional("left light", -Vector::X, 4.5),
    ]
}

fn cylinder() -> Scene {
    let about = "figure 27.19a: a solid cylinder of glass; its top and bottom reflect what its wall refracts";
    let solid = SolidCylinder { y0: 0.0, y1: 2.25, radius: 1.5, materials: Materials::new() };
    let mut scene = common_set_of(about, "glass cylinder", solid, glass(1.5));
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 10 });
    scene.camera = from(point(0.0, 1.0, 4.0), point(0.25, 1.25, 0.0), 500.0);
    scene
}

/// The ring of figures 27.19b and 27.32; the cameras are ours.
fn ring(about: &str) -> Scene {
    let (y0, y1, inner_radius, outer_radius) = (0.0, 0.35, 0.9, 1.25);
    let ring = ThickRing { y0, y1, inner_radius, outer_radius, materials: Materials::new() };
    let upright =
        vec![Step::RotateX(90.0), Step::RotateY(-45.0), Step::Translate(vector(0.0, 1.25, 0.0))];
    let mut scene = common_set_of(about, "glass ring", transformed(ring, upright), glass(1.5));
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 10 });
    scene
}

/// Bowl and view are the book's; the spheres in it are ours.
fn bowl() -> Scene {
    let about = "figure 27.19c: a bowl of glass with two spheres in it";
    let bowl = FlatRimmedBowl {
        inner_radius: 0.9,
        outer_radius: 1.0,
        opening: 180.0,
        materials: Materials::new(),
    };
    let raised = moved(bowl, Vector::Y);
    let mut scene = common_set_of(about, "glass bowl", raised, glass(1.5));
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 10 });
    scene.camera = from(point(1.0, 7.5, 20.0), point(0.0, 0.6, 0.0), 5250.0);
    let yellow = phong(0.4, 0.5, rgb(1.0, 0.8, 0.2), 0.2, 100.0);
    add(&mut scene, "large sphere", sphere(point(-0.2, 0.56, 0.0), 0.4), yellow);
    let blue = phong(0.4, 0.5, rgb(0.3, 0.5, 1.0), 0.2, 100.0);
    add(&mut scene, "small sphere", sphere(point(0.42, 0.55, 0.15), 0.25), blue);
    scene.materials[0].casts_shadows = false; // else the spheres would be in the bowl's shadow
    scene
}

/// The bevel and the material are the book's, the size is ours.
fn beveled_box() -> Scene {
    let about = "figure 27.20: a beveled box of yellow glass: edges refract more than faces";
    let shape = BeveledBox {
        min: point(-2.5, 0.01, -2.0),
        max: point(2.5, 5.01, 2.0),
        bevel: 0.5,
        materials: Materials::new(),
    };
    let yellow = tinted(1.5, rgb(1.0, 1.0, 0.5));
    common_set_of(about, "glass box", shape, yellow)
}

/// Glass with the reflection of chapter 28 and this colour filter.
fn tinted(eta: f64, filter_color: Rgb) -> MaterialKind {
    let phong = phong(0.0, 0.0, Rgb::BLACK, 0.2, 2000.0);
    let inside = Medium { eta, absorption: filter(filter_color) };
    Dielectric { phong, inside, outside: Medium::default() }.into()
}

/// Two disks one behind the other, the front one facing the viewer; `back` is the other's normal.
/// Radii and distance are the book's, the height is ours.
fn disks(about: &str, back: Vector) -> Scene {
    let disk = |z, normal, radius| Disk { center: point(0.0, 4.5, z), normal, radius };
    let front = disk(0.0, Vector::Z, 3.0);
    let mut scene = common_set_of(about, "front disk", front, glass(1.5));
    let back = Object::new("back disk", "front disk", disk(-3.0, back, 2.0));
    scene.objects.insert(1, back);
    scene
}

/// Camera and glass are the book's, the checker is ours.
fn tinted_sphere(about: &str, eye_z: f64, distance: f64) -> Scene {
    let view = [point(0.0, 0.0, eye_z), Point::ORIGIN];
    let mut scene = pinhole(about, [600, 600], view, distance);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 5 });
    scene.background = rgb(0.6, 0.75, 0.95).into();
    scene.lights.push(ambient(0.5));
    scene.lights.push(directional("sun", vector(1.0, 2.0, 1.0), 2.5));
    add(&mut scene, "glass ball", sphere(Point::ORIGIN, 1.0), tinted(1.5, rgb(0.47, 0.86, 0.74)));
    let checker = checker3d(2.0, grey(0.4), Rgb::WHITE);
    add(&mut scene, "ground", rectangle(-1.25), matte(0.5, 0.5, checker));
    scene
}

fn with_ellipsoid(about: &str, eta: f64) -> Scene {
    let steps = vec![
        Step::Scale(vector(6.0, 2.0, 3.0)),
        Step::RotateX(90.0),
        Step::Translate(vector(0.0, 3.0, 0.0)),
    ];
    let ellipsoid = transformed(sphere(Point::ORIGIN, 1.0), steps);
    common_set_of(about, "glass ellipsoid", ellipsoid, glass(eta))
}
