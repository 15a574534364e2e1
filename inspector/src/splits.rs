//! The three parts of the window side by side and the two of the explanation, one above the other: shares of width and
//! height, and the bars between them; picture and space view where the picture is.

use eframe::egui::{
    Align, Button, CursorIcon, Id, Layout, Pos2, Rect, Sense, Stroke, Ui, UiBuilder, Vec2,
    WidgetInfo, accesskit::Role, vec2,
};
use serde::{Deserialize, Serialize};

/// The width of a bar between two parts, in points of the screen.
const BAR: f32 = 8.0;
/// The smallest shares of scene, picture and explanation.
const MIN: [f32; 3] = [0.1, 0.3, 0.25];
/// The smallest share of the details, the smallest before the bar was dragged, and the largest.
const DETAILS: [f32; 3] = [0.15, 0.41, 0.75];
/// The least height of the details before the bar was dragged, with room for a section, in points of the screen.
const DETAILS_MIN_HEIGHT: f32 = 235.0;
/// The least width of the scene's panel, which its numbers and lists need, in points of the screen: less in a window that has
/// no room for more.
const SCENE_MIN_WIDTH: [f32; 2] = [152.0, 176.0];
/// The share of the window that the least width is between these bounds.
const SCENE_MIN_SHARE: f32 = 0.195;

/// The width of a window below which the scene's panel is folded away, and what is left of it, in points of the screen.
pub const NARROW: f32 = 1000.0;
const FOLDED: f32 = 30.0;
/// The share of the window that the explanation gains then.
const GAINED: f32 = 0.08;

/// What is shown where the picture is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Mode {
    /// The picture.
    #[default]
    Picture,
    /// The picture and the space view.
    Both,
    /// The space view.
    Space,
}

impl Mode {
    /// Picture, both, space, and picture again.
    pub fn next(self) -> Self {
        match self {
            Self::Picture => Self::Both,
            Self::Both => Self::Space,
            Self::Space => Self::Picture,
        }
    }

    /// The areas of the picture and of the space view.
    pub fn divide(self, area: Rect) -> [Option<Rect>; 2] {
        let Pos2 { x, y } = area.center().round();
        let halves = match area.width() > area.height() {
            true => [area.with_max_x(x - 1.0), area.with_min_x(x + 1.0)],
            false => [area.with_max_y(y - 1.0), area.with_min_y(y + 1.0)],
        };
        match self {
            Self::Picture => [Some(area), None],
            Self::Space => [None, Some(area)],
            Self::Both => halves.map(Some),
        }
    }
}

/// Shares of the window's width, of which the picture has the rest, and of the explanation's height.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Splits {
    /// The share of the scene's panel, at the left.
    scene: f32,
    /// The share of the explanation, at the right.
    explanation: f32,
    /// The share of the details, below the tree, once the bar was dragged; else they have what the tree does not need.
    dragged: Option<f32>,
    /// Whether the scene's panel is shown in a narrow window, too.
    unfolded: bool,
}

impl Default for Splits {
    fn default() -> Self {
        Self { scene: 0.15, explanation: 0.38, dragged: None, unfolded: false }
    }
}

impl Splits {
    /// Draws the bars, and moves them with the mouse. Returns the areas of the scene, which has none while it is folded away,
    /// and of picture and explanation.
    pub fn show(&mut self, ui: &mut Ui, area: Rect) -> (Option<Rect>, [Rect; 2]) {
        let Self { scene: left, explanation: right, .. } = *self;
        let at = |share: f32| (area.left() + share * area.width()).round();
        let [least, most] = SCENE_MIN_WIDTH;
        let min = (SCENE_MIN_SHARE * area.width()).clamp(least, most);
        let is_folded = self.fold(ui, area);
        let right = if is_folded { right + GAINED } else { right };
        let left = if is_folded { FOLDED / area.width() } else { left.max(min / area.width()) };
        let moved = bar(ui, "left bar", strip(area, at(left)), left);
        self.scene = match moved {
            _ if is_folded => self.scene,
            Some(by) if by.x == 0.0 => self.scene,
            Some(by) => left + by.x / area.width(),
            None => Self::default().scene,
        };
        let moved = bar(ui, "right bar", strip(area, at(1.0 - right)), 1.0 - right);
        self.explanation =
            moved.map_or(Self::default().explanation, |by| self.explanation - by.x / area.width());
        *self = self.fitting();
        let (first, last) = (strip(area, at(left)), strip(area, at(1.0 - right)));
        // below the button that folds it away
        let button = if area.width() < NARROW { FOLDED - BAR } else { 0.0 };
        let scene = Rect::from_min_max(area.min + vec2(0.0, button), first.left_bottom());
        let picture = area.with_min_x(first.right()).with_max_x(last.left());
        (Some(scene).filter(|_| !is_folded), [picture, area.with_min_x(last.right())])
    }

    /// In a narrow window shows the button that folds the scene's panel away. Returns whether it is.
    fn fold(&mut self, ui: &mut Ui, area: Rect) -> bool {
        if area.width() >= NARROW {
            return false;
        }
        let at = Rect::from_min_size(area.min + vec2(1.0, 1.0), Vec2::splat(FOLDED - BAR));
        ui.painter().rect_filled(area.with_max_x(at.right() + 4.0), 0.0, ui.visuals().panel_fill);
        let text = if self.unfolded { "«" } else { "»" };
        let button = ui.put(at, Button::new(text));
        button.widget_info(|| WidgetInfo::labeled(Role::Button, true, "The scene"));
        let hint = "The scene: its settings, lights and objects; always shown in a wider window";
        self.unfolded ^= button.on_hover_text(hint).clicked();
        !self.unfolded
    }

    /// Draws the bar between tree and details, moves it with the mouse, and returns the areas of both; the tree and what is
    /// above it need the height `needed`.
    pub fn show_lower(&mut self, ui: &mut Ui, area: Rect, needed: f32) -> [Rect; 2] {
        let [_, usual, most] = DETAILS;
        // a low window still shows some rows of the tree
        let least = (DETAILS_MIN_HEIGHT / area.height()).clamp(usual, 0.5);
        let usual = (1.0 - needed / area.height()).clamp(least, most);
        let share = self.dragged.unwrap_or(usual);
        let y = (area.bottom() - share * area.height()).round();
        let strip = Rect::from_x_y_ranges(area.x_range(), y - 0.5 * BAR..=y + 0.5 * BAR);
        match bar(ui, "lower bar", strip, 1.0 - share) {
            None => self.dragged = None,
            Some(by) if by.y != 0.0 => self.dragged = Some(share - by.y / area.height()),
            Some(_) => {}
        }
        *self = self.fitting();
        [area.with_max_y(strip.top()), area.with_min_y(strip.bottom())]
    }

    /// The shares clamped so that each part has room; the defaults if a share is NaN.
    #[must_use]
    pub fn fitting(self) -> Self {
        let shares = [self.scene, self.explanation, self.dragged.unwrap_or_default()];
        if !shares.into_iter().all(f32::is_finite) {
            return Self::default();
        }
        let [least, _, most] = DETAILS;
        let dragged = self.dragged.map(|share| share.clamp(least, most));
        let [scene, picture, explanation] = MIN;
        let scene = self.scene.clamp(scene, 1.0 - picture - explanation);
        let explanation = self.explanation.clamp(explanation, 1.0 - picture - scene);
        Self { scene, explanation, dragged, ..self }
    }
}

/// Shows a part of the window in its area, with this margin.
pub fn part<T>(
    ui: &mut Ui,
    name: &str,
    area: Rect,
    margin: Vec2,
    show: impl FnOnce(&mut Ui) -> T,
) -> T {
    let builder = UiBuilder::new().id_salt(name).max_rect(area.shrink2(margin));
    ui.scope_builder(builder, |ui| {
        ui.set_clip_rect(ui.clip_rect().intersect(area));
        show(ui)
    })
    .inner
}

/// Shows something in a part of a row that keeps its width, so that what comes after it does not move.
pub fn fixed(ui: &mut Ui, width: f32, show: impl FnOnce(&mut Ui)) {
    let size = vec2(width, ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
        ui.set_min_width(width);
        show(ui);
    });
}

/// The area of the bar at `x`.
fn strip(area: Rect, x: f32) -> Rect {
    Rect::from_x_y_ranges(x - 0.5 * BAR..=x + 0.5 * BAR, area.y_range())
}

/// Shows a bar and returns how far it is dragged; `None` on a double click, which resets it.
fn bar(ui: &mut Ui, name: &str, rect: Rect, share: f32) -> Option<Vec2> {
    let is_upright = rect.height() > rect.width();
    let (cursor, along) = match is_upright {
        true => (CursorIcon::ResizeHorizontal, vec2(0.0, 1.0)),
        false => (CursorIcon::ResizeVertical, vec2(1.0, 0.0)),
    };
    let response = ui.interact(rect, Id::unique(name), Sense::click_and_drag());
    response.widget_info(|| {
        let mut info = WidgetInfo::labeled(Role::Splitter, true, name);
        info.value = Some(share.into());
        info
    });
    let response = response
        .on_hover_and_drag_cursor(cursor)
        .on_hover_text("Drag to resize; double click: its default place");
    let visuals = ui.style().interact(&response);
    let painter = ui.painter();
    painter.rect_filled(rect, 0.0, visuals.bg_fill);
    let line = Stroke::new(1.0, visuals.fg_stroke.color);
    // three dots as a handle
    for offset in [-8.0, 0.0, 8.0] {
        let dot: Pos2 = rect.center() + offset * along;
        painter.rect_filled(Rect::from_center_size(dot, Vec2::splat(3.0)), 1.5, line.color);
    }
    (!response.double_clicked()).then(|| response.drag_delta())
}
