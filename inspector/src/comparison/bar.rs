//! The bar of comparisons: with what, what is shown, and the next region; what differs is said over the picture.

use eframe::egui::{
    Align2, Area, Button, ComboBox, Frame, Id, Label, Order, PopupCloseBehavior, Rect, RichText,
    Ui, WidgetInfo, accesskit::Role, vec2,
};
use groundtruth::printable;
use pictures::compare::Comparison;
use rays::Logged;
use text::brief::{brief, count};

use crate::action::{Action, Shows, With};
use crate::comparison::menu::CompareMenu;
use crate::comparison::others::Others;
use crate::comparison::theirs::Theirs;
use crate::comparison::{mistake, opening};
use crate::picture::worker::Rendering;
use crate::splits::NARROW;

/// The views of the two pictures, each with its name and its key.
const SHOWN: [(Shows, &str, &str); 5] = [
    (Shows::Ours, "Ours", "T flips between ours and theirs"),
    (Shows::Theirs, "Theirs", "T flips between ours and theirs"),
    (Shows::Swipe, "Swipe", "Ours at the left of the line, theirs at its right (W)"),
    (Shows::Difference, "Difference", "Theirs less ours; brighter: theirs is larger (D)"),
    (
        Shows::Map,
        "Map of z",
        "The difference of each pixel in standard deviations; grey: 0, white and black: ±6 and more (Z)",
    ),
];

/// The views of a log of rays and of ours.
const OF_LOG: [(Shows, &str, &str); 3] = [
    (Shows::Theirs, "Yours", "The rays of the log (T)"),
    (Shows::Ours, "Ours", "Our rays for the same pixel (T)"),
    (Shows::Swipe, "Both", "Our picture and rays, with those of the log (W)"),
];

/// The width of a list, and in a narrow window, in points of the screen.
const LIST_WIDTH: [f32; 2] = [130.0, 97.0];

/// Shows a list in a width that its text does not change; `entries` close it. Returns nothing while it is closed.
pub fn list(
    ui: &mut Ui,
    text: &str,
    name: &str,
    hint: &str,
    entries: impl FnOnce(&mut Ui),
) -> Option<()> {
    let width = LIST_WIDTH[usize::from(ui.max_rect().width() < NARROW)];
    let show = |ui: &mut Ui| {
        ui.set_max_width(width);
        let list = ComboBox::from_id_salt(name).selected_text(text).truncate().width(width);
        let list = list.close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        let list = list.show_ui(ui, entries);
        list.response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, name));
        list.response.on_hover_text(format!("{text}\n{hint}"));
        list.inner
    };
    ui.allocate_ui(vec2(width, ui.spacing().interact_size.y), show).inner
}

/// Shows the bar. Returns what the user asks for.
pub fn show(
    ui: &mut Ui,
    menu: &mut CompareMenu,
    others: &mut Others,
    rendering: &Rendering,
) -> Option<Action> {
    ui.horizontal_wrapped(|ui| {
        let mut asked = None;
        if rendering.source.rays().is_none() {
            mistake::show(ui, &mut menu.mistake, others, rendering);
            asked = menu.show(ui, rendering);
        }
        if others.count() == 0 {
            return asked;
        }
        let chosen = asked.or(choice(ui, others));
        match others.shown_mut() {
            Some(theirs) => chosen.or(views(ui, theirs, rendering)),
            None => {
                match others.is_making() {
                    true => drop(ui.spinner()),
                    false => drop(ui.weak("a click on a pixel runs the program for it")),
                }
                chosen
            }
        }
    })
    .inner
}

/// Shows which of the pictures is held against ours, if there are several, and the button that lets it go.
fn choice(ui: &mut Ui, others: &Others) -> Option<Action> {
    let close = ui.small_button("×").on_hover_text("Compare with this picture no more");
    let closed = close.clicked().then_some(Action::Compare(With::NoMore));
    let names = others.names();
    let [chosen, about] = names.get(others.chosen())?;
    let mut next = None;
    let hint = format!("Compared with: {about} (O: the next of {})", names.len());
    list(ui, last_part(chosen), "With", &hint, |ui| {
        for (index, [name, about]) in names.iter().enumerate() {
            let is_chosen = index == others.chosen();
            let entry = ui.selectable_label(is_chosen, last_part(name)).on_hover_text(about);
            if entry.clicked() {
                next = Some(Action::Compare(With::Other(index)));
                ui.close();
            }
        }
    });
    closed.or(next)
}

/// The name of a file without its folders; another name as it is.
fn last_part(name: &str) -> &str {
    let path = std::path::Path::new(name);
    match opening::is_picture(path) {
        true => path.file_name().and_then(|name| name.to_str()).unwrap_or(name),
        false => name,
    }
}

/// Shows the views to choose from, and the buttons of the next region and of the judgement.
fn views(ui: &mut Ui, theirs: &mut Theirs, rendering: &Rendering) -> Option<Action> {
    if !theirs.fits(rendering) {
        let ([w, h], [width, height]) = (theirs.pixels.size(), rendering.size());
        let name = &theirs.name;
        let text = format!("{name} has {w} × {h} pixels, our picture {width} × {height}");
        ui.colored_label(ui.visuals().warn_fg_color, text);
        return None;
    }
    let is_beside = theirs.is_twin();
    if let Some(log) = theirs.program.as_ref().and_then(|program| program.log()) {
        return views_of_log(ui, &mut theirs.shows, (log, is_beside));
    }
    for (shows, name, hint) in SHOWN {
        let is_there = shows != Shows::Map || theirs.judgement.verdict().is_some();
        // another field of ours is nobody else's
        let name = if is_beside && shows == Shows::Theirs { "Other" } else { name };
        let button = ui.add_enabled(is_there, Button::selectable(theirs.shows == shows, name));
        let button = button.on_disabled_hover_text("After it was judged").on_hover_text(hint);
        if button.clicked() {
            theirs.shows = shows;
        }
    }
    ui.separator();
    if theirs.shows == Shows::Difference
        && let Some(largest) = theirs.largest(rendering)
    {
        let hint = "Nine tenths of the differences are smaller";
        ui.weak(format!("white: +{largest:.2e}")).on_hover_text(hint);
        ui.separator();
    }
    let differs = theirs.comparison(rendering).is_some_and(|comparison| !comparison.is_same());
    let next = ui.add_enabled(differs, Button::new("Next region"));
    let next = next.on_hover_text("Explains the worst pixel of the next region (N)");
    let judges =
        theirs.judgement.button(ui, rendering.is_finished() && theirs.pixels.part().is_none());
    next.clicked().then_some(Action::NextRegion).or(judges.then_some(Action::Compare(With::Judge)))
}

/// Shows what differs, over the lower edge of the picture in this area, so that nothing moves: the verdict once somebody
/// asked for it.
pub fn caption(ui: &Ui, area: Rect, theirs: &Theirs, rendering: &Rendering) {
    if theirs.log().is_some() {
        return;
    }
    let over = Area::new(Id::unique("caption")).order(Order::Middle).pivot(Align2::LEFT_BOTTOM);
    let over = over.fixed_pos(area.left_bottom() + vec2(6.0, -6.0));
    let show = |ui: &mut Ui| {
        ui.set_max_width(area.width() - 28.0);
        if theirs.judgement.show(ui, theirs.shows) {
            return;
        }
        let comparison = theirs.comparison(rendering);
        let text = match (comparison, theirs.pixels.part()) {
            (Some(comparison), _) => summary(comparison),
            (None, Some(part)) => {
                format!("{}: {:.0} %, then compared", theirs.short_name(), 100.0 * part)
            }
            (None, None) => "compared when our picture is finished".to_owned(),
        };
        let hint = comparison.map_or(String::new(), Comparison::to_string);
        ui.label(text).on_hover_text(RichText::new(hint).monospace());
    };
    over.show(ui.ctx(), |ui| Frame::popup(ui.style()).show(ui, show));
}

/// Shows whose rays there are to choose from, and what the laws found in the log.
fn views_of_log(
    ui: &mut Ui,
    shows: &mut Shows,
    (log, is_beside): (&Logged, bool),
) -> Option<Action> {
    if is_beside {
        for (view, name, hint) in OF_LOG {
            ui.selectable_value(shows, view, name).on_hover_text(hint);
        }
        ui.separator();
    }
    let broken = log.verdict.is_broken();
    let next = ui.add_enabled(broken, Button::new("Next broken ray")).on_hover_text("(N)");
    let sentence = printable::text(&log.verdict.sentence());
    let text = RichText::new(&sentence);
    let text = if broken { text.color(ui.visuals().error_fg_color) } else { text };
    ui.add(Label::new(text).truncate()).on_hover_text(sentence);
    next.clicked().then_some(Action::NextRegion)
}

/// A sentence of a comparison with names for A and B.
fn with_names(sentence: &str) -> String {
    let name = |word| match word {
        "A" => "our picture",
        "B" => "the other one",
        word => word,
    };
    sentence.split(' ').map(name).collect::<Vec<_>>().join(" ")
}

/// The result of a comparison, in one line.
fn summary(comparison: &Comparison) -> String {
    if comparison.is_same() {
        return "no pixel differs".to_owned();
    }
    let pixels = f64::from(comparison.size[0]) * f64::from(comparison.size[1]);
    let share = 100.0 * comparison.differing as f64 / pixels;
    let why = comparison.explained_by.first();
    let why = why.map(|first| format!("; explained: {}", with_names(&first.what)));
    let (differing, why) = (count(comparison.differing as usize, "pixel"), why.unwrap_or_default());
    let worst = comparison.worst.map_or(String::new(), |worst| brief(worst.difference));
    let verb = if comparison.differing == 1 { "differs" } else { "differ" };
    format!("{differing} ({share:.2} %) {verb}, by at most {worst}{why}")
}
