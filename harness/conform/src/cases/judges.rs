//! The judges that files of families name.

use super::super::family::{Judge, Namer};
use super::super::{radiance, scenes};

/// The judge of this name, and what names the mistakes of wrong answers in scenes.
pub fn judge(name: &str) -> Option<(Judge, Option<Namer>)> {
    let in_scene = |judge: Judge| Some((judge, Some(radiance::NAMER)));
    match name {
        "radiance" => in_scene(Judge::Answer(radiance::judge)),
        "mean" => in_scene(Judge::Law(radiance::mean_agrees)),
        "rays" => in_scene(Judge::Answer(scenes::judge_rays)),
        "first_hit" => in_scene(Judge::Answer(scenes::judge_hit)),
        "occluded" => in_scene(Judge::Answer(scenes::judge_occluded)),
        _ => None,
    }
}
