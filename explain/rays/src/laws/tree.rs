use super::LawReport;
use crate::traced::{Orphan, Traced};

pub fn check(traced: &Traced, asked: &mut LawReport) {
    asked.rays = traced.log.rays.len();
    let mut find = |ray, cause, words| asked.find(ray, words, [(cause, true)]);
    for orphan in &traced.orphans {
        match *orphan {
            Orphan::Parentless(ray) => {
                let parent =
                    traced.ray(ray).parent.as_ref().map_or(String::new(), ToString::to_string);
                find(
                    ray,
                    "no-parent",
                    format!(
                        "names a parent, {}, that its sample does not have",
                        groundtruth::printable::name(&parent)
                    ),
                );
            }
            Orphan::Twin(ray) => {
                find(ray, "same-name", "has the name of another ray of its sample".to_owned())
            }
        }
    }
    for &ray in &traced.cycles {
        find(ray, "in-a-circle", "is sent by a ray that it sent itself".to_owned());
    }
    // a log without any hit says nothing of them
    let has_hits = traced.log.rays.iter().any(|ray| ray.t.is_some() || ray.point.is_some());
    for (ray, parent) in traced.pairs().filter(|_| has_hits) {
        let from = traced.ray(parent);
        let hit_nothing = from.t.is_none()
            && from.point.is_none()
            && from.object.is_none()
            && from.normal.is_none();
        if hit_nothing {
            find(ray, "left-nothing", "leaves where nothing was hit".to_owned());
        }
    }
}
