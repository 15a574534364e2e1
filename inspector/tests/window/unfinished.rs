//! A picture that is not finished: what is rendered, what is only coarse, and what is still to come.

use std::sync::Arc;

use egui_kittest::kittest::Queryable;
use groundtruth::render::{self, Canvas};
use groundtruth::rgb::Rgb;

use crate::support::*;

/// A pixel of the ground, which is black without lights.
const GROUND: [u32; 2] = [30, 44];

fn words_at(window: &mut Window, pixel: [u32; 2]) -> String {
    let at = on_screen(window, pixel);
    hover(window, at);
    text_with(window, &format!("({}, {})  ", pixel[0], pixel[1]))
}

/// Law: the window says that a pixel is not rendered yet, and not of a finished black pixel; so does the comparison with
/// the explanation.
#[test]
fn an_unrendered_pixel_is_not_shown_as_black() {
    let mut scene = small_glass_sphere();
    scene.lights.clear();
    let mut window = open(scene);
    let canvas = Canvas::new(&window.state().session.rendering.world);
    window.state_mut().session.rendering.canvas = Arc::new(canvas);
    assert_eq!(words_at(&mut window, GROUND), "(30, 44)  not rendered yet");
    click(&mut window, GROUND);
    assert!(window.query_by_label("this pixel is not rendered yet").is_some());

    let rendering = &window.state().session.rendering;
    rendering.canvas.render(&*rendering.world);
    assert!(rendering.canvas.look(|film| film.get(GROUND)) == Rgb::BLACK);
    settle(&mut window);
    let black = text::brief::short(Rgb::BLACK);
    assert_eq!(words_at(&mut window, GROUND), format!("(30, 44)  {black}"));
    for x in [20, 24] {
        assert_eq!(shown(&mut window, [x, 44]), [0; 3], "no hatching");
    }
    assert!(window.query_by_label("= the pixel of the picture, bit for bit").is_some());
}

/// Law: pixels that are not rendered yet are hatched, also where the picture will be black. Oracle: light on a row of the screen.
#[test]
fn what_is_not_rendered_is_hatched() {
    let mut scene = small_glass_sphere();
    scene.lights.clear();
    scene.image.resize(600, 600);
    // hours of work
    scene.image.samples = 10_000;
    let mut window = begin(scene, [1280.0, 800.0]);
    window.run_steps(5);
    let area = window.state().picture.placement([600, 600]).whole();
    let image = window.render().expect("drawn");
    let row = area.center().y as u32;
    let (left, right) = (area.left() as u32 + 9, area.right() as u32 - 9);
    // a line of 85, or a seventh of it through the coarse picture, which may be there already
    let bright = (left..right).filter(|&x| image.get_pixel(x, row).0[0] > 4).count();
    assert!(bright > 20, "{bright} pixels of lines in a row");
}

/// Law: until its pixels are rendered, a block shows its coarse pixel, enlarged; the status "not rendered
/// yet" says that this is not the pixel's own colour. Oracle: the library's pixel in the corner of the block.
#[test]
fn the_coarse_picture_is_shown_over_its_blocks() {
    let mut window = glass_window();
    let world = built(&small_glass_sphere());
    let canvas = Canvas::new(&world);
    canvas.render_coarse(&world);
    set(&mut window, |it| it.session.rendering.canvas = Arc::new(canvas));
    let tone = window.state().picture.tone;
    for block in [[16, 16], [24, 40], [40, 8]] {
        let [r, g, b] = tone.to_bytes(render::pixel(&world, block)).map(f32::from);
        let is_it = |[r2, g2, b2]: [u8; 3]| {
            let off = |seen: u8, full: f32| f32::from(seen) - full;
            // a sixth of the colour comes from below: black, or a line of the hatching
            [off(r2, r), off(g2, g), off(b2, b)].into_iter().all(|off| (-45.0..20.0).contains(&off))
        };
        let inside = [block[0] + 6, block[1] + 6];
        let middle = on_screen(&window, inside);
        let image = window.render().expect("drawn");
        let at = |x: i32, y: i32| {
            let [r, g, b, _] =
                image.get_pixel((middle.x as i32 + x) as u32, (middle.y as i32 + y) as u32).0;
            [r, g, b]
        };
        let seen = (-3..4).flat_map(|x| (-3..4).map(move |y| (x, y)));
        assert!(seen.clone().all(|(x, y)| is_it(at(x, y))), "{block:?}");
        assert!(words_at(&mut window, inside).ends_with("not rendered yet"));
    }
}
