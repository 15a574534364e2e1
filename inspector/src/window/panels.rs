//! The bars: fields for scene, file and pixel, the message, settings of the view, and the pixel under the mouse.

use eframe::egui::{
    Align, Align2, Area, Button, Context, Frame, Id, Key, Label, Layout, Order, ProgressBar, Rect,
    RichText, Slider, TextEdit, Ui, vec2,
};
use text::brief::{count, short};

use crate::action::Action;
use crate::comparison::opening;
use crate::comparison::theirs::Theirs;
use crate::picture::chosen_layer::ChosenLayer;
use crate::picture::display::Picture;
use crate::picture::view::View;
use crate::picture::worker::{Progress, Rendering};
use crate::platform::Purpose;
use crate::scene::source::Source;
use crate::splits::{Mode, fixed};
use crate::window::picker::ScenePicker;

/// The text typed into the bars, and the list of scenes.
#[derive(Default)]
pub struct Fields {
    picker: ScenePicker,
    /// A scene file to open.
    pub open: String,
    /// The file for the picture or the layer.
    pub save: String,
    /// What was proposed for it.
    pub proposed: String,
    /// The coordinates of a pixel.
    pub pixel: String,
}

impl Fields {
    /// Proposes the name of a file, unless another one was typed.
    pub fn propose(&mut self, name: String) {
        if self.save == self.proposed {
            self.save.clone_from(&name);
        }
        self.proposed = name;
    }
}

/// The least width of a window with one row of fields; narrower ones have two.
const ONE_ROW_MIN_WIDTH: f32 = 1200.0;

/// The length of sliders in a narrow window.
const SHORT_SLIDER: f32 = 24.0;

/// The least width of the bar of the view with its separators and all of its buttons in one row.
const WIDE_VIEW_BAR: f32 = 980.0;

/// The id of the field for the scene file, which a shortcut focuses.
pub fn file_field() -> Id {
    Id::unique("the field of the scene file")
}

/// Shows the scene and the pixel to explain, then the file to open and the file to save.
pub fn files(ui: &mut Ui, fields: &mut Fields, source: &Source) -> Option<Action> {
    let width = ui.available_width();
    if width >= ONE_ROW_MIN_WIDTH {
        let row = |ui: &mut Ui| {
            let asked = scene_and_pixel(ui, fields, source, 220.0);
            ui.separator();
            asked.or(open_and_save(ui, fields, [230.0, 190.0]))
        };
        return ui.horizontal(row).inner;
    }
    // the width that labels, buttons and other fields leave
    let asked = ui.horizontal(|ui| scene_and_pixel(ui, fields, source, width - 280.0)).inner;
    let half = 0.5 * (width - 310.0);
    asked.or(ui.horizontal(|ui| open_and_save(ui, fields, [half, half])).inner)
}

fn scene_and_pixel(
    ui: &mut Ui,
    fields: &mut Fields,
    source: &Source,
    width: f32,
) -> Option<Action> {
    let picked = fields.picker.show(ui, &source.name(), width);
    ui.separator();
    let field = TextEdit::singleline(&mut fields.pixel).hint_text("x, y");
    let selected = entry(ui, "Pixel", field, 70.0) | ui.button("Explain").clicked();
    if let Some(entry) = picked {
        return Some(Action::Open(Source::Gallery(entry)));
    }
    let pixel = fields.pixel.trim();
    (selected && !pixel.is_empty()).then(|| Action::RevealTyped(pixel.to_owned()))
}

fn open_and_save(ui: &mut Ui, fields: &mut Fields, widths: [f32; 2]) -> Option<Action> {
    let field = TextEdit::singleline(&mut fields.open).id(file_field());
    let field = field.hint_text("scene.toml or a picture; or drop files");
    let is_named = entry(ui, "File", field, widths[0]);
    let is_choosing_scene = choose(ui, "Choose a scene file");
    let is_opened = ui.button("Open").clicked() || is_named;
    ui.separator();
    let field = TextEdit::singleline(&mut fields.save).hint_text("picture.png or .exr");
    let is_named = entry(ui, "Picture", field, widths[1]);
    let is_choosing = choose(ui, "Choose the file for the picture, and save it");
    let is_saved = ui.button("Save").clicked() || is_named;
    let (file, name) = (fields.open.trim(), fields.save.trim());
    if is_choosing_scene {
        Some(Action::Choose(Purpose::Scene))
    } else if is_choosing {
        Some(Action::Choose(Purpose::Picture))
    } else if is_opened && !file.is_empty() {
        Some(opening::named(file.into()))
    } else {
        (is_saved && !name.is_empty()).then_some(Action::Save)
    }
}

/// Shows the button of the desktop's file chooser.
fn choose(ui: &mut Ui, hint: &str) -> bool {
    ui.button("…").on_hover_text(format!("{hint} (by the desktop's portal, or zenity)")).clicked()
}

/// Shows a field. Returns whether Enter was pressed in it.
fn entry(ui: &mut Ui, name: &str, field: TextEdit<'_>, width: f32) -> bool {
    let label = ui.label(name);
    let field = ui.add(field.desired_width(width)).labelled_by(label.id);
    field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter))
}

/// Shows the message, and whether it is an error, until it is dismissed: over the lower edge, so that nothing moves.
pub fn message(ctx: &Context, message: &mut Option<(String, bool)>) {
    let Some((text, is_error)) = message.clone() else { return };
    let most = 0.7 * ctx.content_rect().width();
    let show = |ui: &mut Ui| {
        ui.set_max_width(most);
        if ui.small_button("×").on_hover_text("Dismiss").clicked() {
            *message = None;
        }
        let text = RichText::new(text).monospace();
        let text = if is_error { text.color(ui.visuals().error_fg_color) } else { text };
        ui.add(Label::new(text).wrap());
    };
    // above the bar there
    let area = Area::new(Id::unique("message")).anchor(Align2::CENTER_BOTTOM, [0.0, -34.0]);
    area.show(ctx, |ui| Frame::popup(ui.style()).show(ui, |ui| ui.horizontal_top(show)));
}

/// Says over the upper edge of the picture in this area that it is not of the file as it is now.
pub fn mark_old(ui: &Ui, area: Rect) {
    let show = |ui: &mut Ui| {
        let text = "the picture of before: the scene file has an error";
        ui.colored_label(ui.visuals().warn_fg_color, text);
    };
    let over = Area::new(Id::unique("old")).order(Order::Middle).pivot(Align2::CENTER_TOP);
    let over = over.fixed_pos(area.center_top() + vec2(0.0, 6.0));
    over.show(ui.ctx(), |ui| Frame::popup(ui.style()).show(ui, show));
}

/// Shows the settings of the view.
pub fn view_settings(
    ui: &mut Ui,
    picture: &mut Picture,
    theirs: Option<&mut Theirs>,
    mode: &mut Mode,
    (rendering, selected): (&Rendering, Option<[u32; 2]>),
) {
    ui.horizontal_wrapped(|ui| {
        if ui.available_width() < ONE_ROW_MIN_WIDTH {
            ui.spacing_mut().slider_width = SHORT_SLIDER;
        }
        let is_narrow = ui.available_width() < WIDE_VIEW_BAR;
        let separator = |ui: &mut Ui| {
            if !is_narrow {
                drop(ui.separator())
            }
        };
        for (shown, text, hint) in [
            (Mode::Picture, "Picture", "The picture (S: the next view)"),
            (Mode::Both, "Both", "The picture, and the rays of the selected sample in space"),
            (Mode::Space, "Space", "The rays of the selected sample in space"),
        ] {
            ui.selectable_value(mode, shown, text).on_hover_text(hint);
        }
        separator(ui);
        let theirs = theirs.filter(|theirs| theirs.fits(rendering));
        picture.layer.choose(ui, is_narrow, theirs.map(|theirs| &mut theirs.shows));
        separator(ui);
        let label = ui.label("Exposure");
        let exposure = Slider::new(&mut picture.tone.exposure, 0.01..=100.0).logarithmic(true);
        ui.add(exposure.max_decimals(3)).labelled_by(label.id);
        let label = ui.label("Gamma");
        let gamma = Slider::new(&mut picture.tone.gamma, 0.2..=5.0);
        ui.add(gamma.max_decimals(2)).labelled_by(label.id);
        let own = rendering.world.image.tone();
        let reset = ui.add_enabled(picture.tone != own, Button::new("Reset"));
        if reset.on_hover_text("Exposure 1 and the gamma of the scene").clicked() {
            picture.tone = own;
        }
        separator(ui);
        let size = rendering.size();
        if ui.button("Whole").on_hover_text("The whole picture, as large as fits").clicked() {
            picture.view = View::WHOLE;
        }
        for (zoom, hint) in [
            (1.0_f32, "A point of the screen for each pixel of the picture"),
            (4.0, "4 × 4 points for each pixel"),
            (12.0, "12 × 12 points for each pixel, with a grid"),
            (64.0, "64 × 64 points for each pixel, with its values as text"),
        ] {
            // the wheel zooms as far
            if is_narrow && zoom > 12.0 {
                continue;
            }
            if ui.button(format!("{zoom}×")).on_hover_text(hint).clicked() {
                picture.set_zoom(size, zoom, selected);
            }
        }
    });
}

/// Shows what is being loaded or the progress, and the pixel under the mouse; a button shows the keys.
pub fn status(
    ui: &mut Ui,
    rendering: &Rendering,
    (theirs, layer): (Option<&Theirs>, &ChosenLayer),
    (hovered, is_proposed): (Option<[u32; 2]>, bool),
    loading: Option<&str>,
) -> Option<Action> {
    ui.horizontal(|ui| {
        let [width, height] = rendering.size();
        let samples = count(rendering.world.samples_per_pixel() as usize, "sample");
        fixed(ui, SIZE_WIDTH, |ui| drop(ui.label(format!("{width} × {height}, {samples}"))));
        ui.separator();
        fixed(ui, PROGRESS_WIDTH, |ui| match (loading, layer.progress()) {
            (Some(what), _) => {
                ui.spinner();
                ui.add(Label::new(what).truncate());
            }
            (None, Some(part)) => {
                let text = format!("layer, {:.0} %", 100.0 * part);
                ui.add(ProgressBar::new(part).desired_width(120.0).text(text));
            }
            (None, None) => progress(ui, rendering),
        });
        ui.separator();
        match hovered {
            Some(pixel) => {
                let layer = layer.in_words(rendering, pixel);
                let layer = layer.map_or(String::new(), |layer| format!("  {layer}"));
                let text = under_mouse(rendering, theirs, pixel) + &layer;
                ui.add(Label::new(RichText::new(text).monospace()).truncate());
            }
            None if is_proposed => drop(ui.weak("many rays, to begin with; click another pixel")),
            None => drop(ui.weak("point at a pixel to read it")),
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let keys = ui.small_button("?").on_hover_text("The keys");
            keys.clicked().then_some(Action::ToggleKeys)
        })
        .inner
    })
    .inner
}

/// The width of the size of the picture in the status bar, and of its progress, in points of the screen.
const SIZE_WIDTH: f32 = 172.0;
const PROGRESS_WIDTH: f32 = 190.0;

fn progress(ui: &mut Ui, rendering: &Rendering) {
    match rendering.progress() {
        Progress::Running(part, elapsed) => {
            ui.add(ProgressBar::new(part).desired_width(120.0).show_percentage());
            ui.label(format!("{:.1} s", elapsed.as_secs_f64()));
            if let Some(note) = rendering.note() {
                ui.weak("many rays").on_hover_text(note);
            }
        }
        Progress::Done(took) => drop(ui.label(format!("rendered in {:.2} s", took.as_secs_f64()))),
        Progress::Stopped => {
            let text = RichText::new("rendering stopped").color(ui.visuals().error_fg_color);
            ui.label(text).on_hover_text("Unexpectedly; the terminal says why");
        }
    }
}

/// A pixel and its radiance, also that of their picture.
fn under_mouse(rendering: &Rendering, theirs: Option<&Theirs>, pixel @ [x, y]: [u32; 2]) -> String {
    let alone = theirs.filter(|theirs| theirs.explained().is_some() && !theirs.is_twin());
    if let Some(radiance) = alone.and_then(|theirs| theirs.pixels.radiance(pixel)) {
        return format!("({x}, {y})  {}", short(radiance));
    }
    let ours = rendering.radiance(pixel).map_or("not rendered yet".to_owned(), short);
    let theirs =
        theirs.and_then(|theirs| Some((theirs.short_name(), theirs.pixels.radiance(pixel)?)));
    let theirs = theirs.map_or(String::new(), |(name, it)| format!("  {name} {}", short(it)));
    format!("({x}, {y})  {ours}{theirs}")
}
