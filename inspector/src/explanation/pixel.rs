//! The pixel as a whole: its sum, its sources of light, its samples, and the menu to copy it.

use eframe::egui::{Button, DragValue, Label, RichText, ScrollArea, TextWrapMode, Ui};
use explain::{PixelExplanation, RecordedRay};
use groundtruth::film::Tone;
use groundtruth::rgb::Rgb;
use text::brief::{percent, short};
use text::digits::{exact_color, shortened};

use crate::comparison::theirs::Theirs;
use crate::explanation::copying::{self, Making};
use crate::explanation::selection::Selection;
use crate::explanation::{Shown, details, tree};
use crate::picture::display;
use crate::platform;

/// The height of a line of the list of sources and samples.
const LINE: f32 = 18.0;

/// Shows the chooser of the sample whose tree is shown.
pub fn chooser(ui: &mut Ui, chosen: &mut u32, last: u32) {
    let label = ui.label("sample");
    *chosen = (*chosen).min(last);
    if ui.add_enabled(*chosen > 0, Button::new("<")).clicked() {
        *chosen -= 1;
    }
    ui.add(DragValue::new(chosen).range(0..=last)).labelled_by(label.id);
    if ui.add_enabled(*chosen < last, Button::new(">")).clicked() {
        *chosen += 1;
    }
    ui.weak(format!("of 0 to {last}"));
}

/// Shows a menu that copies what reproduces this pixel outside the window, and the selected ray.
pub fn copy_menu(
    ui: &mut Ui,
    shown: &Shown<'_>,
    answer: &PixelExplanation,
    sample: u32,
    ray: Option<&RecordedRay>,
    making: &mut Making,
) {
    let (pixel, radiance) = (answer.pixel, answer.radiance);
    let item = |ui: &mut Ui, name: &str, hint: &str| ui.button(name).on_hover_text(hint).clicked();
    ui.menu_button("Copy", |ui| {
        let mut text = None;
        if item(ui, "The command for a terminal", "`explain` shows this sample there") {
            text = Some(copying::explain_command(shown, pixel, sample));
        }
        let is_ours = shown.subject().log().is_none();
        if is_ours && item(ui, "The probe's line", "`probe` answers it with this pixel") {
            text = Some(copying::probe_line(shown.rendering, pixel));
        }
        // not of another program: link, page and test are of our picture
        if shown.subject().program.is_none() {
            if let Some(address) = platform::address() {
                let link = copying::link(shown.rendering, pixel, sample, shown.view);
                let button = ui.add_enabled(link.is_some(), Button::new("A link"));
                let button = button.on_hover_text("It opens this page at this sample");
                let button =
                    button.on_disabled_hover_text("A scene of the gallery, unchanged, has a link");
                let link = link.filter(|_| button.clicked());
                text = text.or(link.map(|link| format!("{address}#{link}")));
            }
            if item(ui, "A page for a class", "HTML of one file: save it as page.html") {
                let ray = ray.map_or(0, |ray| ray.number);
                making.page(ui.ctx(), shown, answer, (sample, ray));
                ui.close();
            }
            if item(ui, "A test in Rust", "The bits of this sample, in a reduced scene") {
                making.test(ui.ctx(), shown.rendering, pixel, sample);
                ui.close();
            }
        }
        if item(ui, "The pixel, all its digits", "Its radiance") {
            text = Some(exact_color(radiance));
        }
        if let Some(ray) = ray.filter(|_| is_ours)
            && item(ui, "All numbers of the selected ray", "As a table")
        {
            text = Some(details::text(ray));
        }
        if let Some(text) = text {
            copying::copy(ui.ctx(), text);
            ui.close();
        }
    });
}

/// Shows the sum of the samples that gives the pixel, and whether it equals the rendered pixel.
pub fn sum(ui: &mut Ui, answer: &PixelExplanation, shown: &Shown<'_>) {
    let rendered = shown.radiance(answer.pixel);
    let program = shown.subject().program;
    let made = program.filter(|program| program.log().is_none());
    let subject = made.map_or("The".to_owned(), |it| format!("With {} the", it.name));
    let exposure = match answer.exposure_time {
        1.0 => String::new(),
        time => format!(", times the exposure time {time:?}"),
    };
    let mean = match answer.samples_per_pixel {
        1 => "radiance of its one sample".to_owned(),
        count => format!("mean of its {count} samples"),
    };
    ui.horizontal_wrapped(|ui| {
        ui.label(format!("{subject} {mean}{exposure}"));
        let total = format!("= {}", exact_color(answer.radiance));
        let text = RichText::new(shortened(&total)).monospace().size(12.0).strong();
        ui.add(Label::new(text).extend()).on_hover_text(total);
    });
    let bits = |color: Rgb| color.to_array().map(f64::to_bits);
    match rendered {
        None => ui.weak("this pixel is not rendered yet"),
        Some(radiance) if bits(radiance) == bits(answer.radiance) => {
            let good = display::ink(ui.visuals(), display::AGREES);
            ui.colored_label(good, "= the pixel of the picture, bit for bit")
        }
        // what a picture file can hold of it
        Some(radiance) if shown.subject().log().is_some() => {
            ui.weak(format!("in the picture file: {}", short(radiance)))
        }
        Some(radiance) => {
            let text = exact_color(radiance);
            let text = format!("differs from the pixel of the picture: {text}");
            ui.colored_label(ui.visuals().error_fg_color, text)
        }
    };
}

/// Shows their value of the pixel and the difference from ours; of both, the explained value until it is rendered.
pub fn theirs(
    ui: &mut Ui,
    pixel: [u32; 2],
    (theirs, [ours, explained]): (&Theirs, [Option<Rgb>; 2]),
    shown: &Shown<'_>,
) {
    let Some(radiance) = theirs.pixels.radiance(pixel).or(explained) else { return };
    let value = theirs.value(pixel).unwrap_or_else(|| short(radiance));
    let name = theirs.short_name();
    let small = |text: String| RichText::new(text).monospace().size(12.0);
    let early = || Some(explained? - shown.rendering.radiance(pixel).or(ours)?);
    let difference = theirs.difference(shown.rendering, pixel).or_else(early);
    let equal = if difference == Some(Rgb::BLACK) { ": equal" } else { "" };
    ui.horizontal_wrapped(|ui| {
        tree::swatch(ui, display::color(shown.tone, radiance));
        ui.label(small(format!("{name}: {value}{equal}")));
    });
    if let Some(difference) = difference.filter(|difference| *difference != Rgb::BLACK) {
        ui.label(small(format!("{name} − ours: {}", short(difference))));
    }
}

/// A line of the sum's list.
enum Line {
    Words(&'static str),
    Numbers(String),
    Spread,
    Sample(u32),
}

/// Shows the lines in view of the list of the sum: the contributions of the sources of light, and all samples, of which a click
/// chooses one.
pub fn sum_list(
    ui: &mut Ui,
    area: ScrollArea,
    (answer, tone): (&PixelExplanation, &Tone),
    selection: &mut Selection,
) {
    let mut lines = Vec::new();
    for (words, sources) in answer.sources.lists() {
        lines.push(Line::Words(words));
        lines.extend(explain::table(sources).into_iter().map(Line::Numbers));
    }
    if answer.samples_per_pixel > 1 {
        lines.extend([Line::Spread, Line::Words("samples with their shares, by value")]);
        lines.extend(sorted(answer).into_iter().map(Line::Sample));
    }
    ui.spacing_mut().item_spacing.y = 0.0;
    ui.spacing_mut().interact_size.y = LINE;
    ui.spacing_mut().button_padding.y = 0.0;
    area.show_rows(ui, LINE, lines.len(), |ui, visible| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        for line in &lines[visible] {
            ui.horizontal(|ui| match line {
                // what it counts stands behind the colon
                Line::Words(words) => {
                    let name = words.split_once(": ").map_or(*words, |(name, _)| name);
                    ui.strong(name).on_hover_text(*words);
                }
                Line::Numbers(text) => {
                    let small = RichText::new(text).monospace().size(11.5);
                    ui.label(small).on_hover_text(text);
                }
                Line::Spread => drop(ui.horizontal(|ui| spread(ui, answer, &mut selection.sample))),
                Line::Sample(index) => sample(ui, *index, (answer, tone), selection),
            });
        }
    });
}

/// Shows standard error, least and greatest; a click on the last two chooses that sample.
fn spread(ui: &mut Ui, answer: &PixelExplanation, chosen: &mut u32) {
    let statistics = &answer.statistics;
    if let Some(error) = statistics.standard_error {
        let hint = "Of the mean, as if the samples were independent; well-spread ones are nearer";
        ui.weak(format!("standard error {}", short(error))).on_hover_text(hint);
    }
    for (name, index) in [("least", statistics.least), ("greatest", statistics.greatest)] {
        let link = ui.link(format!("{name}: sample {index}"));
        if link.on_hover_text(short(answer.radiances[index as usize])).clicked() {
            *chosen = index;
        }
    }
}

fn sample(
    ui: &mut Ui,
    index: u32,
    (answer, tone): (&PixelExplanation, &Tone),
    selection: &mut Selection,
) {
    let radiance = answer.radiances[index as usize];
    let whole: f64 = answer.radiances.iter().map(|radiance| radiance.average()).sum();
    let share = if whole == 0.0 { 0.0 } else { radiance.average() / whole };
    tree::swatch(ui, display::color(tone, radiance));
    let share = percent(share);
    let text = format!("sample {index:>3}  {share:>7}  {}", short(radiance));
    let row = ui.selectable_label(selection.sample == index, RichText::new(text).monospace());
    if row.clicked() {
        selection.sample = index;
    }
    if row.hovered() {
        selection.pointed = Some(index);
    }
}

/// The indices of all samples, the greatest radiance first, averaged over the channels.
fn sorted(answer: &PixelExplanation) -> Vec<u32> {
    let mut indices: Vec<u32> = (0..answer.samples_per_pixel).collect();
    let value = |index: &u32| answer.radiances[*index as usize].average();
    indices.sort_by(|a, b| value(b).total_cmp(&value(a)));
    indices
}
