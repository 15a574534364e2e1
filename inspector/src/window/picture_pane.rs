//! Our picture, the one that it is compared with over it, and what the mouse does there.

use eframe::egui::{Rect, Ui};

use crate::action::{Action, Shows};
use crate::comparison::bar;
use crate::comparison::others::Others;
use crate::explanation::selection::Selection;
use crate::explanation::{Subject, checks, trail};
use crate::picture::display::{PINNED, Picture, coordinates, mark};
use crate::picture::worker::Rendering;

/// Shows both pictures in this area. Returns the pixel under the mouse, and what the user asks for.
pub fn show(
    ui: &mut Ui,
    area: Rect,
    picture: &mut Picture,
    others: &mut Others,
    selection: &mut Selection,
    rendering: &Rendering,
) -> (Option<[u32; 2]>, Option<Action>) {
    let theirs = others.shown_mut().filter(|theirs| theirs.fits(rendering));
    let pinned = selection.pinned_beside();
    let hovered = picture.show(ui, rendering, selection.pixel, |painter, placement| {
        if let Some(theirs) = &theirs {
            theirs.paint(painter, placement, rendering);
            if let Some(log) = theirs.log().filter(|_| theirs.shows != Shows::Ours) {
                checks::mark_pixels(painter, placement, log);
            }
        }
        pinned.into_iter().for_each(|at| mark(painter, placement.rect(at), PINNED));
    });
    let asks = ui.input(|input| input.pointer.secondary_clicked());
    let pointed = hovered.filter(|_| asks);
    if let Some(object) = pointed.and_then(|pixel| rendering.object_in(pixel)) {
        selection.ask_why_not(object);
    }
    let placement = picture.placement(rendering.size());
    let program = theirs.as_ref().and_then(|theirs| theirs.explained().cloned());
    let framed = theirs.and_then(|theirs| {
        theirs.show_divider(ui, area);
        bar::caption(ui, area, theirs, rendering);
        theirs.judgement.show_frames(ui, &placement)
    });
    // over the frames of regions
    coordinates(&ui.painter().with_clip_rect(area), &placement);
    let subject = Subject { rendering, program: program.as_ref() };
    if subject.has_camera() {
        trail::paint(ui, &placement, &selection.trail(&subject.built().world));
    }
    (hovered, framed)
}
