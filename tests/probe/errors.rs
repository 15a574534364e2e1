//! Every error text a person can meet.

use groundtruth::probe;

/// Questions, and the errors they get.
const ERRORS: &[(&str, &str)] = &[
    (r#""#, "column 0: EOF while parsing a value"),
    (r#"hello"#, "column 1: expected value"),
    (
        r#"[1]"#,
        r#"column 0: invalid type: sequence, expected an object with one question, as {"intersect": {…}}"#,
    ),
    (
        r#"{}"#,
        "column 2: no question; there are: intersect, occluded, camera_ray, project, samples, map, lobe, fresnel, light, texture, mapping, noise, transform, grid, radiance",
    ),
    (
        r#"{"id": 3}"#,
        "column 9: no question; there are: intersect, occluded, camera_ray, project, samples, map, lobe, fresnel, light, texture, mapping, noise, transform, grid, radiance",
    ),
    (
        r#"{"intersekt": {}}"#,
        "column 12: no question `intersekt`; there are: intersect, occluded, camera_ray, project, samples, map, lobe, fresnel, light, texture, mapping, noise, transform, grid, radiance",
    ),
    (
        r#"{"fresnel": {"cos_i": 1, "eta": 1}, "light": {"light": {"ambient": {}}, "from": [0, 0, 0]}}"#,
        "column 91: a second question; a line asks one",
    ),
    (r#"{"id": 1, "id": 2, "fresnel": {"cos_i": 1, "eta": 1}}"#, "column 17: duplicate field `id`"),
    (r#"{"fresnel": {"cos_i": 1, "eta": 1}} x"#, "column 37: trailing characters"),
    (r#"{"fresnel": {"cos_i": 1, "eta": 1}"#, "column 34: EOF while parsing an object"),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, 0]}}}"#,
        "intersect.ray.direction: found [0.0, 0.0, 0.0], but a finite vector other than zero is needed",
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "ray": {"origin": [0, 0, 5], "direction": [0, 1e-101, 0]}}}"#,
        "intersect.ray.direction: found [0.0, 1e-101, 0.0], but its largest coordinate has to be from 1e-100 to 1e100 in size: its square has to be a number",
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "ray": {"origin": [0, 0, 5], "direction": [0, 1e101, 0]}}}"#,
        "intersect.ray.direction: found [0.0, 1e101, 0.0], but its largest coordinate has to be from 1e-100 to 1e100 in size: its square has to be a number",
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, 1, 0]}}}"#,
        "column 127: invalid length 4, expected an array of length 3",
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "ray": {"origin": [0, 0, NaN], "direction": [0, 0, 1]}}}"#,
        "column 98: expected value",
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "ray": {"origin": [0, 0, 1e999], "direction": [0, 0, 1]}}}"#,
        "column 102: number out of range",
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "ray": {"origin": [0, 0], "direction": [0, 0, 1]}}}"#,
        "column 96: invalid length 2, expected an array of length 3",
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "ray": {"origin": [0, 0, "5"], "direction": [0, 0, 1]}}}"#,
        r#"column 100: invalid type: string "5", expected a number"#,
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}, "span": [3, 1]}}"#,
        "intersect.span: found [3, 1], but the first must be below the second",
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}, "span": [0, "infinity"]}}"#,
        r#"column 149: invalid value: string "infinity", expected a number, "inf" or "-inf""#,
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}, "al": true}}"#,
        "column 131: unknown field `al`, expected one of `shape`, `transform`, `ray`, `span`, `all`, `leave`",
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 0}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}}}"#,
        "intersect.shape.sphere.radius: found 0, but a positive, finite number is needed",
    ),
    (
        r#"{"intersect": {"shape": {"spheer": {}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}}}"#,
        "column 33: unknown variant `spheer`, expected one of `plane`, `sphere`, …",
    ),
    (
        r#"{"intersect": {"shape": "sphere", "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}}}"#,
        "column 32: a kind needs a table of fields, as `kind = { … }`; it may be empty",
    ),
    (
        r#"{"intersect": {"shape": {"mesh": {"file": "no.ply"}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}}}"#,
        "intersect.shape.mesh.file: no.ply: the file cannot be read: No such file or directory (os error 2)",
    ),
    (
        r#"{"intersect": {"shape": {"tessellated_sphere": {"horizontal": 4096, "vertical": 4096}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}}}"#,
        "intersect.shape.tessellated_sphere.horizontal: 33554432 triangles and parts are too many for a line; at most 262144 fit",
    ),
    (
        r#"{"intersect": {"shape": {"instance": {"of": {"random_spheres": {"count": 300000, "radius": 0.1}}, "transform": []}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}}}"#,
        "intersect.shape.instance.of.random_spheres.count: 300000 triangles and parts are too many for a line; at most 262144 fit",
    ),
    (
        r#"{"occluded": {"shapes": [{"compound": {"parts": [{"shape": {"lattice": {"of": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "counts": [100, 100, 100], "spacing": [3, 3, 3]}}}]}}], "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}}}"#,
        "occluded.shapes[0].compound.parts[0].shape.lattice.counts: 1000001 triangles and parts are too many for a line; at most 262144 fit",
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": -1}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}, "transform": [{"translate": [0, 0, 1]}]}}"#,
        "intersect.shape.sphere.radius: found -1, but a positive, finite number is needed",
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}, "transform": [{"scale": [1, 1, 1e-20]}]}}"#,
        "intersect.transform: the transformation is singular (condition number 1.4e20; at most 1e12 fits)",
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}, "transform": [{"rotate_about": {"point": [0, 0, 0], "direction": [0, 0, 0], "degrees": 3}}]}}"#,
        "intersect.transform[0].rotate_about.direction: found [0.0, 0.0, 0.0], but a finite vector other than zero is needed",
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}, "transform": [{"rotate_about": {"point": [0, 0, 0], "direction": [0, 0, 1], "degrees": 3, "sense": 1}}]}}"#,
        "column 224: unknown field `sense`, expected one of `point`, `direction`, `degrees`",
    ),
    (
        r#"{"occluded": {"ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}}}"#,
        "occluded: needs either `shape` or `shapes`",
    ),
    (
        r#"{"occluded": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}}}"#,
        "occluded: needs either `ray` or `segment`",
    ),
    (
        r#"{"occluded": {"shapes": [{"sphere": {"center": [0, 0, 0], "radius": 1}}, {"disk": {"center": [0, 0, 0], "normal": [0, 0, 0], "radius": 1}}], "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}}}"#,
        "occluded.shapes[1].disk.normal: found [0.0, 0.0, 0.0], but a finite vector other than zero is needed",
    ),
    (
        r#"{"occluded": {"shapes": [{"sphere": {"center": [0, 0, 0], "radius": 1}}], "transform": [{"rotate_x": 1}], "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}}}"#,
        "occluded.transform: goes with `shape`; in a list, each shape can be an instance",
    ),
    (
        r#"{"occluded": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "segment": {"from": [1, 1, 1], "to": [1, 1, 1]}}}"#,
        "occluded.segment.to: the segment has no length, or overflows",
    ),
    (
        r#"{"occluded": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "segment": {"from": [1, 1, 1], "to": [1, 1, 2]}, "span": [0, 1]}}"#,
        "occluded.span: goes with `ray`; a segment ends by itself",
    ),
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
        "column 73: unknown variant `crossed`, expected `parallel` or `transverse`",
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
        "column 49: invalid type: floating point `1000.0`, expected a whole number from 0 to 4294967295",
    ),
    (
        r#"{"samples": {"sampler": {"regular": {}}, "n": 1000, "sets": 83}}"#,
        "samples.sets: found 83, but 1 to 16 sets of 1000 fit",
    ),
    (
        r#"{"samples": {"sampler": {"halton": {}}, "n": 4}}"#,
        "column 33: unknown variant `halton`, expected one of `regular`, `random`, `jittered`, `n_rooks`, `multi_jittered`, `hammersley`, `correlated_multi_jittered`, `sobol`",
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
    (
        r#"{"lobe": {"lobe": {"lambertian": {"reflectance": -1}}, "wo": [0, 0, 1]}}"#,
        "lobe.lobe.lambertian.reflectance: found [-1.0, -1.0, -1.0], but a colour of finite numbers of at least 0 is needed",
    ),
    (
        r#"{"lobe": {"lobe": {"glossy_specular": {"reflectance": 1, "exponent": -1}}, "wo": [0, 0, 1]}}"#,
        "lobe.lobe.glossy_specular.exponent: found -1, but a finite number of at least 0 is needed",
    ),
    (
        r#"{"lobe": {"lobe": {"perfect_transmitter": {"transmittance": 1, "eta": 0}}, "wo": [0, 0, 1]}}"#,
        "lobe.lobe.perfect_transmitter.eta: found 0, but a positive, finite number is needed",
    ),
    (
        r#"{"lobe": {"lobe": {"perfect_transmitter": {"transmittance": -1, "eta": 1}}, "wo": [0, 0, 1]}}"#,
        "lobe.lobe.perfect_transmitter.transmittance: found -1, but a finite number of at least 0 is needed",
    ),
    (
        r#"{"lobe": {"lobe": {"fresnel_reflector": {"eta": 0}}, "wo": [0, 0, 1]}}"#,
        "lobe.lobe.fresnel_reflector.eta: found 0, but a positive, finite number is needed",
    ),
    (
        r#"{"lobe": {"lobe": {"fresnel_transmitter": {"eta": -1}}, "wo": [0, 0, 1]}}"#,
        "lobe.lobe.fresnel_transmitter.eta: found -1, but a positive, finite number is needed",
    ),
    (
        r#"{"lobe": {"lobe": {"perfect_specular": {"reflectance": [1, 1, -1]}}, "wo": [0, 0, 1]}}"#,
        "lobe.lobe.perfect_specular.reflectance: found [1.0, 1.0, -1.0], but a colour of finite numbers of at least 0 is needed",
    ),
    (
        r#"{"lobe": {"lobe": {"lambertian": {"reflectance": 1}}, "wo": [0, 0, 0]}}"#,
        "lobe.wo: found [0.0, 0.0, 0.0], but a finite vector other than zero is needed",
    ),
    (
        r#"{"lobe": {"lobe": {"lambertian": {"reflectance": 1}}, "wo": [0, 0, 1], "wi": [0, 0, 0]}}"#,
        "lobe.wi: found [0.0, 0.0, 0.0], but a finite vector other than zero is needed",
    ),
    (
        r#"{"lobe": {"lobe": {"lambertian": {"reflectance": 1}}, "wo": [0, 0, 1], "u": [0, 1]}}"#,
        "lobe.u: found [0.0, 1.0], but two numbers of at least 0 and below 1 are needed",
    ),
    (r#"{"fresnel": {"eta": 1.5}}"#, "fresnel: needs either `cos_i`, or `wo` and `n`"),
    (
        r#"{"fresnel": {"eta": 1.5, "cos_i": 1.5}}"#,
        "fresnel.cos_i: found 1.5, but a cosine from 0 to 1 is needed",
    ),
    (
        r#"{"fresnel": {"eta": 1.5, "cos_i": 1, "wo": [0, 0, 1], "n": [0, 0, 1]}}"#,
        "fresnel: needs either `cos_i`, or `wo` and `n`",
    ),
    (
        r#"{"fresnel": {"eta": 1.5, "wo": [0, 0, 1], "n": [0, 0, -1]}}"#,
        "fresnel.wo: is behind the surface; turn `n` around and ask with 1/eta",
    ),
    (
        r#"{"light": {"light": {"ambient_occluder": {}}, "from": [0, 0, 1], "u": [[0.5, 0.5]]}}"#,
        "light.normal: missing: light that is sampled is asked for at a surface",
    ),
    (
        r#"{"light": {"light": {"environment": {}}, "from": [0, 0, 1], "normal": [0, 0, 1]}}"#,
        "light.u: found 0 pairs, but this light needs 1",
    ),
    (
        r#"{"light": {"light": {"environment": {}}, "from": [0, 0, 1], "normal": [0, 0, 1], "u": [[0.5, 1]]}}"#,
        "light.u[0]: found [0.5, 1.0], but two numbers of at least 0 and below 1 are needed",
    ),
    (
        r#"{"light": {"light": {"area": {"object": "lamp"}}, "from": [0, 0, 1]}}"#,
        "light.light.area.object: no object `lamp`: the scene has none",
    ),
    (
        r#"{"light": {"light": {"point": {"location": [0, 0, 1], "attenuation": -1}}, "from": [0, 0, 0]}}"#,
        "light.light.point.attenuation: found -1, but a finite number of at least 0 is needed",
    ),
    (
        r#"{"light": {"light": {"sun": {}}, "from": [0, 0, 0]}}"#,
        "column 26: unknown variant `sun`, expected one of `ambient`, `directional`, `point`, `spot`, `ambient_occluder`, `area`, `environment`, `jittered_directional`, `fake_spherical`",
    ),
    (
        r#"{"texture": {"texture": {"checker3d": {"size": 0}}, "point": [0, 0, 0]}}"#,
        "texture.texture.checker3d.size: found 0, but a positive, finite number is needed",
    ),
    (
        r#"{"texture": {"texture": "red", "point": [0, 0, 0]}}"#,
        r#"column 29: invalid type: string "red", expected a colour [r, g, b], one number for a grey, or a texture"#,
    ),
    (
        r#"{"texture": {"texture": [1, 2], "point": [0, 0, 0]}}"#,
        "column 30: invalid length 2, expected a colour: [r, g, b], or one number for a grey",
    ),
    (
        r#"{"transform": {"steps": [{"shear": [1, 0, 1, 0, 0, 0]}]}}"#,
        "transform.steps: the transformation is singular (condition number inf; at most 1e12 fits)",
    ),
    (
        r#"{"transform": {"steps": [{"matrix": [[1, 2, 3, 0], [2, 4, 6, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}]}}"#,
        "transform.steps: the transformation is singular (condition number inf; at most 1e12 fits)",
    ),
    (
        r#"{"transform": {"steps": [{"matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [5, 6, 7, 1]]}]}}"#,
        "transform.steps[0].matrix[3][0]: found 5, but the last of the four rows has to be [0, 0, 0, 1]",
    ),
    (
        r#"{"transform": {"steps": [{"matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 2]]}]}}"#,
        "transform.steps[0].matrix[3][3]: found 2, but the last of the four rows has to be [0, 0, 0, 1]",
    ),
    (
        r#"{"transform": {"steps": [{"matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]}]}}"#,
        "column 78: invalid length 3, expected an array of length 4",
    ),
    (
        r#"{"transform": {"steps": [{"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}]}}"#,
        "column 38: invalid type: integer `1`, expected a sequence",
    ),
    (
        r#"{"transform": {"steps": [{"turn": 3}]}}"#,
        "column 32: unknown variant `turn`, expected one of `translate`, `scale`, `rotate_x`, `rotate_y`, `rotate_z`, `rotate_about`, `reflect`, `shear`, `matrix`",
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}, "leave": [0, 0, 0]}}"#,
        "intersect.leave: found [0.0, 0.0, 0.0], but a finite vector other than zero is needed",
    ),
    (
        r#"{"intersect": {"shape": {"mesh": {}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}}}"#,
        "intersect.shape.mesh: needs either `file`, or `vertices` and `triangles`",
    ),
    (
        r#"{"intersect": {"shape": {"mesh": {"file": "a.ply", "uvs": []}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}}}"#,
        "intersect.shape.mesh.uvs: found beside `file`; leave one of them out",
    ),
    (
        r#"{"intersect": {"shape": {"mesh": {"vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "triangles": [[0, 1, 2], [0, 2, 3]]}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}}}"#,
        "intersect.shape.mesh.triangles[1][2]: found 3, but vertices go from 0 to 2",
    ),
    (
        r#"{"intersect": {"shape": {"mesh": {"vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "triangles": [[0, 1]]}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}}}"#,
        "column 102: invalid length 2, expected an array of length 3",
    ),
    (r#"{"grid": {}}"#, "grid: needs either `boxes` or `shapes`"),
    (r#"{"grid": {"boxes": [], "shapes": []}}"#, "grid: needs either `boxes` or `shapes`"),
    (
        r#"{"grid": {"boxes": []}}"#,
        "grid.boxes: found none with bounds, but a grid has at least one",
    ),
    (
        r#"{"grid": {"shapes": [{"plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}}]}}"#,
        "grid.shapes: found none with bounds, but a grid has at least one",
    ),
    (
        r#"{"grid": {"shapes": [{"sphere": {"center": [0, 0, 0], "radius": 1}}, {"sphere": {"center": [0, 0, 0], "radius": -1}}]}}"#,
        "grid.shapes[1].sphere.radius: found -1, but a positive, finite number is needed",
    ),
    (
        r#"{"grid": {"boxes": [{"min": [0, 0, 0], "max": [1, 1, 1]}, {"min": [0, 2, 0], "max": [1, 1, 1]}]}}"#,
        "grid.boxes[1].max: found [1.0, 1.0, 1.0], but no coordinate may be below that of min, [0.0, 2.0, 0.0]",
    ),
    (
        r#"{"grid": {"boxes": [{"min": [0, 0, 0], "max": [1, 1, 1]}], "multiplier": 0}}"#,
        "grid.multiplier: found 0, but a positive, finite number is needed",
    ),
    (
        r#"{"grid": {"boxes": [{"min": [0, 0, 0], "max": [1, 1, 1]}], "multiplier": 1000}}"#,
        "grid.multiplier: found 1000, but at most 101.593 fits for 1 objects",
    ),
    (
        r#"{"grid": {"boxes": [{"min": [0, 0, 0], "max": [1, 1, 1]}], "cell": [0, 3, 0]}}"#,
        "grid.cell: found [0, 3, 0], but the grid has 3 × 3 × 3 cells, counted from 0",
    ),
    (
        r#"{"grid": {"boxes": [{"min": [0, 0, 0], "max": [1, 1, 1]}], "cell": [0, -1, 0]}}"#,
        "column 73: invalid value: integer `-1`, expected a whole number from 0 to 4294967295",
    ),
    (
        r#"{"grid": {"boxes": [{"min": [0, 0, 0], "max": [1, 1, 1]}], "ray": {"origin": [0, 0, 0], "direction": [0, 0, 0]}}}"#,
        "grid.ray.direction: found [0.0, 0.0, 0.0], but a finite vector other than zero is needed",
    ),
    (r#"{"radiance": {"scene": "ch28/glass-sphere"}}"#, "radiance: needs either `pixel` or `ray`"),
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
        "radiance: a single sample casts more than 1000000 rays; lower the scene's max_depth",
    ),
    (
        r#"{"radiance": {"scene": {"tracer": {"whitted": {"max_depth": 129}}, "image": {"width": 2, "height": 2}, "camera": {"eye": [0, 0, 5], "lens": {"orthographic": {}}}, "materials": [{"name": "glass", "recipe": {"dielectric": {"inside": {"eta": 1.5}}}}], "objects": [{"name": "ball", "material": "glass", "shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}}]}, "pixel": [0, 0]}}"#,
        "radiance.scene.tracer.whitted.max_depth: found 129, but at most 128 fits",
    ),
    (
        r#"{"radiance": {"scene": {"trace": 1, "image": {"width": 2, "height": 2}, "camera": {"eye": [0, 0, 5], "lens": {"orthographic": {}}}, "materials": [{"name": "glass", "recipe": {"dielectric": {"inside": {"eta": 1.5}}}}], "objects": [{"name": "ball", "material": "glass", "shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}}]}, "pixel": [0, 0]}}"#,
        "column 31: unknown field `trace`, expected one of `about`, `tracer`, `transparency`, `accel`, `intersect`, `epsilon`, `background`, `image`, `camera`, `lights`, `materials`, `objects`",
    ),
];

#[test]
fn errors_say_where_what_and_what_would_fit() {
    for (line, error) in ERRORS {
        let reply: serde_json::Value =
            serde_json::from_str(&probe::answer(line)).expect("answers are JSON");
        match (error.strip_suffix('…'), reply["error"].as_str()) {
            (Some(start), Some(found)) => assert!(found.starts_with(start), "{line}: {found}"),
            _ => assert_eq!(reply["error"], *error, "{line}"),
        }
    }
}
