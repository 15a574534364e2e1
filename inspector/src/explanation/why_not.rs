//! Why the selected ray does not hit an object.

use eframe::egui::{ComboBox, RichText, Ui};
use explain::RecordedRay;
use groundtruth::printable::name;
use space::why_not;

use crate::explanation::Subject;
use crate::explanation::asked::Question;
use crate::scene::source::Built;

/// The answer for the ray and the object that were selected last.
#[derive(Default)]
pub struct WhyNotView {
    answered: Option<((Question, usize, u32), Vec<String>)>,
}

impl WhyNotView {
    /// Shows the list of objects, and why the ray does not hit the chosen one. Returns the one that is chosen now.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        subject: &Subject<'_>,
        (question, root): (Question, &RecordedRay),
        ray: usize,
        mut asked: Option<u32>,
    ) -> Option<u32> {
        let objects = &subject.built().world.names.objects;
        if objects.is_empty() {
            return None;
        }
        let chosen = asked.and_then(|object| objects.get(object as usize));
        ui.horizontal(|ui| {
            let label = ui.label("Why does it not hit");
            let text = chosen.map_or("…".to_owned(), |object| name(object).to_string());
            let list = ComboBox::from_id_salt("why not").selected_text(text).truncate();
            let list = list.show_ui(ui, |ui| {
                for (index, object) in (0..).zip(objects) {
                    ui.selectable_value(&mut asked, Some(index), name(object).to_string());
                }
            });
            let hint = "Or click an object of the picture or of space with the right button";
            list.response.labelled_by(label.id).on_hover_text(hint);
        });
        let Some(object) = asked.filter(|_| chosen.is_some()) else { return asked };
        let of = (question, ray, object);
        if self.answered.as_ref().is_none_or(|(answered, _)| *answered != of) {
            self.answered = Some((of, answer(subject, root, ray, object)));
        }
        let lines = self.answered.iter().flat_map(|(_, lines)| lines);
        for (index, line) in lines.enumerate() {
            let text = RichText::new(line);
            ui.label(if index == 0 { text.strong() } else { text.monospace().size(11.5) });
        }
        asked
    }
}

/// The answer in a sentence, and its numbers.
fn answer(subject: &Subject<'_>, root: &RecordedRay, ray: usize, object: u32) -> Vec<String> {
    let Built { source, scene, world, .. } = subject.built();
    let folder = source.folder();
    let question = why_not::Question { scene, folder, world, root, ray, object };
    match question.answer() {
        Ok(answer) => std::iter::once(answer.sentence()).chain(answer.numbers()).collect(),
        Err(problem) => vec![problem],
    }
}
