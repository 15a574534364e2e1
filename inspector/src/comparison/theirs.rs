//! Their picture: read from a file, shown over ours, and compared with ours once that is finished.

use std::path::Path;
use std::sync::Arc;

use eframe::egui::{
    Align2, Color32, Context, CursorIcon, FontId, Id, Painter, Rect, Sense, Stroke, Ui, WidgetInfo,
    accesskit::Role,
};
use groundtruth::film::{Film, Tone};
use groundtruth::rgb::Rgb;
use judge::verdict;
use pictures::compare::{Comparison, Differences, Picture, Transfer};
use rays::{Logged, RayPlace};

use crate::action::Shows;
use crate::comparison::judgement::Judgement;
use crate::comparison::pixels::Pixels;
use crate::comparison::program::Program;
use crate::picture::chosen_layer::named;
use crate::picture::developed::{self, Developed, Version};
use crate::picture::display::write;
use crate::picture::saving::Content;
use crate::picture::view::Placement;
use crate::picture::worker::{Background, Growing, Rendering};
use crate::platform;

/// The share of the differing channels that the picture of the difference shows unclipped.
const UNCLIPPED: f64 = 0.9;

/// The width of the divider that reacts to the mouse, in points of the screen.
const DIVIDER: f32 = 10.0;

/// A finished picture of ours, by its generation, and how it compares with theirs.
type Compared = (u64, Arc<(Comparison, Differences)>);

/// Their picture.
pub struct Theirs {
    /// The name of its file.
    pub name: String,
    /// The view on the screen.
    pub shows: Shows,
    /// The place of the divider, as a share of the width of the picture's part of the window.
    pub divider: f32,
    /// The verdict on it.
    pub judgement: Judgement,
    /// The program that made it, if it is not of a file.
    pub program: Option<Arc<Program>>,
    /// Its pixels.
    pub pixels: Pixels,
    layer: Developed<()>,
    differences: Developed<()>,
    compared: Option<Compared>,
    comparing: Background<Compared>,
    /// The region that was selected last.
    region: Option<usize>,
}

impl Theirs {
    /// Reads a picture file whose display values are encoded by this curve; else by the one that it names, or that of
    /// sRGB.
    ///
    /// # Errors
    /// If it is no picture, or damaged.
    pub fn read(path: &Path, encoding: Option<Transfer>) -> Result<Self, String> {
        let picture = platform::read_picture(path, encoding)?;
        let pixels = Pixels::Whole(picture.radiance().into(), Some(picture.into()));
        Ok(Self::of(path.display().to_string(), pixels, None, Shows::default()))
    }

    /// The picture of a program, in this view: a film, or what it renders from now on.
    pub fn of_program(ctx: &Context, program: Program, film: Option<Film>, shows: Shows) -> Self {
        let program = Arc::new(program);
        let pixels = match film {
            Some(film) => Pixels::Whole(film.into(), None),
            None => Pixels::Growing(Growing::render(ctx, Arc::clone(&program))),
        };
        Self::of(program.name.clone(), pixels, Some(program), shows)
    }

    fn of(name: String, pixels: Pixels, program: Option<Arc<Program>>, shows: Shows) -> Self {
        Self {
            name,
            // a log opens at the first of its broken rays
            region: program.as_ref().and_then(|program| program.log()).map(|_| 0),
            program,
            shows,
            divider: 0.5,
            judgement: Judgement::default(),
            pixels,
            layer: Developed::default(),
            differences: Developed::default(),
            compared: None,
            comparing: Background::default(),
        }
    }

    /// The name of what made it; `theirs` for a file.
    pub fn short_name(&self) -> &str {
        self.program.as_ref().map_or("theirs", |program| &program.name)
    }

    /// The program whose pixels are explained, if it is another than ours: the one whose picture is shown.
    pub fn explained(&self) -> Option<&Arc<Program>> {
        self.program.as_ref().filter(|program| match self.shows {
            Shows::Theirs => true,
            Shows::Swipe => program.log().is_some(),
            Shows::Ours | Shows::Difference | Shows::Map => !program.is_beside_ours(),
        })
    }

    /// Whether the same pixel is explained in both pictures.
    pub fn is_twin(&self) -> bool {
        self.program.as_ref().is_some_and(|program| program.is_beside_ours())
    }

    /// The log of its rays, if that is what is known of it.
    pub fn log(&self) -> Option<&Logged> {
        self.program.as_ref()?.log()
    }

    /// Notes on what was ignored in its file.
    pub fn notes(&self) -> &[String] {
        self.stored().map_or(&[], |picture| &picture.notes)
    }

    fn stored(&self) -> Option<&Picture> {
        if let Pixels::Whole(_, stored) = &self.pixels { stored.as_deref() } else { None }
    }

    /// Its value at a pixel in words: as stored if that is radiance, else radiance and the stored integers.
    pub fn value(&self, pixel: [u32; 2]) -> Option<String> {
        let radiance = self.pixels.radiance(pixel)?;
        let Some(picture) = self.stored() else { return Some(text::brief::short(radiance)) };
        let [r, g, b] = picture.values[picture.index(pixel)];
        Some(match picture.step {
            None if [g, b] == [r, r] => format!("{r:?}"),
            None => format!("({r:?}, {g:?}, {b:?})"),
            Some(step) => {
                let integer = |value: f32| (f64::from(value) / step).round();
                let [r, g, b, largest] = [r, g, b, 1.0].map(integer);
                format!("{}, stored as {r}, {g}, {b} of {largest}", text::brief::short(radiance))
            }
        })
    }

    /// Its comparison with this picture of ours, once that is finished and compared.
    pub fn comparison(&self, rendering: &Rendering) -> Option<&Comparison> {
        Some(&self.compared_with(rendering)?.0)
    }

    /// The difference of theirs from ours at a pixel, 0 where the values of a file count as equal; `None` until both are
    /// rendered, and compared if theirs is of a file.
    pub fn difference(&self, rendering: &Rendering, pixel @ [x, y]: [u32; 2]) -> Option<Rgb> {
        let [width, height] = self.pixels.size();
        if self.program.is_some() {
            // both are of double precision
            return Some(self.pixels.radiance(pixel)? - rendering.radiance(pixel)?);
        }
        let (_, differences) = &**self.compared_with(rendering)?;
        (x < width && y < height).then(|| differences.at([x, y]).into())
    }

    /// The difference that is white; its negative is black.
    pub fn largest(&self, rendering: &Rendering) -> Option<f64> {
        Some(self.compared_with(rendering)?.1.within(UNCLIPPED))
    }

    fn compared_with(&self, rendering: &Rendering) -> Option<&Arc<(Comparison, Differences)>> {
        let (generation, compared) = self.compared.as_ref()?;
        (*generation == rendering.generation).then_some(compared)
    }

    /// Shows one of the pictures, the map only once there is one; ours, if it is shown already.
    pub fn flip(&mut self, wanted: Shows) {
        if self.program.as_ref().is_some_and(|program| !program.is_beside_ours()) {
            return;
        }
        if wanted != Shows::Map || self.judgement.verdict().is_some() {
            self.shows = if self.shows == wanted { Shows::Ours } else { wanted };
        }
    }

    /// The worst pixel of the next region of difference, the largest region first.
    ///
    /// # Errors
    /// Both are not compared yet, or equal.
    pub fn next_region(&mut self, rendering: &Rendering) -> Result<[u32; 2], &'static str> {
        let comparison = self.comparison(rendering).ok_or("the pictures are not compared yet")?;
        let worst: Vec<_> = comparison.listed().map(|it| it.worst).collect();
        self.next_of(&worst).ok_or("no pixel differs")
    }

    /// Where the next ray stands that breaks a law, if it is a log that is shown, and there is one.
    pub fn next_broken(&mut self) -> Option<RayPlace> {
        let broken = self.log()?.broken_rays();
        self.shows = if self.shows == Shows::Ours { Shows::Theirs } else { self.shows };
        let next = self.next_of(&broken)?;
        Some(self.log()?.place(next))
    }

    /// The next region or ray, and after the last the first again.
    fn next_of<T: Copy>(&mut self, all: &[T]) -> Option<T> {
        let next = self.region.map_or(0, |region| region + 1) % all.len().max(1);
        self.region = Some(next);
        all.get(next).copied()
    }

    /// The difference or the map of z that is shown, to be saved; `Some(None)` if it is not there yet.
    pub fn layer(&self, rendering: &Rendering) -> Option<Option<Content>> {
        let name = named(self.shows).filter(|_| self.fits(rendering))?;
        let films = if self.shows == Shows::Map {
            self.judgement.verdict().map(|verdict| {
                let (z, size) = (&verdict.shown.z, verdict.shown.theirs.size);
                (verdict::map_film(z, size), film(size, |index| Rgb::grey(z[index])))
            })
        } else {
            self.compared_with(rendering).map(|compared| {
                let differences = &compared.1;
                let values = film(self.pixels.size(), |index| differences.values()[index].into());
                (differences.film(differences.within(UNCLIPPED)), values)
            })
        };
        Some(films.map(|(colors, values)| Content::Beside { name, colors, values }))
    }

    /// Whether anything is still being computed for it.
    pub fn is_busy(&self, rendering: &Rendering) -> bool {
        let is_compared = self.comparison(rendering).is_some();
        let is_due = self.is_comparable(rendering) && !is_compared;
        let is_developing = self.layer.is_busy() || self.differences.is_busy();
        self.pixels.part().is_some() || is_developing || self.judgement.is_busy() || is_due
    }

    /// Whether it can be compared with our picture: a log has few of the pixels.
    fn is_comparable(&self, rendering: &Rendering) -> bool {
        let is_whole = rendering.is_finished() && self.pixels.part().is_none();
        is_whole && self.fits(rendering) && self.log().is_none()
    }

    /// Whether our picture has its size.
    pub fn fits(&self, rendering: &Rendering) -> bool {
        rendering.size() == self.pixels.size()
    }

    /// Compares with our picture once it is finished, and makes the layer that is shown.
    pub fn refresh(&mut self, ctx: &Context, rendering: &Rendering, tone: Tone) {
        let generation = rendering.generation;
        if let Some(Ok(compared)) = self.comparing.poll() {
            (self.compared, self.region) = (Some(compared), None);
            self.differences = Developed::default();
        }
        self.judgement.refresh(ctx, generation, self.shows == Shows::Map);
        if self.shows == Shows::Map && self.judgement.verdict().is_none() {
            self.shows = Shows::Ours;
        }
        if !self.fits(rendering) {
            return;
        }
        self.pixels.develop(ctx, &mut self.layer, tone);
        let is_compared = self.comparison(rendering).is_some();
        if self.is_comparable(rendering) && !is_compared && !self.comparing.is_busy() {
            let (canvas, theirs) = (Arc::clone(&rendering.canvas), self.pixels.picture());
            self.comparing.start(ctx, move || {
                let (ours, theirs) = (Picture::of_film(&canvas.film()), theirs());
                let comparison =
                    Comparison::of(&ours, &theirs, 0.0).expect("only pictures of one size");
                (generation, Arc::new((comparison, Differences::of(&ours, &theirs, 0.0))))
            });
        }
        if let Some(compared) = self.compared_with(rendering).map(Arc::clone)
            && self.shows == Shows::Difference
        {
            self.differences.refresh(ctx, Version::whole((), Tone::PLAIN), move || {
                let film = compared.1.film(compared.1.within(UNCLIPPED));
                ((), developed::of_film(&film, &Tone::PLAIN))
            });
        }
    }

    /// Draws it over our picture.
    pub fn paint(&self, painter: &Painter, placement: &Placement, rendering: &Rendering) {
        let is_whole = self.program.as_ref().is_none_or(|program| program.is_whole());
        let is_ready = match self.shows {
            Shows::Ours => true,
            _ if !is_whole => true,
            Shows::Theirs => self.pixels.paint(painter, &self.layer, placement),
            Shows::Swipe => {
                let area = painter.clip_rect();
                let right = area.with_min_x(divider_x(area, self.divider));
                self.pixels.paint(&painter.with_clip_rect(right), &self.layer, placement)
            }
            Shows::Difference => {
                self.compared_with(rendering).is_some()
                    && self.differences.paint(painter, placement)
            }
            Shows::Map => self.judgement.map.paint(painter, placement),
        };
        if !is_ready {
            let text = match self.shows {
                Shows::Difference if self.is_comparable(rendering) => "the difference is computed",
                Shows::Difference => "the difference follows when both pictures are finished",
                Shows::Map => "the map of z follows",
                _ => "the other picture follows",
            };
            let at = placement.whole().intersect(painter.clip_rect()).center();
            painter.text(at, Align2::CENTER_CENTER, text, FontId::default(), Color32::WHITE);
        }
    }

    /// Draws the divider of the swipe; the mouse moves it.
    pub fn show_divider(&mut self, ui: &mut Ui, area: Rect) {
        if self.shows != Shows::Swipe || self.program.as_ref().is_some_and(|it| !it.is_whole()) {
            return;
        }
        let x = divider_x(area, self.divider);
        let strip = Rect::from_x_y_ranges(x - 0.5 * DIVIDER..=x + 0.5 * DIVIDER, area.y_range());
        let response = ui.interact(strip, Id::unique("divider"), Sense::drag());
        response.widget_info(|| {
            let mut info = WidgetInfo::labeled(Role::Splitter, true, "divider");
            info.value = Some(self.divider.into());
            info
        });
        let response = response.on_hover_and_drag_cursor(CursorIcon::ResizeHorizontal);
        self.divider = (self.divider + response.drag_delta().x / area.width()).clamp(0.0, 1.0);
        let painter = ui.painter();
        painter.vline(x, area.y_range(), Stroke::new(4.0, Color32::BLACK));
        painter.vline(x, area.y_range(), Stroke::new(2.0, Color32::from_rgb(255, 140, 0)));
        // below the coordinates of pixels
        let area = area.with_min_y(area.top() + 14.0);
        write(painter, area.with_max_x(x), Align2::RIGHT_TOP, "ours".to_owned());
        write(painter, area.with_min_x(x), Align2::LEFT_TOP, self.short_name().to_owned());
    }
}

fn film([width, height]: [u32; 2], value: impl Fn(usize) -> Rgb) -> Film {
    let mut film = Film::new(width, height);
    for index in 0..width as usize * height as usize {
        film.set([index as u32 % width, index as u32 / width], value(index));
    }
    film
}

fn divider_x(area: Rect, share: f32) -> f32 {
    (area.left() + share * area.width()).round()
}
