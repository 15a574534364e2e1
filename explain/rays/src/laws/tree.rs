use super::LawReport;
use crate::traced::{Orphan, Traced};
use groundtruth::printable;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    asked.rays = traced.log.rays.len();
    let mut find = |ray, cause, words| asked.find(ray, words, [(cause, true)]);
    for &(ray, why) in &traced.orphans {
        let (cause, words) = match why {
            Orphan::Parentless => {
                let parent = traced.ray(ray).parent.as_ref().map(ToString::to_string);
                let parent = printable::name(&parent.unwrap_or_default());
                ("no-parent", format!("names a parent, {parent}, that its sample does not have"))
            }
            Orphan::Twin => ("same-name", "has the name of another ray of its sample".to_owned()),
            Orphan::InCircle => ("in-a-circle", "is sent by a ray that it sent itself".to_owned()),
        };
        find(ray, cause, words);
    }
    // a log without any hit says nothing of them
    let has_hits = traced.log.rays.iter().any(|ray| ray.t.is_some() || ray.point.is_some());
    for (ray, parent) in traced.pairs().filter(|_| has_hits) {
        let from = traced.ray(parent);
        let is_told = from.object.is_some() || from.normal.is_some();
        if from.t.is_none() && from.point.is_none() && !is_told {
            find(ray, "left-nothing", "leaves where nothing was hit".to_owned());
        }
    }
}
