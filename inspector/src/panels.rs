//! The bars: which scene, where to save, how to look at it, and what is under the mouse.

use std::path::PathBuf;

use eframe::egui::{Button, ComboBox, Label, Response, Slider, TextEdit, Ui};
use groundtruth::explain::short;
use groundtruth::gallery;

use crate::picture::{Picture, tone_of};
use crate::worker::{Progress, Rendering, Source};

/// What a person typed into the bars.
#[derive(Default)]
pub struct Fields {
    /// A scene file to open.
    pub open: String,
    /// Where to save the picture.
    pub save: String,
    /// The coordinates of a pixel.
    pub pixel: String,
}

/// What a person wants of the bars.
pub enum Wish {
    /// Another scene.
    Open(Source),
    /// The picture in a file.
    Save(PathBuf),
    /// The pixel of these coordinates, as typed.
    Select(String),
}

/// The scene, the file to open, the file to save and the pixel to explain.
pub fn files(ui: &mut Ui, fields: &mut Fields, source: &Source) -> Option<Wish> {
    let mut wish = None;
    ui.horizontal(|ui| {
        let label = ui.label("Scene");
        if let Some(entry) = picker(ui, source, &label) {
            wish = Some(Wish::Open(Source::Gallery(entry)));
        }
        ui.separator();
        let hint = "scene.toml, or drop a file";
        if entry(ui, "File", &mut fields.open, hint, 230.0, "Open") {
            wish = Some(Wish::Open(Source::File(fields.open.trim().into())));
        }
        ui.separator();
        let hint = "picture.png or .exr";
        if entry(ui, "Picture", &mut fields.save, hint, 190.0, "Save") {
            wish = Some(Wish::Save(fields.save.trim().into()));
        }
        ui.separator();
        if entry(ui, "Pixel", &mut fields.pixel, "x, y", 70.0, "Explain") {
            wish = Some(Wish::Select(fields.pixel.clone()));
        }
    });
    wish
}

/// The gallery by chapter.
fn picker(ui: &mut Ui, source: &Source, label: &Response) -> Option<gallery::Entry> {
    let mut picked = None;
    let current = source.name();
    let combo = ComboBox::from_id_salt("scene").selected_text(current.as_str()).width(220.0);
    let combo = combo.height(640.0).truncate().show_ui(ui, |ui| {
        let mut chapter = "";
        for entry in gallery::scenes() {
            let (its_chapter, name) = entry.name.split_once('/').unwrap_or(("", entry.name));
            if its_chapter != chapter {
                chapter = its_chapter;
                let number = chapter.trim_start_matches("ch").trim_start_matches('0');
                ui.weak(format!("Chapter {number}"));
            }
            let line = ui.selectable_label(current == entry.name, name);
            if line.on_hover_ui(|ui| drop(ui.label((entry.build)().about))).clicked() {
                picked = Some(entry);
            }
        }
    });
    combo.response.labelled_by(label.id);
    picked
}

/// A field with its button; true if the button or Enter was pressed.
fn entry(ui: &mut Ui, name: &str, text: &mut String, hint: &str, width: f32, verb: &str) -> bool {
    let label = ui.label(name);
    let field = TextEdit::singleline(text).hint_text(hint).desired_width(width);
    let field = ui.add(field).labelled_by(label.id);
    let entered =
        field.lost_focus() && ui.input(|input| input.key_pressed(eframe::egui::Key::Enter));
    let pressed = ui.add_enabled(!text.trim().is_empty(), Button::new(verb)).clicked();
    (entered || pressed) && !text.trim().is_empty()
}

/// How to look at the picture.
pub fn look(ui: &mut Ui, picture: &mut Picture, rendering: &Rendering) {
    ui.horizontal_wrapped(|ui| {
        let label = ui.label("Exposure");
        let exposure = Slider::new(&mut picture.tone.exposure, 0.01..=100.0).logarithmic(true);
        ui.add(exposure.max_decimals(3)).labelled_by(label.id);
        let label = ui.label("Gamma");
        let gamma = Slider::new(&mut picture.tone.gamma, 0.2..=5.0);
        ui.add(gamma.max_decimals(2)).labelled_by(label.id);
        let own = tone_of(rendering);
        let reset = ui.add_enabled(picture.tone != own, Button::new("Reset"));
        if reset.on_hover_text("Exposure 1 and the gamma of the scene").clicked() {
            picture.tone = own;
        }
        let size = rendering.size();
        if ui.button("Whole").on_hover_text("The whole picture").clicked() {
            picture.view = crate::view::View::WHOLE;
        }
        for zoom in [1.0_f32, 4.0, 12.0] {
            if ui.button(format!("{zoom}×")).on_hover_text("Points for a pixel").clicked() {
                picture.set_zoom(size, zoom);
            }
        }
    });
}

/// What is under the mouse, how far the picture is, and which keys there are.
pub fn status(ui: &mut Ui, rendering: &Rendering, over: Option<[u32; 2]>, loading: bool) {
    ui.horizontal(|ui| {
        let [width, height] = rendering.size();
        let samples = rendering.world.samples_per_pixel();
        ui.label(format!("{width} × {height}, {samples} samples"));
        ui.separator();
        if loading {
            ui.spinner();
            ui.label("loading");
        }
        match rendering.progress() {
            Progress::Running(part, elapsed) => {
                let bar = eframe::egui::ProgressBar::new(part).desired_width(120.0);
                ui.add(bar.show_percentage());
                ui.label(format!("{:.1} s", elapsed.as_secs_f64()));
            }
            Progress::Done(took) => {
                drop(ui.label(format!("rendered in {:.2} s", took.as_secs_f64())))
            }
            Progress::Stopped => drop(ui.colored_label(
                ui.visuals().error_fg_color,
                "rendering stopped unexpectedly; the terminal says why",
            )),
        }
        ui.separator();
        match over {
            Some([x, y]) => {
                let radiance = rendering.canvas.look(|film| film.get([x, y]));
                ui.monospace(format!("({x}, {y})  {}", short(radiance)));
            }
            None => drop(ui.weak("point at a pixel to read it")),
        }
    });
    let help = "Click: explain a pixel · arrows: next pixel (Shift: 10) · wheel: zoom · drag: pan";
    ui.add(Label::new(eframe::egui::RichText::new(help).weak()).truncate());
}
