//! Audits of rows, also where values are not finite.

use groundtruth::film::Film;
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::world::World;
use pictures::sums::{Contradiction, MergeError, Sums, SumsFile, audit};

use super::header::header;
use crate::verbs::equal;

const SIDE: u32 = 8;

fn world() -> World {
    let mut scene = (gallery::find("ch03/single-sphere").expect("listed").build)();
    scene.image.resize(SIDE, SIDE);
    scene.image.samples = 1;
    World::build(&scene).expect("it is valid")
}

/// Law: an audit of any rows accepts a correct part. It names the pixel of a changed value in its rows, also of one that is
/// not finite, and ignores changes in other rows. Oracle: the renderer, and the pixel that was changed.
#[test]
fn an_audit_is_of_its_rows() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut world = world();
    let film = render::render(&world);
    let part = |film: &Film| {
        let mut sums = Sums::new(header([SIDE; 2]));
        sums.add(film, 3).expect("it fits");
        let file = folder.path().join("a.sums");
        sums.write(&file).expect("written");
        SumsFile::open(&file).expect("whole")
    };
    let right = part(&film);
    for rows in [vec![0], vec![7], vec![1, 2], (0..SIDE).collect()] {
        audit(&right, &mut world, &rows, || ())
            .unwrap_or_else(|error| panic!("rows {rows:?}: {error}"));
    }
    for (at, value) in [([3, 2], f64::NAN), ([0, 5], 0.25), ([7, 0], f64::INFINITY)] {
        let mut changed = film.clone();
        let [r, _, b] = film.get(at).to_array();
        changed.set(at, Rgb::new(r, value, b));
        let wrong = part(&changed);
        for row in 0..SIDE {
            let found = match audit(&wrong, &mut world, &[row], || ()) {
                Ok(()) => None,
                Err(MergeError::Contradiction(Contradiction::Audit { pixel, .. })) => Some(pixel),
                Err(error) => panic!("{error}"),
            };
            let expected = (row == at[1]).then_some(at);
            equal(format!("pixel that differs in row {row}"), found, expected);
        }
    }
}
