//! `bounds`: where a mesh is, and a camera that sees all of it.

use std::path::Path;

use groundtruth::film::read_exr;

use super::run_in;

const KNOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/knot.ply");

/// Law: what `bounds` prints of a mesh file is a scene whose picture shows all of the mesh: something is seen, nothing at
/// the edge, also of a mesh that is far from the origin and small. Oracle: the pixels; a mesh moved and scaled by hand.
#[test]
fn the_scene_of_a_mesh_shows_all_of_it() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::copy(KNOT, folder.path().join("knot.ply")).expect("copied");
    let far = "v 1e5 2e5 -3e5\nv 100002 2e5 -3e5\nv 1e5 200001 -3e5\nv 1e5 2e5 -299998\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";
    std::fs::write(folder.path().join("far.obj"), far).expect("written");
    for mesh in ["knot.ply", "far.obj"] {
        let run = run_in(folder.path(), &["bounds", mesh]);
        assert_eq!(run.status, Some(0), "{}", run.stderr);
        assert!(run.stdout.starts_with(&format!("# {mesh}: from [")), "{}", run.stdout);
        std::fs::write(folder.path().join("seen.toml"), &run.stdout).expect("written");
        let render = ["render", "seen.toml", "-o", "a.exr", "--samples", "1", "--size", "80x60"];
        let rendered = run_in(folder.path(), &render);
        assert_eq!(rendered.status, Some(0), "{}", rendered.stderr);
        let film = read_exr(&folder.path().join("a.exr")).expect("written");
        let seen = |x: u32, y: u32| !film.get([x, y]).is_black();
        let count =
            (0..60).flat_map(|y| (0..80).map(move |x| (x, y))).filter(|&(x, y)| seen(x, y)).count();
        assert!(count > 200, "{mesh}: {count} pixels show it");
        let edge = (0..80).any(|x| seen(x, 0) || seen(x, 59))
            || (0..60).any(|y| seen(0, y) || seen(79, y));
        assert!(!edge, "{mesh} reaches the edge");
    }
}

/// Law: of a scene `bounds` prints the box of each object, and a camera that may stand in its place. Oracle: a sphere's
/// box, by hand; the scene with that camera is read.
#[test]
fn the_boxes_of_a_scene_and_its_camera_are_printed() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = "[image]\nwidth = 40\nheight = 30\n[[materials]]\nname = \"m\"\nrecipe.matte.cd = 1\n\
        [[objects]]\nname = \"ball\"\nmaterial = \"m\"\nshape.sphere = { center = [1, 2, 3], radius = 2 }\n\
        [[objects]]\nname = \"ground\"\nmaterial = \"m\"\nshape.plane = { point = [0, 0, 0], normal = [0, 1, 0] }\n";
    let camera = "[camera]\neye = [0, 0, 50]\nlens.orthographic = {}\n";
    std::fs::write(folder.path().join("a.toml"), format!("{scene}{camera}")).expect("written");
    let run = run_in(folder.path(), &["bounds", "a.toml"]);
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    for line in [
        "#   \"ball\": from [-1.0, 0.0, 1.0] to [3.0, 4.0, 5.0]",
        "#   \"ground\": has no end",
        "# all that end: from [-1.0, 0.0, 1.0] to [3.0, 4.0, 5.0]",
        "look_at = [1.0, 2.0, 3.0]",
    ] {
        assert!(run.stdout.lines().any(|found| found == line), "{line} in\n{}", run.stdout);
    }
    std::fs::write(folder.path().join("b.toml"), format!("{scene}{}", run.stdout))
        .expect("written");
    let again = run_in(folder.path(), &["bounds", "b.toml"]);
    assert_eq!(again.stdout, run.stdout, "{}", again.stderr);
    assert_eq!(run_in(Path::new("."), &["bounds", "no.ply"]).status, Some(2));
}
