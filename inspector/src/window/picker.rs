//! The list of the gallery's scenes by chapter, with thumbnails and a search field.

use eframe::egui::{
    Align, Button, FontId, Image, Key, Modifiers, Popup, PopupCloseBehavior, Rect, RichText,
    ScrollArea, TextEdit, TextFormat, TextureId, Ui, WidgetInfo,
    accesskit::Role,
    load::SizedTexture,
    text::{LayoutJob, TextWrapping},
    vec2,
};
use gallery::{self, Entry};

use crate::window::thumbnails::{SIZE, Thumbnails};

/// The number of frames for which a list is drawn invisibly, until its size is known and it is in position.
const FRAMES_TO_OPEN: u8 = 3;

/// The list, closed or open.
#[derive(Default)]
pub struct ScenePicker {
    /// The text in the search field.
    typed: String,
    /// The place in the list of the scene that Enter opens.
    chosen: usize,
    /// Whether that scene is to be scrolled into view.
    scroll: bool,
    /// Frames until the open list is in position.
    opening: u8,
    thumbnails: Thumbnails,
}

impl ScenePicker {
    /// Shows the present scene; a click opens the list. Returns the scene that was picked.
    pub fn show(&mut self, ui: &mut Ui, current: &str, width: f32) -> Option<Entry> {
        let label = ui.label("Scene");
        let height = ui.spacing().interact_size.y;
        let button = Button::new(current).truncate().right_text(RichText::new("▾").monospace());
        let button = ui.add_sized([width, height], button).labelled_by(label.id);
        let button = button.on_hover_text(current);
        if button.clicked() {
            self.typed.clear();
            self.chosen =
                gallery::ranked("").iter().position(|entry| entry.name == current).unwrap_or(0);
            self.opening = FRAMES_TO_OPEN;
        }
        let max_height = 0.8 * ui.ctx().content_rect().height();
        let popup = Popup::menu(&button).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        popup.width(460.0).show(|ui| self.list(ui, max_height))?.inner
    }

    fn list(&mut self, ui: &mut Ui, max_height: f32) -> Option<Entry> {
        let step = arrow_step(ui);
        let hint = "a name, a word, a chapter or a figure";
        let field = TextEdit::singleline(&mut self.typed).hint_text(hint);
        let field = ui.add(field.desired_width(f32::INFINITY));
        let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if self.opening > 0 {
            field.request_focus();
        }
        let found = gallery::ranked(&self.typed);
        if field.changed() {
            self.chosen = 0;
        }
        let last = found.len().saturating_sub(1);
        self.chosen = self.chosen.saturating_add_signed(step).min(last);
        self.scroll = step != 0 || field.changed() || self.opening > 0;
        let mut picked = if entered { found.get(self.chosen).copied() } else { None };
        // with a least height: the popup remembers that of a short list
        let area = ScrollArea::vertical().max_height(max_height).min_scrolled_height(max_height);
        area.auto_shrink([false, true]).show(ui, |ui| {
            let mut chapter = "";
            for (index, &entry) in found.iter().enumerate() {
                let (its_chapter, name) = entry.name.split_once('/').unwrap_or(("", entry.name));
                // what a search found is not in the order of the chapters
                if self.typed.is_empty() && its_chapter != chapter {
                    chapter = its_chapter;
                    let number = chapter.trim_start_matches("ch").trim_start_matches('0');
                    ui.weak(format!("Chapter {number}"));
                }
                if self.row(ui, entry, name, index == self.chosen) {
                    picked = Some(entry);
                }
            }
            if found.is_empty() {
                ui.weak("no scene has this in its name and description");
            }
        });
        self.opening = self.opening.saturating_sub(1);
        if picked.is_some() {
            ui.close();
        }
        picked
    }

    /// Shows a scene's thumbnail and name; returns whether it was clicked.
    fn row(&mut self, ui: &mut Ui, entry: Entry, name: &str, is_chosen: bool) -> bool {
        let row_height = SIZE[1] as f32 + 4.0;
        let is_wanted = is_chosen && self.scroll;
        let next = ui.cursor().with_max_y(ui.cursor().top() + row_height);
        if !ui.is_rect_visible(next) && !is_wanted {
            ui.allocate_space(vec2(ui.available_width(), row_height));
            return false;
        }
        let [width, height] = SIZE.map(|side| side as f32);
        let size = vec2(width, height);
        let image = match self.thumbnails.get(ui.ctx(), entry) {
            Some(thumbnail) => Image::new(SizedTexture::new(thumbnail.id(), size)),
            // the white corner of the texture that the letters are in
            None => Image::new(SizedTexture::new(TextureId::default(), size))
                .uv(Rect::ZERO)
                .tint(ui.visuals().extreme_bg_color),
        };
        let shown = if self.typed.is_empty() { name } else { entry.name };
        let text = described(ui, shown, gallery::about(entry));
        // laid out here: a button that cuts its text leaves one line of it
        let space = ui.available_width() - width - 3.0 * ui.spacing().button_padding.x;
        let wrap = TextWrapping { max_rows: 2, ..TextWrapping::truncate_at_width(space) };
        let text = ui.fonts_mut(|fonts| fonts.layout_job(LayoutJob { wrap, ..text }));
        let button = Button::image_and_text(image.fit_to_exact_size(size), text);
        let button = button.selected(is_chosen).frame_when_inactive(is_chosen);
        let row = ui.add(button.min_size(vec2(0.0, row_height)));
        row.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
        if is_wanted {
            row.scroll_to_me(if self.opening > 0 { Some(Align::Center) } else { None });
        }
        row.on_hover_text(gallery::about(entry)).clicked()
    }
}

/// The name of a scene and its description, one below the other.
fn described(ui: &Ui, name: &str, about: &str) -> LayoutJob {
    let (strong, weak) = (ui.visuals().strong_text_color(), ui.visuals().weak_text_color());
    let mut text = LayoutJob::default();
    text.append(name, 0.0, TextFormat::simple(FontId::proportional(13.0), strong));
    let about = format!("\n{about}");
    text.append(&about, 0.0, TextFormat::simple(FontId::proportional(11.0), weak));
    text
}

/// The step in the list that the arrow keys ask for; the field does not get them.
fn arrow_step(ui: &Ui) -> isize {
    ui.input_mut(|input| {
        let mut presses = |key| input.count_and_consume_key(Modifiers::NONE, key) as isize;
        presses(Key::ArrowDown) - presses(Key::ArrowUp)
    })
}
