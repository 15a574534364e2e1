//! Zoom, pan, tone, and snapshots of the window.

use eframe::egui::{Pos2, Rect, accesskit::Role, pos2, vec2};
use egui_kittest::kittest::Queryable;
use egui_kittest::{SnapshotOptions, image_snapshot_options};
use inspector::picture::view::View;
use pictures::parse_pixel;

use crate::support::*;

const AREA: Rect = Rect { min: pos2(190.0, 90.0), max: pos2(870.0, 770.0) };

/// Law: the centre of a pixel's rectangle is in that pixel, and a position outside the picture is in no
/// pixel, at every zoom and after every pan.
#[test]
fn a_position_on_the_screen_is_in_the_pixel_drawn_there() {
    let size = [37, 53];
    for zoom in [0.5, 1.0, 3.3, 16.0, 160.0] {
        for by in [vec2(0.0, 0.0), vec2(-31.0, 17.5), vec2(400.0, 300.0)] {
            let mut view = View::WHOLE;
            view.set_zoom(AREA, size, zoom, None);
            view.pan(AREA, size, by);
            let placement = view.place(AREA, size);
            for pixel in [[0, 0], [36, 0], [0, 52], [36, 52], [17, 29]] {
                assert_eq!(
                    placement.pixel(placement.rect(pixel).center()),
                    Some(pixel),
                    "{zoom} {by}"
                );
            }
            let whole = placement.whole();
            for outside in [whole.min - vec2(0.1, 0.0), whole.max, whole.max + vec2(0.0, 9.0)] {
                assert_eq!(placement.pixel(outside), None, "{zoom} {by}");
            }
        }
    }
}

/// Law: zooming does not move the point of the picture under the mouse, up to the rounding of the picture's
/// corner to whole points.
#[test]
fn zoom_keeps_the_point_under_the_mouse() {
    let size = [600, 600];
    let under = |view: &View, at: Pos2| {
        let placement = view.place(AREA, size);
        (at - placement.corner) / placement.scale
    };
    let mut view = View::WHOLE;
    for (at, factor) in
        [(pos2(400.0, 300.0), 1.7), (pos2(600.0, 500.0), 4.0), (pos2(300.0, 700.0), 0.3)]
    {
        let before = under(&view, at);
        view.zoom_at(AREA, size, at, factor);
        let moved = (under(&view, at) - before) * view.place(AREA, size).scale;
        // the corner is rounded once before and once after, at either scale
        assert!(moved.length() < 2.0 * (1.0 + factor), "{moved}");
    }
}

/// Law: however far the picture is dragged, some of it stays in the middle; a pixel can be brought back
/// into view.
#[test]
fn the_picture_cannot_be_lost() {
    let size = [60, 40];
    let mut view = View::WHOLE;
    view.set_zoom(AREA, size, 10.0, None);
    for by in [vec2(9e4, 0.0), vec2(-9e5, 9e5), vec2(0.0, -9e5)] {
        view.pan(AREA, size, by);
        assert!(view.place(AREA, size).whole().expand(1.0).contains(AREA.center()));
    }
    view.set_zoom(AREA, size, 40.0, None);
    for pixel in [[0, 0], [59, 39], [59, 0]] {
        view.reveal(AREA, size, pixel);
        assert!(AREA.contains_rect(view.place(AREA, size).rect(pixel)), "{pixel:?}");
    }
}

/// Law: coordinates are read in all common notations, and nothing else is accepted.
#[test]
fn coordinates_are_read_as_people_write_them() {
    for text in ["200,150", " 200, 150 ", "(200, 150)", "200 150"] {
        assert_eq!(parse_pixel(text), Ok([200, 150]), "{text}");
    }
    for text in ["", "200", "200,", "200,-1", "2.5,1", "1,2,3", "99999999999,0", "x,y"] {
        assert!(parse_pixel(text).is_err(), "{text}");
    }
}

/// Law: the wheel zooms, a drag pans, and neither selects a pixel.
#[test]
fn wheel_and_drag_move_the_picture_and_select_nothing() {
    let mut window = glass_window();
    let placement = |window: &Window| window.state().picture.placement([48, 48]);
    let (before, at) = (placement(&window), on_screen(&window, [20, 20]));
    turn_wheel(&mut window, at);
    let zoomed = placement(&window);
    assert!(zoomed.scale > 1.5 * before.scale, "{} after {}", zoomed.scale, before.scale);
    assert_eq!(zoomed.pixel(at), Some([20, 20]));

    drag(&mut window, at, at + vec2(60.0, 24.0));
    let moved = placement(&window).corner - zoomed.corner;
    assert!((moved - vec2(60.0, 24.0)).length() < 2.0, "{moved}");
    assert_eq!(window.state().selection.pixel, None);
}

/// Law: a picture larger than the largest texture is shown completely, also across the seams between its
/// tiles. Oracle: `Tone` on the film.
#[test]
fn large_pictures_are_shown_across_the_seams() {
    for size in [[1060, 24], [24, 1060]] {
        let mut scene = small_glass_sphere();
        scene.image.resize(size[0], size[1]);
        // the ground has many colours, and neighbouring pixels differ
        scene.image.pixel_size = 0.5;
        scene.image.samples = 1;
        let mut window = open(scene);
        let film = film(&window);
        let tone = window.state().picture.tone;
        window.state_mut().picture.set_zoom(size, 10.0, None);
        for along in [5, 1000, 1023, 1024, 1055] {
            let pixel = if size[0] > size[1] { [along, 7] } else { [7, along] };
            window.state_mut().picture.reveal(size, pixel);
            window.run_steps(2);
            assert_eq!(shown(&mut window, pixel), tone.to_bytes(film.get(pixel)), "{pixel:?}");
        }
    }
}

/// Law: a finished picture hides the one before it, also where it is black. Oracle: without any
/// light the ground is black.
#[test]
fn nothing_of_the_old_picture_shines_through() {
    let mut window = glass_window();
    let ground = [30, 44];
    assert_ne!(shown(&mut window, ground), [0, 0, 0]);
    // the ground is lit until the last of them is off
    for light in ["high lamp", "front lamp", "left light", "ambient"] {
        push(&mut window, light);
    }
    assert_eq!(shown(&mut window, ground), [0, 0, 0]);
    let film = film(&window);
    let tone = window.state().picture.tone;
    for pixel in [[1, 1], [17, 19], [40, 46]] {
        assert_eq!(shown(&mut window, pixel), tone.to_bytes(film.get(pixel)), "{pixel:?}");
    }
}

/// Law: exposure and gamma change the screen and not the radiance. Oracle: the film before, and
/// `Tone` on one pixel.
#[test]
fn exposure_changes_the_screen_and_not_the_picture() {
    let mut window = glass_window();
    let (before, at) = (film(&window), [3, 3]);
    let shown = |window: &mut Window| shown(window, at);
    let tone = window.state().picture.tone;
    assert_eq!(shown(&mut window), tone.to_bytes(before.get(at)));
    let brighter = groundtruth::film::Tone { exposure: 2.5, gamma: 2.2, ..tone };
    set(&mut window, |it| it.picture.tone = brighter);
    assert_eq!(shown(&mut window), brighter.to_bytes(before.get(at)));
    assert_ne!(brighter.to_bytes(before.get(at)), tone.to_bytes(before.get(at)));
    assert_eq!(film(&window), before);
}

/// Compares a part of the window with its committed picture; a few pixels at the edges of glyphs
/// may differ.
fn snapshot(window: &mut Window, name: &str, part: Rect) {
    let whole = window.render().expect("drawn");
    let [x, y, width, height] =
        [part.min.x, part.min.y, part.width(), part.height()].map(|side| side as u32);
    let part = image::imageops::crop_imm(&whole, x, y, width, height).to_image();
    let options = SnapshotOptions::new().threshold(2.0).max_failed_pixels(50_usize);
    image_snapshot_options(&part, name, &options);
}

#[test]
fn picture_and_mark_look_as_before() {
    let mut window = glass_window_at([17, 19]);
    window.state_mut().picture.set_zoom([48, 48], 20.0, None);
    window.run_steps(3);
    let middle = on_screen(&window, [19, 20]);
    snapshot(&mut window, "picture", Rect::from_center_size(middle, vec2(240.0, 200.0)));
}

#[test]
fn tree_looks_as_before() {
    let mut window = glass_window_at([17, 19]);
    window.run_steps(3);
    snapshot(&mut window, "tree", Rect::from_min_max(pos2(776.0, 60.0), pos2(1276.0, 370.0)));
}

/// Law: the buttons of the zooms keep the selected pixel in view, at the border of the picture, too, and below grid and values
/// its column and row stand at the edges. Oracle: the place of the pixel; dark ground at the edges, which the picture lacks.
#[test]
fn zooms_keep_the_selected_pixel() {
    let mut window = glass_window_at([45, 2]);
    let area = window.get_by_role_and_label(Role::Image, "picture").rect();
    let is_dark =
        |window: &mut Window, at: Pos2| color_at(window, at).iter().all(|channel| *channel < 60);
    for zoom in ["12×", "64×", "4×", "64×"] {
        push_button(&mut window, zoom);
        let rect = window.state().picture.placement([48, 48]).rect([45, 2]);
        assert!(area.contains_rect(rect), "{zoom}: {rect} of {area}");
    }
    let beside = window.state().picture.placement([48, 48]).rect([45, 2]).center();
    let edges = [pos2(beside.x + 9.0, area.top() + 3.0), pos2(area.left() + 4.0, beside.y + 6.0)];
    for at in edges {
        assert!(is_dark(&mut window, at), "{at}");
        assert!(!is_dark(&mut window, at + vec2(26.0, 20.0)), "{at}");
    }
}
