//! The judges that files of families name.

use super::super::family::{Judge, Namer};
use super::super::radiance;

/// The judge of this name, and what names the mistakes of wrong answers.
pub fn judge(name: &str) -> Option<(Judge, Option<Namer>)> {
    let scenes = Some(radiance::NAMER);
    Some(match name {
        "radiance" => (Judge::Answer(radiance::judge), scenes),
        "mean" => (Judge::Law(radiance::mean_agrees), scenes),
        _ => return None,
    })
}
