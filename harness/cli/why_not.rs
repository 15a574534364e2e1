//! `groundtruth explain --why-not`: why a ray does not hit an object.

use explain::PixelExplanation;
use groundtruth::film::Provenance;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use serde::Serialize;
use space::why_not::{Question, WhyNot, object_named};
use text::shell;

use super::explain::Explain;
use super::{Outcome, print};

/// What `--why-not --json` prints.
#[derive(Serialize)]
struct Report {
    made: Provenance,
    pixel: [u32; 2],
    sample: u32,
    sentence: String,
    #[serde(flatten)]
    why_not: WhyNot,
    next: String,
}

impl Explain {
    /// Prints the answer for an object and the explained sample, as text or, with how it was made, as JSON.
    ///
    /// # Errors
    /// No such object, or no such ray.
    pub(super) fn why_not(
        &self,
        object: &str,
        (scene, world): (&Scene, &World),
        explanation: &PixelExplanation,
        made: Option<Provenance>,
    ) -> Outcome {
        let object = object_named(scene, object)?;
        let sample = explanation.samples.first().ok_or("no sample is explained")?;
        let root = sample.ray.as_ref().ok_or("no ray: the camera sees nothing at this pixel")?;
        let (folder, ray) = (self.scene.files_folder(), self.ray.unwrap_or(0));
        let why_not = Question { scene, folder, world, root, ray, object }.answer()?;
        let next = next(&why_not, &self.command());
        if let Some(made) = made {
            let (pixel, sample) = (explanation.pixel, sample.index);
            let sentence = why_not.sentence();
            let report = Report { made, pixel, sample, sentence, why_not, next };
            return print(&(serde_json::to_string_pretty(&report)? + "\n"));
        }
        let mut text = why_not.sentence() + "\n";
        why_not.numbers().iter().for_each(|line| text += &format!("  {line}\n"));
        print(&(text + &format!("next: {next}\n")))
    }
}

/// The command that tells more: about a ray that meets the object, about the object that is in the way, or about all
/// rays.
fn next(why_not: &WhyNot, command: &str) -> String {
    let about = |object: &str, ray: usize| {
        let ray = if ray > 0 { format!(" --ray {ray}") } else { String::new() };
        format!("{command} --why-not {}{ray}", shell::quoted(object))
    };
    let is_met = why_not.met_by.contains(&why_not.ray);
    match (why_not.met_by.first(), &why_not.ended) {
        (Some(&other), _) if !is_met => about(&why_not.object, other),
        (_, Some(ended)) if !is_met => about(&ended.object, why_not.ray),
        _ => command.to_owned(),
    }
}
