//! Errors of shapes and their transformations.

/// The replaced text, its replacement, and the error.
pub const ERRORS: &[(&str, &str, &str)] = &[
    (
        "radius",
        "radios",
        "scene.toml:31: objects[0] \"ball\", shape.sphere.radios: unknown field `radios`; did you mean `radius`?",
    ),
    (
        "radius = 1\n",
        "",
        "scene.toml:29: objects[0] \"ball\", shape.sphere: missing field `radius`",
    ),
    (
        "radius = 1",
        "radius = \"big\"",
        "scene.toml:31: objects[0] \"ball\", shape.sphere.radius: invalid type: string \"big\", expected a number",
    ),
    (
        "[0, 0, 0]",
        "[0, 0]",
        "scene.toml:30: objects[0] \"ball\", shape.sphere.center: invalid length 2, expected an array of length 3",
    ),
    (
        "[0, 0, 0]",
        "[0, 0, 0, 1]",
        "scene.toml:30: objects[0] \"ball\", shape.sphere.center: invalid length 4, expected an array of length 3",
    ),
    (
        "sphere",
        "spheer",
        "scene.toml:29: objects[0] \"ball\", shape.spheer: unknown kind `spheer`; did you mean `sphere`?",
    ),
    (
        "radius = 1",
        "radius = nan",
        "scene.toml:31: objects[0] \"ball\", shape.sphere.radius: found NaN, but a positive, finite number is needed",
    ),
    (
        "radius = 1",
        "radius = inf",
        "scene.toml:31: objects[0] \"ball\", shape.sphere.radius: found inf, but a positive, finite number is needed",
    ),
    (
        "radius = 1",
        "radius = -1",
        "scene.toml:31: objects[0] \"ball\", shape.sphere.radius: found -1, but a positive, finite number is needed",
    ),
    (
        "radius = 1",
        "radius = 0",
        "scene.toml:31: objects[0] \"ball\", shape.sphere.radius: found 0, but a positive, finite number is needed",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "[objects.shape.triangle]\nvertices = [[0, 0, 0], [1, 1, 1], [2, 2, 2]]\n",
        "scene.toml:30: objects[0] \"ball\", shape.triangle.vertices: found [[0.0, 0.0, 0.0], [1.0, 1.0, 1.0], [2.0, 2.0, 2.0]], a triangle of area zero, but its corners must not be on one line",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "[objects.shape.box]\nmin = [0, 0, 0]\nmax = [1, 0, 1]\n",
        "scene.toml:31: objects[0] \"ball\", shape.box.max: found [1.0, 0.0, 1.0], but each coordinate must be above that of min, [0.0, 0.0, 0.0]",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "[objects.shape.rectangle]\ncorner = [0, 0, 0]\na = [1, 0, 0]\nb = [1, 1, 0]\n",
        "scene.toml:32: objects[0] \"ball\", shape.rectangle.b: found [1.0, 1.0, 0.0], but it must be perpendicular to a, [1.0, 0.0, 0.0]",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "[objects.shape.rectangle]\ncorner = [0, 0, 0]\na = [1, 0, 0]\nb = [2, 0, 0]\n",
        "scene.toml:32: objects[0] \"ball\", shape.rectangle.b: found [2.0, 0.0, 0.0], but the sides must span an area",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "[objects.shape.open_cylinder]\ny0 = 1\ny1 = 1\nradius = 1\n",
        "scene.toml:31: objects[0] \"ball\", shape.open_cylinder.y1: found 1, but it must be above y0, 1",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "[objects.shape.plane]\npoint = [0, 0, 0]\nnormal = [0, 0, 0]\n",
        "scene.toml:31: objects[0] \"ball\", shape.plane.normal: found [0.0, 0.0, 0.0], but a finite vector other than zero is needed",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "[objects.shape.tessellated_sphere]\nhorizontal = 2\nvertical = 4\n",
        "scene.toml:30: objects[0] \"ball\", shape.tessellated_sphere.horizontal: found 2, but 3 to 4096 steps are needed",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "shape = { instance = { of = { sphere = { center = [0, 0, 0], radius = 1 } }, transform = [{ scale = [1, 0, 1] }] } }\n",
        "scene.toml:29: objects[0] \"ball\", shape.instance.transform: the transformation is singular (condition number inf; at most 1e12 fits)",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "shape = { instance = { of = { sphere = { center = [0, 0, 0], radius = 1 } }, transform = [{ scale = [1, 1, 1e-13] }] } }\n",
        "scene.toml:29: objects[0] \"ball\", shape.instance.transform: the transformation is singular (condition number 1.4e13; at most 1e12 fits)",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "[objects.shape.instance]\nof = { sphere = { center = [0, 0, 0], radius = 1 } }\ntransform = [\n{ matrix = [[1, 0, 0, 0],\n[0, 1, 0, 0],\n[0, 0, inf, 0],\n[0, 0, 0, 1]] }]\n",
        "scene.toml:34: objects[0] \"ball\", shape.instance.transform[0].matrix[2][2]: found inf, but a finite number is needed",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "[objects.shape.instance]\nof = { sphere = { center = [0, 0, 0], radius = 1 } }\ntransform = [{ matrix = [[1, 0, 0, 0], [0, 1, 0], [0, 0, 1, 0], [0, 0, 0, 1]] }]\n",
        "scene.toml:31: objects[0] \"ball\", shape.instance.transform[0].matrix: invalid length 3, expected an array of length 4",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "shape = { instance = { of = { sphere = { center = [0, 0, 0], radius = 1 } }, transform = [{ translate = [nan, 0, 0] }] } }\n",
        "scene.toml:29: objects[0] \"ball\", shape.instance.transform[0].translate: found [NaN, 0.0, 0.0], but finite coordinates are needed",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "shape = { instance = { of = { sphere = { center = [0, 0, 0], radius = 1 } }, transform = [{ rotate_about = { point = [0, 0, 0], direction = [0, 0, 0], degrees = 3 } }] } }\n",
        "scene.toml:29: objects[0] \"ball\", shape.instance.transform[0].rotate_about.direction: found [0.0, 0.0, 0.0], but a finite vector other than zero is needed",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "shape = { instance = { of = { sphere = { center = [0, 0, 0], radius = 1 } }, transform = [{ spin = 3 }] } }\n",
        "scene.toml:29: objects[0] \"ball\", shape.instance.transform[0].spin: unknown kind `spin`, expected one of `translate`, `scale`, `rotate_x`, `rotate_y`, `rotate_z`, `rotate_about`, `reflect`, `shear`, `matrix`",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "shape = { instance = { of = { sphere = { center = [0, 0, 0], radius = 1 } }, transform = [{ rotate_about = { point = [0, 0, 0], direction = [0, 0, 1], degrees = 3, sense = 1 } }] } }\n",
        "scene.toml:29: objects[0] \"ball\", shape.instance.transform[0].rotate_about.sense: unexpected keys in table: sense, available keys: point, direction, degrees",
    ),
    (
        "\n[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "shape = { instance = { of = { sphere = { center = [0, 0, 0], radius = 1 } }, transform = [{ scale = 0 }] } }\n",
        "scene.toml:28: objects[0] \"ball\", shape.instance.transform: the transformation is singular (condition number inf; at most 1e12 fits)",
    ),
    (
        "\n[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "shape = { instance = { of = { sphere = { center = [0, 0, 0], radius = 1 } }, transform = [{ scale = \"big\" }] } }\n",
        "scene.toml:28: objects[0] \"ball\", shape.instance.transform[0].scale: invalid type: string \"big\", expected one factor, or three as [x, y, z]",
    ),
    (
        "\n[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "shape = { instance = { of = { sphere = { center = [0, 0, 0], radius = 1 } }, transform = [{ scale = [1, 2] }] } }\n",
        "scene.toml:28: objects[0] \"ball\", shape.instance.transform[0].scale: invalid length 2, expected an array of length 3",
    ),
];
