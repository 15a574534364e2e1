//! The contract of [`Texture`] (Suffern, ch. 29 and 30).

use std::sync::Arc;

use groundtruth::kinds::Resources;
use groundtruth::math::{Normal, Pcg32, Point, Ray, Span, Vector, power_of_two};
use groundtruth::shapes::{self, Context, Shape, Surface};
use groundtruth::textures::TexturePoint;
use groundtruth::textures::{Kind, Texture};
use libtest_mimic::Trial;

use super::{Holds, ensure};
use testkit::scaling::scaled;

pub fn trials() -> Vec<Trial> {
    super::trials(
        Kind::ENTRIES,
        &[
            ("colours_are_reflectances", colours_are_reflectances),
            ("the_colour_moves_with_the_object", the_colour_moves_with_the_object),
            ("scaling_by_a_power_of_two_keeps_every_bit", scaling_keeps_every_bit),
            ("scaling_keeps_every_bit_on_meshes", scaling_keeps_every_bit_on_meshes),
        ],
    )
}

fn built(kind: &Kind) -> Arc<dyn Texture> {
    kind.build(&mut Resources::default()).expect("specimens are valid")
}

/// Surfaces all over, among them points on the borders of cells and far away.
pub fn surfaces() -> impl Iterator<Item = Surface> {
    let mut random = Pcg32::new(30, 0);
    (0..2000).map(move |i| {
        let reach = [1.0, 10.0, 1e6][i % 3];
        let mut c = || match random.below(4) {
            0 => f64::from(random.below(16)) - 8.0,
            _ => reach * (2.0 * random.uniform() - 1.0),
        };
        let point = Point::new(c(), c(), c());
        let normal = Normal::new(Vector::new(c(), c(), c())).unwrap_or(Normal::Y);
        Surface::new(point, 1e-12, normal)
    })
}

/// Law: a specimen's colours lie between 0 and 1 (all specimens are made of such).
fn colours_are_reflectances(kind: &Kind) -> Holds {
    let texture = built(kind);
    for at in surfaces() {
        let color = texture.color(&TexturePoint::new(&at));
        let fine = color.to_array().iter().all(|c| (0.0..=1.0).contains(c));
        ensure!(fine, "{:?}: {color:?}", at.local);
        ensure!(texture.color(&TexturePoint::new(&at)) == color, "{:?}: two answers", at.local);
    }
    Ok(())
}

/// Law: the position of the object in the world does not matter, only the point on it (ch. 30: textures are
/// evaluated in the object's own coordinates).
fn the_colour_moves_with_the_object(kind: &Kind) -> Holds {
    let texture = built(kind);
    for at in surfaces() {
        let moved = Surface { point: at.point + Vector::new(0.3, -7.0, 11.1), ..at.clone() };
        let (here, there) =
            (texture.color(&TexturePoint::new(&at)), texture.color(&TexturePoint::new(&moved)));
        ensure!(here == there, "{:?}: {here:?}, moved {there:?}", at.local);
    }
    Ok(())
}

/// A surface with lengths times a power of two.
pub fn scaled_surface(at: &Surface, factor: f64) -> Surface {
    let mut at = at.clone();
    at.point = at.point.scaled(factor);
    at.local = at.local.scaled(factor);
    at.error *= factor;
    at
}

fn scaling_keeps_every_bit(kind: &Kind) -> Holds {
    let texture = built(kind);
    for k in [1, -7, 30, -30] {
        let larger = built(&scaled(kind, power_of_two(k)));
        for at in surfaces() {
            let (here, there) = (
                texture.color(&TexturePoint::new(&at)),
                larger.color(&TexturePoint::new(&scaled_surface(&at, power_of_two(k)))),
            );
            ensure!(here == there, "{:?}, 2^{k}: {there:?}, not {here:?}", at.local);
        }
    }
    Ok(())
}

/// An octahedron with texture coordinates.
fn octahedron(factor: f64) -> Arc<dyn Shape> {
    let mesh = shapes::Kind::ENTRIES.iter().find(|entry| entry.module == "mesh");
    let octahedron = (mesh.expect("there are meshes").specimens)().pop().expect("the last one");
    scaled(&octahedron, factor).build(&mut Context::default()).expect("specimens are valid")
}

/// Law: the same at hits of a mesh, where textures may use triangles and texture coordinates.
fn scaling_keeps_every_bit_on_meshes(kind: &Kind) -> Holds {
    let (texture, mesh) = (built(kind), octahedron(1.0));
    for k in [1, -7, 30, -30] {
        let factor = power_of_two(k);
        let (larger, larger_mesh) = (built(&scaled(kind, factor)), octahedron(factor));
        let mut random = Pcg32::new(30, 6);
        for _ in 0..500 {
            let mut c = || 2.0 * random.uniform() - 1.0;
            let (from, way) =
                (Point::new(0.1 * c(), 0.1 * c(), 0.1 * c()), Vector::new(c(), c(), c()));
            let color = |texture: &Arc<dyn Texture>, mesh: &Arc<dyn Shape>, ray: &Ray| {
                let hit = mesh.hit(ray, Span::AHEAD).expect("from within");
                let surface = mesh.surface(ray, &hit);
                texture.color(&TexturePoint::of_hit(&surface, &**mesh, &hit))
            };
            let here = color(&texture, &mesh, &Ray::new(from, way));
            let ray = Ray::new(from.scaled(factor), factor * way);
            let there = color(&larger, &larger_mesh, &ray);
            ensure!(here == there, "from {from:?} along {way:?}, 2^{k}: {there:?}, not {here:?}");
        }
    }
    Ok(())
}
