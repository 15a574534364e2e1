//! The lights that add nothing at a hit, and the sentence about a black ray.

use std::collections::BTreeMap;

use explain::{RecordedRay, Unlit};
use groundtruth::lights::Spot;
use groundtruth::math::sin_cos;
use groundtruth::shapes::Sampling;
use serde::Deserialize;
use testkit::properties::*;

use crate::prelude::*;

/// A few operations on unit vectors and on points near the origin.
const ROUNDING: f64 = 1e-12;

fn unit() -> impl Strategy<Value = Vector> {
    let component = || -1.0..1.0_f64;
    (component(), component(), component())
        .prop_map(|(x, y, z)| Vector::new(x, y, z))
        .prop_filter_map("not near zero", |v| if v.length() > 0.1 { v.unit() } else { None })
}

fn white() -> Matte {
    Matte { ka: 0.0.into(), kd: 0.5.into(), cd: Rgb::WHITE.into() }
}

/// A disk of this material about the origin, seen from `eye`.
fn disk(normal: Vector, eye: Vector, recipe: impl Into<materials::Kind>) -> Scene {
    let camera =
        Viewpoint::new(Point::ORIGIN + 5.0 * eye, Point::ORIGIN, Orthographic { zoom: 1.0 });
    let mut scene = Scene::new("", Image { pixel_size: 1e-6, ..Image::new(1, 1) }, camera);
    scene.camera.up = Vector::new(0.3, 0.5, -0.8);
    scene.materials = vec![Material::new("disk", recipe)];
    let shape = Disk { center: Point::ORIGIN, normal, radius: 1.0 };
    scene.objects = vec![Object::new("disk", "disk", shape)];
    scene
}

/// The same with one light.
fn lit(mut scene: Scene, light: impl Into<lights::Kind>) -> Scene {
    scene.lights = vec![Light::new("light", light)];
    scene
}

fn sun(direction: Vector) -> Directional {
    Directional { ls: 1.0, color: Rgb::WHITE, direction }
}

/// The camera's ray.
fn ray(scene: &Scene) -> RecordedRay {
    let world = World::build(scene).expect("the scene is valid");
    explain::sample(scene, &world, [0, 0], 0).ray.expect("the camera sees all its film")
}

/// Why the only light adds nothing to a black picture.
fn reason(scene: &Scene) -> Unlit {
    let ray = ray(scene);
    assert!(ray.radiance.is_black() && ray.unlit.len() == 1, "{ray:#?}");
    let text = ray.unlit[0].reason.to_string();
    let black = ray.black.expect("a reason");
    assert!(black.contains(&text), "`{black}` does not say `{text}`");
    ray.unlit[0].reason.clone()
}

fn near(found: f64, expected: f64) -> bool {
    (found - expected).abs() <= ROUNDING * expected.abs().max(1.0)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..laws() })]

    /// Law: a light below the plane of a surface that is seen from above is behind the surface, with the
    /// cosine of its angle; a surface seen from below has a viewer behind it, unless it is two-sided.
    /// Oracle: dot products of the given directions.
    #[test]
    fn lights_and_viewers_behind_a_surface(
        (n, eye, light) in (unit(), unit(), unit()),
        two_sided in any::<bool>(),
    ) {
        let (cos_o, cos_i) = (n.dot(eye), n.dot(light));
        prop_assume!(cos_o.abs() > 0.05 && cos_i.abs() > 0.05);
        let mut scene = lit(disk(n, eye, white()), sun(light));
        scene.materials[0].two_sided = two_sided;
        let cos_i = if two_sided { cos_i * cos_o.signum() } else { cos_i };
        if (two_sided || cos_o > 0.0) && cos_i > 0.0 {
            let ray = ray(&scene);
            prop_assert!(ray.unlit.is_empty() && ray.black.is_none());
            prop_assert!(near(ray.radiance.r, 0.5 / PI * cos_i));
            return Ok(());
        }
        match reason(&scene) {
            Unlit::ViewerBehind { cos_o: found } => {
                prop_assert!(!two_sided && cos_o < 0.0 && near(found, cos_o), "{found}, {cos_o}");
            }
            Unlit::BehindSurface { cos_i: found } => {
                prop_assert!((two_sided || cos_o > 0.0) && near(found, cos_i), "{found}, {cos_i}");
            }
            other => prop_assert!(false, "{other:?}"),
        }
    }

    /// Law: a light between the plane of an interpolated normal and that of the true one is behind the true
    /// surface. Oracle: the dot products of a light chosen between both planes.
    #[test]
    fn lights_behind_the_true_surface(angle in 0.2..0.6_f64, share in 0.1..0.9_f64) {
        let (sin, cos) = sin_cos(angle);
        let leaning = Vector::new(sin, cos, 0.0);
        // by `share · angle` below the plane y = 0
        let (sin_below, cos_below) = sin_cos(share * angle);
        let light = Vector::new(cos_below, -sin_below, 0.0);
        let mut scene = lit(disk(Vector::new(0.0, 1.0, 0.0), leaning, white()), sun(light));
        let vertices =
            [[-9.0, 0.0, -9.0], [0.0, 0.0, 9.0], [9.0, 0.0, -9.0]].map(|[x, y, z]| Point::new(x, y, z));
        let normals = Some([leaning; 3]);
        scene.objects = vec![Object::new("disk", "disk", Triangle { vertices, normals })];
        match reason(&scene) {
            Unlit::BehindTrueSurface { cos_i, cos_shading, edges } => {
                prop_assert!(near(cos_i, -sin_below) && near(cos_shading, leaning.dot(light)));
                prop_assert_eq!(edges, None, "a triangle alone is not in its own way");
            }
            other => prop_assert!(false, "{other:?}"),
        }
    }

    /// Law: where a mesh is in the way of light to itself, a light above the true surface is blocked by it, one below is at
    /// the shadow terminator, and both say how many mean edges of the triangle away; another object is not the own mesh.
    /// Oracle: the distance `d / cos` to a wall at `x = d` along the light, and the edges by Pythagoras; a scaled instance
    /// has the same ratio, and none is told if its textures, and so their coordinates, are left in place.
    #[test]
    fn a_mesh_in_its_own_way_is_so_many_edges_away(
        (angle, share, d) in (0.2..0.6_f64, -0.9..0.9_f64, 0.3..0.9_f64),
        (is_one, placing) in (any::<bool>(), 0..3),
    ) {
        prop_assume!(share.abs() > 0.1);
        let ((sin, cos), (sin_below, cos_below)) = (sin_cos(angle), sin_cos(share * angle));
        let leaning = Vector::new(sin, cos, 0.0);
        let light = Vector::new(cos_below, -sin_below, 0.0);
        let of = |parts: &[([[f64; 3]; 3], Vector)]| Mesh {
            normals: Some(parts.iter().flat_map(|(_, normal)| [*normal; 3]).collect()),
            smooth: true,
            ..Mesh::of_lists(
                parts.iter().flat_map(|(points, _)| points.map(Point::from)).collect(),
                (0..parts.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
            )
        };
        let floor = ([[-9.0, 0.0, -9.0], [0.0, 0.0, 9.0], [9.0, 0.0, -9.0]], leaning);
        let wall = ([[d, -99.0, -99.0], [d, -99.0, 99.0], [d, 99.0, 0.0]], -Vector::X);
        let placed = |mesh: Mesh| {
            let scaled = Instance::new(mesh.clone(), vec![Step::Scale(Vector::new(0.5, 0.5, 0.5))]);
            match placing {
                0 => Kind::from(mesh),
                1 => scaled.into(),
                _ => Instance { transform_texture: false, ..scaled }.into(),
            }
        };
        let mut scene = lit(disk(Vector::Y, Vector::Y, white()), sun(light));
        scene.objects = match is_one {
            true => vec![Object::new("both", "disk", placed(of(&[floor, wall])))],
            false => [("floor", floor), ("wall", wall)]
                .map(|(name, mesh)| Object::new(name, "disk", placed(of(&[mesh])))).to_vec(),
        };
        let (found, is_blocked) = match reason(&scene) {
            Unlit::Blocked { edges, .. } => (edges, true),
            Unlit::BehindTrueSurface { edges, .. } => (edges, false),
            other => return Err(TestCaseError::fail(format!("{other:?}"))),
        };
        prop_assert_eq!(is_blocked, share < 0.0);
        let mean_edge = (18.0 + 2.0 * (81.0 + 324.0_f64).sqrt()) / 3.0;
        match found {
            Some(edges) => {
                prop_assert!(is_one && placing < 2 && near(edges, d / cos_below / mean_edge), "{edges}");
            }
            None => prop_assert!(!is_one || placing == 2),
        }
    }

    /// Law: a hit outside the cone of a spot light has its angle to the axis. Oracle: the arc cosine.
    #[test]
    fn hits_outside_a_cone((axis, towards) in (unit(), unit()), outer in 1.0..80.0_f64) {
        let y = Vector::new(0.0, 1.0, 0.0);
        prop_assume!(towards.dot(y) > 0.1);
        let angle = to_degrees(acos(-towards.dot(axis)));
        prop_assume!(angle > outer + 1e-3);
        let location = Point::ORIGIN + 3.0 * towards;
        let (ls, color, inner, attenuation) = (1.0, Rgb::WHITE, 0.5 * outer, 0.0);
        let spot = Spot { ls, color, location, direction: axis, inner, outer, attenuation };
        match reason(&lit(disk(y, y, white()), spot)) {
            Unlit::OutsideCone { angle: found, outer: found_outer } => {
                // the arc cosine loses digits near 0 and 180 degrees
                prop_assert!((found - angle).abs() < 1e-5 && found_outer == outer, "{found}, {angle}");
            }
            other => prop_assert!(false, "{other:?}"),
        }
    }

    /// Law: a hit behind a one-sided lamp has the lamp's cosine. Oracle: the dot product with the only
    /// point of a lamp too small to matter.
    #[test]
    fn hits_behind_a_lamp((normal, towards) in (unit(), unit())) {
        let y = Vector::new(0.0, 1.0, 0.0);
        let cosine = -normal.dot(towards);
        // the camera, straight above, does not see the lamp
        prop_assume!((0.1..0.99).contains(&towards.dot(y)) && cosine < -0.05);
        let mut scene = disk(y, y, white());
        scene.materials.push(Material::new("lamp", Emissive::new(1.0, Rgb::WHITE)));
        let center = Point::ORIGIN + 3.0 * towards;
        let lamp = Disk { center, normal, radius: 1e-14 };
        scene.objects.push(Object::new("lamp", "lamp", lamp));
        let sampling = Some(Sampling::Area);
        match reason(&lit(scene, Area { object: "lamp".to_owned(), sampling })) {
            Unlit::BehindLamp { cos_lamp } => prop_assert!(near(cos_lamp, cosine)),
            other => prop_assert!(false, "{other:?}"),
        }
    }
}

/// A white lamp above the disk, not seen by the camera.
fn under_a_lamp(tracer: Tracer) -> Scene {
    let mut scene = lit(
        disk(Vector::Y, Vector::Y, Matte { ka: 1.0.into(), ..white() }),
        Area { object: "lamp".to_owned(), sampling: None },
    );
    scene.materials.push(Material::new("lamp", Emissive::new(1.0, Rgb::WHITE)));
    let corner = Point::new(1.0, 2.0, -1.0);
    let (a, b) = (Vector::new(2.0, 0.0, 0.0), Vector::new(0.0, 0.0, 2.0));
    scene.objects.push(Object::new("lamp", "lamp", Rectangle { corner, a, b }));
    scene.lights.push(Light::new("sky", Ambient { ls: 1.0, color: Rgb::WHITE }));
    scene.lights.push(Light::new("sun", sun(Vector::new(0.3, 1.0, 0.0))));
    scene.tracer = tracer;
    scene
}

/// Law: a tracer that does not sample a light says so. Oracle: the table of tracers in `docs/scene.md`:
/// `path_trace` samples none and cannot meet a sun, `global_trace` and `path` with depth 0 would send an edge
/// too many, and no path counts ambient light.
#[test]
fn tracers_that_do_not_sample() {
    let depth = |max_depth| Depth { max_depth };
    let expected = [
        (Tracer::PathTrace(depth(3)), [Unlit::NotSampled, Unlit::LeftOut, Unlit::LeftOut]),
        (Tracer::GlobalTrace(depth(0)), [Unlit::TooDeep, Unlit::LeftOut, Unlit::TooDeep]),
        (Tracer::Path(depth(0)), [Unlit::TooDeep, Unlit::LeftOut, Unlit::TooDeep]),
    ];
    for (tracer, expected) in expected {
        let found: Vec<_> = ray(&under_a_lamp(tracer)).unlit.into_iter().collect();
        let names: Vec<_> = found.iter().map(|unlit| &*unlit.light).collect();
        assert_eq!(names, ["light", "sky", "sun"], "{tracer:?}");
        let reasons: Vec<_> = found.into_iter().map(|unlit| unlit.reason).collect();
        assert_eq!(reasons, expected, "{tracer:?}");
    }
    // the second hit of a path, inside a closed room
    let mut room = super::paths::room(0.5, 0.0, 1);
    room.tracer = Tracer::GlobalTrace(depth(3));
    let first = ray(&room);
    let second = first.children.iter().find(|ray| ray.depth == 1 && ray.hit.is_some());
    let second = second.filter(|ray| !ray.unlit.is_empty()).expect("the path goes on");
    assert_eq!(second.unlit[0].reason, Unlit::FirstHitOnly);
}

/// One change of a scene whose camera's ray is then black, or not.
#[derive(Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Case {
    light: String,
    recipe: String,
    lights: Option<String>,
    objects: String,
    before: String,
    says: Option<String>,
    child: Option<String>,
}

impl Default for Case {
    fn default() -> Case {
        let disk = "shape.disk = { center = [0, 0, 0], normal = [0, 1, 0], radius = 1 }";
        Case {
            light: "directional = { direction = [0.3, 1, 0] }".to_owned(),
            recipe: "matte = { ka = 0, kd = 0.5, cd = 1 }".to_owned(),
            lights: None,
            objects: format!("{{ name = \"disk\", material = \"disk\", {disk} }}"),
            before: String::new(),
            says: None,
            child: None,
        }
    }
}

/// Law: a black ray says which of its factors is 0, light by light, and one that is not black says nothing.
/// Oracle: a table of scenes in which one factor is 0, and the words for it.
#[test]
fn a_black_ray_says_why() {
    let table: BTreeMap<String, Vec<Case>> =
        toml::from_str(include_str!("black.toml")).expect("cases");
    let mut wrong = Vec::new();
    for case in &table["case"] {
        let Case { light, recipe, objects, before, .. } = case;
        let own = format!("{{ name = \"light\", source = {{ {light} }} }}");
        let lights = case.lights.as_ref().unwrap_or(&own);
        let text = format!(
            "{before}\nimage = {{ width = 1, height = 1, pixel_size = 1e-6 }}\ncamera.eye = [0, 5, 0]\n\
             camera.look_at = [0, 0, 0]\ncamera.up = [0.3, 0.5, -0.8]\ncamera.lens.orthographic = {{}}\n\
             lights = [{lights}]\nmaterials = [{{ name = \"disk\", recipe = {{ {recipe} }} }}]\n\
             objects = [{objects}]\n"
        );
        let (scene, _) = scenefile::from_toml(&text, Path::new("scene.toml"))
            .unwrap_or_else(|e| panic!("{e}: {text}"));
        let ray = ray(&scene);
        let child = case.child.as_ref().and_then(|_| ray.children[0].black.as_ref());
        if (&ray.black, child) != (&case.says, case.child.as_ref())
            || ray.radiance.is_black() != case.says.is_some()
        {
            wrong.push(format!("{:?} and {child:?}: {text}", ray.black));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
