//! Surface acne: the effect of an epsilon that is too small for its scene.

use crate::pictures::studio::{bits, built};
use crate::prelude::*;

/// Law: by the book's hit functions a planet far from the origin is in its own shadow in many of the pixels
/// that the sun lights, by the library's in none. Oracle: sphere and shadow by their equations, in
/// coordinates around the planet's centre, which keep their digits.
/// Book: self-shadowing and ε.
#[test]
fn the_planet_shades_itself_by_the_textbook_only() {
    /// Of some 1000 pixels that are lit by the sun.
    const MANY: usize = 200;
    let sun = Vector::new(-4.0, 2.0, 2.5).unit().expect("not zero");
    let (radius, moon) = (2.5e7, Vector::new(-2.6e7, 1.7e7, 2.2e7));
    let [book, robust] = ["ch16/surface-acne", "ch16/surface-acne-cured"].map(|name| {
        let mut scene = small(name, 96, 64, 1);
        let lit = render::render(&built(&scene));
        scene.lights[1].enabled = false;
        let world = built(&scene);
        let unlit = render::render(&world);
        let (mut reached, mut dark) = (0, 0);
        for pixel in pixels(96, 64) {
            let (ray, _) = camera_ray(&world, pixel, 0);
            let o = ray.origin - Point::new(1.5e14, 0.0, 0.0);
            let d = ray.direction.unit().expect("not zero");
            let (b, c) = (o.dot(d), o.length_squared() - radius * radius);
            if b * b <= c || world.hit(&ray, Span::AHEAD).is_none_or(|hit| hit.object.index != 0) {
                continue; // beside the planet, or on the moon in front of it
            }
            let p = o + (-b - (b * b - c).sqrt()) * d;
            // not grazing, and well outside the moon's shadow
            let from_moon = (p - moon).cross(sun).length();
            if p.dot(sun) > 0.1 * radius && from_moon > 5.5e6 {
                reached += 1;
                dark += usize::from(bits(lit.get(pixel)) == bits(unlit.get(pixel)));
            }
        }
        assert!(reached > 3 * MANY, "{name}: the sun reaches {reached} pixels");
        dark
    });
    assert!(book > MANY, "{book} pixels are in their own shadow");
    assert_eq!(robust, 0);
}
