//! What textures cost: a scene pays only for what it uses.

use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use groundtruth::textures::{self, Texture};

use crate::prelude::*;

#[derive(Debug, Default)]
struct Watched(AtomicU32);

impl Texture for Watched {
    fn color(&self, _: &TexturePoint<'_>) -> Rgb {
        self.0.fetch_add(1, Relaxed);
        Rgb::WHITE
    }
}

/// How often the texture of a lit sphere with these coefficients is evaluated, in nine pixels that all show
/// the sphere.
fn look_ups(ka: f64, kd: f64, lights: &[&str]) -> u32 {
    let texture = Arc::new(Watched::default());
    let mut scene = from_front(3, 3, 1.0);
    let cd = Paint::from(textures::Kind::Custom(Custom(Arc::<Watched>::clone(&texture))));
    scene.materials.push(Material::new("watched", Matte { ka: ka.into(), kd: kd.into(), cd }));
    let sphere = Sphere { center: Point::ORIGIN, radius: 5.0, inward: false };
    scene.objects.push(Object::new("sphere", "watched", sphere));
    for &name in lights {
        let (ls, color, direction) = (1.0, Rgb::WHITE, Vector::Z);
        scene.lights.push(match name {
            "ambient" | "second ambient" => Light::new(name, Ambient { ls, color }),
            _ => Light::new(name, Directional { ls, color, direction }),
        });
    }
    render::render(&built(&scene));
    texture.0.load(Relaxed)
}

/// Law: a texture is evaluated once for a hit, whatever the number and kinds of the lights, and not at all
/// where its coefficients are 0. Oracle: counting, for nine pixels.
#[test]
fn textures_are_evaluated_only_where_used() {
    assert_eq!(look_ups(0.0, 0.0, &["ambient", "sun"]), 0);
    assert_eq!(look_ups(0.0, 0.5, &["ambient", "sun"]), 9);
    assert_eq!(look_ups(0.0, 0.5, &["sun", "second sun", "third sun"]), 9);
    assert_eq!(look_ups(0.5, 0.0, &["ambient", "sun"]), 9);
    assert_eq!(look_ups(0.5, 0.5, &["ambient", "sun"]), 9);
    assert_eq!(look_ups(0.5, 0.5, &["ambient", "second ambient", "sun"]), 9);
}
