//! The menu *Compare with …*: one field for a value of the scene, another scene or a picture, and a list of what there is.

use eframe::egui::{
    Button, Key, Margin, Popup, PopupCloseBehavior, RichText, ScrollArea, TextEdit, TextWrapMode,
    Ui,
    text::{CCursor, CCursorRange},
};

use crate::action::{Action, With};
use crate::comparison::opening::is_picture;
use crate::picture::worker::Rendering;
use crate::platform::Purpose;
use crate::scene::fields::{self, Change};
use crate::scene::source::Source;

/// The number of frames for which a popup is drawn invisibly, until its size is known and it is in position.
const FRAMES_TO_OPEN: u8 = 3;
/// The height of a line of the list, and of the list, in points of the screen.
const LINE: f32 = 18.0;
const LIST_HEIGHT: f32 = 260.0;
const WIDTH: f32 = 460.0;
/// Around the text of the field.
const FIELD_MARGIN: Margin = Margin::symmetric(6, 4);

/// The menu, closed or open.
#[derive(Default)]
pub struct CompareMenu {
    typed: String,
    /// The words by which a mistake is looked for.
    pub mistake: String,
    problem: Option<String>,
    /// Frames until the open menu is in position.
    opening: u8,
    /// What fits the typed words, and for which rendering and words it was looked up.
    found: Option<((u64, String), Vec<Row>)>,
}

/// A line of the list.
#[derive(Clone)]
enum Row {
    Title(&'static str),
    Field(Change),
    Scene(gallery::Entry),
}

impl CompareMenu {
    /// Shows the button, and the menu once it is open. Returns what to compare with.
    pub fn show(&mut self, ui: &mut Ui, rendering: &Rendering) -> Option<Action> {
        let button = ui.button("Compare with …");
        let button = button.on_hover_text(
            "Another value of a field, another scene, this one as it is now, or a picture, which can also be dropped on \
             the window",
        );
        if button.clicked() {
            (self.opening, self.problem) = (FRAMES_TO_OPEN, None);
        }
        let popup = Popup::menu(&button).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        popup.width(WIDTH).show(|ui| self.body(ui, rendering))?.inner
    }

    fn body(&mut self, ui: &mut Ui, rendering: &Rendering) -> Option<Action> {
        let mut asked = None;
        ui.horizontal(|ui| {
            let action = |ui: &mut Ui, name, hint, action| {
                ui.button(name).on_hover_text(hint).clicked().then_some(action)
            };
            let hint = "The scene as it is shown now; what is changed then is compared with it";
            asked = action(ui, "This state", hint, Action::Compare(With::State))
                .or(action(ui, "A picture …", "A file", Action::Choose(Purpose::Theirs)))
                .or(action(ui, "A scene …", "A file", Action::Choose(Purpose::OtherScene)));
        });
        ui.add_space(4.0);
        let label = ui.label("or a field with another value, or a scene");
        let hint = "words of a path, path = value, a scene, or a file";
        let field = TextEdit::singleline(&mut self.typed).hint_text(hint).margin(FIELD_MARGIN);
        let output = field.desired_width(f32::INFINITY).show(ui);
        let field = output.response.response.labelled_by(label.id);
        let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if self.opening > 0 {
            field.request_focus();
        }
        self.opening = self.opening.saturating_sub(1);
        if field.changed() {
            self.problem = None;
        }
        if entered {
            self.look_up(rendering);
            match self.meant(rendering) {
                Ok(action) => asked = Some(action),
                Err(problem) => {
                    self.problem = Some(problem);
                    field.request_focus();
                }
            }
        }
        if let Some(problem) = &self.problem {
            ui.colored_label(ui.visuals().error_fg_color, problem);
        }
        match self.list(ui, rendering) {
            Some(Row::Scene(entry)) => {
                asked = Some(Action::Compare(With::Scene(Source::Gallery(entry))))
            }
            Some(Row::Field(change)) => {
                // its value is what is typed next
                self.typed = change.to_string();
                let end = self.typed.chars().count();
                let start = end - change.value.chars().count();
                let mut state = output.state;
                let range = CCursorRange::two(CCursor::new(start), CCursor::new(end));
                state.cursor.set_char_range(Some(range));
                state.store(ui.ctx(), field.id);
                field.request_focus();
            }
            Some(Row::Title(_)) | None => {}
        }
        if asked.is_some() {
            ui.close();
        }
        asked
    }

    /// Shows the fields and scenes that have the typed words; returns the one that is clicked.
    fn list(&mut self, ui: &mut Ui, rendering: &Rendering) -> Option<Row> {
        self.look_up(rendering);
        let (_, rows) = self.found.as_ref()?;
        let mut clicked = None;
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.spacing_mut().interact_size.y = LINE;
        ui.spacing_mut().button_padding.y = 0.0;
        let area = ScrollArea::vertical().max_height(LIST_HEIGHT).min_scrolled_height(LIST_HEIGHT);
        area.auto_shrink([false, true]).show_rows(ui, LINE, rows.len(), |ui, visible| {
            ui.style_mut().wrap_mode = Some(TextWrapMode::Truncate);
            for row in &rows[visible] {
                let (text, hint) = match row {
                    Row::Title(title) => {
                        ui.weak(*title);
                        continue;
                    }
                    Row::Field(change) => (change.to_string(), "Type another value for it"),
                    Row::Scene(entry) => (entry.name.to_owned(), gallery::about(*entry)),
                };
                let button = Button::selectable(false, RichText::new(text));
                if ui.add(button).on_hover_text(hint).clicked() {
                    clicked = Some(row.clone());
                }
            }
        });
        clicked
    }

    fn look_up(&mut self, rendering: &Rendering) {
        let of = (rendering.generation, self.typed.clone());
        if self.found.as_ref().is_some_and(|(found, _)| *found == of) {
            return;
        }
        let typed = self.typed.split('=').next().unwrap_or_default();
        let of_scene = fields::all(&rendering.scene).into_iter();
        let of_scene = of_scene.filter(|field| fields::has_words(&field.path, typed));
        let of_scene: Vec<Row> = of_scene.map(Row::Field).collect();
        let scenes = gallery::ranked(typed).into_iter().map(Row::Scene).collect();
        let parts = [("Fields of this scene", of_scene), ("Scenes", scenes)];
        let parts = parts.into_iter().filter(|(_, rows)| !rows.is_empty());
        let rows = parts.flat_map(|(title, rows)| std::iter::once(Row::Title(title)).chain(rows));
        self.found = Some((of, rows.collect()));
    }

    /// What the typed text asks for. Words that only one field has stand for its path.
    fn meant(&self, rendering: &Rendering) -> Result<Action, String> {
        let typed = self.typed.trim();
        if typed.is_empty() {
            return Err("type a field as path = value, or the name of a scene".to_owned());
        }
        if let Some(mut change) = Change::parse(typed) {
            let rows = self.found.iter().flat_map(|(_, rows)| rows);
            let fields =
                rows.filter_map(|row| if let Row::Field(it) = row { Some(it) } else { None });
            let fields: Vec<&Change> = fields.collect();
            let is_whole = fields.iter().any(|field| field.path == change.path);
            if !is_whole && change.applied(&rendering.scene).is_err() {
                match fields[..] {
                    [] => {}
                    [field] => change.path.clone_from(&field.path),
                    _ => return Err(format!("{} fields have these words", fields.len())),
                }
            }
            return Ok(Action::Compare(With::Field(change)));
        }
        if is_picture(typed.as_ref()) {
            return Ok(Action::Compare(With::Picture(typed.into())));
        }
        Source::named(typed).map(|source| Action::Compare(With::Scene(source)))
    }
}
