//! What a second look at the window found: what waited, was too faint, could not be undone, or was cut.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use eframe::egui::{Color32, Context, Key, Pos2, Rect, Shape, Theme, Visuals, accesskit::Role};
use egui_kittest::kittest::Queryable;
use explain::RecordedRay;
use groundtruth::render::{self, Canvas};
use groundtruth::trace::RayKind;
use inspector::action::Shows;
use inspector::comparison::recipe::Recipe;
use inspector::explanation::tree::{BROKEN, KINDS, LOCAL};
use inspector::picture::display::{AGREES, ground, ink};
use inspector::space::backdrop::{Backdrop, Request};
use inspector::splits::Mode;
use inspector::window::style::set_style;
use judge::mistakes;
use text::brief::short;

use crate::support::*;

/// Law: another picture is explained at the selected pixel and swiped, coarse, while it is rendered; how far it is stands
/// over the picture in per cent. Oracle: the library's explanation of the other scene, and its first sample of a block.
#[test]
fn another_picture_is_explained_before_it_is_whole() {
    let scene = small("ch28/glass-sphere", [480, 480], 100);
    let other = eta("1.33").applied(&scene).expect("a field");
    let mut window = begin(scene, [1280.0, 800.0]);
    let pixel = [170, 190];
    window.run_steps(2);
    let at = on_screen(&window, pixel);
    point_and_press(&mut window, at);
    window.state_mut().others.add(Recipe::Field(eta("1.33")));
    let explained = |window: &Window| {
        window.state().selection.beside.explanation().map(|answer| answer.radiance)
    };
    wait_until(&mut window, "it is explained", |window| explained(window).is_some());
    assert!(theirs(&window).pixels.part().is_some_and(|part| part < 0.9), "it is rendered");
    let answer = explain::pixel(&other, &built(&other), pixel, None).expect("few rays").radiance;
    assert_eq!(explained(&window), Some(answer));
    window.run_steps(2);
    assert!(window.query_by_label(&format!("eta = 1.33: {}", short(answer))).is_some());
    let ours = window.state().selection.explanation().expect("it is explained").radiance;
    assert!(
        window.query_by_label(&format!("eta = 1.33 − ours: {}", short(answer - ours))).is_some()
    );
    assert!(text_with(&window, " %, then compared").starts_with("eta = 1.33: "));
    assert_eq!(theirs(&window).shows, Shows::Swipe);
    // right of the line, top left in its block, and not to be taken for hatching
    let (world, tone) = (built(&other), window.state().picture.tone);
    let coarse = |at: &[u32; 2]| tone.to_bytes(render::sample(&world, *at, 0, &mut ()));
    let corners = (20..45).flat_map(|y| (34..58).map(move |x| [8 * x, 8 * y]));
    let bright = |at: &[u32; 2]| coarse(at).iter().any(|it| *it > 150);
    let corner = corners.into_iter().find(bright).expect("the background");
    let expected = coarse(&corner).map(f32::from);
    let is_near = |window: &mut Window| {
        let seen = shown(window, corner).map(f32::from);
        seen.iter().zip(expected).all(|(seen, it)| (seen - it).abs() < 45.0)
    };
    for _ in 0..400 {
        if is_near(&mut window) {
            break;
        }
        window.step();
    }
    assert!(is_near(&mut window), "{:?} for {expected:?}", shown(&mut window, corner));
}

/// Law: the list of mistakes has those first that change most pixels of the scene; its search leaves those with all words,
/// Enter takes the first, and the picture opens in swipe, whatever was shown before. Oracle: the table of the mistakes.
#[test]
fn the_list_of_mistakes_is_searched_and_ordered() {
    let mut window = glass_window();
    let mut shown = mistakes::shown_by("ch28/glass-sphere");
    shown.sort_by(|a, b| b.effect.share.total_cmp(&a.effect.share));
    assert!(shown[0].effect.share > 2.0 * shown[shown.len() - 1].effect.share);
    let height = |window: &Window, name: &str| {
        let row = window.query_by_role_and_label(Role::Button, name);
        row.map(|row| row.rect().top())
    };
    window.get_by_role_and_label(Role::ComboBox, "With the mistake").click();
    window.run_steps(6);
    let rows: Vec<f32> = shown.iter().map_while(|it| height(&window, it.mistake.name)).collect();
    assert!(rows.len() >= 4 && rows.is_sorted(), "{rows:?}");
    let word = "cosine";
    let has_word = |name: &str, words: &str| name.contains(word) || words.contains(word);
    let found: Vec<_> =
        shown.iter().filter(|it| has_word(it.mistake.name, it.mistake.words)).collect();
    assert!(!found.is_empty() && found.len() < shown.len());
    type_text(&mut window, word);
    for it in &shown {
        let is_found = found.iter().any(|found| found.mistake == it.mistake);
        assert_eq!(height(&window, it.mistake.name).is_some(), is_found, "{}", it.mistake.name);
    }
    press(&mut window, Key::Enter);
    assert_eq!(theirs(&window).name, found[0].mistake.name);
    press(&mut window, Key::T);
    set(&mut window, |it| it.others.set_mistake(None));
    set(&mut window, |it| it.others.set_mistake(Some(found[0].mistake)));
    assert_eq!(theirs(&window).shows, Shows::Swipe);
}

/// Law: after one sample for each square of 64 × 64 pixels something of all of the view is seen, before any pixel is whole.
/// Oracle: a count of the samples.
#[test]
fn few_samples_show_the_whole_view() {
    let world = built(&small("ch28/glass-sphere", [640, 512], 256));
    let (canvas, samples) = (Canvas::new(&world), AtomicU32::new(0));
    let is_over = || samples.fetch_add(1, Ordering::Relaxed) >= 80;
    assert!(!canvas.preview(&world, &is_over), "it is paused");
    assert_eq!((canvas.seen(), canvas.progress().0), (80, 0));
    let pixels = || (0..512).flat_map(|y| (0..640).map(move |x| [x, y]));
    assert!(canvas.look_partly(|picture| pixels().all(|at| picture.coarse(at).is_some())));
    canvas.preview(&world, &|| false);
    assert_eq!(canvas.seen(), 80 * 64, "one of each block, none twice");
}

fn luminance(color: Color32) -> f64 {
    let linear = |byte: u8| {
        let part = f64::from(byte) / 255.0;
        if part <= 0.04045 {
            part / 12.92
        } else {
            groundtruth::math::power((part + 0.055) / 1.055, 2.4)
        }
    };
    0.2126 * linear(color.r()) + 0.7152 * linear(color.g()) + 0.0722 * linear(color.b())
}

fn contrast(a: Color32, b: Color32) -> f64 {
    let [a, b] = [a, b].map(luminance);
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

fn visuals(theme: Theme) -> Visuals {
    let ctx = Context::default();
    set_style(&ctx);
    ctx.style_of(theme).visuals.clone()
}

/// Law: text, and what the colours of rays are written in, has a contrast of at least 4.5 to panels, and to the ground of what
/// is selected, in both themes. Oracle: the formula of the Web Content Accessibility Guidelines 2.
#[test]
fn text_stands_out_in_both_themes() {
    for theme in [Theme::Dark, Theme::Light] {
        let it = visuals(theme);
        let rays = KINDS.map(|(_, color)| color);
        let inks = [&rays[..], &[BROKEN, LOCAL, AGREES]].concat();
        let inks = inks.into_iter().map(|color| ink(&it, color));
        let plain = [it.text_color(), it.weak_text_color(), it.strong_text_color()];
        let told = [it.error_fg_color, it.warn_fg_color, it.hyperlink_color];
        for color in inks.chain(plain).chain(told) {
            for on in [it.panel_fill, it.window_fill, it.selection.bg_fill, it.faint_bg_color] {
                // faint stripes are added to the panel
                let on = if on.a() == 0 { it.panel_fill.blend(on) } else { on };
                let found = contrast(color, on);
                assert!(found >= 4.5, "{theme:?}: {color:?} on {on:?} has {found:.2}");
            }
        }
    }
}

/// How many pixels of a part of the screen have this colour.
fn count_of(window: &mut Window, part: Rect, color: Color32) -> usize {
    let image = window.render().expect("drawn");
    let [r, g, b, _] = color.to_array();
    let is_it =
        |pixel: &[u8; 4]| pixel.iter().zip([r, g, b]).all(|(it, wanted)| it.abs_diff(wanted) <= 2);
    let pixels = image.enumerate_pixels();
    let inside = pixels.filter(|(x, y, _)| part.contains([*x as f32, *y as f32].into()));
    inside.filter(|(.., pixel)| is_it(&pixel.0)).count()
}

/// Law: the theme reaches the ground of the picture and of space, and a ray has the same colour in tree, space and section.
/// Oracle: the pixels of the window.
#[test]
fn the_theme_reaches_everything() {
    for (theme, is_light) in [(Theme::Dark, false), (Theme::Light, true)] {
        let mut window = glass_window_at(ON_GLASS);
        if is_light {
            press(&mut window, Key::B);
        }
        press(&mut window, Key::S);
        push(&mut window, "The section");
        let it = visuals(theme);
        let [picture, section] = ["picture", "section"]
            .map(|name| window.get_by_role_and_label(Role::Image, name).rect());
        let space = window.get_by_role_and_label(Role::Canvas, "space").rect();
        for part in [picture, space] {
            assert!(count_of(&mut window, part, ground(&it)) > 200, "{theme:?} {part}");
        }
        let reflected = ink(&it, KINDS[1].1);
        let of_section = count_of(&mut window, section, reflected);
        let (_, root) = window.state().selection.root().expect("it is explained");
        let is_reflected = |ray: &&RecordedRay| matches!(ray.kind, RayKind::Reflected);
        let number = root.children.iter().find(is_reflected).expect("glass").number;
        // the path to the selected ray is drawn strongest
        set(&mut window, |it| it.selection.go_to(number));
        let of_space = count_of(&mut window, space, reflected);
        assert!(of_section > 20 && of_space > 20, "{theme:?}: {of_section}, {of_space}");
    }
}

/// Law: *Fit rays* sees the hits of rays of at least a hundredth of the light, and looks through what hides them; *Fit scene*
/// sees all objects and looks through none. Oracle: the ball around the library's rays of that share.
#[test]
fn rays_of_some_share_are_framed() {
    let scene = small("ch28/glass-sphere", [48, 48], 4);
    let world = built(&scene);
    let share = |root: &RecordedRay, number: usize| {
        root.path_to(number).last().map_or(0.0, |ray| ray.share)
    };
    let framed = |root: &RecordedRay, least: f64| {
        let mut pieces = space::segments(&world, root, 1.0);
        pieces.retain(|piece| share(root, piece.ray) >= least);
        space::of_hits(&world, &pieces).expect("it hits")
    };
    let pixels = (4..44).flat_map(|y| (4..44).map(move |x| [x, y]));
    let is_other = |pixel: &[u32; 2]| {
        let root = ray_of(&scene, *pixel, 0);
        root.hit.is_some() && framed(&root, 0.01).1 < 0.9 * framed(&root, 0.0).1
    };
    let pixel = pixels.into_iter().find(is_other).expect("one with a faint ray far away");
    let mut window = glass_window_at(pixel);
    set(&mut window, |it| it.space.mode = Mode::Space);
    push_button(&mut window, "Fit rays");
    let orbit = window.state().space.camera.orbit.expect("a camera");
    let (center, radius) = framed(&ray_of(&scene, pixel, 0), 0.01);
    assert!(orbit.target.distance(center) < 1e-9 * radius);
    window.state_mut().space.camera.faded = vec![0];
    push_button(&mut window, "Fit scene");
    let camera = &window.state().space.camera;
    assert!(camera.faded.is_empty());
    let (center, _) = space::of_scene(&world);
    let orbit = camera.orbit.expect("a camera");
    assert!(orbit.target.distance(center) < 1e-9 * orbit.distance);
}

/// Law: the first picture of space, which is seen while it turns, has the borders of objects where they are, to two points,
/// within a frame's time. Oracle: the library's ray through each square.
#[test]
fn borders_are_sharp_while_space_turns() {
    let world = Arc::new(built(&small_glass_sphere()));
    let ctx = Context::default();
    let size = [320, 240];
    let orbit = space::Orbit::around(space::of_scene(&world), 30.0, 20.0);
    let segments = Arc::default();
    let request = Request {
        version: (0, None),
        orbit,
        size,
        faded: Vec::new(),
        ground: 24,
        segments: Arc::clone(&segments),
    };
    let mut backdrop = Backdrop::default();
    while backdrop.runs(&segments).is_none() {
        backdrop.refresh(&ctx, &world, request.clone());
    }
    assert!(backdrop.is_busy(), "it is the first");
    let sight = orbit.sight(size.map(|along| along as f64));
    let scene = space::Backdrop { world: &world, faded: &[] };
    let squares = (0..120).flat_map(|y| (0..160).map(move |x| [x, y]));
    let wrong = squares.filter(|at: &[u32; 2]| {
        let middle = at.map(|along| 2.0 * f64::from(along) + 1.0);
        let (_, object) = scene.seen(&sight.ray(middle), Default::default());
        backdrop.object_at(middle.map(|along| along as f32)) != object
    });
    let wrong = wrong.count();
    assert!(wrong < 60, "{wrong} of 19200 squares");
}

/// All that is drawn, without lists of it.
fn drawn(window: &Window) -> Vec<&Shape> {
    let mut found = Vec::new();
    let mut shapes: Vec<&Shape> = window.output().shapes.iter().map(|it| &it.shape).collect();
    while let Some(shape) = shapes.pop() {
        match shape {
            Shape::Vec(inner) => shapes.extend(inner),
            other => found.push(other),
        }
    }
    found
}

/// Law: no line of the section goes through its words, and no words lie on others. Oracle: a hundred points of each line that
/// is drawn, and the rectangles of the texts.
#[test]
fn words_of_the_section_lie_beside_its_lines() {
    for size in [[1000.0, 700.0], [1400.0, 900.0]] {
        let mut window = open_sized(small_glass_sphere(), size);
        click(&mut window, ON_GLASS);
        push(&mut window, "The section");
        let area = window.get_by_role_and_label(Role::Image, "section").rect();
        let (mut words, mut points) = (Vec::new(), Vec::new());
        let mut line = |ends: &[Pos2]| {
            let at = |part: usize| ends[0].lerp(ends[1], part as f32 / 100.0);
            points.extend((0..=100).map(at));
        };
        for shape in drawn(&window) {
            match shape {
                Shape::Text(text) if area.contains_rect(text.visual_bounding_rect()) => {
                    words.push(text.visual_bounding_rect());
                }
                Shape::LineSegment { points, .. } => line(points),
                Shape::Path(path) if !path.closed => path.points.windows(2).for_each(&mut line),
                _ => {}
            }
        }
        points.retain(|at| area.contains(*at));
        assert!(words.len() > 5 && points.len() > 500, "{} words", words.len());
        for (index, rect) in words.iter().enumerate() {
            assert!(!words[..index].iter().any(|other| other.intersects(*rect)), "{size:?}");
            let crossed = points.iter().find(|at| rect.contains(**at));
            assert!(crossed.is_none(), "{size:?}: {rect} at {crossed:?}");
        }
    }
}

/// Law: every text that is cut has a tool tip with the whole of it, in windows of every size and in each part of the
/// explanation. Oracle: what is drawn, and the accessibility tree while the mouse is on it.
#[test]
fn no_text_is_cut_without_a_tool_tip() {
    let mut missing = Vec::new();
    for size in [[900.0, 600.0], [1400.0, 900.0]] {
        let mut window = open_sized(small_glass_sphere(), size);
        click(&mut window, ON_GLASS);
        for tab in ["The ray", "The section", "The sum", "The samples"] {
            push(&mut window, tab);
            let cut = |shape: &Shape| match shape {
                Shape::Text(text) if text.galley.elided => {
                    Some((text.galley.job.text.clone(), text.visual_bounding_rect()))
                }
                _ => None,
            };
            let texts: Vec<_> = drawn(&window).into_iter().filter_map(cut).collect();
            for (text, place) in texts {
                let told = |window: &Window| {
                    window.query_all_by(|node| text_of(node).contains(&text)).count()
                };
                let before = told(&window);
                hover(&mut window, place.center());
                window.run_steps(60);
                if told(&window) <= before {
                    missing.push(format!("{size:?}, {tab}: {text}"));
                }
                hover(&mut window, eframe::egui::pos2(1.0, 1.0));
            }
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
}
