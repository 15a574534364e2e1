//! Paths: the densities and MIS shares of each bounce; its lines.

use explain::{Outline, RecordedRay, RecordedTerm, Row};
use groundtruth::shapes::Sampling;
use groundtruth::trace::TermSource;

use super::{all, reads_as_before};
use crate::prelude::*;

/// The side of the lamp, and its height.
const SIDE: f64 = 2.0;
const HEIGHT: f64 = 1.5;
/// The exponent of the walls' highlights.
const EXPONENT: f64 = 10.0;

/// A spherical room with these walls and a square lamp that faces down; the camera is below the lamp.
pub fn room(kd: f64, ks: f64, samples: u32) -> Scene {
    let lens = Orthographic { zoom: 1.0 };
    let camera = Viewpoint::new(Point::ORIGIN, Point::new(0.3, -1.0, 0.2), lens);
    let mut scene = Scene::new("", Image { samples, ..Image::new(1, 1) }, camera);
    scene.tracer = Tracer::Path(Depth { max_depth: 10 });
    let lamp = Rectangle {
        corner: Point::new(-0.5 * SIDE, HEIGHT, -0.5 * SIDE),
        a: Vector::new(SIDE, 0.0, 0.0),
        b: Vector::new(0.0, 0.0, SIDE),
    };
    let (cd, cs) = (Rgb::WHITE.into(), Rgb::WHITE.into());
    scene.materials = vec![
        Material::new("lamp", Emissive::new(2.0, Rgb::new(1.0, 0.5, 0.25))),
        Material::new(
            "wall",
            Phong {
                ka: 0.0.into(),
                kd: kd.into(),
                cd,
                ks: ks.into(),
                cs,
                exponent: EXPONENT.into(),
            },
        ),
    ];
    scene.objects = vec![
        Object::new("lamp", "lamp", lamp),
        Object::new("wall", "wall", Sphere { center: Point::ORIGIN, radius: 3.0, inward: true }),
    ];
    let sampling = Some(Sampling::Area);
    scene.lights = vec![Light::new("lamp", Area { object: "lamp".to_owned(), sampling })];
    scene
}

/// The camera's rays of the samples of a room.
fn paths(scene: &Scene) -> Vec<RecordedRay> {
    let world = World::build(scene).expect("the scene is valid");
    let samples = explain::pixel(scene, &world, [0, 0], None).expect("few rays").samples;
    samples.into_iter().filter_map(|sample| sample.ray).collect()
}

/// The continuing rays of a path. Each comes with its parent, whose hit sent it, and with the parent's term
/// that receives its light: (parent, term, ray).
fn bounces(root: &RecordedRay) -> Vec<(&RecordedRay, &RecordedTerm, &RecordedRay)> {
    let mut bounces = Vec::new();
    for hit in all(root) {
        for ray in hit.children.iter().filter(|ray| !ray.is_shadow()) {
            let mut terms = hit.terms.iter();
            let term = terms.find(|term| term.ray == Some(ray.number)).expect("its light counts");
            bounces.push((hit, term, ray));
        }
    }
    bounces
}

/// Cosines between a direction and the normal of a hit, and between it and the mirrored incoming ray.
fn cosines(hit: &RecordedRay, direction: Vector) -> [f64; 2] {
    let normal = Vector::from(hit.hit.as_ref().expect("it scatters").normal);
    let came = hit.ray.direction;
    let mirrored = came - (2.0 * normal.dot(came)) * normal;
    [normal.dot(direction), mirrored.dot(direction).max(0.0)]
}

/// The densities of cosine-weighted directions and of Phong's highlight.
fn densities([cos_i, cos_r]: [f64; 2]) -> [f64; 2] {
    [cos_i / PI, (EXPONENT + 1.0) / (2.0 * PI) * power(cos_r, EXPONENT)]
}

/// The density with which the square lamp is sampled from a point: `d²/(A cosθ')`.
fn by_lamp(at: Point, direction: Vector) -> f64 {
    let distance = (HEIGHT - at.y()) / direction.y();
    distance * distance / (SIDE * SIDE * direction.y())
}

/// Directions have an error of about 1e-15; the tenth power of a small cosine has ten times the cosine's
/// relative error.
const ROUNDING: f64 = 1e-9;

fn near(found: f64, expected: f64) -> bool {
    (found - expected).abs() <= ROUNDING * expected.abs().max(1e-3)
}

/// Law: the weight of a lobe's ray is `f cosθ / (pdf · chance · survival)`, with the density of the lobe
/// that drew it. Oracle: the formulas of both lobes and both densities, from directions and normals.
#[test]
fn the_weight_of_a_bounce_is_its_factors() {
    let (kd, ks) = (0.5, 0.3);
    let (mut by, mut ended) = ([0, 0], 0);
    // few paths come as deep as roulette
    for root in &paths(&room(kd, ks, 1024)) {
        for (hit, term, ray) in bounces(root) {
            let TermSource::Traced { lobe, pdf, lobe_probability: chance, survival } = &term.source
            else {
                panic!("a lobe sent it: {term:?}");
            };
            let cosines @ [cos_i, cos_r] = cosines(hit, ray.ray.direction);
            let (which, f) = match lobe {
                Lobe::Lambertian(_) => (0, kd / PI),
                Lobe::GlossySpecular(_) => (1, ks * power(cos_r, EXPONENT)),
                other => panic!("the wall has no {}", other.name()),
            };
            let (density, pdf) = (densities(cosines)[which], pdf.expect("it is drawn"));
            assert!(near(pdf, density), "{}: pdf {pdf}, not {density}", lobe.name());
            let (found, expected) = (term.weight.g * pdf * chance * survival, f * cos_i);
            assert!(near(found, expected), "{}: {found}, not {expected}", lobe.name());
            let right = *chance > 0.0 && *chance < 1.0 && *survival <= 1.0;
            assert!(right, "probabilities {chance} of the lobe and {survival} of survival");
            assert!(ray.depth > 5 || *survival == 1.0, "roulette begins at depth 5");
            by[which] += 1;
            ended += usize::from(*survival < 1.0);
        }
    }
    assert!(by.iter().all(|&count| count > 50) && ended > 20, "{by:?}, {ended}");
}

/// Law: emission met by a lobe's ray has the MIS weight `p²/(p² + q²)`, a light sample `q²/(p² + q²)`: `p` is
/// the density of the direction by all lobes, `q` by the lamp. Oracle: both densities by their formulas.
#[test]
fn mis_shares_are_those_of_the_densities() {
    let (mut met, mut sampled) = (0, 0);
    for root in &paths(&room(0.5, 0.3, 1024)) {
        for (hit, term, ray) in bounces(root) {
            let TermSource::Traced { lobe, lobe_probability: chance, .. } = &term.source else {
                panic!("a lobe sent it: {term:?}");
            };
            let diffuse = if lobe.name() == "Lambertian" { *chance } else { 1.0 - chance };
            let by_lobes = |direction: Vector| {
                let [spread, highlight] = densities(cosines(hit, direction));
                diffuse * spread + (1.0 - diffuse) * highlight
            };
            let at = hit.hit.as_ref().expect("it scatters").point;
            for term in &ray.terms {
                let TermSource::Emission { mis } = term.source else { continue };
                let direction = ray.ray.direction;
                let (p, q) = (by_lobes(direction), by_lamp(at, direction));
                let (mis, expected) = (mis.expect("the lamp is sampled"), p * p / (p * p + q * q));
                assert!(near(mis, expected), "met: {mis}, not {expected}");
                assert_eq!(term.weight, Rgb::grey(mis));
                met += 1;
            }
            let shadows = hit.children.iter().filter(|ray| ray.is_shadow());
            for (term, shadow) in hit.terms.iter().zip(shadows) {
                let TermSource::Direct { pdf, mis, .. } = term.source else { continue };
                let direction = shadow.ray.direction.unit().expect("it has one");
                let (p, q) = (by_lobes(direction), by_lamp(at, direction));
                let (mis, expected) = (mis.expect("lobes are sampled"), q * q / (p * p + q * q));
                assert!(near(pdf.expect("it is drawn"), q), "pdf {pdf:?}, not {q}");
                assert!(near(mis, expected), "sampled: {mis}, not {expected}");
                sampled += 1;
            }
        }
    }
    assert!(met > 50 && sampled > 500, "{met} met, {sampled} sampled");
}

/// Law: emission that the camera sees directly has weight 1 and no MIS share. Oracle: the lamp.
#[test]
fn what_the_camera_sees_has_no_mis_share() {
    let mut scene = room(0.5, 0.3, 1);
    scene.camera.look_at = Point::new(0.0, 1.0, 0.01);
    scene.camera.up = Vector::X;
    let root = &paths(&scene)[0];
    let TermSource::Emission { mis: None } = root.terms[0].source else { panic!("{root:?}") };
    assert_eq!((root.terms[0].weight, root.radiance), (Rgb::WHITE, Rgb::new(2.0, 1.0, 0.5)));
}

/// The text of each ray of a path and of its own light. The numbers are checked above; this golden shows
/// changes of the text.
#[test]
fn the_lines_of_a_path_read_as_before() {
    let paths = paths(&room(0.5, 0.3, 64));
    let late = |ray: &RecordedRay| ray.depth > 1 && ray.own_contribution != Rgb::BLACK;
    let meets = |root: &&RecordedRay| all(root).into_iter().any(late);
    let root = paths.iter().find(meets).expect("a path meets the lamp late");
    let rows = Outline::default().rows(root);
    let said = rows.iter().map(|row| match row {
        Row::Ray { ray, term, indent } => {
            let sampling = term.map_or(String::new(), RecordedTerm::sampling);
            format!("{}{}  {sampling}", "    ".repeat(*indent), ray.line())
        }
        Row::Local { term, indent } => format!("{}{}", "    ".repeat(*indent), term.line()),
        Row::Folded { .. } => panic!("nothing is small"),
    });
    reads_as_before("path.txt", &said.collect::<Vec<_>>().join("\n"));
}
