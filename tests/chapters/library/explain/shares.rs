//! What each term adds to its sample, and where the path of the light ends.

use std::iter::successors;

use explain::{RecordedRay, RecordedTerm};
use groundtruth::math::sin_cos;
use scenefile::from_toml;

use super::{UNDER_WATER, all, nested_glass_of};
use crate::prelude::*;
use crate::support::stage::recorded;

/// The tree of the only pixel of a scene file.
fn tree_of(text: &str) -> RecordedRay {
    let (scene, world) = from_toml(text, Path::new("scene.toml")).expect("it is valid");
    explain::sample(&scene, &world, [0, 0], 0).ray.expect("the camera sees all its film")
}

/// The radiance of a ray if one term of the tree, by its ray's number and its place there, were left out.
fn without(ray: &RecordedRay, left_out: (usize, usize)) -> Rgb {
    let value = |(index, term): (usize, &RecordedTerm)| match term.ray {
        _ if (ray.number, index) == left_out => Rgb::BLACK,
        Some(number) => term.weight * without(ray.child(number).expect("a child"), left_out),
        None => term.value,
    };
    ray.transmittance * ray.terms.iter().enumerate().map(value).sum()
}

/// Law: the contribution of every term is its share of the sample, in media that colour the light too; a ray's own
/// contribution is that of its terms without a ray, and with its children's shares it makes the ray's share.
/// Oracle: the sample with and without the term, added up again; the sums.
#[test]
fn each_term_adds_what_the_sample_has_less_without_it() {
    for root in [nested_glass_of(Rgb::new(0.3, 0.05, 0.7)), tree_of(UNDER_WATER)] {
        let sample = without(&root, (usize::MAX, 0));
        let mut count = 0;
        for ray in all(&root) {
            for (index, term) in ray.terms.iter().enumerate() {
                let expected = sample + -1.0 * without(&root, (ray.number, index));
                let apart = (term.contribution + -1.0 * expected).map(f64::abs).max();
                assert!(apart < 1e-14, "ray {}: {term:?}, not {expected:?}", ray.number);
                let share = expected.average() / sample.average();
                assert!(
                    (term.share - share).abs() < 1e-13,
                    "ray {}: {term:?}, not {share}",
                    ray.number
                );
                count += u32::from(share > 0.0);
            }
            let local = ray.terms.iter().filter(|term| term.ray.is_none());
            let own: Rgb = local.map(|term| term.contribution).sum();
            close!(ray.own_contribution, own, 1e-12, "ray {}", ray.number);
            let children: f64 = ray.children.iter().map(|child| child.share).sum();
            near!(children + own.average() / sample.average(), ray.share, 1e-12);
        }
        assert!(count >= 2, "only {count} terms add light");
    }
}

/// A mirror over a bright floor that mirrors a little itself.
const MIRRORED_FLOOR: &str = include_str!("mirrored_floor.toml");

/// Law: the path of the light takes the child that adds most, and ends where a ray's own light adds more, be it
/// inside the tree; the text shows no ray beyond it. Oracle: every child compared; a floor that shines by its own
/// light nine times as much as it mirrors.
#[test]
fn the_path_of_the_light_follows_the_largest() {
    let paths = [nested_glass_of(Rgb::BLACK), tree_of(MIRRORED_FLOOR)].map(|root| {
        let path: Vec<_> = successors(Some(&root), |ray| ray.largest_child()).collect();
        for (i, ray) in path.iter().enumerate() {
            let own = ray.own_contribution.average() / root.contribution.average();
            let chosen = path.get(i + 1).map_or(own, |next| next.share);
            let most = ray.children.iter().map(|child| child.share).fold(0.0, f64::max);
            at_most!(most, chosen, "ray {}", ray.number);
        }
        let numbers: Vec<usize> = path.iter().map(|ray| ray.number).collect();
        let found = root.path_to(numbers[numbers.len() - 1]);
        assert_eq!(found.iter().map(|ray| ray.number).collect::<Vec<_>>(), numbers);
        assert!(root.path_to(usize::MAX).is_empty());
        let name = |ray: &&RecordedRay| ray.hit.as_ref().map(|hit| hit.object.to_string());
        path.iter().filter_map(name).collect::<Vec<_>>()
    });
    at_least!(paths[0].len(), 4, "boundaries of the glass");
    assert_eq!(paths[1], ["mirror", "floor"]);
    let (scene, world) = from_toml(MIRRORED_FLOOR, Path::new("scene.toml")).expect("it is valid");
    let explained = explain::pixel(&scene, &world, [0, 0], None).expect("few rays");
    let shown = |largest| explained.text(0.0, largest).matches("contributes").count();
    let whole = all(&tree_of(MIRRORED_FLOOR)).len();
    assert_eq!((shown(true), shown(false)), (2, whole));
    above!(whole, 2, "rays: the floor mirrors something");
}

/// Law: the angle of incidence is that to the true normal, wherever the shading normals lean. Oracle: a triangle
/// that is turned by a known angle from the ray.
#[test]
fn the_angle_of_incidence_is_to_the_true_normal() {
    for (degrees, lean) in
        [0.0, 20.0, 65.0].into_iter().flat_map(|a| [0.0, 0.3, -0.5].map(|b| (a, b)))
    {
        let (sin, cos) = sin_cos(to_radians(degrees));
        let vertices =
            [(-3.0, -3.0), (3.0, -3.0), (0.0, 4.0)].map(|(x, y)| Point::new(x * cos, y, -x * sin));
        let normals = Some([Vector::new(sin, lean, cos); 3]);
        let mut scene = stage(Rgb::BLACK);
        put(&mut scene, Triangle { vertices, normals }, matte(0.0, 1.0, Rgb::WHITE));
        let hit =
            recorded(&built(&scene), Point::new(0.0, 0.0, 5.0), -Vector::Z).root().hit.clone();
        let hit = hit.expect("it is met");
        near!(hit.angle_of_incidence, degrees, 1e-6, "lean {lean}");
        // rounded, it may differ from the true one by a bit
        let cosine = hit.shading_normal.dot(hit.normal);
        assert_eq!(cosine > 1.0 - 1e-12, lean == 0.0, "{degrees}°, lean {lean}");
    }
}
