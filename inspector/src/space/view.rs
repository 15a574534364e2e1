//! The space view: its camera, what is drawn in it, and the mouse and keys that move it.

use std::collections::BTreeMap;
use std::sync::Arc;

use eframe::egui::{
    Align2, Context, Id, Rect, Response, Sense, Slider, Ui, Vec2, WidgetInfo, accesskit::Role, vec2,
};
use explain::RecordedRay;
use groundtruth::printable::name;
use groundtruth::world::World;
use space::{Orbit, Segment};
use text::brief::count;

use crate::explanation::Subject;
use crate::explanation::asked::Question;
use crate::explanation::selection::Selection;
use crate::explanation::{beside, pointing};
use crate::picture::display::{ground, write};
use crate::space::backdrop::{Backdrop, Request};
use crate::space::camera::{Camera, Seen};
use crate::space::filter::Filter;
use crate::space::paint::{Canvas, Rays, numbered};
use crate::splits::{Mode, fixed, part};

/// The most pieces of rays that are drawn.
const MAX_PIECES: usize = 4000;
/// The margin of the buttons, in points of the screen.
const MARGIN: Vec2 = vec2(6.0, 3.0);

/// The width of the slider along a path with its words, in points of the screen.
const STEPS_WIDTH: f32 = 160.0;

/// The lengths of the frustum of the scene's camera and of normals, in distances of the orbiting camera.
const FRUSTUM: f64 = 0.08;
const NORMAL: f64 = 0.05;

/// What the mouse does in the view.
#[derive(Default)]
struct Pointed {
    /// The ray under the mouse.
    hovered: Option<usize>,
    /// The ray that was clicked.
    clicked: Option<usize>,
    /// The object of which is asked why the selected ray does not hit it.
    why_not: Option<u32>,
}

/// The pieces of rays that are drawn: for which tree and filter.
struct Pieces {
    question: Question,
    filter: Filter,
    /// The numbers of the rays, and the one that was selected.
    drawn: (Vec<usize>, usize),
    segments: Arc<Vec<Segment>>,
    /// Rays and pieces of smaller contribution, which are not drawn.
    left_out: usize,
}

impl Pieces {
    fn of(
        world: &World,
        (question, root): (Question, &RecordedRay),
        selected: usize,
        filter: &Filter,
    ) -> Self {
        let (_, reach) = space::of_scene(world);
        let all = space::segments(world, root, reach);
        let (drawn, small) = filter.drawn(root, selected);
        let mut segments: Vec<Segment> =
            all.into_iter().filter(|piece| drawn.binary_search(&piece.ray).is_ok()).collect();
        let beyond = segments.len().saturating_sub(MAX_PIECES);
        if beyond > 0 {
            let shares: BTreeMap<usize, f64> =
                root.rays().iter().map(|ray| (ray.number, ray.share)).collect();
            segments.sort_by(|a, b| shares[&b.ray].total_cmp(&shares[&a.ray]));
            segments.truncate(MAX_PIECES);
        }
        let (filter, segments) = (filter.clone(), Arc::new(segments));
        let drawn = (drawn, selected);
        Self { question, filter, drawn, segments, left_out: small + beyond }
    }
}

/// The space view.
#[derive(Default)]
pub struct SpaceView {
    /// Whether it is shown.
    pub mode: Mode,
    /// The camera.
    pub camera: Camera,
    /// The index of the object that is pointed at in the list of objects.
    pub pointed: Option<u32>,
    filter: Filter,
    /// The scene behind the rays.
    pub backdrop: Backdrop,
    pieces: Option<Pieces>,
    /// Those of the other tree.
    other: Option<Pieces>,
    /// The object for which the menu was opened.
    menu: Option<u32>,
    id: Option<Id>,
}

impl SpaceView {
    /// Forgets the camera and the faded objects of another scene.
    pub fn restart(&mut self) {
        *self = Self { mode: self.mode, ..Self::default() };
    }

    /// Whether something of it is still being drawn.
    pub fn is_busy(&self) -> bool {
        self.mode != Mode::Picture && self.backdrop.is_busy()
    }

    /// Whether it gets the keys.
    pub fn has_keys(&self, ctx: &Context) -> bool {
        self.id.is_some() && ctx.memory(|memory| memory.focused()) == self.id
    }

    /// Shows the rays of the selected sample in this area, with those of the other picture if both are shown, and passes on
    /// what the mouse does.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        area: Rect,
        (subject, is_both): (&Subject<'_>, bool),
        selection: &mut Selection,
    ) {
        let world = &subject.built().world;
        let tree = selection.root();
        let trees = [tree, selection.root_beside().filter(|_| is_both)];
        let path = tree.map_or(Vec::new(), |(_, root)| selection.tree.path(root));
        let path: Vec<usize> = path.iter().map(|ray| ray.number).collect();
        self.update_pieces(world, trees, path.last().copied().unwrap_or(0));
        let segments =
            self.pieces.as_ref().map_or_else(Arc::default, |it| Arc::clone(&it.segments));
        let (root, selected) = (tree.map(|(_, root)| root), selection.tree.ray);
        let scene = Seen { world, root, selected, segments: &segments };
        self.camera.start(&scene);
        let mut stepped = None;
        let walk = (&*path, &mut stepped);
        let buttons = part(ui, "space buttons", area, MARGIN, |ui| self.buttons(ui, &scene, walk));
        let view = area.with_min_y(buttons.bottom() + MARGIN.y);
        let response = ui.interact(view, Id::unique("space"), Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, "space"));
        self.id = Some(response.id);
        self.camera.follow(ui, &response, &scene);
        let Some(orbit) = self.camera.orbit else { return };
        let request = Request {
            version: subject.version(),
            orbit,
            size: [view.width(), view.height()].map(|side| side as usize),
            faded: self.camera.faded.clone(),
            ground: ground(ui.visuals()).r(),
            segments: Arc::clone(&segments),
        };
        self.backdrop.refresh(ui.ctx(), world, request);
        let of = (&orbit, &**world, subject.has_camera());
        let pointed = self.paint(ui, view, &response, of, selection);
        if let Some(number) = stepped.or(pointed.clicked) {
            selection.go_to(number);
        }
        if let Some(object) = pointed.why_not {
            selection.ask_why_not(object);
        }
        selection.tree.hovered = selection.tree.hovered.or(pointed.hovered);
    }

    /// Works the pieces out again if the tree or the filter has changed.
    fn update_pieces(
        &mut self,
        world: &World,
        trees: [Option<(Question, &RecordedRay)>; 2],
        selected: usize,
    ) {
        for (pieces, tree) in [&mut self.pieces, &mut self.other].into_iter().zip(trees) {
            let is_same = |it: &Pieces| {
                Some(it.question) == tree.map(|(question, _)| question)
                    && it.filter == self.filter
                    && (it.drawn.1 == selected || it.drawn.0.binary_search(&selected).is_ok())
            };
            if !pieces.as_ref().is_some_and(is_same) {
                *pieces = tree.map(|tree| Pieces::of(world, tree, selected, &self.filter));
            }
        }
    }

    /// Shows the buttons, and the slider that walks along the path to a ray: returns where they end.
    fn buttons(
        &mut self,
        ui: &mut Ui,
        scene: &Seen<'_>,
        (path, stepped): (&[usize], &mut Option<usize>),
    ) -> Rect {
        let row = ui.horizontal_wrapped(|ui| {
            self.camera.buttons(ui, scene);
            ui.separator();
            if let Some(root) = scene.root {
                ui.menu_button("Rays", |ui| self.filter.show(ui, root));
            }
            ui.menu_button("Look through", |ui| self.fading(ui, scene.world));
            let last = path.len().max(1);
            let mut step = 1 + path.iter().position(|ray| *ray == scene.selected).unwrap_or(0);
            fixed(ui, STEPS_WIDTH, |ui| {
                let label = ui.label("step");
                ui.spacing_mut().slider_width = 0.4 * STEPS_WIDTH;
                let slider = Slider::new(&mut step, 1..=last);
                let slider = slider.custom_formatter(move |step, _| format!("{step} of {last}"));
                let slider = ui.add_enabled(last > 1, slider).labelled_by(label.id);
                if slider.on_hover_text("Walks along the path to the selected ray").changed() {
                    *stepped = path.get(step - 1).copied();
                }
            });
        });
        row.response.rect
    }

    /// Shows which objects are looked through.
    fn fading(&mut self, ui: &mut Ui, world: &World) {
        ui.weak("Transparent materials always are.");
        for object in world.objects() {
            self.camera.fade(ui, object.index, name(&object.name).to_string());
        }
    }

    /// Draws the scene, the rays and the line below them; returns what the mouse does.
    fn paint(
        &mut self,
        ui: &Ui,
        view: Rect,
        response: &Response,
        (orbit, world, has_camera): (&Orbit, &World, bool),
        selection: &Selection,
    ) -> Pointed {
        let painter = ui.painter().with_clip_rect(view.intersect(ui.clip_rect()));
        let sight = orbit.sight([view.width(), view.height()].map(f64::from));
        let visuals = ui.visuals();
        let canvas = Canvas { painter: &painter, corner: view.min, sight, visuals };
        let root = selection.root().map(|(_, root)| root);
        let by_number = root.map_or(Vec::new(), RecordedRay::rays);
        let (selected, lit) = (selection.tree.ray, selection.tree.lit);
        let lit_ray = lit.and_then(|number| numbered(&by_number, number));
        let at = response.hover_pos();
        let object = at.and_then(|at| self.backdrop.object_at((at - view.min).into()));
        let of_ray = lit_ray.and_then(|ray| Some(&*ray.hit.as_ref()?.object));
        let of_ray = world.objects().iter().find(|object| Some(&*object.name) == of_ray);
        painter.rect_filled(view, 0.0, ground(visuals));
        let of_ray = of_ray.map(|object| object.index);
        self.backdrop.paint(&painter, view, self.pointed.or(of_ray).or(object));
        if has_camera {
            canvas.frustum(world, selection.pixel, FRUSTUM * orbit.distance);
        }
        let mut pointed = Pointed::default();
        if let Some(pieces) = &self.pieces {
            let runs = self.backdrop.runs(&pieces.segments);
            let path = root.map_or(Vec::new(), |root| root.path_to(selected));
            let next = path.last().map_or(&[][..], |ray| &ray.children);
            let labelled: Vec<_> = path.iter().copied().chain(next).collect();
            let path = path.iter().map(|ray| ray.number);
            let all_lit: Vec<usize> = lit.into_iter().chain(path).collect();
            let other = selection.root_beside().map(|(_, other)| other);
            if let (Some(pieces), Some(other)) = (&self.other, other) {
                canvas.rays(&Rays {
                    by_number: &other.rays(),
                    segments: &pieces.segments,
                    dashed: true,
                    ..Rays::default()
                });
            }
            let drawn = canvas.rays(&Rays {
                by_number: &by_number,
                segments: &pieces.segments,
                runs: runs.as_deref().map(Vec::as_slice),
                lit: if lit.is_some() || selected > 0 { &all_lit } else { &[] },
                broken: Some(&selection.tree.found),
                dashed: false,
                normals: self.filter.normals.then_some(NORMAL * orbit.distance),
            });
            canvas.labels(&labelled, &pieces.segments);
            let trees = root.zip(other.filter(|_| self.other.is_some()));
            let parted = trees.and_then(|(root, other)| beside::parting(root, other));
            parted.into_iter().for_each(|rays| canvas.parting(rays));
            pointed.hovered = at.and_then(|at| pointing::nearest(&drawn, at));
            pointed.clicked = pointed.hovered.filter(|_| response.clicked());
            if pieces.left_out > 0 {
                let left_out = count(pieces.left_out, "ray");
                let text = format!("{left_out} of small share not drawn (Rays)");
                write(&painter, view, Align2::RIGHT_TOP, text);
            }
        }
        let under = pointed.hovered.and_then(|number| numbered(&by_number, number));
        let object_name = object.and_then(|index| world.names.objects.get(index as usize));
        let text = match (under.or(lit_ray), object_name) {
            (Some(ray), _) => ray.line(),
            (None, Some(object)) => format!("{} (right click: look through it)", name(object)),
            (None, None) => "drag: turn · Shift or right drag: move · wheel: nearer".to_owned(),
        };
        write(&painter, view, Align2::LEFT_BOTTOM, text);
        pointed.why_not = self.object_menu(response, object, world);
        pointed
    }

    /// Shows the menu of the object that was clicked with the right button. Returns the object of which is asked why the
    /// selected ray does not hit it.
    fn object_menu(
        &mut self,
        response: &Response,
        object: Option<u32>,
        world: &World,
    ) -> Option<u32> {
        if response.secondary_clicked() {
            self.menu = object;
        }
        let object = self.menu?;
        let object_name = name(world.names.objects.get(object as usize)?);
        let mut asked = None;
        response.context_menu(|ui| {
            if self.camera.fade(ui, object, format!("Look through {object_name}")) {
                ui.close();
            }
            let question = format!("Why does the selected ray not hit {object_name}?");
            if ui.button(question).clicked() {
                asked = Some(object);
            }
        });
        asked
    }
}
