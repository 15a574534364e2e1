//! `groundtruth report`: its contents are complete and right.

mod html;
mod light;
mod markup;
mod plots;
mod random_samples;
mod references;
mod samplers;
mod structures;
mod tables;
mod textbook;
mod textures;
mod times;

use std::process::Command;
use std::sync::LazyLock;
use std::time::{Duration, UNIX_EPOCH};

use exact::backward_error::ALLOWED;
use exact::composites;
use oracle::hard::{Family, Kind};
use report::{Interrupted, PAGES, Page, ReportProgress, Settings};
use serde_json::Value;

/// Small, but large enough for the laws to judge.
const SMALL: Settings = Settings {
    seed: 5,
    cases: 60,
    objects: 1000,
    side: 16,
    samples: 1024,
    pixels: 16,
    seeds: 16,
    width: 6,
};

/// A report of all pages.
struct Small {
    json: Value,
    html: String,
}

fn measure(pages: &[Page], settings: &Settings) -> Small {
    let report =
        report::run(pages, settings, &ReportProgress::default()).expect("nobody interrupts");
    Small { json: serde_json::from_str(&report.json()).expect("JSON"), html: report.html() }
}

/// Measured once for all tests.
static REPORT: LazyLock<Small> = LazyLock::new(|| measure(PAGES, &SMALL));

fn list(value: &Value) -> &[Value] {
    value.as_array().expect("a list")
}

fn text(value: &Value) -> &str {
    value.as_str().expect("a text")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// Every scene and choice of a page.
fn choices(page: &str) -> impl Iterator<Item = (&'static Value, &'static Value)> {
    let scenes = list(&REPORT.json["pages"][page]["scenes"]);
    scenes.iter().flat_map(|scene| list(&scene["choices"]).iter().map(move |c| (scene, c)))
}

/// Every kind and family of page 1.
fn families() -> impl Iterator<Item = (&'static str, &'static str, &'static Value)> {
    list(&REPORT.json["pages"]["intersections"]["kinds"]).iter().flat_map(|kind| {
        let families = list(&kind["families"]).iter();
        families.map(move |family| (text(&kind["kind"]), text(&family["family"]), family))
    })
}

/// Law: no shape and no family is left out.
#[test]
fn the_report_holds_every_shape_and_family() {
    let found: Vec<(String, String)> =
        families().map(|(kind, family, _)| (kind.to_owned(), family.to_owned())).collect();
    let one = Kind::ALL.iter().map(|kind| format!("{kind:?}"));
    let kinds = one.chain(composites::Kind::ALL.iter().map(|kind| format!("{kind:?}")));
    let expected: Vec<_> = kinds
        .flat_map(|kind| Family::ALL.map(|family| (kind.clone(), format!("{family:?}"))))
        .collect();
    assert_eq!(found, expected);
    let judged: u64 = families().map(|(_, _, f)| f["judged"].as_u64().expect("a count")).sum();
    let kinds = list(&REPORT.json["pages"]["intersections"]["kinds"]);
    let rays: u64 = kinds.iter().map(|kind| kind["cases"].as_u64().expect("a count")).sum();
    let all = rays * Family::ALL.len() as u64;
    assert!(2 * judged > all && judged <= all, "{judged} of {all} are judged");
}

/// Law: our routines lose and invent no hit, and are right within 100 u·cond. Oracle: 512-bit arithmetic.
#[test]
fn ours_is_right_on_every_family() {
    for (kind, name, family) in families() {
        let ours = &family["ours"];
        assert_eq!((&ours["lost"], &ours["wrong"]), (&0.into(), &0.into()), "{kind} {name}");
        let hits = family["hits"].as_u64().expect("a count");
        let errors = ["median", "p999", "worst"].map(|key| ours[key].as_f64());
        match errors {
            [Some(median), Some(p999), Some(worst)] => {
                assert!(median <= p999 && p999 <= worst && worst <= ALLOWED, "{kind} {name}");
                assert!(ours["hit_ns"].as_f64().is_some_and(|ns| ns > 0.0), "{kind} {name}");
            }
            _ => assert_eq!((hits, errors), (0, [None; 3]), "{kind} {name}"),
        }
    }
}

/// Law: the comparison shows the known weaknesses of the textbook's formulas: `b² − 4ac` loses digits for
/// far spheres and cylinders, a constant epsilon loses hits on tiny shapes; planes lose nothing.
#[test]
fn the_textbook_fails_where_it_is_known_to() {
    let book = |kind: &str, family: &str| {
        let found = families().find(|(k, f, _)| (*k, *f) == (kind, family));
        found.expect("it is there").2["textbook"].clone()
    };
    // at a distance of 10³ to 10⁸ sizes, b² loses 6 to 16 digits against r²
    for kind in ["Sphere", "OpenCylinder"] {
        let far = book(kind, "FarOrigin");
        let worst = far["worst"].as_f64().unwrap_or(0.0);
        assert!(worst > 1e4 || far["lost"].as_u64() > Some(0), "{kind}: {far}");
        assert!(book(kind, "Ordinary")["worst"].as_f64().is_some_and(|e| e < ALLOWED), "{kind}");
    }
    let scaled = book("Sphere", "Scaled");
    assert!(scaled["lost"].as_u64() > Some(0), "{scaled}");
    let worst = &book("Plane", "FarOrigin")["worst"];
    assert!(worst.as_f64().is_some_and(|e| e < ALLOWED), "the worst error is {worst}");
    // compounds and grids lose hits, too; on ordinary rays they lose and invent nothing
    for kind in ["Compound", "RandomSpheres", "Lattice", "TessellatedSphere"] {
        let scaled = book(kind, "Scaled");
        assert!(scaled["lost"].as_u64() > Some(0), "{kind}: {scaled}");
        let ordinary = book(kind, "Ordinary");
        assert_eq!((&ordinary["lost"], &ordinary["wrong"]), (&0.into(), &0.into()), "{kind}");
    }
}

/// Law: every structure is measured at every size or left out for a stated reason; all give the same hits;
/// and the number of tests per ray is plausible: all objects in a list, far fewer in a tree.
#[test]
fn acceleration_is_measured_or_left_out_for_a_reason() {
    let stages = list(&REPORT.json["pages"]["acceleration"]["stages"]);
    assert!(stages.len() >= 4, "{} stages", stages.len());
    for stage in stages {
        let (runs, skipped) = (list(&stage["runs"]), list(&stage["skipped"]));
        assert_eq!(stage["agree"], true, "{}", stage["stage"]);
        let of = |name: &str| runs.iter().filter(|r| r["structure"] == name).count();
        assert_eq!((of("list"), of("bvh")), (3, 3), "{}", stage["stage"]);
        assert!(skipped.iter().all(|s| s["why"].as_str().is_some_and(|why| !why.is_empty())));
        for run in runs {
            let [objects, tests] = ["objects", "tests_per_ray"].map(|key| number(&run[key]));
            match run["structure"].as_str() {
                Some("list") => assert_eq!(tests, objects, "{run}"),
                Some("bvh") => assert!(tests < 0.3 * objects, "{run}"),
                _ => assert!(tests <= 3.0 * objects, "{run}"),
            }
            let times = ["build_seconds", "picture_seconds"].map(|key| number(&run[key]));
            assert!(times.iter().all(|time| *time > 0.0), "{run}");
        }
    }
}

/// Everything that does not depend on the clock.
fn timeless(value: &Value) -> Value {
    let clock = |key: &str| {
        let exact = ["disturbed", "efficiency", "equal_time"];
        key.ends_with("_ns") || key.ends_with("_seconds") || exact.contains(&key)
    };
    match value {
        Value::Object(map) => {
            let kept = map.iter().filter(|(key, _)| !clock(key));
            Value::Object(kept.map(|(key, value)| (key.clone(), timeless(value))).collect())
        }
        Value::Array(items) => items.iter().map(timeless).collect(),
        other => other.clone(),
    }
}

/// Law: the same seed gives the same report, except for the times, on one thread and on two. Oracle: each other.
#[test]
fn a_report_is_the_same_each_time_but_for_the_times() {
    let tiny =
        Settings { cases: 8, objects: 316, samples: 16, pixels: 3, seeds: 2, width: 4, ..SMALL };
    let [first, again] = [1, 2].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| measure(PAGES, &tiny).json["pages"].clone())
    });
    for page in PAGES.iter().map(|page| page.name) {
        assert!(timeless(&again[page]) == timeless(&first[page]), "{page} differs");
        assert!(timeless(&again[page]) != again[page], "there are times in {page}");
    }
}

/// Law: a report names machine, version, commit and seed. Oracle: git, and the comparison of the program's
/// time with the commit's.
#[test]
fn a_report_says_where_it_comes_from() {
    let provenance = &REPORT.json["provenance"];
    for key in ["version", "commit", "processor", "platform"] {
        let words = text(&provenance[key]);
        assert!(!words.is_empty() && REPORT.html.contains(words), "{key}: {words}");
    }
    assert_eq!(provenance["version"], env!("CARGO_PKG_VERSION"));
    let git = |words: &[&str]| {
        let folder = env!("CARGO_MANIFEST_DIR");
        let output = Command::new("git").args(["-C", folder]).args(words).output().ok()?;
        output.status.success().then(|| String::from_utf8(output.stdout).expect("a text"))
    };
    if let Some(head) = git(&["log", "-1", "--format=%H %ct"]) {
        let commit = text(&provenance["commit"]);
        let (hash, time) = head.trim().split_once(' ').expect("two words");
        assert!(commit.starts_with(&hash[..12]), "{commit}, not {hash}");
        let time = UNIX_EPOCH + Duration::from_secs(time.parse().expect("seconds"));
        let program = std::env::current_exe().expect("this one").metadata().expect("a file");
        let older = program.modified().expect("a time") < time;
        assert_eq!(commit.ends_with("-or-earlier"), older, "{commit}");
    }
    assert!(provenance["threads"].as_u64() >= Some(1));
    assert_eq!(REPORT.json["seed"], SMALL.seed);
}

/// Law: an interrupted run gives no report and stops before its last step.
#[test]
fn an_interrupted_report_stops_at_the_next_step() {
    for page in PAGES {
        let progress = ReportProgress::default();
        progress.interrupt();
        let result = report::run(&[*page], &SMALL, &progress);
        assert_eq!(result.map(drop), Err(Interrupted), "{}", page.name);
        assert!(progress.steps().0 < progress.steps().1, "{:?}", progress.steps());
    }
}

/// Law: a page takes as many steps as it announces, so that the progress ends at 100 %.
#[test]
fn the_progress_ends_at_the_end() {
    for page in PAGES {
        let progress = ReportProgress::default();
        let tiny = Settings { cases: 2, objects: 100, side: 4, samples: 16, width: 4, ..SMALL };
        assert!(report::run(&[*page], &tiny, &progress).is_ok());
        assert_eq!(progress.steps(), ((page.steps)(&tiny), (page.steps)(&tiny)), "{}", page.name);
    }
}
