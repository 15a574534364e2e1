//! Errors of questions about lobes, lights and textures.

/// Questions, and their errors.
pub const ERRORS: &[(&str, &str)] = &[
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
        "column 26: unknown kind `sun`, expected one of `ambient`, `directional`, `point`, `spot`, `ambient_occluder`, `area`, `environment`, `jittered_directional`, `fake_spherical`",
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
];
