use super::{LawReport, RayLaw};
use crate::traced::{Orphan, Traced};

pub const LAW: RayLaw = RayLaw {
    name: "tree",
    says: "rays are a tree: each has one sender in its sample, which hit something",
    needs: &[],
    causes: &[
        "its parent is not in the log",
        "another ray of its sample has the same name",
        "rays send each other in a circle",
        "it was sent by a ray that hit nothing",
    ],
    check,
};

fn check(traced: &Traced, asked: &mut LawReport) {
    asked.rays = traced.log.rays.len();
    let mut find = |ray: usize, cause: usize, words: String| {
        asked.findings.push(super::BrokenRay { ray, words, causes: 1 << cause, follows: None });
    };
    for orphan in &traced.orphans {
        match *orphan {
            Orphan::Parentless(ray) => {
                let parent =
                    traced.ray(ray).parent.as_ref().map_or(String::new(), ToString::to_string);
                find(
                    ray,
                    0,
                    format!(
                        "names a parent, {}, that its sample does not have",
                        groundtruth::printable::name(&parent)
                    ),
                );
            }
            Orphan::Twin(ray) => {
                find(ray, 1, "has the name of another ray of its sample".to_owned())
            }
        }
    }
    for &ray in &traced.cycles {
        find(ray, 2, "is sent by a ray that it sent itself".to_owned());
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
            find(ray, 3, "leaves where nothing was hit".to_owned());
        }
    }
}
