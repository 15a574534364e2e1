//! Pixel (210, 160) of ch16/shadows, in a scene that has only what its rays touch:
//! 1 of 5 objects, 2 of 3 lights, 1 of 5 materials; without any other part of it the pixel has other bits.

use std::path::Path;

use groundtruth::render;

/// The bits that the pixel has in the whole scene.
#[test]
fn pixel_210_160_of_ch16_shadows() {
    let file = Path::new("scene.toml");
    let (_, world) = scenefile::from_toml(SCENE, file).expect("the scene is valid");
    let radiance = render::pixel(&world, [210, 160]);
    let bits = radiance.to_array().map(f64::to_bits);
    // [0.29960662212394557, 0.18725413882746597, 0.0]
    let expected = [0x3fd32cc140ebfdf9, 0x3fc7f7f19126fd77, 0x0000000000000000];
    assert_eq!(bits, expected, "the pixel is {radiance:?}");
}

const SCENE: &str = r#"
about = "figure 16.1b: the shadows of two lights make the positions clear"
tracer = "ray_cast"
accel = "bvh"
background = [0.0, 0.0, 0.0]

[image]
width = 300
height = 200
pixel_size = 1.0
samples = 16
gamma = 1.0
out_of_gamut = "max_to_one"

[camera]
eye = [2.0, 2.5, 15.0]
look_at = [3.0, 2.5, 0.0]
up = [0.0, 1.0, 0.0]
roll = 0.0
exposure_time = 1.0

[camera.lens.pinhole]
distance = 400.0
zoom = 1.0

[[lights]]
name = "ambient"
shadows = true

[lights.source.ambient]
ls = 1.0
color = [1.0, 1.0, 1.0]

[[lights]]
name = "lamp"
shadows = true

[lights.source.point]
ls = 4.0
color = [1.0, 1.0, 1.0]
location = [-12.0, 15.0, 30.0]
attenuation = 0.0

[[materials]]
name = "box"

[materials.recipe.matte]
ka = 0.2
kd = 0.3
cd = [0.8, 0.5, 0.0]

[[objects]]
name = "box"
material = "box"

[objects.shape.box]
min = [5.4, -0.5, -3.0]
max = [7.5, 4.75, 0.6]
"#;
