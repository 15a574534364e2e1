//! Layers against explanations of the same pixels, which find the same by the tree of rays: from the camera down,
//! throughput by throughput, where layers add up from the ends of rays to the camera.

use explain::{PixelExplanation, RecordedHit, RecordedRay, RecordedTerm};
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Scene, TransparentShadows};
use groundtruth::trace::{Outcome, RayKind, TermSource};
use groundtruth::world::World;
use layers::{Layer, Part};

use super::scenes::{named, random_pixels, small};

/// Two orders of a sum of a thousand products of a dozen factors differ by less, relative to the sum of magnitudes.
const ROUNDING: f64 = 1e-11;

/// A pixel explained, with all its samples.
struct Explained {
    explanation: PixelExplanation,
    pixel: [u32; 2],
}

impl Explained {
    fn of(scene: &Scene, world: &World, pixel: [u32; 2]) -> Option<Self> {
        let explanation = explain::pixel(scene, world, pixel, None).ok()?;
        explanation
            .samples
            .iter()
            .all(|sample| sample.complete)
            .then_some(Self { explanation, pixel })
    }

    /// The rays of all samples.
    fn rays(&self) -> Vec<&RecordedRay> {
        let roots = self.explanation.samples.iter().filter_map(|sample| sample.ray.as_ref());
        roots.flat_map(RecordedRay::rays).collect()
    }

    /// What the hit of the sample nearest to the centre is.
    fn centre_hit(&self, world: &World) -> Option<&RecordedHit> {
        let sample = render::camera_sample(world, self.pixel, 0)?;
        let [x, y] = render::film_point(&world.image, sample.pixel, [0.5, 0.5]);
        let mut nearest: Option<(f64, &explain::SampleExplanation)> = None;
        for sample in &self.explanation.samples {
            let [film_x, film_y] = sample.film?;
            let [dx, dy] = [film_x - x, film_y - y];
            let distance = dx * dx + dy * dy;
            if nearest.is_none_or(|(least, _)| distance < least) {
                nearest = Some((distance, sample));
            }
        }
        nearest?.1.ray.as_ref()?.hit.as_ref()
    }

    /// What the terms that `of` takes add to the pixel, and the sum of their magnitudes; `of` gets each term that ends
    /// a path, its ray, and the term of the camera's ray that leads to it.
    fn sum(&self, of: impl Fn(&RecordedRay, &RecordedTerm, &RecordedTerm) -> bool) -> Rgb {
        let factor = self.explanation.exposure_time / f64::from(self.explanation.samples_per_pixel);
        let mut sum = Rgb::BLACK;
        let roots = self.explanation.samples.iter().filter_map(|sample| sample.ray.as_ref());
        for root in roots {
            for first in &root.terms {
                let is_traced = matches!(first.source, TermSource::Traced { .. });
                let child = first.ray.filter(|_| is_traced).and_then(|ray| root.child(ray));
                let rays = child.map_or(vec![root], RecordedRay::rays);
                for ray in rays {
                    let own = if is_traced { &ray.terms[..] } else { std::slice::from_ref(first) };
                    let ends = own.iter().filter(|term| {
                        !matches!(term.source, TermSource::Traced { .. } | TermSource::Light { .. })
                    });
                    let taken = ends.filter(|term| of(ray, term, first));
                    sum += factor * taken.map(|term| term.contribution).sum::<Rgb>();
                }
            }
        }
        sum
    }

    fn of_part(&self, kind: &str, part: &Part) -> Rgb {
        self.sum(|ray, term, first| match (kind, part) {
            ("emission", _) => matches!(term.source, TermSource::Emission { .. }),
            ("background", _) => matches!(term.source, TermSource::Background { .. }),
            (_, Part::Light(_, light)) => term.light.as_ref() == Some(light),
            (_, Part::Depth(depth)) => ray.depth == *depth,
            (_, Part::Lobe(name)) => match &first.source {
                TermSource::Traced { lobe, .. } | TermSource::Direct { lobe, .. } => {
                    lobe.name() == *name
                }
                _ => false,
            },
            _ => unreachable!("{kind} is no part"),
        })
    }

    /// The value that a layer must have.
    fn value(&self, layer: &Layer, world: &World) -> Option<Rgb> {
        let (rays, explanation) = (self.rays(), &self.explanation);
        let hit = self.centre_hit(world);
        let is_cast = |ray: &&&RecordedRay| {
            !matches!(ray.kind, RayKind::Shadow { .. }) && ray.outcome != Outcome::TooDeep
        };
        let index_of = |names: &[&str], name: &str| names.iter().position(|it| *it == name);
        let number = |number: f64| Some(Rgb::grey(number));
        match layer.kind().name {
            "picture" => Some(explanation.radiance),
            "normal" => Some(hit?.normal.to_array().into()),
            "shading-normal" => Some(hit?.shading_normal.to_array().into()),
            "distance" => number(hit?.t),
            "object" => number(index_of(&layer.names(world)?, &hit?.object)? as f64),
            "material" => number(index_of(&layer.names(world)?, &hit?.material)? as f64),
            "tree-depth" => {
                number(rays.iter().filter(is_cast).map(|ray| ray.depth).max().unwrap_or(0).into())
            }
            "rays" => number(rays.len() as f64),
            "variance" | "error" => {
                let count = f64::from(explanation.samples_per_pixel);
                let error = explanation.statistics.standard_error.unwrap_or(Rgb::BLACK);
                let error = explanation.exposure_time * error;
                let variance = layer.kind().name == "variance";
                Some(if variance { error.map(|error| count * error * error) } else { error })
            }
            kind => Some(self.of_part(kind, layer.part())),
        }
    }
}

/// Whether two values are equal but for rounding, relative to `scale`.
fn near(a: Option<Rgb>, b: Option<Rgb>, scale: f64) -> bool {
    match (a, b) {
        (None, None) => true,
        (Some(a), Some(b)) => (0..3).all(|k| {
            let [a, b] = [a, b].map(|it| it.to_array()[k]);
            a == b || (a.is_nan() && b.is_nan()) || (a - b).abs() <= ROUNDING * scale.max(a.abs())
        }),
        _ => false,
    }
}

/// Checks all layers at some pixels of a scene; returns how many pixels could be explained.
fn check(name: &str, (scene, world): &(Scene, World), pixels: u32) -> usize {
    let mut checked = 0;
    for pixel in random_pixels(world, pixels) {
        let Some(explained) = Explained::of(scene, world, pixel) else { continue };
        checked += 1;
        let all = Layer::all(world, pixel);
        let largest = explained.explanation.radiances.iter().map(|it| it.max()).fold(0.0, f64::max);
        let scale = largest * explained.explanation.exposure_time;
        for (layer, value) in &all {
            // the tree does not have them
            if ["uv", "tests", "steps"].contains(&layer.kind().name) {
                continue;
            }
            let scale = match layer.kind().name {
                "variance" => scale * scale,
                _ => scale,
            };
            let wanted = explained.value(layer, world);
            assert!(
                near(*value, wanted, scale),
                "{name}, {pixel:?}: {layer} is {value:?}, by the explanation {wanted:?}"
            );
            assert_eq!(
                layer.value(world, pixel).map(Rgb::to_array),
                value.map(Rgb::to_array),
                "{name}, {pixel:?}: {layer} alone"
            );
        }
        sums(name, pixel, &all, scale);
    }
    checked
}

/// The parts by light and those without one, and the parts by depth, add up to the picture.
fn sums(name: &str, pixel: [u32; 2], all: &[(Layer, Option<Rgb>)], scale: f64) {
    let sum = |kinds: &[&str]| -> Rgb {
        let parts = all.iter().filter(|(layer, _)| kinds.contains(&layer.kind().name));
        parts.filter_map(|(_, value)| *value).sum()
    };
    let picture = sum(&["picture"]);
    for kinds in [&["light", "emission", "background"][..], &["depth"]] {
        let parts = sum(kinds);
        let (parts, picture) = (Some(parts), Some(picture));
        assert!(near(parts, picture, scale), "{name}, {pixel:?}: {kinds:?} {parts:?} {picture:?}");
    }
}

/// Law: layers equal what an explanation of the pixel says, and the parts of the sum add up to it. Oracle: the tree of
/// rays of all samples.
#[test]
fn layers_equal_explanations() {
    let of_all_kinds = [
        ("ch04/checker-mitchell", 24, 4),
        ("ch14/page-one", 24, 4),
        ("ch18/rectangle", 12, 4),
        ("ch23/smooth-sphere", 24, 1),
        ("ch24/hall-of-mirrors", 16, 2),
        ("ch26/cornell-box", 8, 2),
        ("ch28/glass-sphere", 24, 2),
        ("ch28/ten-blocks", 24, 2),
    ];
    for (name, width, samples) in of_all_kinds {
        assert_eq!(check(name, &named(name, width, samples), 24), 24, "{name}");
    }
    for entry in gallery::scenes().filter(|_| testkit::is_thorough()) {
        let checked = check(entry.name, &small(&(entry.build)(), 48, 4), 200);
        assert!(checked >= 150, "{}: {checked} of 200 pixels could be explained", entry.name);
    }
    // a quarter of the time has a quarter of the light, and a sixteenth of its variance
    let (mut scene, _) = named("ch18/rectangle", 12, 4);
    scene.camera.exposure_time = 0.25;
    let world = World::build(&scene).expect("valid");
    assert_eq!(check("a quarter of the exposure time", &(scene, world), 24), 24, "pixels checked");
}

/// The objects that a recorded ray tests with the method *list*: all in each search for a first hit; for a shadow ray that
/// looks for any object, those up to the one that it finds, of which those without an end come first.
fn tests_in_a_list(world: &World, ray: &RecordedRay) -> usize {
    let objects = world.objects();
    let is_attenuated = world.transparency.shadows == TransparentShadows::Attenuated;
    match ray.outcome {
        Outcome::Hit | Outcome::Background => objects.len(),
        Outcome::TooDeep | Outcome::OverBudget => 0,
        // from surface to surface, and from the last to the light
        Outcome::Unblocked { boundaries } if is_attenuated => {
            (boundaries as usize + 1) * objects.len()
        }
        Outcome::Unblocked { .. } => objects.len(),
        Outcome::Blocked { .. } => {
            let (bounded, unbounded): (Vec<_>, Vec<_>) =
                objects.iter().partition(|object| object.shape.bounds().is_bounded());
            let by = ray.blocked_by.as_ref().expect("an object");
            let mut order = unbounded.iter().chain(&bounded);
            1 + order.position(|object| object.name == *by).expect("an object of the world")
        }
    }
}

/// Law: with the method *list*, the layer `tests` is what all rays test, shadow rays too: blocked by a plane and by bounded
/// objects, unblocked, and straight through glass. Oracle: the tree of rays, and the order of a list, by hand.
#[test]
fn a_list_tests_every_object_for_every_ray_shadow_rays_too() {
    let mut kinds = [0; 3];
    for name in ["ch16/shadows", "ch24/hall-of-mirrors", "ch28/glass-sphere", "ch28/tinted-shadows"]
    {
        let (mut scene, _) = named(name, 24, 1);
        scene.accel = groundtruth::accel::Method::List;
        let world = World::build(&scene).expect("valid");
        let tests = Layer::named("tests", &world).expect("a layer");
        for pixel in random_pixels(&world, 120) {
            let explained = Explained::of(&scene, &world, pixel).expect("small");
            let rays = explained.rays();
            let blocks = |ray: &&RecordedRay| matches!(ray.outcome, Outcome::Blocked { .. });
            if name == "ch28/tinted-shadows" && rays.iter().any(blocks) {
                // the surfaces before the blocker are not recorded
                continue;
            }
            for ray in &rays {
                match ray.outcome {
                    Outcome::Blocked { .. } => kinds[0] += 1,
                    Outcome::Unblocked { boundaries: 0 } => kinds[1] += 1,
                    Outcome::Unblocked { .. } => kinds[2] += 1,
                    _ => {}
                }
            }
            let wanted: usize = rays.iter().map(|ray| tests_in_a_list(&world, ray)).sum();
            let (found, wanted) = (tests.value(&world, pixel), Rgb::grey(wanted as f64));
            assert_eq!(found, Some(wanted), "objects tested by the pixel {pixel:?} of {name}");
        }
    }
    let is_each = kinds.iter().all(|count| *count > 20);
    assert!(is_each, "rays blocked, unblocked, and through glass: {kinds:?}, not above 20 each");
}

/// Law: texture coordinates are those of the image's look-up, where a hit has one. Oracle: the texel of the recorded
/// texture.
#[test]
fn texture_coordinates_are_those_of_the_look_up() {
    let mut found = 0;
    for entry in gallery::scenes().filter(|entry| entry.name.starts_with("ch29/")) {
        let (scene, world) = small(&(entry.build)(), 16, 1);
        let uv = Layer::named("uv", &world).expect("a layer");
        for pixel in random_pixels(&world, 20) {
            let Some(explained) = Explained::of(&scene, &world, pixel) else { continue };
            let hit = explained.centre_hit(&world);
            let texel = hit.and_then(|hit| hit.textures.iter().find_map(|it| it.texel));
            let Some(texel) = texel else { continue };
            let [u, v] = texel.uv;
            assert_eq!(
                uv.value(&world, pixel),
                Some(Rgb::new(u, v, 0.0)),
                "{} {pixel:?}",
                entry.name
            );
            found += 1;
        }
    }
    assert!(found > 20, "{found} pixels with an image");
}
