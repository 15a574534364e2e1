//! The rays of the selected sample in space.

use eframe::egui::{
    Event, Key, Modifiers, PointerButton, Pos2, Rect, Shape, accesskit::Role, epaint::ClippedShape,
    pos2, vec2,
};
use egui_kittest::kittest::Queryable;
use explain::RecordedRay;
use groundtruth::cameras::{Pinhole, View, ViewPlane, Viewpoint};
use groundtruth::math::Point;
use inspector::space::filter::Filter;
use inspector::splits::Mode;

use crate::support::*;

/// A pixel of the glass sphere.
const PIXEL: [u32; 2] = [26, 25];

/// A window that shows a pixel of the glass sphere in space.
fn in_space() -> Window {
    let mut window = glass_window_at(PIXEL);
    set(&mut window, |it| it.space.mode = Mode::Space);
    window
}

fn area(window: &Window) -> Rect {
    window.get_by_role_and_label(Role::Canvas, "space").rect()
}

/// The tracer's own pinhole at the place of the orbiting camera, with a film in points of the screen.
fn camera(window: &Window) -> View {
    let orbit = window.state().space.camera.orbit.expect("there is something to see");
    let size = area(window).size();
    let film = ViewPlane { width: size.x.into(), height: size.y.into() };
    let eye = orbit.sight([film.width, film.height]).eye;
    // half the smaller side is seen under an angle whose tangent is 0.36
    let lens = Pinhole { distance: 0.5 * film.width.min(film.height) / 0.36, zoom: 1.0 };
    Viewpoint::new(eye, orbit.target, lens).build(film).expect("a camera")
}

/// Where the tracer's pinhole sees a point, on the screen.
fn place(window: &Window, point: Point) -> Pos2 {
    let [x, y] = camera(window).eyes()[0].project(point).expect("it is in view");
    area(window).center() + vec2(x as f32, -y as f32)
}

fn root(window: &Window) -> RecordedRay {
    window.state().selection.root().expect("explained").1.clone()
}

/// The middle of the ray inside the glass.
fn middle(ray: &RecordedRay) -> Point {
    let end = ray.hit.as_ref().expect("it meets the back of the sphere").point;
    ray.ray.origin + 0.5 * (end - ray.ray.origin)
}

/// Law: a ray is drawn where the tracer's pinhole projects its recorded ends: the mouse there points at it, lights its
/// row, and a click selects it. Oracle: `Eye::project` of a pinhole.
#[test]
fn a_ray_is_drawn_where_it_is() {
    let mut window = in_space();
    let root = root(&window);
    let inside =
        root.children.iter().find(|ray| ray.line().contains("transmitted")).expect("glass");
    let at = place(&window, middle(inside));
    hover(&mut window, at);
    assert_eq!(window.state().selection.tree.lit, Some(inside.number));
    window.drag_at(at);
    window.drop_at(at);
    window.run_steps(3);
    assert_eq!(window.state().selection.tree.ray, inside.number);
    let aside = pos2(area(&window).left() + 2.0, at.y);
    hover(&mut window, aside);
    assert_eq!(window.state().selection.tree.lit, None);
}

/// Law: a row of the tree that is pointed at lights its ray. Oracle: the number in the row.
#[test]
fn a_row_of_the_tree_lights_its_ray() {
    let mut window = in_space();
    let row = window.get_by_label_contains("1  from 0").rect().center();
    hover(&mut window, row);
    assert_eq!(window.state().selection.tree.lit, Some(1));
}

/// Law: the camera turns about its target by 0.4° for a point, and the wheel and the keys keep the target. Closed form.
#[test]
fn the_camera_orbits() {
    let mut window = in_space();
    let before = window.state().space.camera.orbit.unwrap();
    let at = area(&window).center();
    drag(&mut window, at, at + vec2(-50.0, 20.0));
    let turned = window.state().space.camera.orbit.unwrap();
    assert!((turned.yaw - before.yaw - 20.0).abs() < 1e-3, "{} after {}", turned.yaw, before.yaw);
    assert!((turned.pitch - before.pitch - 8.0).abs() < 1e-3);
    assert_eq!((turned.target, turned.distance), (before.target, before.distance));
    // the view has the keys since it was dragged
    press(&mut window, Key::Num3);
    let top = window.state().space.camera.orbit.unwrap();
    assert_eq!(top.pitch, 90.0);
    press(&mut window, Key::ArrowDown);
    assert_eq!(window.state().space.camera.orbit.unwrap().pitch, 85.0);
}

/// Law: S shows picture, both, and space, in turn; the picture and the space view share its area without overlap.
#[test]
fn a_key_goes_through_the_views() {
    let mut window = glass_window_at(PIXEL);
    for (mode, has_picture, has_space) in
        [(Mode::Both, true, true), (Mode::Space, false, true), (Mode::Picture, true, false)]
    {
        press(&mut window, Key::S);
        assert_eq!(window.state().space.mode, mode);
        let picture = window.query_by_role_and_label(Role::Image, "picture");
        let space = window.query_by_role_and_label(Role::Canvas, "space");
        assert_eq!([picture.is_some(), space.is_some()], [has_picture, has_space]);
        if let (Some(picture), Some(space)) = (picture, space) {
            assert!(!picture.rect().intersects(space.rect()));
        }
    }
}

/// Law: an object that is looked through shows what is behind it. Oracle: the colour of the red sphere's middle is no
/// longer red alone.
#[test]
fn an_object_can_be_looked_through() {
    let mut window = in_space();
    let world = built(&small_glass_sphere());
    let red = world.objects().iter().find(|object| &*object.name == "red sphere").expect("red");
    let at = place(&window, red.shape.bounds().center());
    let opaque = color_at(&mut window, at);
    set(&mut window, |it| it.space.camera.faded.push(red.index));
    let faded = color_at(&mut window, at);
    let redness = |[r, g, _]: [u8; 3]| i32::from(r) - i32::from(g);
    assert!(redness(opaque) > 40, "{opaque:?}");
    assert!(redness(faded) < redness(opaque) - 20, "{faded:?} after {opaque:?}");
}

/// Law: a drag moves the section as far as the mouse, the wheel makes it larger, and a double click fits it
/// again. Oracle: the pixels of the window before.
#[test]
fn the_section_is_zoomed_moved_and_fitted() {
    let mut window = glass_window_at(PIXEL);
    push(&mut window, "The section");
    let area = window.get_by_role_and_label(Role::Image, "section").rect();
    let drawn = |window: &mut Window| {
        hover(window, pos2(1.0, 1.0));
        window.render().expect("drawn")
    };
    let fitted = drawn(&mut window);
    let (at, by) = (area.center(), vec2(24.0, -16.0));
    drag(&mut window, at, at + by);
    let moved = drawn(&mut window);
    let mut differing = 0;
    for x in (area.left() as u32 + 40)..(area.right() as u32 - 40) {
        for y in (area.top() as u32 + 30)..(area.bottom() as u32 - 30) {
            let there = moved.get_pixel((x as f32 + by.x) as u32, (y as f32 + by.y) as u32);
            let [before, after] = [fitted.get_pixel(x, y).0, there.0];
            let is_same = before.iter().zip(after).all(|(a, b)| a.abs_diff(b) <= 8);
            assert!(is_same, "({x}, {y}): {before:?} and {after:?}");
            differing += u32::from(fitted.get_pixel(x, y) != moved.get_pixel(x, y));
        }
    }
    assert!(differing > 100, "{differing} pixels were moved");

    double_click(&mut window, at);
    assert!(drawn(&mut window) == fitted, "a double click fits");
    turn_wheel(&mut window, at);
    let larger = drawn(&mut window);
    assert!(larger != fitted);
    double_click(&mut window, at);
    assert!(drawn(&mut window) == fitted);
}

/// Law: a click with the right button on an object of the picture says why the selected ray does not hit it. Oracle: the
/// ground is a part of the plane y = 0, which the camera's ray, going down by 0.04 for each unit, meets behind its edge.
#[test]
fn the_right_button_asks_why_not() {
    let mut window = glass_window_at(PIXEL);
    let pos = on_screen(&window, [24, 46]);
    window.hover_at(pos);
    window.step();
    let press = |pressed| Event::PointerButton {
        pos,
        button: PointerButton::Secondary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    window.input_mut().events.extend([true, false].map(press));
    settle(&mut window);
    let sentence = text_with(&window, "does not hit");
    assert!(sentence.contains("ground") && sentence.contains("outside the part"), "{sentence}");
    assert_eq!(window.state().selection.pixel, Some(PIXEL), "the pixel stays");
}

/// Law: what is pointed at is outlined, and keeps its own colours inside, so that none is that of a ray; when another object is
/// pointed at, it is no more. Oracle: the screen before, in the middle of the red sphere and around its projected bounds.
#[test]
fn what_is_pointed_at_is_outlined() {
    let mut window = in_space();
    let world = built(&small_glass_sphere());
    let red = world.objects().iter().find(|object| &*object.name == "red sphere").expect("red");
    let middle = place(&window, red.shape.bounds().center());
    let before = window.render().expect("drawn");
    window.hover_at(window.get_by_label("red sphere").rect().center());
    settle(&mut window);
    let after = window.render().expect("drawn");
    let around = area(&window).intersect(Rect::from_center_size(middle, vec2(600.0, 600.0)));
    let all = (around.left() as u32..around.right() as u32)
        .flat_map(|x| (around.top() as u32 + 30..around.bottom() as u32 - 30).map(move |y| [x, y]));
    let is_changed = |[x, y]: &[u32; 2]| before.get_pixel(*x, *y) != after.get_pixel(*x, *y);
    let changed: Vec<[u32; 2]> = all.filter(is_changed).collect();
    assert!(changed.len() > 100, "{} pixels of an outline", changed.len());
    let near = |[x, y]: &&[u32; 2]| pos2(*x as f32, *y as f32).distance(middle) < 12.0;
    assert_eq!(changed.iter().find(near), None);
    window.hover_at(window.get_by_label("glass sphere").rect().center());
    settle(&mut window);
    let other = window.render().expect("drawn");
    let kept = changed.iter().filter(|[x, y]| other.get_pixel(*x, *y) == after.get_pixel(*x, *y));
    assert!(10 * kept.count() < changed.len(), "the outline is still there");
}

/// Law: rays of less than half a per cent are not drawn at first but counted; the path to one that is selected is drawn with
/// it, and blocked shadow rays of a ray that is drawn stay. *All rays* draws all. Oracle: the shares of the tree.
#[test]
fn small_rays_are_counted_and_not_drawn() {
    let window = in_space();
    let root = root(&window);
    let rays = root.rays();
    let (filter, all) = (Filter::default(), Filter::ALL);
    let (drawn, small) = filter.drawn(&root, 0);
    assert_eq!(drawn.len() + small, rays.len());
    let is_large = |number: &usize| root.path_to(*number).iter().all(|ray| ray.share >= 0.005);
    assert!(drawn.iter().all(is_large));
    let smallest = rays.iter().find(|ray| ray.share < 0.005).expect("small");
    assert!(small > 0 && !drawn.contains(&smallest.number));
    let with_it = filter.drawn(&root, smallest.number).0;
    assert!(root.path_to(smallest.number).iter().all(|ray| with_it.contains(&ray.number)));
    assert_eq!(all.drawn(&root, 0), ((0..rays.len()).collect(), 0));
    let acne = (gallery::find("ch16/surface-acne").expect("in the gallery").build)();
    let dark = ray_of(&acne, [138, 115], 0);
    assert!(dark.children.iter().any(|ray| ray.share == 0.0 && ray.blocked_by.is_some()));
    assert_eq!(filter.drawn(&dark, 0), ((0..dark.count()).collect(), 0));
}

/// Law: the slider walks along the path to the ray that was selected, there and back: each step selects the next ray of it, and
/// all of it stays drawn. A ray beside the path begins another one. Oracle: the tree.
#[test]
fn a_slider_walks_along_the_path() {
    let mut window = in_space();
    let root = root(&window);
    let inside = root.largest_child().expect("it enters the glass");
    let beside = root.children.iter().find(|ray| ray.number != inside.number).expect("reflected");
    let leaving = inside.children.iter().find(|ray| ray.hit.is_none()).expect("one leaves");
    set(&mut window, |it| it.selection.go_to(leaving.number));
    let walk = |window: &mut Window, key: Key| {
        window.get_by_role_and_label(Role::Slider, "step").focus();
        window.step();
        press(window, key);
        let step = window.get_by_role_and_label(Role::SpinButton, "step").value();
        (window.state().selection.tree.ray, step.expect("it is shown"))
    };
    assert_eq!(walk(&mut window, Key::ArrowLeft), (inside.number, "2 of 3".to_owned()));
    assert_eq!(walk(&mut window, Key::ArrowLeft), (root.number, "1 of 3".to_owned()));
    let end = place(&window, middle(inside));
    hover(&mut window, end);
    assert_eq!(window.state().selection.tree.lit, Some(inside.number), "it stays drawn");
    assert_eq!(walk(&mut window, Key::ArrowRight), (inside.number, "2 of 3".to_owned()));
    assert_eq!(walk(&mut window, Key::ArrowRight), (leaving.number, "3 of 3".to_owned()));
    set(&mut window, |it| it.selection.go_to(beside.number));
    assert_eq!(walk(&mut window, Key::ArrowLeft), (root.number, "1 of 2".to_owned()));
}

/// Law: in a scene that is opened while space is shown the view frames its rays, not the whole scene. Oracle: the library's
/// camera for the tree of the proposed pixel.
#[test]
fn another_scene_frames_its_rays() {
    let mut window = in_space();
    window.state_mut().proposes = true;
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("another.toml");
    let scene = small("ch26/cornell-box", [24, 24], 1);
    write(&path, &scene);
    type_into(&mut window, "File", &path.display().to_string());
    let expected = space::orbit_of(&built(&scene), &root(&window));
    assert_eq!(window.state().space.camera.orbit, Some(expected));
}

/// Law: at the end of each ray of the path to the selected one, and of those that it sends on, stands its number, with the
/// name of what is there at the first; that of a ray that ends out of view stands inside of it, too. Oracle: `Eye::project`.
#[test]
fn ends_of_the_path_are_labelled() {
    let mut window = in_space();
    let root = root(&window);
    let inside = root.largest_child().expect("it enters the glass").clone();
    set(&mut window, |it| it.selection.go_to(inside.number));
    hover(&mut window, pos2(1.0, 1.0));
    let texts = |window: &Window| {
        let shapes = window.output().shapes.clone();
        let text = |clipped: ClippedShape| match clipped.shape {
            Shape::Text(text) => Some((text.galley.job.text.clone(), text.visual_bounding_rect())),
            _ => None,
        };
        let texts: Vec<(String, Rect)> = shapes.into_iter().filter_map(text).collect();
        texts
    };
    let label = |window: &Window, text: &str| {
        let view = area(window);
        let mut found =
            texts(window).into_iter().filter(|(it, at)| it == text && view.contains_rect(*at));
        found.next().unwrap_or_else(|| panic!("no {text} in {:?}", texts(window))).1
    };
    for (ray, text) in [(&root, "0 glass sphere".to_owned()), (&inside, inside.number.to_string())]
    {
        let end = place(&window, ray.hit.as_ref().expect("it hits").point);
        let distance = label(&window, &text).distance_to_pos(end);
        assert!(distance < 30.0, "{text} is {distance} from its end");
    }
    let leaving = inside.children.iter().find(|ray| ray.hit.is_none()).expect("one leaves");
    label(&window, &format!("{} background", leaving.number));
}
