//! Builds a scene of a sphere in code, renders it to `sphere.png`, and explains a pixel:
//! `cargo run --example sphere`.

use std::error::Error;
use std::path::Path;

use groundtruth::film::{self, Tone};
use groundtruth::render;
use groundtruth::scene::build::{add, ambient, grey, ground, matte, phong, pinhole};
use groundtruth::scene::build::{point, point_light, rgb, sphere};
use groundtruth::world::World;

fn main() -> Result<(), Box<dyn Error>> {
    // 400×300 pixels on a view plane at distance 600; the eye, and the point that it looks at
    let view = [point(0.0, 3.0, 8.0), point(0.0, 0.8, 0.0)];
    let mut scene = pinhole("an orange sphere on the ground", [400, 300], view, 600.0);
    scene.lights = vec![ambient(0.3), point_light("lamp", point(4.0, 6.0, 5.0), 3.0)];
    let orange = phong(1.0, 0.7, rgb(1.0, 0.4, 0.1), 0.2, 50.0);
    add(&mut scene, "sphere", sphere(point(0.0, 1.0, 0.0), 1.0), orange);
    add(&mut scene, "ground", ground(0.0), matte(1.0, 0.7, grey(0.6)));

    let world = World::build(&scene)?;
    let picture = render::render(&world);
    let tone = Tone { exposure: 1.0, gamma: 2.2, out_of_gamut: scene.image.out_of_gamut };
    film::write(&picture, &tone, Path::new("sphere.png"))?;

    // the first sample of the pixel at column 222, row 116; rays below 1 % of it are folded
    let explanation = explain::pixel(&scene, &world, [222, 116], Some(0))?;
    println!("{}", explanation.text(0.01, false));
    Ok(())
}
