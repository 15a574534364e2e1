//! The list of the gallery's scenes by chapter, with thumbnails and a search field.

use eframe::egui::{
    Align, Button, Color32, ColorImage, Image, Key, Popup, PopupCloseBehavior, Rect, ScrollArea,
    Shape, Stroke, TextEdit, TextureHandle, TextureId, TextureOptions, Ui, load::SizedTexture,
    vec2,
};
use groundtruth::gallery::{self, Entry};

use crate::scene::thumbnails::{SIZE, Thumbnails};

/// A list is drawn invisibly for these frames, until its size is known and it is in position.
const FRAMES_TO_OPEN: u8 = 3;

/// The list, closed or open.
#[derive(Default)]
pub struct ScenePicker {
    /// The text in the search field.
    typed: String,
    /// Frames until the open list is in position.
    opening: u8,
    thumbnails: Thumbnails,
    /// Shown for a thumbnail that is not rendered yet.
    blank: Option<TextureHandle>,
}

impl ScenePicker {
    /// Shows the present scene; a click opens the list. Returns the scene that was picked.
    pub fn show(&mut self, ui: &mut Ui, current: &str, width: f32) -> Option<Entry> {
        let label = ui.label("Scene");
        let height = ui.spacing().interact_size.y;
        // the spaces leave room for the arrow
        let button = Button::new(current).truncate().right_text("    ");
        let button = ui.add_sized([width, height], button).labelled_by(label.id);
        let button = button.on_hover_text(current);
        arrow(ui, button.rect);
        if button.clicked() {
            self.typed.clear();
            self.opening = FRAMES_TO_OPEN;
        }
        let max_height = 0.8 * ui.ctx().content_rect().height();
        let popup = Popup::menu(&button).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        popup.width(320.0).show(|ui| self.list(ui, current, max_height))?.inner
    }

    fn list(&mut self, ui: &mut Ui, current: &str, max_height: f32) -> Option<Entry> {
        let field = TextEdit::singleline(&mut self.typed).hint_text("type a part of a name");
        let field = ui.add(field.desired_width(f32::INFINITY));
        let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if self.opening > 0 {
            field.request_focus();
        }
        let found = found(&self.typed);
        let mut picked = if entered { found.first().copied() } else { None };
        ScrollArea::vertical().max_height(max_height).auto_shrink([false, true]).show(ui, |ui| {
            let mut chapter = "";
            for &entry in &found {
                let (its_chapter, name) = entry.name.split_once('/').unwrap_or(("", entry.name));
                if its_chapter != chapter {
                    chapter = its_chapter;
                    let number = chapter.trim_start_matches("ch").trim_start_matches('0');
                    ui.weak(format!("Chapter {number}"));
                }
                if self.row(ui, entry, name, entry.name == current) {
                    picked = Some(entry);
                }
            }
            if found.is_empty() {
                ui.weak("no scene has this in its name");
            }
        });
        self.opening = self.opening.saturating_sub(1);
        if picked.is_some() {
            ui.close();
        }
        picked
    }

    /// Shows a scene's thumbnail and name; returns whether it was clicked.
    fn row(&mut self, ui: &mut Ui, entry: Entry, name: &str, is_current: bool) -> bool {
        let row_height = SIZE[1] as f32 + 4.0;
        let next = ui.cursor().with_max_y(ui.cursor().top() + row_height);
        if !ui.is_rect_visible(next) && !is_current {
            ui.allocate_space(vec2(ui.available_width(), row_height));
            return false;
        }
        let [width, height] = SIZE.map(|side| side as f32);
        let image = Image::new(SizedTexture::new(self.picture(ui, entry), vec2(width, height)));
        let button = Button::image_and_text(image.fit_to_exact_size(vec2(width, height)), name);
        let button = button.selected(is_current).frame_when_inactive(is_current);
        let row = ui.add(button.min_size(vec2(0.0, row_height)));
        if is_current && self.opening > 0 {
            row.scroll_to_me(Some(Align::Center));
        }
        row.on_hover_ui(|ui| drop(ui.label((entry.build)().about))).clicked()
    }

    fn picture(&mut self, ui: &Ui, entry: Entry) -> TextureId {
        if let Some(thumbnail) = self.thumbnails.get(ui.ctx(), entry) {
            return thumbnail.id();
        }
        let grey = || ColorImage::filled([1, 1], Color32::from_gray(40));
        let load = || ui.ctx().load_texture("blank", grey(), TextureOptions::NEAREST);
        self.blank.get_or_insert_with(load).id()
    }

    /// The number of thumbnails that were rendered.
    pub fn thumbnails(&self) -> usize {
        self.thumbnails.count()
    }
}

/// The arrow at the right end of a button that opens a list.
fn arrow(ui: &Ui, button: Rect) {
    let middle = button.right_center() - vec2(11.0, 0.0);
    let corners = [vec2(-4.0, -2.0), vec2(4.0, -2.0), vec2(0.0, 3.0)].map(|to| middle + to);
    let color = ui.visuals().widgets.inactive.fg_stroke.color;
    ui.painter().add(Shape::convex_polygon(corners.into(), color, Stroke::NONE));
}

/// The scenes whose names contain the typed text.
pub fn found(typed: &str) -> Vec<Entry> {
    let typed = typed.trim().to_lowercase();
    gallery::scenes().filter(|entry| entry.name.contains(&typed)).collect()
}
