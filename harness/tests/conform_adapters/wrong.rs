//! The adapter that is wrong on purpose.

use serde_json::Value;

use super::{ANSWERED, example, groundtruth, has, root, text_of};

/// A mistake of `wrong.py`.
struct Planted {
    /// Its comment.
    comment: &'static str,
    /// Beginnings of the names of families that it may spoil.
    spoils: &'static [&'static str],
    /// A family that it must spoil, even with few cases.
    surely: &'static str,
    /// What the card calls it; nothing if the answers do not give it away.
    name: &'static str,
}

const PLANTED: [Planted; 10] = [
    Planted {
        comment: "t is counted in a unit direction",
        spoils: &["intersect.sphere."],
        surely: "intersect.sphere.direction_length",
        name: "t is counted in a unit direction",
    },
    Planted {
        comment: "the normal is turned to the viewer",
        spoils: &["intersect.triangle."],
        surely: "intersect.triangle.ordinary",
        name: "the normal is turned to the viewer",
    },
    Planted {
        comment: "a plane is hit behind the origin",
        spoils: &["intersect.plane."],
        surely: "intersect.plane.ordinary",
        name: "a hit behind the origin",
    },
    Planted {
        comment: "what is behind the light hides it",
        spoils: &["occluded."],
        surely: "occluded.plane.segment",
        name: "",
    },
    Planted {
        comment: "1/π is left out",
        spoils: &["lobe.lambertian.values", "lobe.lambertian.sample"],
        surely: "lobe.lambertian.values",
        name: "π times too large",
    },
    Planted {
        comment: "uniform, and the pdf is that of the cosine",
        spoils: &["lobe.lambertian.density"],
        surely: "lobe.lambertian.density",
        name: "",
    },
    Planted {
        comment: "η upside down",
        spoils: &["fresnel.directions"],
        surely: "fresnel.directions",
        name: "η upside down",
    },
    Planted {
        comment: "Schlick's approximation",
        spoils: &["fresnel.cosine"],
        surely: "fresnel.cosine",
        name: "Schlick's approximation",
    },
    Planted {
        comment: "the corner of the pixel",
        spoils: &["camera_ray.pinhole."],
        surely: "camera_ray.pinhole.values",
        name: "the corner of the pixel for its middle",
    },
    Planted {
        comment: "rows from the bottom",
        spoils: &["project.pinhole.values"],
        surely: "project.pinhole.values",
        name: "rows from the bottom",
    },
];

/// Law: each mistake fails its families and no other, and is named where the answers give it away; the exit status
/// is 1. Oracle: the comments that mark the mistakes.
#[test]
fn each_mistake_of_the_wrong_adapter_is_found() {
    let wrong = text_of(example("wrong.py"));
    let comments: Vec<&str> =
        wrong.lines().filter_map(|line| Some(line.split_once("# mistake: ")?.1)).collect();
    let mut expected = PLANTED.map(|planted| planted.comment).to_vec();
    let mut found = comments.clone();
    expected.sort_unstable();
    found.sort_unstable();
    assert_eq!(found, expected);
    if !has("python3") {
        return;
    }
    let wrong = example("wrong.py");
    let mut arguments = vec!["conform", "--json", "--cases", "16"];
    arguments.extend(ANSWERED);
    arguments.extend(["--", "python3", &wrong]);
    let output = groundtruth(&root(), &arguments);
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    let card: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let families = card["families"].as_array().expect("a list");
    let failed: Vec<&Value> = families.iter().filter(|row| row["counts"]["wrong"] != 0).collect();
    let is = |row: &Value, name: &str| row["family"] == name;
    for row in &failed {
        let name = row["family"].as_str().expect("a name");
        let is_meant = |planted: &Planted| planted.spoils.iter().any(|it| name.starts_with(it));
        assert!(PLANTED.iter().any(is_meant), "{name} fails, and no mistake spoils it: {row}");
    }
    for Planted { comment, surely, name, .. } in PLANTED {
        let row = failed.iter().find(|row| is(row, surely));
        let row = row.unwrap_or_else(|| panic!("{surely} does not fail: {comment}"));
        let names: Vec<&str> = row["names"]
            .as_array()
            .into_iter()
            .flatten()
            .filter_map(|name| name.as_str()?.split(" (").next())
            .collect();
        assert!(name.is_empty() || names.contains(&name), "{surely}: {comment}: {names:?}");
    }
}
