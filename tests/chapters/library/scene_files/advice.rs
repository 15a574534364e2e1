//! Scene files with mistakes that people make: the error says what to write.

use super::{error_of, with};
use crate::prelude::*;

/// Mistakes that people make: the replaced text, its replacement, and the error.
const ADVICE: &[(&str, &str, &str)] = &[
    (
        "[[lights]]",
        "[lights]",
        "scene.toml:15: lights: found a table, but a list is needed: write `[[lights]]` for each of them",
    ),
    (
        "[image]",
        "[[image]]",
        "scene.toml:7: image: found a list, but a table is needed: write `[image]`",
    ),
    (
        "lens = { pinhole = { distance = 5 } }",
        "lens = [5]",
        "scene.toml:13: camera.lens: found a list, but a table is needed: write `lens = { kind = { … } }`",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "shape.sphere = [0, 0, 0, 1]\n",
        "scene.toml:29: objects[0] \"ball\", shape.sphere: found a list, but a table is needed: write `sphere = { center = … }`",
    ),
    (
        "shape.sphere",
        "shape.shpere",
        "scene.toml:29: objects[0] \"ball\", shape.shpere: unknown kind `shpere`; did you mean `sphere`?",
    ),
    (
        "[tracer.whitted]\nmax_depth = 5",
        "[tracer.Whitted]\nmax_depth = 5",
        "scene.toml:4: tracer.Whitted: unknown kind `Whitted`; did you mean `whitted`?",
    ),
    (
        "max_depth = 5",
        "max_depth = -1",
        "scene.toml:5: tracer.whitted.max_depth: invalid value: integer `-1`, expected a whole number from 0 to 128",
    ),
    (
        "height = 4",
        "height = 4\nsamples = 1e3",
        "scene.toml:10: image.samples: invalid type: floating point `1000.0`, expected a whole number from 1 to 65536; write 1000",
    ),
    (
        "radius = 1",
        "radius = 1,2",
        "scene.toml:31: unexpected key or value, expected newline, `#`: write `1.2` with a point, not `1,2`",
    ),
    (
        "distance = 5",
        "distance = -5,25",
        "scene.toml:13: invalid literal string, expected `'`: write `-5.25` with a point, not `-5,25`",
    ),
    (
        "radius = 1",
        "radius = .5",
        "scene.toml:31: invalid mantissa, expected digits: write `0.5`, with digits on both sides",
    ),
    (
        "center = [0, 0, 0]",
        "center = [0, 0, 0",
        "scene.toml:30: this `[` is not closed; write its `]`",
    ),
    (
        "lens = { pinhole = { distance = 5 } }",
        "lens = { pinhole = { distance = 5 } # \"]",
        "scene.toml:13: this `{` is not closed; write its `}`",
    ),
    ("radius = 1", "radius = [1, \"]\", 2", "scene.toml:31: this `[` is not closed; write its `]`"),
    (
        "center = [0, 0, 0]",
        "center = [\n0,\n0\n0]",
        "scene.toml:33: missing comma between array elements, expected `,`",
    ),
    (
        "name = \"red\"",
        "name: \"red\"",
        "scene.toml:20: key with no value, expected `=`: write `name = \"red\"`",
    ),
    (
        "name = \"red\"",
        "name = red",
        "scene.toml:20: string values must be quoted, expected literal string: write `name = \"red\"`",
    ),
    (
        "name = \"red\"",
        r#"name = "C:\Users\me""#,
        r"scene.toml:20: too few unicode value digits, expected unicode hexadecimal value: in double quotes a backslash begins an escape; write the path in single quotes, as 'C:\meshes\bunny.ply', or with /",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "shape.mesh = { file = \"meshes\\new.ply\" }\n",
        r#"scene.toml:29: objects[0] "ball", shape.mesh.file: meshes\u{a}ew.ply: the file cannot be read: No such file or directory (os error 2); in double quotes a backslash begins an escape; write the path in single quotes, as 'C:\meshes\bunny.ply', or with /"#,
    ),
];

/// Law: the error of a mistake that people make says what to write. Oracle: the mended text is a scene.
#[test]
fn errors_of_common_mistakes_say_what_to_write() {
    for (part, replacement, error) in ADVICE {
        assert_eq!(error_of(&with(part, replacement)), *error, "{part} -> {replacement}");
    }
    let mended =
        with("radius = 1", "radius = 1.2").replacen("name = \"red\"", r"name = 'C:\Users\me'", 1);
    let mended = mended.replacen("material = \"red\"", r"material = 'C:\Users\me'", 1);
    world::from_toml(&mended, Path::new("scene.toml")).expect("it is right");
}
