//! Errors of questions about cameras, samples and whole scenes.

/// Questions, and their errors.
pub const ERRORS: &[(&str, &str)] = &[
    (
        r#"{"camera_ray": {"camera": {"eye": [0, 0, 4], "lens": {"pinhole": {"distance": 4}}}, "image": {"width": 6, "height": 2}, "pixel": [6, 0]}}"#,
        "camera_ray.pixel: found [6, 0], which is outside the picture of 6 × 2",
    ),
    (
        r#"{"camera_ray": {"camera": {"eye": [0, 0, 4], "lens": {"pinhole": {"distance": 4}}}, "image": {"width": 6, "height": 2}, "pixel": [0, -1]}}"#,
        "column 135: invalid value: integer `-1`, expected a whole number from 0 to 4294967295",
    ),
    (
        r#"{"camera_ray": {"camera": {"eye": [0, 0, 4], "lens": {"pinhole": {"distance": 4}}}, "image": {"width": 0, "height": 2}, "pixel": [0, 0]}}"#,
        "camera_ray.image.width: found 0 × 2, but a picture has at least one pixel",
    ),
    (
        r#"{"camera_ray": {"camera": {"eye": [0, 0, 4], "lens": {"pinhole": {"distance": 4}}}, "image": {"width": 6, "height": 2, "pixel_size": 1e308}, "pixel": [0, 0]}}"#,
        "camera_ray.image.pixel_size: found 1e308, but the picture is then too large for this lens",
    ),
    (
        r#"{"camera_ray": {"camera": {"eye": [0, 0, 0], "lens": {"pinhole": {"distance": 4}}}, "image": {"width": 6, "height": 2}, "pixel": [0, 0]}}"#,
        "camera_ray.camera.look_at: found [0.0, 0.0, 0.0], which is the eye: there is no view direction",
    ),
    (
        r#"{"camera_ray": {"camera": {"eye": [0, 0, 4], "lens": {"pinhole": {"distance": 4}}}, "image": {"width": 6, "height": 2}, "pixel": [0, 0], "place": [0, 1.5]}}"#,
        "camera_ray.place: found [0.0, 1.5], but two numbers from 0 to 1 are needed",
    ),
    (
        r#"{"camera_ray": {"camera": {"eye": [0, 0, 4], "lens": {"pinhole": {"distance": 4}}}, "image": {"width": 6, "height": 2}, "pixel": [0, 0], "lens": [1, 0.5]}}"#,
        "camera_ray.lens: found [1.0, 0.5], which is outside the unit disk",
    ),
    (
        r#"{"camera_ray": {"camera": {"eye": [0, 0, 4], "lens": {"pinhole": {"distance": 4}}}, "image": {"width": 6, "height": 2}, "pixel": [0, 0], "eye": "left"}}"#,
        "camera_ray.eye: goes with a stereo pair",
    ),
    (
        r#"{"camera_ray": {"camera": {"eye": [0, 0, 4], "stereo": {"viewing": "parallel", "separation": 5}, "lens": {"pinhole": {"distance": 4}}}, "image": {"width": 6, "height": 2}, "pixel": [0, 0]}}"#,
        "camera_ray.eye: a stereo pair has two: left, right",
    ),
    (
        r#"{"camera_ray": {"camera": {"eye": [0, 0, 4], "stereo": {"viewing": "parallel", "separation": 5}, "lens": {"pinhole": {"distance": 4}}}, "image": {"width": 6, "height": 2}, "pixel": [6, 0], "eye": "left"}}"#,
        "camera_ray.pixel: found [6, 0], which is outside the picture of 6 × 2",
    ),
    (
        r#"{"project": {"camera": {"eye": [0, 0, 4], "lens": {"fisheye": {"fov": 400}}}, "image": {"width": 6, "height": 2}, "point": [0, 0, 0]}}"#,
        "project.camera.lens.fisheye.fov: found 400, but more than 0 and at most 360 degrees fit",
    ),
    (
        r#"{"project": {"camera": {"eye": [0, 0, 4], "lens": {"thin_lens": {"distance": 4, "focal_distance": 8, "lens_radius": -1}}}, "image": {"width": 6, "height": 2}, "point": [0, 0, 0]}}"#,
        "project.camera.lens.thin_lens.lens_radius: found -1, but a finite number of at least 0 is needed",
    ),
    (
        r#"{"project": {"camera": {"eye": [0, 0, 4], "stereo": {"viewing": "crossed", "separation": 5}, "lens": {"pinhole": {"distance": 4}}}, "image": {"width": 6, "height": 2}, "point": [0, 0, 0]}}"#,
        "column 73: unknown kind `crossed`, expected `parallel` or `transverse`",
    ),
    (
        r#"{"samples": {"sampler": {"regular": {}}, "n": 0}}"#,
        "samples.n: found 0, but 1 to 16384 fit",
    ),
    (
        r#"{"samples": {"sampler": {"regular": {}}, "n": 4000000000}}"#,
        "samples.n: found 4000000000, but 1 to 16384 fit",
    ),
    (
        r#"{"samples": {"sampler": {"regular": {}}, "n": 1e3}}"#,
        "column 49: invalid type: floating point `1000.0`, expected a whole number from 0 to 4294967295; write 1000",
    ),
    (
        r#"{"samples": {"sampler": {"regular": {}}, "n": 1000, "sets": 83}}"#,
        "samples.sets: found 83, but 1 to 16 sets of 1000 fit",
    ),
    (
        r#"{"samples": {"sampler": {"halton": {}}, "n": 4}}"#,
        "column 33: unknown kind `halton`, expected one of `regular`, `random`, `jittered`, `n_rooks`, `multi_jittered`, `hammersley`, `correlated_multi_jittered`, `sobol`",
    ),
    (
        r#"{"samples": {"sampler": {"regular": {}}, "n": 4, "sets": 1, "draw": {"pixel": [0, 0], "index": 0}}}"#,
        "samples: needs either `sets` or `draw`, not both",
    ),
    (
        r#"{"samples": {"sampler": {"regular": {}}, "n": 4, "seed": -1}}"#,
        "column 59: invalid value: integer `-1`, expected a whole number that is not negative",
    ),
    (
        r#"{"map": {"to": {"disk": {}}, "u": [1, 0]}}"#,
        "map.u: found [1.0, 0.0], but two numbers of at least 0 and below 1 are needed",
    ),
    (r#"{"map": {"to": {"disk": {}}}}"#, "map: needs either `u` or `point`"),
    (
        r#"{"map": {"to": {"disk": {}}, "point": [0.8, 0.8]}}"#,
        "map.point: found [0.8, 0.8], but a point [x, y] of the unit disk is needed",
    ),
    (
        r#"{"map": {"to": {"hemisphere": {"exponent": -0.5}}, "u": [0, 0]}}"#,
        "map.to.hemisphere.exponent: found -0.5, but 0 or more fits",
    ),
    (
        r#"{"map": {"to": {"hemisphere": {"exponent": 1}}, "point": [0, 0, -1]}}"#,
        "map.point: found [0.0, 0.0, -1.0], but a direction [x, y, z] with z of at least 0 is needed",
    ),
    (
        r#"{"map": {"to": {"sphere": {}}, "point": [0, 1]}}"#,
        "map.point: found [0.0, 1.0], but a direction [x, y, z] is needed",
    ),
    (
        r#"{"map": {"to": {"sphere": {}}, "point": [0, 0, 0]}}"#,
        "map.point: found [0.0, 0.0, 0.0], but a finite vector other than zero is needed",
    ),
    (r#"{"radiance": {"scene": "ch28/glass-sphere"}}"#, "radiance: needs either `pixel` or `ray`"),
    (
        r#"{"radiance": {"scene": "ch28/glass-sphere", "pixel": [30, 0], "size": [30, 20]}}"#,
        "radiance.pixel: found [30, 0], which is outside the picture of 30 × 20",
    ),
    (
        r#"{"radiance": {"scene": "ch28/glass-sphere", "pixel": [0, 0], "size": [30, 0]}}"#,
        "radiance.size: found 30 × 0, but 1 to 33554432 pixels fit",
    ),
    (
        r#"{"radiance": {"scene": "ch28/glass-sphere", "ray": {"origin": [0, 0, 0], "direction": [0, 0, 1]}, "size": [3, 2]}}"#,
        "radiance.size: a ray has no size; leave it out, or ask for a `pixel`",
    ),
    (
        r#"{"radiance": {"scene": "ch28/glass-sphere", "pixel": [600, 0]}}"#,
        "radiance.pixel: found [600, 0], which is outside the picture of 600 × 600",
    ),
    (
        r#"{"radiance": {"scene": "nothing-like-it", "pixel": [0, 0]}}"#,
        "radiance.scene: no scene `nothing-like-it`: neither a gallery name (`groundtruth list` shows them) nor a file",
    ),
    (
        r#"{"radiance": {"scene": "no.toml", "pixel": [0, 0]}}"#,
        "radiance.scene: no.toml: cannot be read: No such file or directory (os error 2)",
    ),
    (
        r#"{"radiance": {"scene": "ch28/glass-sphere", "pixel": [0, 0], "samples": 0}}"#,
        "radiance.scene.image.samples: found 0, but 1 to 65536 fit",
    ),
    (
        r#"{"radiance": {"scene": "ch28/glass-sphere", "pixel": [0, 0], "samples": 4000000000}}"#,
        "radiance.scene.image.samples: found 4000000000, but 1 to 65536 fit",
    ),
    (
        r#"{"radiance": {"scene": "ch28/glass-sphere", "pixel": [300, 200], "samples": 65536, "replicas": 1024}}"#,
        "radiance: this would take about 4e9 tests of a ray and an object, and at most 2e8 fit; ask for fewer samples or replicas, or lower the scene's max_depth",
    ),
    (
        r#"{"radiance": {"scene": "ch28/glass-sphere", "pixel": [0, 0], "replicas": 100000}}"#,
        "radiance.replicas: found 100000, but 1 to 1024 fit",
    ),
    (
        r#"{"radiance": {"scene": {"image": {"width": 2, "height": 2}, "camera": {"eye": [0, 0, 5], "lens": {"orthographic": {}}}, "materials": [{"name": "glass", "recipe": {"dielectric": {"inside": {"eta": 1.5}}}}], "objects": [{"name": "ball", "material": "glass", "shape": {"sphere": {"center": [0, 0, 0], "radius": -1}}}]}, "pixel": [0, 0]}}"#,
        r#"radiance.scene.objects[0] "ball", shape.sphere.radius: found -1, but a positive, finite number is needed"#,
    ),
    (
        r#"{"radiance": {"scene": {"image": {"width": 2, "height": 2}, "camera": {"eye": [0, 0, 5], "lens": {"orthographic": {}}}, "materials": [{"name": "glass", "recipe": {"dielectric": {"inside": {"eta": 1.5}}}}], "objects": [{"name": "ball", "material": "glass", "shape": {"tessellated_sphere": {"horizontal": 4000, "vertical": 4000}}}]}, "pixel": [0, 0]}}"#,
        r#"radiance.scene.objects[0] "ball", shape.tessellated_sphere.horizontal: 32000000 triangles and parts are too many for a line; at most 262144 fit"#,
    ),
    (
        r#"{"radiance": {"scene": {"tracer": {"whitted": {"max_depth": 128}}, "image": {"width": 2, "height": 2}, "camera": {"eye": [0, 0, 5], "lens": {"orthographic": {}}}, "materials": [{"name": "glass", "recipe": {"dielectric": {"inside": {"eta": 1.5}}}}], "objects": [{"name": "ball", "material": "glass", "shape": {"sphere": {"center": [0, 0, 0], "radius": 2}}}, {"name": "inner", "material": "glass", "shape": {"sphere": {"center": [0, 0, 0], "radius": 1.5}}}]}, "pixel": [0, 0]}}"#,
        "radiance: a single sample: more than 1000000 rays; lower max_depth or the number of samples",
    ),
    // its first sample, and those of most pixels, miss the glass
    (
        r#"{"radiance": {"scene": {"background": 1, "tracer": {"whitted": {"max_depth": 100}}, "accel": "bvh", "image": {"width": 1000, "height": 1000, "pixel_size": 0.1}, "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "lens": {"pinhole": {"distance": 5}}}, "materials": [{"name": "a", "recipe": {"dielectric": {"inside": {"eta": 1.5}}}}, {"name": "b", "recipe": {"dielectric": {"inside": {"eta": 1.7}}}}, {"name": "c", "recipe": {"dielectric": {"inside": {"eta": 1.9}}}}], "objects": [{"name": "a", "material": "a", "shape": {"sphere": {"center": [0, 0, 0], "radius": 1.0}}}, {"name": "b", "material": "b", "shape": {"sphere": {"center": [0, 0, 0], "radius": 0.9}}}, {"name": "c", "material": "c", "shape": {"sphere": {"center": [0, 0, 0], "radius": 0.8}}}, {"name": "far", "material": "a", "shape": {"instance": {"of": {"tessellated_sphere": {"horizontal": 16, "vertical": 8}}, "transform": [{"translate": [0, 0, 100]}]}}}]}, "pixel": [489, 500], "samples": 16, "replicas": 1}}"#,
        "radiance: these samples and replicas: more than 6250000 rays; lower max_depth or the number of samples",
    ),
    (
        r#"{"radiance": {"scene": {"tracer": {"whitted": {"max_depth": 129}}, "image": {"width": 2, "height": 2}, "camera": {"eye": [0, 0, 5], "lens": {"orthographic": {}}}, "materials": [{"name": "glass", "recipe": {"dielectric": {"inside": {"eta": 1.5}}}}], "objects": [{"name": "ball", "material": "glass", "shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}}]}, "pixel": [0, 0]}}"#,
        "radiance.scene.tracer.whitted.max_depth: found 129, but at most 128 fits",
    ),
    (
        r#"{"radiance": {"scene": {"trace": 1, "image": {"width": 2, "height": 2}, "camera": {"eye": [0, 0, 5], "lens": {"orthographic": {}}}, "materials": [{"name": "glass", "recipe": {"dielectric": {"inside": {"eta": 1.5}}}}], "objects": [{"name": "ball", "material": "glass", "shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}}]}, "pixel": [0, 0]}}"#,
        "column 31: unknown field `trace`; did you mean `tracer`?",
    ),
];
