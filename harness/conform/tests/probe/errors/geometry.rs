//! Errors of questions about rays, shapes, transformations and grids.

/// Questions, and their errors.
pub const ERRORS: &[(&str, &str)] = &[
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
        "column 131: unknown field `al`, expected one of `shape`, `scene`, `transform`, `ray`, `span`, `all`, `leave`",
    ),
    (
        r#"{"intersect": {"shape": {"sphere": {"center": [0, 0, 0], "radius": 0}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}}}"#,
        "intersect.shape.sphere.radius: found 0, but a positive, finite number is needed",
    ),
    (
        r#"{"intersect": {"shape": {"spheer": {}}, "ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}}}"#,
        "column 33: unknown kind `spheer`; did you mean `sphere`?",
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
        "occluded: needs `shape`, `shapes` or `scene`",
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
        "column 38: invalid type: integer `1`, expected a list",
    ),
    (
        r#"{"transform": {"steps": [{"turn": 3}]}}"#,
        "column 32: unknown kind `turn`, expected one of `translate`, `scale`, `rotate_x`, `rotate_y`, `rotate_z`, `rotate_about`, `reflect`, `shear`, `matrix`",
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
];
