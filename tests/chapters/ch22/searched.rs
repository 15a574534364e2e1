//! The same objects searched by every method, and random rays to test them with.

use groundtruth::accel::Accel;

use crate::prelude::*;

/// The hits of the ray with the objects.
pub fn hits(objects: &[Arc<dyn Shape>], ray: &Ray) -> impl Fn(u32, Span) -> Option<Candidate> {
    |index, span| objects[index as usize].hit(ray, span)
}

/// The greatest distance of a ray's origin, in sizes of the scene, at which all methods find the same:
/// see `docs/accuracy.md`.
const FARTHEST: f64 = (1 << 20) as f64;

/// The same objects, searched by every method.
pub struct Both {
    pub objects: Vec<Arc<dyn Shape>>,
    pub list: Accel,
    pub grid: Accel,
    pub tree: Accel,
    whole: Aabb,
}

impl Both {
    pub fn new(objects: Vec<Arc<dyn Shape>>) -> Self {
        let bounds: Vec<Aabb> = objects.iter().map(|object| object.bounds()).collect();
        let [list, grid, tree] = Method::ALL.map(|method| Accel::build(method, &bounds));
        let bounded = bounds.into_iter().filter(Aabb::is_bounded);
        Self { objects, list, grid, tree, whole: bounded.fold(Aabb::EMPTY, Aabb::union) }
    }

    /// All but the list.
    fn others(&self) -> [&Accel; 2] {
        [&self.grid, &self.tree]
    }

    /// Whether the ray starts within [`FARTHEST`] sizes of the scene.
    fn is_near(&self, ray: &Ray) -> bool {
        let size = self.whole.extent().max_abs();
        (ray.origin - self.whole.center()).max_abs() <= FARTHEST * size
    }

    /// Whether anything is hit; fails if the methods disagree on a ray that starts near.
    pub fn check(&self, ray: &Ray, span: Span, case: &str) -> bool {
        let hit = hits(&self.objects, ray);
        let find = |accel: &Accel| {
            let found = accel.nearest(ray, span, &mut (), &hit);
            found.map(|(i, hit)| (i, hit.t.to_bits(), hit.part, hit.parameters.map(f64::to_bits)))
        };
        let first = find(&self.list);
        if !self.is_near(ray) {
            let found = self.others().map(find);
            let inside = found.iter().flatten().all(|(_, t, ..)| span.contains(f64::from_bits(*t)));
            assert!(inside, "{case}: {found:?} outside {span:?}");
            return false;
        }
        for accel in self.others() {
            assert_eq!(find(accel), first, "{case}: {ray:?} in {span:?}");
        }
        let any = |accel: &Accel| Some(accel.any(ray, span, &mut (), |i| hit(i, span))?.1.t);
        let shadows: Vec<_> = [&self.list].into_iter().chain(self.others()).map(any).collect();
        let same = shadows.iter().all(|t| t.is_some() == first.is_some());
        assert!(same, "{case}: shadow of {ray:?} in {span:?}");
        for t in shadows.into_iter().flatten().chain(first.map(|(_, t, ..)| f64::from_bits(t))) {
            assert!(span.contains(t), "{case}: {t:e} outside {span:?}");
        }
        first.is_some()
    }
}

/// A random ray; one in three has zeros of either sign in its direction, and some start very far away.
pub fn ray(draw: &mut Draw, extent: f64) -> Ray {
    let far = if draw.below(4) == 0 { draw.decades(0.0, 6.0) } else { draw.between(0.0, 2.0) };
    let target = draw.point(extent);
    let away = draw.direction();
    let mut direction = draw.decades(-3.0, 3.0) * away;
    let origin = target + (far * extent) * away;
    if draw.below(3) == 0 {
        let mut d = direction.to_array();
        for _ in 0..=draw.below(2) {
            d[draw.below(3)] = draw.pick(&[0.0, -0.0]);
        }
        if d != [0.0; 3] {
            direction = d.into();
            return Ray::new(target - (far * extent / direction.length()) * direction, direction);
        }
    }
    Ray::new(origin, -direction)
}

/// Checks all methods on these rays; fails unless at least one ray in `rarely` hits.
pub fn agree(
    name: &str,
    objects: Vec<Arc<dyn Shape>>,
    rays: impl Iterator<Item = Ray>,
    rarely: usize,
) {
    let both = Both::new(objects);
    let spans = [Span::AHEAD, Span::SEGMENT, Span::LINE, Span { min: 0.25, max: 3.0 }];
    let (mut hits, mut count) = (0, 0);
    for (i, ray) in rays.enumerate() {
        count += 1;
        hits += usize::from(both.check(&ray, spans[0], name));
        both.check(&ray, spans[i % 4], name);
    }
    assert!(hits * rarely >= count && count > 0, "{name}: only {hits} of {count} rays hit");
}

pub fn some_rays(seed: u64, count: usize, extent: f64) -> impl Iterator<Item = Ray> {
    let mut draw = Draw::new(seed);
    (0..count).map(move |_| ray(&mut draw, extent))
}

pub fn spheres(draw: &mut Draw, count: usize) -> Vec<Arc<dyn Shape>> {
    let sphere =
        |_| Sphere { center: draw.point(1.0), radius: draw.decades(-2.5, -0.7), inward: false };
    (0..count).map(sphere).map(shape_of).collect()
}
