//! Golden images: each one is reproduced, and each scene of the gallery has one.

use std::path::Path;

use golden::{GoldenStatus, Goldens};
use golden::{compare, review};
use libtest_mimic::Trial;

/// `ch24::golden::hall_of_mirrors`, `ch24::golden::hall_of_mirrors_normals`.
pub fn trials() -> Vec<Trial> {
    let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../goldens"));
    let goldens = match Goldens::open(folder) {
        Ok(goldens) => goldens,
        Err(error) => {
            let failed = move || Err(error.to_string().into());
            return vec![Trial::test("golden::the_manifest_can_be_read", failed)];
        }
    };
    let names = goldens.names();
    let trial = |name: String| {
        let goldens = goldens.clone();
        let (chapter, scene) = name.split_once('/').unwrap_or(("files", &name));
        let words = scene.replace(['-', '.'], "_");
        Trial::test(format!("{chapter}::golden::{words}"), move || {
            Ok(is_the_same(&goldens, &name)?)
        })
    };
    names.into_iter().map(trial).collect()
}

fn is_the_same(goldens: &Goldens, name: &str) -> Result<(), String> {
    let finding = goldens.check(name).map_err(|error| error.to_string())?;
    if finding.status == GoldenStatus::Same {
        return Ok(());
    }
    let mut text = format!("{name}: {}\n", review::words(&finding.status));
    if let (Some(golden), Some(expected), Some(got)) =
        (&finding.golden, &finding.expected, &finding.got)
    {
        text += &format!("it shows: {}\n", golden.shows);
        for worst in compare::differences(expected, got).iter().take(3) {
            text += &format!("{worst:?}\n");
        }
    }
    text += "to look:   groundtruth goldens review -o review.html\n";
    Err(text + "to accept: " + &review::accept_command(&finding))
}
